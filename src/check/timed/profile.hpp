// SPDX-License-Identifier: MIT
// Where the states of a search come from.
#pragma once

#include <optional>

#include "check/timed/graph.hpp"
#include "grafverif/ir/state_profile.hpp"

namespace grafverif::timed {

enum class Effort {
    Brief,  ///< somebody waits for the end: a tenth of a second
    Full,   ///< some seconds
};
/// Of the first states found, as many as the effort allows. `finest`: what makes the time unit fine, if something does.
StateProfile profile_of(Graph& graph, std::optional<StateProfile::Finest> finest, Effort effort = Effort::Full);

}  // namespace grafverif::timed
