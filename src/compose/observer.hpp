// SPDX-License-Identifier: MIT
// Builds the observer automaton of a Sentence (pattern, scope, duration and count of a property with Pattern::Watched).
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Terms over variables that an observer reads. Each of these terms can be used in a guard.
struct ObserverTerms {
    std::vector<Id<Expr>> operands = {};  ///< operands of the property
    Id<Expr> considered = {};             ///< true if the current state is relevant for the property
    Id<Expr> active = {};                 ///< true if this observer must read the state next

    /// `look`: variable that the observer assigns when it has read the state. `next`: the new value of this variable.
    Id<Expr> look = {}, next = {};
};

struct ObserverMade {
    Network::Template automaton = {};
    /// Locations that encode the property. If `settled` is empty, the property states that no location of `pending` is
    /// reached; otherwise it states that `pending` leads to `settled`.
    std::vector<Id<Network::Location>> pending = {}, settled = {};
};

/// Builds the observer. `duration` is the duration that the property states (`watch.duration_ms`), in time units of the
/// network; 0 if the property has no duration.
ObserverMade observer_of(Exprs& exprs, const Sentence& watch, const ObserverTerms& terms, std::int64_t duration);

}  // namespace grafverif
