// SPDX-License-Identifier: MIT
// State profile: the components that contribute most states to a search.
#pragma once

#include <optional>

#include "check/timed/graph.hpp"
#include "grafverif/ir/state_profile.hpp"

namespace grafverif::timed {

enum class Effort {
    Brief,  ///< a tenth of a second, because the user waits for the result
    Full,   ///< a few seconds
};
/// Returns a profile of the first states found, as many as the effort permits. `finest` is the cause of a fine time
/// unit, if there is one.
StateProfile profile_of(Graph& graph, std::optional<StateProfile::Finest> finest, Effort effort = Effort::Full);

}  // namespace grafverif::timed
