// SPDX-License-Identifier: MIT
// Property: a query about a closed loop. The pattern of a property is one of `Pattern` and has the same semantics in
// every engine. The operands of a property are expressions of the ClosedLoop or Network that contains the property. In
// a ClosedLoop, the leaves of the operands are Variable (index in `symbols`); in a Network, they are Variable and At.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grafverif/ir/expr.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

enum class Pattern {
    Always,      ///< p holds in every reachable state
    Never,       ///< p does not hold in any reachable state
    Reachable,   ///< p holds in some reachable state
    Inevitable,  ///< p holds at some time on every maximal run
    LeadsTo,     ///< from every state with p, a state with q is inevitable (this may be the same state); operands p, q
    NoDeadlock,  ///< from every reachable state, an edge can be taken immediately or after a delay
    NoTimelock,  ///< from every reachable state, a state in which time can pass is reachable
    ReachableAllSteps,  ///< every step of every chart is active in some reachable state
    ExactlyOneOf,       ///< in every reachable state, exactly one of the operands holds
    AlwaysPossible,     ///< from every reachable state, a state with p is reachable
    Watched,            ///< `Property::watch`, which an observer automaton decides (docs/reference/properties.md)
    RawUppaal,
    RawCtl,
    RawLtl,  ///< `raw`: formula for an external tool
};

/// Maximum count of a `Sentence`: the observer of a `Sentence` has two locations per unit of the
/// count.
inline constexpr std::int64_t greatest_count = 100;

/// A property that an observer automaton decides: it has a duration, a count or a scope, or its kind is Precedence. The
/// operands of the property are the operands of the kind, followed by the operands of the scope.
struct Sentence {
    enum class Kind {
        Absence,       ///< `never p`
        Universality,  ///< `always p`
        Existence,     ///< `inevitable p`
        Response,      ///< `p leads to q`, without or with `within` a duration
        Precedence,    ///< `p precedes q`
        HoldsFor,      ///< `p holds for` at least a duration
        HoldsAtMost,   ///< `p holds at most` a duration
        Since,         ///< `p at most` a duration `since q`
        Recurrence,    ///< `p at least every` duration
        Occurrences,   ///< `p at most` a count `times`
    };
    enum class Scope { Globally, Before, After, Between, AfterUntil };

    Kind kind = Kind::Absence;
    Scope scope = Scope::Globally;
    std::int64_t duration_ms = 0;  ///< duration in ms; 0 if there is none
    std::int64_t count = 0;        ///< maximum number of occurrences, only for Occurrences; otherwise 0

    bool operator==(const Sentence&) const = default;
};

struct Property {
    std::string name = {};
    std::string text = {};  ///< description that the model gives in quotation marks; may be empty
    Pattern pattern = Pattern::Always;
    std::vector<Id<Expr>> operands = {};
    std::string raw = {};
    Sentence watch = {};     ///< parameters of the pattern Watched; unused for other patterns
    bool at_stable = false;  ///< true if the property is evaluated only in quiescent states
    bool expected_violated = false;
    Span origin = {};

    bool operator==(const Property&) const = default;
};

}  // namespace grafverif
