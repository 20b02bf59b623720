// SPDX-License-Identifier: MIT
// State profile: the components that contribute most states to a search.
#pragma once

#include <optional>

#include "check/timed/graph.hpp"
#include "grafverif/ir/state_profile.hpp"

namespace grafverif::timed {

enum class Effort {
    Brief,  ///< computation takes about 0.1 s, because the user waits for the result
    Full,   ///< computation takes a few seconds
};
/// Returns a profile of the states that were found first. `effort` limits the number of these states. `finest` is the
/// duration that requires a fine time unit, if there is such a duration.
StateProfile profile_of(Graph& graph, std::optional<StateProfile::Finest> finest, Effort effort = Effort::Full);

}  // namespace grafverif::timed
