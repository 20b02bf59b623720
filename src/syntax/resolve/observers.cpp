// SPDX-License-Identifier: MIT
// Resolves the observers of a closed loop (automata that monitor it) and its constraints (assumptions about the
// inputs).
#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/chart.hpp"
#include "syntax/resolve/expand.hpp"
#include "syntax/resolve/loop_scope.hpp"
#include "syntax/resolve/nearest.hpp"

namespace grafverif {

namespace {

using Observer = ClosedLoop::Observer;
using ObserverLocation = ClosedLoop::ObserverLocation;

Id<ObserverLocation> location_named(LoopScope& scope, const Observer& observer, tree::Name name) {
    Nearest nearest(scope.text(name));
    for (const Id<ObserverLocation> id : observer.locations.ids()) {
        if (observer.locations[id].name == scope.text(name))
            return scope.record.refer(name.where, observer.locations[id].origin), id;
        nearest.offer(observer.locations[id].name);
    }
    scope.diagnostics.add(messages::unknown(name.where, "location", scope.text(name), nearest.best()));
    return {};
}

void declare_location(LoopScope& scope, Observer& observer, const tree::Location& written) {
    const std::string name(scope.text(written.name));
    scope.record.declare(DeclarationKind::Location, name, written.name.where, written.where, observer.origin);
    for (const ObserverLocation& other : observer.locations)
        if (other.name == name) {
            scope.diagnostics.add(duplicate(written.name, "location", name, other.origin));
            return;
        }
    if (written.invariant.valid())
        scope.diagnostics.add(messages::observer_blocks(scope.file.exprs[written.invariant].where, observer.name));
    const Id<ObserverLocation> location = observer.locations.add({name, written.name.where});
    if (!written.initial) return;
    if (observer.initial.valid())
        scope.diagnostics.add(messages::two_initial_locations(written.name.where, observer.name,
                                                              observer.locations[observer.initial].origin));
    observer.initial = location;
}

void declare_observer(LoopScope& scope, const tree::Observer& written) {
    const InCopy copy(scope.diagnostics, scope.file, written.name);
    Observer observer{.name = std::string(scope.text(written.name)), .origin = written.name.where};
    scope.record.declare(DeclarationKind::Observer, observer.name, observer.origin, written.where, scope.loop.origin);
    for (const tree::ObserverItem& item : written.items)
        if (const auto* location = std::get_if<tree::Location>(&item)) declare_location(scope, observer, *location);
    if (!observer.initial.valid())
        scope.diagnostics.add(messages::observer_without_start(written.name.where, observer.name));
    const auto instance = scope.instances.find(scope.text(written.name));
    if (instance != scope.instances.end())
        scope.diagnostics.add(
            duplicate(written.name, "observer", observer.name, scope.loop.instances[instance->second].origin));
    const auto [known, fresh] = scope.observers.try_emplace(scope.text(written.name));
    if (!fresh)
        scope.diagnostics.add(
            duplicate(written.name, "observer", observer.name, scope.loop.observers[known->second].origin));
    const Id<Observer> id = scope.loop.observers.add(std::move(observer));
    if (fresh) known->second = id;
}

void resolve_edge(LoopScope& scope, Id<Observer> observer, const tree::ObserverEdge& written) {
    for (const tree::Assignment& assignment : written.assignments)
        scope.diagnostics.add(messages::observer_acts(assignment.where, scope.loop.observers[observer].name));
    ClosedLoop::ObserverEdge edge{.origin = written.where};
    edge.from = location_named(scope, scope.loop.observers[observer], written.from);
    edge.to = location_named(scope, scope.loop.observers[observer], written.to);
    edge.guard = written.condition.valid()
                     ? property_terms(scope).resolve(written.condition, TermKind::Boolean, "the guard of an observer")
                     : scope.loop.exprs.constant(true);
    if (edge.from.valid() && edge.to.valid() && edge.guard.valid())
        scope.loop.observers[observer].edges.push_back(std::move(edge));
}

// -- constraints ------------------------------------------------------------------------------------------------------

/// True if the term reads only inputs of controllers. Otherwise, reports the first name that does
/// not denote such an input.
bool reads_inputs_only(LoopScope& scope, Id<Expr> condition, Span where) {
    bool only = true;
    const auto refuse = [&](const std::string& name) {
        scope.diagnostics.add(messages::constraint_reads(where, name, "an input of a controller"));
        only = false;
    };
    const ClosedLoop& loop = scope.loop;
    for (const Id<Expr> leaf : leaves(loop.exprs, condition))
        std::visit(
            overloaded{
                [&](const ClosedLoop::SharedSymbol& of) {
                    const ClosedLoop::Shared& shared = loop.shared[of.shared];
                    if (!shared.reader.valid() || shared.writer.valid()) refuse(shared.name);
                },
                [&](const ClosedLoop::InternalSymbol& of) {
                    refuse(scope.chart(of.controller).variables[of.variable].name);
                },
                [&](const ClosedLoop::StepSymbol& of) { refuse("X" + scope.chart(of.controller).steps[of.step].name); },
                [&](const ClosedLoop::LocationSymbol& of) { refuse(loop.instances[of.instance].name); },
                [&](const ClosedLoop::OwnSymbol& of) { refuse(loop.instances[of.instance].name); },
                [&](const ClosedLoop::TimeSymbol& of) { refuse(time_text(scope.chart(of.controller), of)); },
                [&](const ClosedLoop::ObserverSymbol& of) { refuse(loop.observers[of.observer].name); },
            },
            loop.symbols[{static_cast<std::uint32_t>(loop.exprs[leaf].value)}]);
    return only;
}

void add_constraint(LoopScope& scope, ClosedLoop::Constraint constraint, const std::string& owner, std::size_t number) {
    constraint.name = owner + "constraint_" + std::to_string(number);
    scope.loop.constraints.add(std::move(constraint));
}

/// Adds the constraints that charts declare for their inputs.
void take_chart_constraints(LoopScope& scope) {
    for (const Id<ClosedLoop::Controller> id : scope.loop.controllers.ids()) {
        const Chart& chart = scope.chart(id);
        std::size_t number = 0;
        for (const Chart::Constraint& constraint : chart.constraints) {
            ++number;
            const Id<Expr> copy = translate(chart.exprs, constraint.condition, scope.loop.exprs, [&](const Expr& leaf) {
                const std::string& name = chart.variables[{static_cast<std::uint32_t>(leaf.value)}].name;
                return symbol_leaf(scope, ClosedLoop::SharedSymbol{scope.shared.at(name)});
            });
            add_constraint(scope, {.condition = copy, .controller = id, .origin = constraint.origin}, chart.name + "_",
                           number);
        }
    }
}

/// Adds the constraints that components declare for their outputs. In the added constraints, the bound variables
/// replace the outputs, and the arguments replace the constants.
void take_component_constraints(LoopScope& scope) {
    for (const Id<ClosedLoop::Instance> id : scope.loop.instances.ids()) {
        const ClosedLoop::Instance& instance = scope.loop.instances[id];
        const Component& component = scope.context.model.components[instance.component];
        std::size_t number = 0;
        for (const Component::Constraint& constraint : component.constraints) {
            Exprs& exprs = scope.loop.exprs;
            const Id<Expr> copy = translate(component.exprs, constraint.condition, exprs, [&](const Expr& leaf) {
                if (leaf.op == Op::Integer || leaf.op == Op::Duration) return exprs.integer(leaf.value);
                const auto index = static_cast<std::uint32_t>(leaf.value);
                const ClosedLoop::Argument& argument = instance.arguments[index];
                if (const auto* shared = std::get_if<Id<ClosedLoop::Shared>>(&argument))
                    return symbol_leaf(scope, ClosedLoop::SharedSymbol{*shared});
                const std::int64_t value = std::get<std::int64_t>(argument);
                return component.parameters[{index}].value == Component::ValueKind::Boolean ? exprs.constant(value != 0)
                                                                                            : exprs.integer(value);
            });
            add_constraint(scope, {.condition = copy, .instance = id, .origin = constraint.origin}, instance.name + "_",
                           ++number);
        }
    }
}

}  // namespace

void declare_observers(LoopScope& scope, const tree::ClosedLoop& written) {
    for (const tree::LoopItem& item : written.items)
        if (const auto* observer = std::get_if<tree::Observer>(&item)) declare_observer(scope, *observer);
}

void resolve_observers(LoopScope& scope, const tree::ClosedLoop& written) {
    std::uint32_t index = 0;
    for (const tree::LoopItem& item : written.items) {
        const auto* observer = std::get_if<tree::Observer>(&item);
        if (observer == nullptr) continue;
        const InCopy copy(scope.diagnostics, scope.file, observer->name);
        for (const tree::ObserverItem& part : observer->items)
            if (const auto* edge = std::get_if<tree::ObserverEdge>(&part)) resolve_edge(scope, {index}, *edge);
        ++index;
    }
}

void resolve_constraints(LoopScope& scope, const tree::ClosedLoop& written) {
    std::size_t number = 0;
    for (const tree::LoopItem& item : written.items) {
        const auto* constraint = std::get_if<tree::Constraint>(&item);
        if (constraint == nullptr) continue;
        const InCopy copy(scope.diagnostics, scope.file, constraint->copy);
        const Id<Expr> condition =
            property_terms(scope).resolve(constraint->condition, TermKind::Boolean, "a constraint");
        if (!condition.valid() || !reads_inputs_only(scope, condition, constraint->where)) continue;
        add_constraint(scope, {.condition = condition, .origin = constraint->where}, "", ++number);
    }
    if (scope.diagnostics.errors() > 0 || scope.record.beyond_errors()) return;
    take_chart_constraints(scope);
    take_component_constraints(scope);
}

}  // namespace grafverif
