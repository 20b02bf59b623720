// SPDX-License-Identifier: MIT
#include "ir/network_run.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "support/overloaded.hpp"

namespace grafverif {

namespace {

/// Returns the value of a leaf under the arguments of `process`.
std::function<std::int64_t(const Expr&)> meaning(const NetworkState& state, const Network::Process& process) {
    return [&](const Expr& leaf) -> std::int64_t {
        const auto index = static_cast<std::size_t>(leaf.value);
        if (leaf.op == Op::Variable) return state.variables[index];
        return std::visit(overloaded{[&](Id<Network::Variable> variable) { return state.variables[variable.index]; },
                                     [](std::int64_t constant) { return constant; }},
                          process.arguments[index]);
    };
}

bool holds(Op relation, std::int64_t clock, std::int64_t bound) {
    if (relation == Op::Less) return clock < bound;
    if (relation == Op::LessEqual) return clock <= bound;
    if (relation == Op::Equal) return clock == bound;
    if (relation == Op::GreaterEqual) return clock >= bound;
    return clock > bound;
}

bool satisfied(const Network& network, Id<Network::Process> process,
               const std::vector<Network::ClockConstraint>& constraints, const std::vector<std::int64_t>& clocks) {
    return std::ranges::all_of(constraints, [&](const Network::ClockConstraint& constraint) {
        const std::int64_t bound = bound_value(network, network.processes[process], constraint.bound);
        return holds(constraint.relation, clocks[constraint.clock.index], bound);
    });
}

Id<Network::Variable> target_of(const Network& network, const Network::Process& process, Id<Expr> target) {
    const Expr& leaf = network.exprs[target];
    const auto index = static_cast<std::uint32_t>(leaf.value);
    if (leaf.op == Op::Variable) return {index};
    return std::get<Id<Network::Variable>>(process.arguments[index]);
}

Step assign(const Network& network, NetworkState& state, const Network::Process& process,
            const std::vector<Network::Assignment>& assignments) {
    for (const Network::Assignment& assignment : assignments) {
        const Id<Network::Variable> target = target_of(network, process, assignment.target);
        const auto result = evaluate(network.exprs, assignment.value, meaning(state, process));
        if (!result) return {Step::Result::NoValue, target};
        const Type& type = network.variables[target].type;
        if (*result < type.low || *result > type.high) return {Step::Result::OutOfRange, target};
        state.variables[target.index] = *result;
    }
    return {};
}

/// Checks if the edge can be taken. If the edge can be taken, `clocks` receives the clocks of its process after resets.
Step begin(const Network& network, const NetworkState& state, const Fire& move, std::vector<std::int64_t>& clocks) {
    const Network::Process& process = network.processes[move.process];
    const Network::Template& shape = automaton(network, move.process);
    const Network::Edge& edge = shape.edges[move.edge];
    if (state.locations[move.process.index] != edge.from) return {Step::Result::Blocked, {}};
    const auto guard = evaluate(network.exprs, edge.guard, meaning(state, process));
    if (!guard) return {Step::Result::NoValue, {}};
    clocks = state.clocks[move.process.index];
    if (*guard == 0 || !satisfied(network, move.process, edge.constraint, clocks)) return {Step::Result::Blocked, {}};

    for (const Id<Network::Clock> clock : edge.resets) clocks[clock.index] = 0;
    const bool allowed = satisfied(network, move.process, shape.locations[edge.to].invariant, clocks);
    return {allowed ? Step::Result::Done : Step::Result::Blocked, {}};
}

Step fire(const Network& network, NetworkState& state, const Fire& move) {
    std::vector<std::int64_t> clocks;
    if (const Step step = begin(network, state, move, clocks); step.result != Step::Result::Done) return step;
    const Network::Process& process = network.processes[move.process];
    const Network::Template& shape = automaton(network, move.process);
    const Network::Edge& edge = shape.edges[move.edge];
    state.clocks[move.process.index] = std::move(clocks);
    if (const Step step = assign(network, state, process, edge.assignments); step.result != Step::Result::Done)
        return step;
    for (const Id<Network::Procedure> call : edge.calls) {
        const Step step = assign(network, state, process, shape.procedures[call].assignments);
        if (step.result != Step::Result::Done) return step;
    }
    state.locations[move.process.index] = edge.to;
    return {};
}

Step pass(const Network& network, NetworkState& state, std::int64_t units) {
    if (units <= 0 || urgent_edge_waits(network, state)) return {Step::Result::Blocked, {}};
    for (std::vector<std::int64_t>& clocks : state.clocks)
        for (std::int64_t& clock : clocks) clock += units;
    const auto allowed = [&](Id<Network::Process> process) {
        const Network::Location& location = automaton(network, process).locations[state.locations[process.index]];
        return satisfied(network, process, location.invariant, state.clocks[process.index]);
    };
    return {std::ranges::all_of(network.processes.ids(), allowed) ? Step::Result::Done : Step::Result::Blocked, {}};
}

}  // namespace

NetworkState initial_state(const Network& network) {
    NetworkState state;
    for (const Network::Variable& variable : network.variables) state.variables.push_back(variable.initial);
    for (const Id<Network::Process> process : network.processes.ids()) {
        state.locations.push_back(network.processes[process].initial);
        state.clocks.emplace_back(automaton(network, process).clocks.size(), 0);
    }
    return state;
}

Step perform(const Network& network, NetworkState& state, const Move& move) {
    NetworkState next = state;
    const Step step = std::visit(overloaded{[&](const Delay& delay) { return pass(network, next, delay.units); },
                                            [&](const Fire& edge) { return fire(network, next, edge); }},
                                 move);
    if (step.result == Step::Result::Done) state = std::move(next);
    return step;
}

std::vector<Fire> enabled(const Network& network, const NetworkState& state) {
    std::vector<Fire> moves;
    std::vector<std::int64_t> clocks;
    for (const Id<Network::Process> process : network.processes.ids()) {
        const Network::Template& shape = automaton(network, process);
        for (const Id<Network::Edge> edge : shape.edges.ids()) {
            const Fire move{process, edge};
            if (begin(network, state, move, clocks).result != Step::Result::Blocked) moves.push_back(move);
        }
    }
    return moves;
}

bool urgent_edge_waits(const Network& network, const NetworkState& state) {
    return std::ranges::any_of(enabled(network, state),
                               [&](const Fire& move) { return taken_edge(network, move).urgent; });
}

bool may_delay(const Network& network, const NetworkState& state) {
    NetworkState next = state;
    return perform(network, next, Delay{1}).result == Step::Result::Done;
}

std::optional<std::int64_t> value(const Network& network, const NetworkState& state, Id<Expr> expr) {
    return evaluate(network.exprs, expr, [&](const Expr& leaf) -> std::int64_t {
        if (leaf.op == Op::At) return state.locations[at_process(leaf)].index == at_location(leaf) ? 1 : 0;
        return state.variables[static_cast<std::size_t>(leaf.value)];
    });
}

std::optional<std::vector<NetworkState>> replay(const Network& network, const Run& run) {
    std::vector<NetworkState> states = {initial_state(network)};
    for (const Move& move : run.moves) {
        NetworkState next = states.back();
        if (perform(network, next, move).result != Step::Result::Done) return {};
        states.push_back(std::move(next));
    }
    if (!run.loop) return states;
    if (*run.loop >= run.moves.size()) return {};
    const auto same = [&](const NetworkState& left, const NetworkState& right) {
        if (left.locations != right.locations) return false;
        return std::ranges::all_of(network.variables.ids(), [&](Id<Network::Variable> variable) {
            return network.variables[variable].scratch ||
                   left.variables[variable.index] == right.variables[variable.index];
        });
    };
    if (!same(states[*run.loop], states.back())) return {};
    return states;
}

}  // namespace grafverif
