// SPDX-License-Identifier: MIT
// Builds the observer automaton of a sentence: its reactions to the states that it reads.
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Terms that an observer reads, in a form that guards can contain.
struct ObserverTerms {
    std::vector<Id<Expr>> operands = {};  ///< of the property
    Id<Expr> judged = {};                 ///< true if the state counts
    Id<Expr> turn = {};                   ///< true if this observer reads next
    Id<Expr> look = {}, next = {};        ///< variable assigned after reading, and its new value
};

struct ObserverMade {
    Network::Template automaton = {};
    /// Encodes the property: no location of `pending` is ever reached; or, if `settled` is not empty, `pending` leads
    /// to `settled`.
    std::vector<Id<Network::Location>> pending = {}, settled = {};
};

/// `duration`: of the sentence, in time units.
ObserverMade observer_of(Exprs& exprs, const Sentence& watch, const ObserverTerms& terms, std::int64_t duration);

}  // namespace grafverif
