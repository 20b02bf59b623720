// SPDX-License-Identifier: MIT
// Component: a timed automaton with discrete data and parameters (TADD; CEP13 section 2), as written in the input
// language and with resolved names. An edge is the 7-tuple (l, g, t, u, a, r, l') of CEP13 2.3: guard over data, clock
// constraint, urgency, assignments, clock resets.
//
// Expressions are stored in `exprs`; apart from constants, their leaves are Parameter (index in
// `parameters`) and Variable (index in `variables`, the internal variables of the component). A
// duration is a Duration leaf (milliseconds), a Parameter of kind Duration, a sum of durations, or
// an integer times a duration.
//
// Invariants (see verify): every id is in its table; an urgent edge has no clock constraint (CEP13 2.3); an invariant
// has upper bounds only; only outputs and internal variables are assigned; the types of operands, arguments and
// assigned values agree.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/expr.hpp"
#include "grafverif/ir/type.hpp"
#include "grafverif/support/source.hpp"
#include "grafverif/support/table.hpp"

namespace grafverif {

struct Component {
    enum class ParameterKind { Input, Output, Constant };
    enum class ValueKind { Boolean, Integer, Duration };  ///< Duration is allowed only for constants
    struct Parameter {
        std::string name = {};
        ParameterKind kind = ParameterKind::Input;
        ValueKind value = ValueKind::Boolean;
        /// Range of an integer output; the bounds contain only constants that are declared before
        /// the output.
        std::optional<Id<Expr>> low = {}, high = {};
        /// Default of a constant, or value of an output at power-on (if empty: 0 or, for an integer, `low`).
        std::optional<Id<Expr>> initial = {};
        Span origin = {};
        bool operator==(const Parameter&) const = default;
    };

    /// An internal variable; each instance has a separate copy.
    struct Variable {
        std::string name = {};
        ValueKind value = ValueKind::Boolean;
        std::optional<Id<Expr>> low = {}, high = {};
        std::optional<Id<Expr>> initial = {};
        Span origin = {};
        bool operator==(const Variable&) const = default;
    };

    struct Clock {
        std::string name = {};
        Span origin = {};
        bool operator==(const Clock&) const = default;
    };

    /// `clock relation bound` (CEP13 equation (4)); relation is Less, LessEqual, Equal, GreaterEqual or Greater.
    struct ClockConstraint {
        Id<Clock> clock = {};
        Op relation = Op::LessEqual;
        Id<Expr> bound = {};
        Span origin = {};
        bool operator==(const ClockConstraint&) const = default;
    };

    /// `target := value`; `target` is a Parameter leaf (an output) or a Variable leaf.
    struct Assignment {
        Id<Expr> target = {};
        Id<Expr> value = {};
        Span origin = {};
        bool operator==(const Assignment&) const = default;
    };

    struct Location {
        std::string name = {};
        std::vector<ClockConstraint> invariant = {};
        std::vector<Assignment> initially = {};  ///< values at power-on of an instance that starts in this location
        Span origin = {};
        bool operator==(const Location&) const = default;
    };

    struct Edge {
        Id<Location> from = {}, to = {};
        bool urgent = false;
        Id<Expr> guard = {};
        std::vector<ClockConstraint> constraint = {};  ///< conjunction of clock constraints

        /// The assignments of the edge. Assignments are executed in order; each assignment reads the results of the
        /// previous assignments.
        std::vector<Assignment> assignments = {};
        std::vector<Id<Clock>> resets = {};
        Span origin = {};
        bool operator==(const Edge&) const = default;
    };

    /// A condition on the outputs of the component, which must hold for all values of the inputs.
    struct Constraint {
        Id<Expr> condition = {};
        Span origin = {};
        bool operator==(const Constraint&) const = default;
    };

    std::string name = {};
    std::string summary = {};  ///< the first line of the comment above the component
    Exprs exprs = {};
    Table<Parameter> parameters = {};
    Table<Variable> variables = {};
    Table<Clock> clocks = {};
    Table<Location> locations = {};
    Table<Edge> edges = {};
    Id<Location> initial = {};  ///< if invalid, every instance must specify its initial location with `initially`
    std::vector<Constraint> constraints = {};
    Span origin = {};

    bool operator==(const Component&) const = default;
};

std::vector<std::string> verify(const Component& component);

}  // namespace grafverif
