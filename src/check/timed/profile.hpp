// SPDX-License-Identifier: MIT
// Computes a state profile: the components of a model that contribute most to the number of states of a search.
#pragma once

#include <optional>

#include "check/timed/graph.hpp"
#include "grafverif/ir/state_profile.hpp"

namespace grafverif::timed {

enum class Effort {
    Brief,  ///< for a computation of about 0.1 s, because the user waits for the result
    Full,   ///< for a computation of a few seconds
};
/// Returns a profile of the states that the search found first; `effort` limits their number. `finest` is the duration
/// of the model that requires the current, fine time unit, or nullopt.
StateProfile profile_of(Graph& graph, std::optional<StateProfile::Finest> finest, Effort effort = Effort::Full);

}  // namespace grafverif::timed
