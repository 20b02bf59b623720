// SPDX-License-Identifier: MIT
// State profile: the components that contribute most states to a search.
#pragma once

#include <optional>

#include "check/timed/graph.hpp"
#include "grafverif/ir/state_profile.hpp"

namespace grafverif::timed {

enum class Effort {
    Brief,  ///< about a tenth of a second, because the user waits for the result
    Full,   ///< a few seconds
};
/// Returns a profile of the states that were found first. The effort limits their number. `finest` is the duration that
/// requires a fine time unit, if there is such a duration.
StateProfile profile_of(Graph& graph, std::optional<StateProfile::Finest> finest, Effort effort = Effort::Full);

}  // namespace grafverif::timed
