// SPDX-License-Identifier: MIT
#include "run/network_walk.hpp"

#include <algorithm>

#include "support/overloaded.hpp"

namespace grafverif {

namespace {

const Network::Template& automaton(const Network& network, const Network::Process& process) {
    return network.templates[process.automaton];
}

void lower(std::optional<std::int64_t>& least, std::int64_t value) { least = least ? std::min(*least, value) : value; }

/// Returns the greatest integer clock value that the constraint admits.
std::int64_t greatest(Op relation, std::int64_t bound) { return relation == Op::Less ? bound - 1 : bound; }

/// Returns the time until the invariant of the current location prevents time from passing, or nothing if the invariant
/// has no upper bound.
std::optional<std::int64_t> delay_limit(const Network& network, const NetworkState& state, Id<Network::Process> id) {
    const Network::Process& process = network.processes[id];
    std::optional<std::int64_t> limit;
    for (const Network::ClockConstraint& bound :
         automaton(network, process).locations[state.locations[id.index]].invariant)
        lower(limit, greatest(bound.relation, bound_value(network, process, bound.bound)) -
                         state.clocks[id.index][bound.clock.index]);
    return limit;
}

bool guard_holds(const Network& network, const NetworkState& state, const Network::Process& process, Id<Expr> guard) {
    const auto meaning = [&](const Expr& leaf) -> std::int64_t {
        const auto index = static_cast<std::size_t>(leaf.value);
        if (leaf.op == Op::Variable) return state.variables[index];
        return std::visit(overloaded{[&](Id<Network::Variable> variable) { return state.variables[variable.index]; },
                                     [](std::int64_t constant) { return constant; }},
                          process.arguments[index]);
    };
    return evaluate(network.exprs, guard, meaning).value_or(0) != 0;
}

/// Returns the number of time units until the clock constraint of `edge` first holds, or nothing if it never holds
/// again.
std::optional<std::int64_t> wait(const Network& network, const NetworkState& state, Id<Network::Process> id,
                                 const Network::Edge& edge) {
    std::int64_t from = 0;
    std::optional<std::int64_t> until;
    for (const Network::ClockConstraint& constraint : edge.constraint) {
        const std::int64_t bound = bound_value(network, network.processes[id], constraint.bound);
        const std::int64_t clock = state.clocks[id.index][constraint.clock.index];
        const Op relation = constraint.relation;
        if (relation == Op::Equal || relation == Op::GreaterEqual) from = std::max(from, bound - clock);
        if (relation == Op::Greater) from = std::max(from, bound + 1 - clock);
        if (relation != Op::GreaterEqual && relation != Op::Greater) lower(until, greatest(relation, bound) - clock);
    }
    if (until && *until < from) return {};
    return from;
}

}  // namespace

Leeway leeway(const Network& network, const NetworkState& state) {
    Leeway leeway;
    leeway.may_pass = may_delay(network, state);
    for (const Id<Network::Process> id : network.processes.ids()) {
        const Network::Process& process = network.processes[id];
        if (const auto limit = delay_limit(network, state, id)) lower(leeway.limit, *limit);
        for (const Network::Edge& edge : automaton(network, process).edges) {
            if (edge.from != state.locations[id.index] || edge.constraint.empty()) continue;
            const std::optional<std::int64_t> units = wait(network, state, id, edge);
            if (units && *units > 0 && guard_holds(network, state, process, edge.guard)) lower(leeway.change, *units);
        }
    }
    return leeway;
}

std::vector<Network::ClockConstraint> reached_bounds(const Network& network, const NetworkState& state,
                                                     Id<Network::Process> id) {
    const Network::Process& process = network.processes[id];
    std::vector<Network::ClockConstraint> found =
        automaton(network, process).locations[state.locations[id.index]].invariant;
    std::erase_if(found, [&](const Network::ClockConstraint& bound) {
        return greatest(bound.relation, bound_value(network, process, bound.bound)) >
               state.clocks[id.index][bound.clock.index];
    });
    return found;
}

std::vector<Id<Network::Process>> impatient(const Network& network, const NetworkState& state) {
    std::vector<bool> urgent(network.processes.size());
    for (const Fire& move : enabled(network, state))
        if (automaton(network, network.processes[move.process]).edges[move.edge].urgent)
            urgent[move.process.index] = true;
    std::vector<Id<Network::Process>> found;
    for (const Id<Network::Process> id : network.processes.ids())
        if (urgent[id.index] || !reached_bounds(network, state, id).empty()) found.push_back(id);
    return found;
}

bool continue_without_delay(const Network& network, Run& run, std::vector<NetworkState>& states) {
    constexpr std::size_t longest = 10'000;
    const std::size_t end = states.size() - 1;
    while (!run.loop) {
        const std::vector<Id<Network::Process>> blocking = impatient(network, states.back());
        const std::vector<Fire> moves = enabled(network, states.back());
        const auto move = std::ranges::find_if(
            moves, [&](const Fire& one) { return std::ranges::find(blocking, one.process) != blocking.end(); });
        if (move == moves.end()) return true;
        NetworkState next = states.back();
        if (states.size() - end > longest || perform(network, next, *move).result != Step::Result::Done) return false;
        const auto seen = std::find(states.begin() + static_cast<std::ptrdiff_t>(end), states.end(), next);
        if (seen != states.end()) run.loop = static_cast<std::size_t>(seen - states.begin());
        run.moves.emplace_back(*move);
        states.push_back(std::move(next));
    }
    return true;
}

}  // namespace grafverif
