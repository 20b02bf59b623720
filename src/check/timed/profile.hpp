// SPDX-License-Identifier: MIT
// State profile: the components that contribute most states to a search.
#pragma once

#include <optional>

#include "check/timed/graph.hpp"
#include "grafverif/ir/state_profile.hpp"

namespace grafverif::timed {

enum class Effort {
    Brief,  ///< the user waits for the end: a tenth of a second
    Full,   ///< some seconds
};
/// Profile of the first states found, as many as the effort permits. `finest`: the cause of a fine time unit, if there
/// is one.
StateProfile profile_of(Graph& graph, std::optional<StateProfile::Finest> finest, Effort effort = Effort::Full);

}  // namespace grafverif::timed
