// SPDX-License-Identifier: MIT
// Builds the observer automaton of a sentence: its reactions to the states that it reads.
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Terms that an observer reads, in a form that guards can contain.
struct ObserverTerms {
    std::vector<Id<Expr>> operands = {};  ///< operands of the property
    Id<Expr> judged = {};                 ///< true if the property considers the state
    Id<Expr> turn = {};                   ///< true if it is this observer's turn to read
    Id<Expr> look = {}, next = {};        ///< variable that is assigned after reading, and its new value
};

struct ObserverMade {
    Network::Template automaton = {};
    /// Encoding of the property. If `settled` is empty, no location of `pending` is ever reached; otherwise `pending`
    /// leads to `settled`.
    std::vector<Id<Network::Location>> pending = {}, settled = {};
};

/// Builds the observer. `duration` is that of the sentence, in time units.
ObserverMade observer_of(Exprs& exprs, const Sentence& watch, const ObserverTerms& terms, std::int64_t duration);

}  // namespace grafverif
