// SPDX-License-Identifier: MIT
// The automaton that watches for one sentence: what it does when it looks at a state, by what holds there.
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// What an observer reads, as guards have it.
struct ObserverTerms {
    std::vector<Id<Expr>> operands = {};  ///< of the property
    Id<Expr> judged = {};                 ///< the state counts
    Id<Expr> turn = {};                   ///< it is this observer's turn to look
    Id<Expr> look = {}, next = {};        ///< what it assigns, and the value, once it has looked
};

struct ObserverMade {
    Network::Template automaton = {};
    /// The property: it is never at one of `pending`; with `settled`, from there it always comes to one of those.
    std::vector<Id<Network::Location>> pending = {}, settled = {};
};

/// `duration`: of the watch, in time units.
ObserverMade observer_of(Exprs& exprs, const Sentence& watch, const ObserverTerms& terms, std::int64_t duration);

}  // namespace grafverif
