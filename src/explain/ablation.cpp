// SPDX-License-Identifier: MIT
#include "explain/ablation.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace grafverif {

namespace {

/// Maximum number of values of an output. An instance with an output that has more values is not removed.
constexpr std::int64_t most_values = 64;

Network::Template& automaton_of(Network& network, Id<Network::Process> process) {
    return network.templates[network.processes[process].automaton];
}

/// The variables that an instance writes, each with the assignments to flags that the instance executes whenever it
/// writes the variable.
using WrittenVariables = std::map<std::uint32_t, std::vector<Network::Assignment>>;

WrittenVariables written_by(const Network& network, const Network::Template& automaton) {
    const auto variable_of = [&](const Network::Assignment& assignment) {
        return static_cast<std::uint32_t>(network.exprs[assignment.target].value);
    };
    const auto is_flag = [&](const Network::Assignment& assignment) {
        return network.variables[{variable_of(assignment)}].role == Network::Role::Flag;
    };
    WrittenVariables written;
    for (const Network::Edge& edge : automaton.edges)
        for (const Network::Assignment& assignment : edge.assignments) {
            if (is_flag(assignment) || network.variables[{variable_of(assignment)}].scratch) continue;
            std::vector<Network::Assignment>& flags = written[variable_of(assignment)];
            for (const Network::Assignment& other : edge.assignments)
                if (is_flag(other) && std::ranges::find(flags, other) == flags.end()) flags.push_back(other);
        }
    return written;
}

void silence_clocks(Network::Template& automaton) {
    for (Network::Location& location : automaton.locations) location.invariant.clear();
    for (Network::Edge& edge : automaton.edges) {
        edge.constraint.clear();
        edge.resets.clear();
    }
}

/// Gives the instance a separate copy of its component, so that a change does not affect other instances. Returns the
/// copy.
Component& own_component(Model& model, Id<ClosedLoop> loop, Id<ClosedLoop::Instance> instance) {
    ClosedLoop::Instance& of = model.loops[loop].instances[instance];
    Component own = model.components[of.component];
    const auto taken = [&](const Component& other) { return other.name == own.name; };
    while (std::ranges::any_of(model.components, taken)) own.name += "_";
    of.component = model.components.add(std::move(own));
    return model.components[of.component];
}

}  // namespace

bool is_forced(const Component& component, Id<Component::Edge> edge) {
    return component.edges[edge].urgent || !component.locations[component.edges[edge].from].invariant.empty();
}

void drop_edge(Model& model, Id<ClosedLoop> loop, Id<ClosedLoop::Instance> instance, Id<Component::Edge> edge) {
    Component& own = own_component(model, loop, instance);
    own.edges[edge].guard = own.exprs.constant(false);
    own.locations[own.edges[edge].from].invariant.clear();
}

bool is_guarded(const Component& component, Id<Component::Edge> edge) {
    return component.edges[edge].urgent || !is_true(component.exprs, component.edges[edge].guard);
}

void drop_guard(Model& model, Id<ClosedLoop> loop, Id<ClosedLoop::Instance> instance, Id<Component::Edge> edge) {
    Component& own = own_component(model, loop, instance);
    own.edges[edge].guard = own.exprs.constant(true);
    own.edges[edge].urgent = false;
}

Network with_ranges_of(const Network& network, const Network& changed) {
    Network wide = expand(changed);
    for (const Id<Network::Variable> id : wide.variables.ids()) wide.variables[id].type = network.variables[id].type;
    return wide;
}

bool drop_timing(Network& network, Id<Network::Process> process) {
    Network::Template& automaton = automaton_of(network, process);
    const auto limits = [](const auto& each) { return !each.empty(); };
    const bool had = std::ranges::any_of(automaton.locations, limits, &Network::Location::invariant) ||
                     std::ranges::any_of(automaton.edges, limits, &Network::Edge::constraint);
    silence_clocks(automaton);
    return had;
}

bool drop_instance(Network& network, Id<Network::Process> process, bool roams) {
    Network::Template& automaton = automaton_of(network, process);
    const WrittenVariables written = written_by(network, automaton);
    for (const auto& [variable, flags] : written) {
        const Type& type = network.variables[{variable}].type;
        if (type.high - type.low >= most_values) return false;
    }
    if (std::ranges::any_of(automaton.edges, [](const Network::Edge& edge) { return !edge.calls.empty(); }))
        return false;
    const Span origin = network.processes[process].origin;
    const Id<Expr> always = network.exprs.constant(true);
    automaton.edges = {};
    silence_clocks(automaton);
    for (const Id<Network::Location> from : automaton.locations.ids()) {
        if (!roams && from != network.processes[process].initial) continue;
        for (const Id<Network::Location> to : automaton.locations.ids())
            if (from != to && roams) automaton.edges.add({.from = from, .to = to, .guard = always, .origin = origin});
        for (const auto& [variable, flags] : written) {
            const Id<Expr> target = network.exprs.leaf(Op::Variable, variable);
            const Type type = network.variables[{variable}].type;
            for (std::int64_t value = type.low; value <= type.high; ++value) {
                const Id<Expr> now = type.boolean ? network.exprs.constant(value != 0) : network.exprs.integer(value);
                const Id<Expr> same = type.boolean ? (value != 0 ? target : network.exprs.negation(target))
                                                   : network.exprs.apply(Op::Equal, target, now);
                Network::Edge edge{.from = from, .to = from, .guard = network.exprs.negation(same), .origin = origin};
                edge.assignments = {{target, now}};
                edge.assignments.insert(edge.assignments.end(), flags.begin(), flags.end());
                automaton.edges.add(std::move(edge));
            }
        }
    }
    return true;
}

}  // namespace grafverif
