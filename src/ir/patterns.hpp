// SPDX-License-Identifier: MIT
#pragma once

#include "grafverif/ir/property.hpp"

namespace grafverif {

/// True if the pattern is a state invariant: a run to a single state can show its violation.
inline bool is_about_all_states(Pattern pattern) {
    return pattern == Pattern::Always || pattern == Pattern::Never || pattern == Pattern::ExactlyOneOf;
}

/// True if a run to a single state can show the violation or, for `reachable`, that the property holds.
inline bool is_about_single_states(Pattern pattern) {
    return is_about_all_states(pattern) || pattern == Pattern::Reachable;
}

/// True if the verdict depends only on the set of reachable states. The steps of `reachable all steps` are reached by
/// different runs.
inline bool is_about_states(Pattern pattern) {
    return is_about_single_states(pattern) || pattern == Pattern::ReachableAllSteps;
}

/// True if the property states that something happens eventually; its counterexamples are maximal runs.
inline bool is_liveness(Pattern pattern) { return pattern == Pattern::Inevitable || pattern == Pattern::LeadsTo; }

/// True for a `leads to` that the model declares. False for a `leads to` between locations of an observer, because its
/// premise is irrelevant to vacuity.
inline bool is_declared_response(const Property& property) {
    return property.pattern == Pattern::LeadsTo && property.watch == Sentence{};
}

}  // namespace grafverif
