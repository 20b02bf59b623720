// SPDX-License-Identifier: MIT
// Resolves the locations and edges of a component. Comparisons of clocks become clock constraints (paper CEP13,
// equation (4)); the remaining conjuncts become the guard; an assignment `clock := 0` becomes a reset.
#include <optional>
#include <unordered_set>
#include <vector>

#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "syntax/resolve/component_scope.hpp"
#include "syntax/resolve/expand.hpp"
#include "syntax/resolve/nearest.hpp"

namespace grafverif {

namespace {

bool is_comparison(tree::Op op) { return op >= tree::Op::Equal && op <= tree::Op::GreaterEqual; }

std::optional<Id<Component::Clock>> clock_at(const ComponentScope& scope, Id<tree::Expr> id) {
    const tree::Expr& node = scope.file.exprs[id];
    const auto found = node.op == tree::Op::Name ? scope.symbols.find(node.word) : scope.symbols.end();
    if (found == scope.symbols.end() || !std::holds_alternative<Id<Component::Clock>>(found->second)) return {};
    return std::get<Id<Component::Clock>>(found->second);
}

/// Returns the relation with exchanged operands, for example `>=` for `<=`, because `3s <= t` is equivalent to `t >=
/// 3s`.
Op mirrored(Op relation) {
    switch (relation) {
    case Op::Less: return Op::Greater;
    case Op::LessEqual: return Op::GreaterEqual;
    case Op::Greater: return Op::Less;
    case Op::GreaterEqual: return Op::LessEqual;
    default: return relation;
    }
}

struct Conjuncts {
    std::vector<Id<Expr>> data = {};
    std::vector<Component::ClockConstraint> clocks = {};
    std::vector<Id<tree::Expr>> data_nodes = {};  ///< for each element of `data`: its node in the syntax tree
};

void take_clock_constraint(ComponentScope& scope, const tree::Expr& node, Conjuncts& taken) {
    const auto left = clock_at(scope, node.first), right = clock_at(scope, node.last);
    if (left && right) {
        scope.diagnostics.add(messages::clock_compared_with_clock(node.where));
        return;
    }
    Component::ClockConstraint constraint;
    constraint.clock = left ? *left : *right;
    constraint.relation = left ? ir_op(node.op) : mirrored(ir_op(node.op));
    constraint.origin = node.where;
    scope.record.refer(scope.file.exprs[left ? node.first : node.last].where,
                       scope.component.clocks[constraint.clock].origin);
    Terms terms = constant_terms(scope, "the bound of a clock");
    const Id<tree::Expr> bound = left ? node.last : node.first;
    constraint.bound = terms.resolve(bound, TermKind::Duration, "the comparison of a clock");
    if (node.op == tree::Op::NotEqual) scope.diagnostics.add(messages::clock_not_equal(node.where));
    else if (constraint.bound.valid()) taken.clocks.push_back(constraint);
}

/// Splits a conjunction into conjuncts, including nested conjunctions in brackets. The recursion is safe because the
/// parser limits the depth of terms.
void take(ComponentScope& scope, Id<tree::Expr> id, Conjuncts& taken) {
    const tree::Expr& node = scope.file.exprs[id];
    if (node.op == tree::Op::And) {
        for (Id<tree::Expr> operand = node.first; operand.valid(); operand = scope.file.exprs[operand].next)
            take(scope, operand, taken);
        return;
    }
    if (is_comparison(node.op) && (clock_at(scope, node.first) || clock_at(scope, node.last)))
        return take_clock_constraint(scope, node, taken);
    const Id<Expr> term = all_terms(scope).resolve(id, TermKind::Boolean, "a guard");
    if (!term.valid()) return;
    taken.data.push_back(term);
    taken.data_nodes.push_back(id);
}

// -- assignments ------------------------------------------------------------------------------------------------------

const ComponentScope::Symbol* target_of(ComponentScope& scope, tree::Name name) {
    const auto found = scope.symbols.find(name.word);
    if (found != scope.symbols.end())
        return scope.record.refer(name.where, origin(scope.component, found->second), true), &found->second;
    if (scope.diagnostics.full())
        return scope.diagnostics.add(messages::unknown(name.where, "variable", scope.text(name), "")), nullptr;
    Nearest nearest(scope.text(name));
    for (const auto& parameter : scope.component.parameters)
        if (parameter.kind == Component::ParameterKind::Output) nearest.offer(parameter.name);
    for (const auto& variable : scope.component.variables) nearest.offer(variable.name);
    for (const auto& clock : scope.component.clocks) nearest.offer(clock.name);
    scope.diagnostics.add(messages::unknown(name.where, "variable", scope.text(name), nearest.best()));
    return nullptr;
}

/// Resolves the assignment `target := value`; `values` resolves the value. The result is empty after an error.
std::optional<Component::Assignment> assignment(ComponentScope& scope, const tree::Assignment& written,
                                                const ComponentScope::Symbol& target, Terms values) {
    Component::Assignment resolved;
    resolved.origin = written.where;
    TermKind kind = TermKind::Boolean;
    if (const auto* parameter = std::get_if<Id<Component::Parameter>>(&target)) {
        const Component::Parameter& assigned = scope.component.parameters[*parameter];
        if (assigned.kind != Component::ParameterKind::Output) {
            const bool input = assigned.kind == Component::ParameterKind::Input;
            scope.diagnostics.add(
                messages::assigned_constant(written.target.where, assigned.name, input ? "an input" : "a constant"));
            return {};
        }
        kind = kind_of(assigned.value);
        resolved.target = scope.component.exprs.leaf(Op::Parameter, parameter->index);
    } else if (const auto* variable = std::get_if<Id<Component::Variable>>(&target)) {
        kind = kind_of(scope.component.variables[*variable].value);
        resolved.target = scope.component.exprs.leaf(Op::Variable, variable->index);
    } else {
        scope.diagnostics.add(messages::assigned_constant(written.target.where, scope.text(written.target), "a clock"));
        return {};
    }
    resolved.value = values.resolve(written.value, kind, '`' + std::string(scope.text(written.target)) + '`');
    if (!resolved.value.valid()) return {};
    return resolved;
}

void reset(ComponentScope& scope, const tree::Assignment& written, Id<Component::Clock> clock, Component::Edge& edge) {
    const tree::Expr& value = scope.file.exprs[written.value];
    const bool zero = (value.op == tree::Op::Number || value.op == tree::Op::Duration) && value.value == 0;
    if (zero) edge.resets.push_back(clock);
    else scope.diagnostics.add(messages::clock_reset(written.where, scope.text(written.target)));
}

Id<Component::Location> location_named(ComponentScope& scope, tree::Name name) {
    const auto found = scope.locations.find(name.word);
    if (found != scope.locations.end())
        return scope.record.refer(name.where, scope.component.locations[found->second].origin), found->second;
    if (scope.diagnostics.full())
        return scope.diagnostics.add(messages::unknown(name.where, "location", scope.text(name), "")),
               Id<Component::Location>{};
    Nearest nearest(scope.text(name));
    for (const auto& location : scope.component.locations) nearest.offer(location.name);
    scope.diagnostics.add(messages::unknown(name.where, "location", scope.text(name), nearest.best()));
    return {};
}

}  // namespace

void declare_location(ComponentScope& scope, const tree::Location& written) {
    const InCopy copy(scope.diagnostics, scope.file, written.name);
    const auto [known, fresh] = scope.locations.try_emplace(written.name.word);
    scope.record.declare(DeclarationKind::Location, scope.text(written.name), written.name.where, written.where,
                         scope.component.origin);
    if (!fresh) {
        scope.diagnostics.add(duplicate(written.name, "location", scope.text(written.name),
                                        scope.component.locations[known->second].origin));
        return;
    }
    known->second = scope.component.locations.add({std::string(scope.text(written.name)), {}, {}, written.name.where});
    if (!written.initial) return;
    if (scope.component.initial.valid())
        scope.diagnostics.add(messages::two_initial_locations(
            written.name.where, scope.component.name, scope.component.locations[scope.component.initial].origin));
    else scope.component.initial = known->second;
}

void resolve_location(ComponentScope& scope, const tree::Location& written) {
    const InCopy copy(scope.diagnostics, scope.file, written.name);
    const auto known = scope.locations.find(written.name.word);
    if (scope.component.locations[known->second].origin.begin != written.name.where.begin)
        return;  // a second declaration, which has already been reported
    Conjuncts invariant;
    if (written.invariant.valid()) take(scope, written.invariant, invariant);
    for (const Id<tree::Expr> node : invariant.data_nodes)
        if (scope.file.exprs[node].op != tree::Op::True)
            scope.diagnostics.add(messages::invariant_without_clock(scope.file.exprs[node].where));
    for (const Component::ClockConstraint& constraint : invariant.clocks)
        if (constraint.relation != Op::LessEqual && constraint.relation != Op::Less)
            scope.diagnostics.add(messages::lower_bound_invariant(constraint.origin));
    std::vector<Component::Assignment> values;
    std::unordered_set<Id<tree::Word>> assigned;
    for (const tree::Assignment& value : written.values) {
        const ComponentScope::Symbol* target = target_of(scope, value.target);
        if (target == nullptr) continue;
        if (!assigned.insert(value.target.word).second)
            scope.diagnostics.add(messages::assigned_twice(value.where, scope.text(value.target)));
        if (auto resolved = assignment(scope, value, *target, constant_terms(scope, "a value at power-on")))
            values.push_back(std::move(*resolved));
    }
    Component::Location& location = scope.component.locations[known->second];
    location.invariant = std::move(invariant.clocks);
    location.initially = std::move(values);
}

void resolve_edge(ComponentScope& scope, const tree::Edge& written) {
    const InCopy copy(scope.diagnostics, scope.file, written.from);
    Component::Edge edge;
    edge.from = location_named(scope, written.from);
    edge.to = location_named(scope, written.to);
    edge.urgent = written.urgent;
    edge.origin = written.where;
    Conjuncts condition;
    if (written.condition.valid()) take(scope, written.condition, condition);
    edge.guard = scope.component.exprs.conjunction(condition.data);
    edge.constraint = std::move(condition.clocks);
    if (edge.urgent && !edge.constraint.empty())
        scope.diagnostics.add(messages::urgent_clock_guard(edge.constraint.front().origin));
    std::unordered_set<Id<tree::Word>> assigned;
    for (const tree::Assignment& value : written.assignments) {
        const ComponentScope::Symbol* target = target_of(scope, value.target);
        if (target == nullptr) continue;
        if (!assigned.insert(value.target.word).second)
            scope.diagnostics.add(messages::assigned_twice(value.where, scope.text(value.target)));
        if (const auto* clock = std::get_if<Id<Component::Clock>>(target)) {
            reset(scope, value, *clock, edge);
            continue;
        }
        if (auto resolved = assignment(scope, value, *target, all_terms(scope)))
            edge.assignments.push_back(std::move(*resolved));
    }
    scope.component.edges.add(std::move(edge));
}

}  // namespace grafverif
