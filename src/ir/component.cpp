// SPDX-License-Identifier: MIT
#include "grafverif/ir/component.hpp"

#include <string_view>
#include <unordered_set>

#include "ir/sorts.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

namespace {

Sort sort_of(Component::ValueKind kind) {
    switch (kind) {
    case Component::ValueKind::Boolean: return Sort::Boolean;
    case Component::ValueKind::Integer: return Sort::Integer;
    case Component::ValueKind::Duration: return Sort::Duration;
    }
    unreachable();
}

Sort leaf_sort(const Component& component, const Expr& leaf) {
    const auto index = static_cast<std::uint32_t>(leaf.value);
    if (leaf.op == Op::Duration) return Sort::Duration;
    if (leaf.op == Op::Parameter && component.parameters.contains({index}))
        return sort_of(component.parameters[{index}].value);
    if (leaf.op == Op::Variable && component.variables.contains({index}))
        return sort_of(component.variables[{index}].value);
    return Sort::None;
}

struct ComponentChecker {
    const Component& component;
    Sorts sorts{component.exprs, [this](const Expr& leaf) { return leaf_sort(component, leaf); }};
    std::vector<std::string> faults = {};

    void check(bool holds, std::string fault) {
        if (!holds) faults.push_back(std::move(fault));
    }

    bool is(Id<Expr> term, Sort sort, const std::string& what) { return sorts.check(term, sort, what, faults); }
};

template <class Declared>
void check_declared(ComponentChecker& checker, const Declared& declared, bool ranged) {
    using Kind = Component::ValueKind;
    checker.check(declared.low.has_value() == declared.high.has_value(),
                  declared.name + " has only one bound of its range");
    checker.check(declared.low.has_value() == (ranged && declared.value == Kind::Integer),
                  declared.name + " has no range although it is an integer, or has a superfluous range");
    for (const auto& bound : {declared.low, declared.high})
        if (bound) checker.is(*bound, Sort::Integer, "a bound of " + declared.name);
    if (declared.initial) checker.is(*declared.initial, sort_of(declared.value), "the value of " + declared.name);
}

void check_names(ComponentChecker& checker) {
    std::unordered_set<std::string_view> names, locations;
    const auto add = [&](std::string_view name) {
        checker.check(names.insert(name).second, "two elements are named " + std::string(name));
    };
    for (const auto& parameter : checker.component.parameters) add(parameter.name);
    for (const auto& variable : checker.component.variables) add(variable.name);
    for (const auto& clock : checker.component.clocks) add(clock.name);
    for (const auto& location : checker.component.locations)
        checker.check(locations.insert(location.name).second, "two locations are named " + location.name);
}

void check_assignments(ComponentChecker& checker, const std::vector<Component::Assignment>& assignments) {
    const Component& component = checker.component;
    for (const Component::Assignment& assignment : assignments) {
        const Sort sort = checker.sorts(assignment.target);
        checker.check(sort != Sort::None, "the target of an assignment does not exist or has no type");
        if (sort == Sort::None) continue;
        const Expr& target = component.exprs[assignment.target];
        const bool output =
            target.op == Op::Parameter &&
            component.parameters[Id<Component::Parameter>{static_cast<std::uint32_t>(target.value)}].kind ==
                Component::ParameterKind::Output;
        checker.check(output || target.op == Op::Variable,
                      "the target of an assignment is not an output or variable of the component");
        checker.is(assignment.value, sort, "an assigned value");
    }
}

void check_clocks(ComponentChecker& checker, const std::vector<Component::ClockConstraint>& constraints) {
    for (const Component::ClockConstraint& constraint : constraints) {
        checker.check(checker.component.clocks.contains(constraint.clock),
                      "a clock constraint refers to a clock that does not exist");
        checker.is(constraint.bound, Sort::Duration, "the bound of a clock");
        checker.check(is_comparison(constraint.relation) && constraint.relation != Op::NotEqual,
                      "a clock constraint has an invalid relation");
    }
}

void check_locations(ComponentChecker& checker) {
    const Component& component = checker.component;
    checker.check(!component.locations.empty(), "the component has no location");
    checker.check(!component.initial.valid() || component.locations.contains(component.initial),
                  "the initial location does not exist");
    for (const Component::Location& location : component.locations) {
        check_clocks(checker, location.invariant);
        for (const auto& bound : location.invariant)
            checker.check(bound.relation == Op::Less || bound.relation == Op::LessEqual,
                          "the invariant of " + location.name + " has a lower bound");
        check_assignments(checker, location.initially);
    }
}

void check_edges(ComponentChecker& checker) {
    const Component& component = checker.component;
    for (const Component::Edge& edge : component.edges) {
        checker.check(component.locations.contains(edge.from) && component.locations.contains(edge.to),
                      "an edge links a location that does not exist");
        checker.is(edge.guard, Sort::Boolean, "a guard");
        checker.check(!edge.urgent || edge.constraint.empty(), "an urgent edge has a clock constraint");
        check_clocks(checker, edge.constraint);
        check_assignments(checker, edge.assignments);
        for (const auto clock : edge.resets)
            checker.check(component.clocks.contains(clock), "an edge resets a clock that does not exist");
    }
}

}  // namespace

std::vector<std::string> verify(const Component& component) {
    ComponentChecker checker{component};
    check_names(checker);
    for (const auto& parameter : component.parameters)
        check_declared(checker, parameter, parameter.kind == Component::ParameterKind::Output);
    for (const auto& variable : component.variables) check_declared(checker, variable, true);
    check_locations(checker);
    check_edges(checker);
    for (const Component::Constraint& constraint : component.constraints)
        checker.is(constraint.condition, Sort::Boolean, "a constraint");
    return checker.faults;
}

}  // namespace grafverif
