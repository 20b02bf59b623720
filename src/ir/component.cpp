// SPDX-License-Identifier: MIT
#include "grafverif/ir/component.hpp"

#include <string_view>
#include <unordered_set>

namespace grafverif {

namespace {

struct Checker {
    const Component& component;
    std::vector<std::string> faults = {};

    void check(bool holds, std::string fault) {
        if (!holds) faults.push_back(std::move(fault));
    }

    Component::ValueKind kind(Id<Expr> id) const {
        const Expr& node = component.exprs[id];
        const auto index = static_cast<std::uint32_t>(node.value);
        if (node.op == Op::Parameter) return component.parameters[Id<Component::Parameter>{index}].value;
        if (node.op == Op::Variable) return component.variables[Id<Component::Variable>{index}].value;
        if (node.op == Op::Duration) return Component::ValueKind::Duration;
        if (node.op == Op::Plus) return kind(component.exprs.operands(id)[0]);
        if (node.op == Op::Times) {
            const bool duration = kind(component.exprs.operands(id)[0]) == Component::ValueKind::Duration ||
                                  kind(component.exprs.operands(id)[1]) == Component::ValueKind::Duration;
            return duration ? Component::ValueKind::Duration : Component::ValueKind::Integer;
        }
        return node.op == Op::Integer || is_arithmetic(node.op) ? Component::ValueKind::Integer
                                                                : Component::ValueKind::Boolean;
    }

    bool is_known(Id<Expr> id) const { return component.exprs.contains(id); }
};

void check_leaves(Checker& checker) {
    const Component& component = checker.component;
    for (std::uint32_t index = 0; index < component.exprs.size(); ++index) {
        const Expr& node = component.exprs[Id<Expr>{index}];
        if (!is_leaf(node.op)) continue;
        const bool parameter =
            node.op == Op::Parameter && component.parameters.contains({static_cast<std::uint32_t>(node.value)});
        const bool variable =
            node.op == Op::Variable && component.variables.contains({static_cast<std::uint32_t>(node.value)});
        checker.check(parameter || variable, "a leaf of an expression is in no table");
    }
}

template <class Declared>
void check_declared(Checker& checker, const Declared& declared, bool ranged) {
    using Kind = Component::ValueKind;
    checker.check(declared.low.has_value() == declared.high.has_value(), declared.name + " has half a range");
    checker.check(declared.low.has_value() == (ranged && declared.value == Kind::Integer),
                  declared.name + " lacks a range, or has one too much");
    if (declared.initial)
        checker.check(checker.is_known(*declared.initial) && checker.kind(*declared.initial) == declared.value,
                      "the value of " + declared.name + " has another type");
}

void check_names(Checker& checker) {
    std::unordered_set<std::string_view> names, locations;
    const auto add = [&](std::string_view name) {
        checker.check(names.insert(name).second, "two things are named " + std::string(name));
    };
    for (const auto& parameter : checker.component.parameters) add(parameter.name);
    for (const auto& variable : checker.component.variables) add(variable.name);
    for (const auto& clock : checker.component.clocks) add(clock.name);
    for (const auto& location : checker.component.locations)
        checker.check(locations.insert(location.name).second, "two locations are named " + location.name);
}

void check_assignments(Checker& checker, const std::vector<Component::Assignment>& assignments) {
    const Component& component = checker.component;
    for (const Component::Assignment& assignment : assignments) {
        const bool known = checker.is_known(assignment.target) && checker.is_known(assignment.value);
        checker.check(known, "an assignment is not in the table");
        if (!known) continue;
        const Expr& target = component.exprs[assignment.target];
        const bool output =
            target.op == Op::Parameter &&
            component.parameters[Id<Component::Parameter>{static_cast<std::uint32_t>(target.value)}].kind ==
                Component::ParameterKind::Output;
        checker.check(output || target.op == Op::Variable, "something else than an output or own variable is assigned");
        checker.check(checker.kind(assignment.target) == checker.kind(assignment.value),
                      "an assignment has a value of another type");
    }
}

void check_clocks(Checker& checker, const std::vector<Component::ClockConstraint>& constraints) {
    for (const Component::ClockConstraint& constraint : constraints) {
        checker.check(checker.component.clocks.contains(constraint.clock), "a clock constraint is about no clock");
        checker.check(
            checker.is_known(constraint.bound) && checker.kind(constraint.bound) == Component::ValueKind::Duration,
            "the bound of a clock is no duration");
        checker.check(is_comparison(constraint.relation) && constraint.relation != Op::NotEqual,
                      "a clock constraint has no relation");
    }
}

void check_locations(Checker& checker) {
    const Component& component = checker.component;
    checker.check(!component.locations.empty(), "there is no location");
    checker.check(!component.initial.valid() || component.locations.contains(component.initial),
                  "the initial location is in no table");
    for (const Component::Location& location : component.locations) {
        check_clocks(checker, location.invariant);
        for (const auto& bound : location.invariant)
            checker.check(bound.relation == Op::Less || bound.relation == Op::LessEqual,
                          "the invariant of " + location.name + " bounds from below");
        check_assignments(checker, location.initially);
    }
}

void check_edges(Checker& checker) {
    const Component& component = checker.component;
    for (const Component::Edge& edge : component.edges) {
        checker.check(component.locations.contains(edge.from) && component.locations.contains(edge.to),
                      "an edge links locations in no table");
        const bool known = checker.is_known(edge.guard);
        checker.check(known, "a guard is in no table");
        if (known) checker.check(checker.kind(edge.guard) == Component::ValueKind::Boolean, "a guard is not Boolean");
        checker.check(!edge.urgent || edge.constraint.empty(), "an urgent edge has a clock constraint");
        check_clocks(checker, edge.constraint);
        check_assignments(checker, edge.assignments);
        for (const auto clock : edge.resets)
            checker.check(component.clocks.contains(clock), "a reset is about no clock");
    }
}

}  // namespace

std::vector<std::string> verify(const Component& component) {
    Checker checker{component};
    check_leaves(checker);
    if (!checker.faults.empty()) return checker.faults;
    check_names(checker);
    for (const auto& parameter : component.parameters)
        check_declared(checker, parameter, parameter.kind == Component::ParameterKind::Output);
    for (const auto& variable : component.variables) check_declared(checker, variable, true);
    check_locations(checker);
    check_edges(checker);
    for (const Component::Constraint& constraint : component.constraints) {
        const bool known = checker.is_known(constraint.condition);
        checker.check(known && checker.kind(constraint.condition) == Component::ValueKind::Boolean,
                      "a constraint is not Boolean");
    }
    return checker.faults;
}

}  // namespace grafverif
