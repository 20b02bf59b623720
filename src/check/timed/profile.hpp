// SPDX-License-Identifier: MIT
// Where the states of a search come from.
#pragma once

#include "check/timed/graph.hpp"
#include "grafverif/ir/state_profile.hpp"

namespace grafverif::timed {

enum class Effort {
    Brief,  ///< somebody waits for the end: a tenth of a second
    Full,   ///< some seconds
};
/// Of the first states found, as many as the effort allows.
StateProfile profile_of(Graph& graph, Effort effort = Effort::Full);

}  // namespace grafverif::timed
