// SPDX-License-Identifier: MIT
#pragma once

#include "grafverif/ir/property.hpp"

namespace grafverif {

/// Whether it says something of every state by itself: a run to one state violates it.
inline bool is_about_all_states(Pattern pattern) {
    return pattern == Pattern::Always || pattern == Pattern::Never || pattern == Pattern::ExactlyOneOf;
}

/// Likewise of every state, or of some state: what decides it is which states there are, not how runs go on.
inline bool is_about_single_states(Pattern pattern) {
    return is_about_all_states(pattern) || pattern == Pattern::Reachable;
}

/// True of a `leads to` that the model declares, false of one between places of an observer, whose premise says nothing of
/// vacuity.
inline bool is_declared_response(const Property& property) {
    return property.pattern == Pattern::LeadsTo && property.watch == Sentence{};
}

}  // namespace grafverif
