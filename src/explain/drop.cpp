// SPDX-License-Identifier: MIT
#include "explain/drop.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "support/overloaded.hpp"

namespace grafverif {

namespace {

/// More values of one variable than this are too many.
constexpr std::int64_t most_values = 64;

Network::Template& automaton_of(Network& network, Id<Network::Process> process) {
    return network.templates[network.processes[process].automaton];
}

/// What an instance writes, and which flags it sets with it.
using Written = std::map<std::uint32_t, std::vector<Network::Assignment>>;

Written written_by(const Network& network, const Network::Template& automaton) {
    const auto variable_of = [&](const Network::Assignment& assignment) {
        return static_cast<std::uint32_t>(network.exprs[assignment.target].value);
    };
    const auto is_flag = [&](const Network::Assignment& assignment) {
        return network.variables[{variable_of(assignment)}].role == Network::Role::Flag;
    };
    Written written;
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

/// The entities of `table` that are not of `step`.
template <class Entity>
Table<Entity> without(const Table<Entity>& table, Id<Chart::Step> step) {
    Table<Entity> rest;
    for (const Entity& entity : table)
        if (entity.step != step) rest.add(entity);
    return rest;
}

// -- terms -------------------------------------------------------------------------------------------------------------

bool has_edge(const Exprs& exprs, Id<Expr> term) {
    const Op op = exprs[term].op;
    return op == Op::Rise || op == Op::Fall ||
           std::ranges::any_of(exprs.operands(term), [&](Id<Expr> operand) { return has_edge(exprs, operand); });
}

bool is_list(Op op) { return op == Op::And || op == Op::Or; }

/// The condition that `place` is in.
template <class ChartOrConst>
auto& condition_of(ChartOrConst& chart, const TermPlace& place) {
    switch (place.of) {
    case TermPlace::Of::Transition: return chart.transitions[{place.index}].condition;
    case TermPlace::Of::Action: return chart.continuous[{place.index}].condition;
    case TermPlace::Of::Event: return chart.stored[{place.index}].event;
    }
    unreachable();
}

/// Adds the operands of lists at and below `place`, where `term` stands.
void collect_operands(const Exprs& exprs, Id<Expr> term, const TermPlace& place, std::vector<TermPlace>& found) {
    const Op op = exprs[term].op;
    if (!is_list(op) && op != Op::Not) return;
    for (std::uint32_t k = 0; k < exprs[term].count; ++k) {
        const Id<Expr> operand = exprs.operands(term)[k];
        TermPlace below = place;
        below.path.push_back(k);
        if (is_list(op) && (place.of != TermPlace::Of::Event || !has_edge(exprs, operand))) found.push_back(below);
        collect_operands(exprs, operand, below, found);
    }
}

void collect_terms(const Exprs& exprs, Id<Expr> condition, const TermPlace& place, std::vector<TermPlace>& found) {
    const Op op = exprs[condition].op;
    if (!is_list(op) && !is_constant(op) && place.of != TermPlace::Of::Event) found.push_back(place);
    collect_operands(exprs, condition, place, found);
}

/// `term` without what stands at the end of `path`.
Id<Expr> without_term(Exprs& exprs, Id<Expr> term, std::span<const std::uint32_t> path) {
    if (path.empty()) return exprs.constant(true);
    const Op op = exprs[term].op;
    std::vector<Id<Expr>> operands(exprs.operands(term).begin(), exprs.operands(term).end());
    if (path.size() == 1) operands.erase(operands.begin() + path.front());
    else operands[path.front()] = without_term(exprs, operands[path.front()], path.subspan(1));
    return exprs.apply(op, operands);
}

// -- plants ------------------------------------------------------------------------------------------------------------

/// The component of the instance, which no other instance has any more.
Component& own_component(Model& model, Id<ClosedLoop> loop, Id<ClosedLoop::Instance> instance) {
    ClosedLoop::Instance& of = model.loops[loop].instances[instance];
    Component own = model.components[of.component];
    const auto taken = [&](const Component& other) { return other.name == own.name; };
    while (std::ranges::any_of(model.components, taken)) own.name += "_";
    of.component = model.components.add(std::move(own));
    return model.components[of.component];
}

}  // namespace

void drop_transition(Chart& chart, Id<Chart::Transition> transition) {
    chart.transitions[transition].condition = chart.exprs.constant(false);
}

bool drop_actions(Chart& chart, Id<Chart::Step> step) {
    const std::size_t had = chart.continuous.size() + chart.forcing.size();
    chart.continuous = without(chart.continuous, step);
    chart.forcing = without(chart.forcing, step);
    bool any = chart.continuous.size() + chart.forcing.size() != had;
    // A variable that actions store in stays one, whose value is kept: the action waits for what never happens.
    for (Chart::StoredAction& action : chart.stored) {
        if (action.step != step || action.on == Chart::StoredOn::Clearing) continue;
        action.on = Chart::StoredOn::Event;
        action.event = chart.exprs.constant(false);
        any = true;
    }
    return any;
}

std::vector<TermPlace> terms_of(const Chart& chart) {
    std::vector<TermPlace> found;
    const auto collect = [&](TermPlace::Of of, std::uint32_t index, Id<Expr> condition) {
        if (condition.valid()) collect_terms(chart.exprs, condition, {of, index, {}}, found);
    };
    for (const auto id : chart.transitions.ids())
        collect(TermPlace::Of::Transition, id.index, chart.transitions[id].condition);
    for (const auto id : chart.continuous.ids())
        collect(TermPlace::Of::Action, id.index, chart.continuous[id].condition);
    for (const auto id : chart.stored.ids()) collect(TermPlace::Of::Event, id.index, chart.stored[id].event);
    return found;
}

Id<Expr> term_at(const Chart& chart, const TermPlace& place) {
    Id<Expr> term = condition_of(chart, place);
    for (const std::uint32_t operand : place.path) term = chart.exprs.operands(term)[operand];
    return term;
}

void drop_term(Chart& chart, const TermPlace& place) {
    condition_of(chart, place) = without_term(chart.exprs, condition_of(chart, place), place.path);
}

bool drop_edge(Model& model, Id<ClosedLoop> loop, Id<ClosedLoop::Instance> instance, Id<Component::Edge> edge) {
    Component& own = own_component(model, loop, instance);
    own.edges[edge].guard = own.exprs.constant(false);
    std::vector<Component::ClockConstraint>& invariant = own.locations[own.edges[edge].from].invariant;
    const bool forced = own.edges[edge].urgent || !invariant.empty();
    invariant.clear();
    return forced;
}

bool drop_guard(Model& model, Id<ClosedLoop> loop, Id<ClosedLoop::Instance> instance, Id<Component::Edge> edge) {
    const Component& component = model.components[model.loops[loop].instances[instance].component];
    if (!component.edges[edge].urgent && is_true(component.exprs, component.edges[edge].guard)) return false;
    Component& own = own_component(model, loop, instance);
    own.edges[edge].guard = own.exprs.constant(true);
    own.edges[edge].urgent = false;
    return true;
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
    const Written written = written_by(network, automaton);
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
