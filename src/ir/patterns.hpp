// SPDX-License-Identifier: MIT
#pragma once

#include "grafverif/ir/property.hpp"

namespace grafverif {

/// True if a property of this pattern states that a condition holds in every reachable state, so that a run to a single
/// state can show a violation.
inline bool is_about_all_states(Pattern pattern) {
    return pattern == Pattern::Always || pattern == Pattern::Never || pattern == Pattern::ExactlyOneOf;
}

/// True if a run to a single state can show a violation or, for `reachable`, that the property holds.
inline bool is_about_single_states(Pattern pattern) {
    return is_about_all_states(pattern) || pattern == Pattern::Reachable;
}

/// True if the verdict on a property of this pattern depends only on the set of reachable states. The result is also
/// true for `reachable all steps`, for which different runs may reach the steps.
inline bool is_about_states(Pattern pattern) {
    return is_about_single_states(pattern) || pattern == Pattern::ReachableAllSteps;
}

/// True if a property of this pattern states that some run exists. A single run cannot show that the property is
/// violated.
inline bool is_about_existence(Pattern pattern) {
    return pattern == Pattern::Reachable || pattern == Pattern::ReachableAllSteps;
}

/// True if a property of this pattern states that some state is reached eventually on each run; a counterexample is a
/// maximal run.
inline bool is_liveness(Pattern pattern) { return pattern == Pattern::Inevitable || pattern == Pattern::LeadsTo; }

/// True for a `leads to` that the model declares. False for a `leads to` that grafverif derives from a Sentence
/// (Property::watch), because the premise of a derived property does not determine vacuity.
inline bool is_declared_response(const Property& property) {
    return property.pattern == Pattern::LeadsTo && property.watch == Sentence{};
}

}  // namespace grafverif
