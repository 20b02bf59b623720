// SPDX-License-Identifier: MIT
#include "plant/plant.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "plant/checks.hpp"
#include "plant/time_unit.hpp"
#include "plant/variables.hpp"
#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "support/unique_names.hpp"

namespace grafverif {

namespace {

using Variable = Network::Variable;

/// Union-find structure, with path halving, of variables that must have the same type.
class Classes {
public:
    explicit Classes(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), std::uint32_t{0}); }

    std::uint32_t of(std::uint32_t variable) {
        for (; parent_[variable] != variable; variable = parent_[variable])
            parent_[variable] = parent_[parent_[variable]];
        return variable;
    }
    void join(std::uint32_t left, std::uint32_t right) { parent_[of(left)] = of(right); }

private:
    std::vector<std::uint32_t> parent_;
};

/// Unifies the types of variables that are bound to the same parameter in several processes. Integer variables are
/// widened to the convex hull of the ranges of all variables that share a parameter, directly or transitively. Sets the
/// types of Read and Written parameters accordingly.
void unify_ranges(Network& network) {
    Classes classes(network.variables.size());
    // For each parameter of each template: the first variable that is bound to the parameter.
    std::vector<std::vector<Id<Variable>>> first(network.templates.size());
    for (const Id<Network::Template> id : network.templates.ids())
        first[id.index].resize(network.templates[id].parameters.size());
    for (const Network::Process& process : network.processes) {
        for (std::size_t i = 0; i < process.arguments.size(); ++i) {
            const auto* variable = std::get_if<Id<Variable>>(&process.arguments[i]);
            if (!variable || network.variables[*variable].type.boolean) continue;
            Id<Variable>& other = first[process.automaton.index][i];
            if (other.valid()) classes.join(variable->index, other.index);
            other = *variable;
        }
    }
    for (const Id<Variable> id : network.variables.ids()) {
        const Type& type = network.variables[id].type;
        Type& hull = network.variables[{classes.of(id.index)}].type;
        hull.low = std::min(hull.low, type.low);
        hull.high = std::max(hull.high, type.high);
    }
    for (const Id<Variable> id : network.variables.ids())
        network.variables[id].type = network.variables[{classes.of(id.index)}].type;
    for (const Id<Network::Template> id : network.templates.ids()) {
        Network::Template& automaton = network.templates[id];
        for (const Id<Network::Parameter> parameter : automaton.parameters.ids())
            if (const Id<Variable> variable = first[id.index][parameter.index]; variable.valid())
                automaton.parameters[parameter].type = network.variables[variable].type;
    }
}

/// Returns the terms that replace the parameters and variables of a component in a template. In general, this term is a
/// parameter of the template. An input that is bound to a term is replaced by this term, so that its value is exact in
/// every state, including states between the moves of one instant. If an automaton computed the term, the value would
/// be delayed.
std::vector<Id<Expr>> read_as(const ClosedLoop& loop, const Component& component,
                              const std::vector<ClosedLoop::Argument>& arguments, Exprs& to) {
    TermCopier term(loop.exprs, to, [&](const Expr& leaf) {
        const ClosedLoop::Symbol& symbol = loop.symbols[{static_cast<std::uint32_t>(leaf.value)}];
        return to.leaf(Op::Variable, std::get<ClosedLoop::SharedSymbol>(symbol).shared.index);
    });
    std::vector<Id<Expr>> list;
    std::uint32_t next = 0;
    for (const ClosedLoop::Argument& argument : arguments) {
        const auto* bound = std::get_if<Id<Expr>>(&argument);
        list.push_back(bound != nullptr ? term(*bound) : to.leaf(Op::Parameter, next++));
    }
    for (std::size_t k = 0; k < component.variables.size(); ++k) list.push_back(to.leaf(Op::Parameter, next++));
    return list;
}

bool has_terms(const ClosedLoop::Instance& instance) {
    return std::ranges::any_of(instance.arguments,
                               [](const auto& each) { return std::holds_alternative<Id<Expr>>(each); });
}

/// Copies the terms of one component into the network. Durations are converted to time units, and names are replaced.
class Terms {
public:
    Terms(const Component& component, std::int64_t unit, std::vector<Id<Expr>> names, Exprs& to)
        : copy_(component.exprs, to,
                [unit, &to, own = component.parameters.size(), names = std::move(names)](const Expr& node) {
                    if (node.op == Op::Duration) return to.integer(node.value / unit);
                    const auto index = static_cast<std::size_t>(node.value);
                    return names[node.op == Op::Parameter ? index : own + index];
                }) {}

    Id<Expr> operator()(Id<Expr> root) { return copy_(root); }

    std::vector<Network::ClockConstraint> constraints(const std::vector<Component::ClockConstraint>& from) {
        std::vector<Network::ClockConstraint> list;
        for (const Component::ClockConstraint& constraint : from)
            list.push_back({{constraint.clock.index}, constraint.relation, (*this)(constraint.bound)});
        return list;
    }

private:
    TermCopier copy_;
};

Table<Network::Parameter> parameters(const Component& component, const std::vector<ClosedLoop::Argument>& arguments) {
    const auto type = [](Component::ValueKind value) {
        return value == Component::ValueKind::Boolean ? Type{} : integer_type(least_integer, greatest_integer);
    };
    const auto kind = [](Component::ParameterKind from) {
        switch (from) {
        case Component::ParameterKind::Input: return Network::ParameterKind::Read;
        case Component::ParameterKind::Output: return Network::ParameterKind::Written;
        case Component::ParameterKind::Constant: return Network::ParameterKind::Constant;
        }
        unreachable();
    };
    Table<Network::Parameter> list;
    for (const Id<Component::Parameter> id : component.parameters.ids()) {
        if (std::holds_alternative<Id<Expr>>(arguments[id.index])) continue;
        const Component::Parameter& parameter = component.parameters[id];
        list.add({parameter.name, kind(parameter.kind), type(parameter.value)});
    }
    for (const Component::Variable& variable : component.variables)
        list.add({variable.name, Network::ParameterKind::Written, type(variable.value)});
    return list;
}

Network::Edge edge_of(const Component::Edge& from, Terms& terms) {
    Network::Edge edge{.from = {from.from.index}, .to = {from.to.index}, .urgent = from.urgent};
    edge.guard = terms(from.guard);
    edge.constraint = terms.constraints(from.constraint);
    for (const Component::Assignment& assignment : from.assignments)
        edge.assignments.push_back({terms(assignment.target), terms(assignment.value)});
    for (const Id<Component::Clock> clock : from.resets) edge.resets.push_back({clock.index});
    edge.origin = from.origin;
    return edge;
}

Network::Template template_of(const ClosedLoop& loop, const Component& component,
                              const std::vector<ClosedLoop::Argument>& arguments, std::int64_t unit, Exprs& exprs) {
    Terms terms(component, unit, read_as(loop, component, arguments, exprs), exprs);
    Network::Template automaton;
    automaton.name = component.name;
    automaton.parameters = parameters(component, arguments);
    for (const Component::Clock& clock : component.clocks) automaton.clocks.add({clock.name});
    for (const Component::Location& location : component.locations)
        automaton.locations.add({location.name, terms.constraints(location.invariant), location.origin});
    automaton.initial = {component.initial.valid() ? component.initial.index : 0};
    for (const Component::Edge& edge : component.edges) automaton.edges.add(edge_of(edge, terms));
    automaton.origin = component.origin;
    return automaton;
}

/// Creates the process of an instance. The arguments of the process are the arguments of all parameters that no term
/// replaces, followed by the variables of the instance.
Network::Process process_of(const ClosedLoop::Instance& instance, const Component& component, std::int64_t unit,
                            const std::vector<Id<Network::Variable>>& own) {
    Network::Process process{.name = instance.name, .initial = {instance.initial.index}, .origin = instance.origin};
    process.kind = instance.environment ? Network::ProcessKind::Environment : Network::ProcessKind::Plant;
    for (const Id<Component::Parameter> id : component.parameters.ids()) {
        if (std::holds_alternative<Id<Expr>>(instance.arguments[id.index])) continue;
        const bool duration = component.parameters[id].value == Component::ValueKind::Duration;
        process.arguments.push_back(std::visit(
            overloaded{
                [](Id<ClosedLoop::Shared> shared) -> Network::Argument { return Id<Network::Variable>{shared.index}; },
                [&](std::int64_t constant) -> Network::Argument { return duration ? constant / unit : constant; },
                [](Id<Expr>) -> Network::Argument { unreachable(); },
            },
            instance.arguments[id.index]));
    }
    process.arguments.insert(process.arguments.end(), own.begin(), own.end());
    return process;
}

/// Widens the types of integer parameters that are bound to constants, so that they include all these constants.
void admit_arguments(Network& network) {
    for (const Network::Process& process : network.processes) {
        Table<Network::Parameter>& list = network.templates[process.automaton].parameters;
        for (const Id<Network::Parameter> parameter : list.ids()) {
            const auto* value = std::get_if<std::int64_t>(&process.arguments[parameter.index]);
            if (!value || list[parameter].type.boolean) continue;
            list[parameter].type.low = std::min(list[parameter].type.low, *value);
            list[parameter].type.high = std::max(list[parameter].type.high, *value);
        }
    }
}

}  // namespace

std::optional<Network> plant(const Model& model, const ClosedLoop& loop, Diagnostics& diagnostics) {
    const std::optional<std::int64_t> unit = time_unit(model, loop, diagnostics);
    std::optional<PlantVariables> variables = plant_variables(model, loop, diagnostics);
    if (!unit || !variables) return {};

    Network network;
    network.name = loop.name;
    network.grain = loop.grain;
    network.time_unit_ms = *unit;
    network.constants = loop.constants;
    network.variables = std::move(variables->variables);
    std::vector<Id<Network::Template>> templates(model.components.size());
    UniqueNames names;  // names of templates that are already used
    for (const Component& component : model.components) names.fresh(component.name);
    for (const Id<ClosedLoop::Instance> id : loop.instances.ids()) {
        const ClosedLoop::Instance& instance = loop.instances[id];
        const Component& component = model.components[instance.component];
        const bool alone = has_terms(instance);
        Id<Network::Template> automaton = alone ? Id<Network::Template>{} : templates[instance.component.index];
        if (!automaton.valid())
            automaton = network.templates.add(template_of(loop, component, instance.arguments, *unit, network.exprs));
        if (alone) network.templates[automaton].name = names.fresh(component.name + "_" + instance.name);
        else templates[instance.component.index] = automaton;
        Network::Process process = process_of(instance, component, *unit, variables->own[id.index]);
        process.automaton = automaton;
        network.processes.add(std::move(process));
    }
    unify_ranges(network);
    admit_arguments(network);

    const std::size_t errors = diagnostics.errors();
    check_urgent_invariants(network, diagnostics);
    warn_skipped_ranges(network, diagnostics);
    if (diagnostics.errors() != errors) return {};
    assert(verify(network).empty());
    return network;
}

}  // namespace grafverif
