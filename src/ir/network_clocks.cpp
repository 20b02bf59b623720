// SPDX-License-Identifier: MIT
#include "ir/network_clocks.hpp"

#include <algorithm>

#include "support/overloaded.hpp"

namespace grafverif {

namespace {

std::int64_t constant(const Network& network, Id<Expr> bound) {
    const auto value = evaluate(network.exprs, bound, [](const Expr&) -> std::int64_t { return 0; });
    return std::clamp(value.value_or(0), -ClockInterval::unbounded, ClockInterval::unbounded);
}

/// Returns the cap for one comparison: the least value from which on the result is the same for all clock values.
std::int64_t cap_of(const ClockInterval& interval) {
    if (interval.high >= ClockInterval::unbounded) return std::max<std::int64_t>(interval.low, 0);
    return std::max<std::int64_t>(interval.high + 1, 0);
}

/// Sets `greatest` to `value` if `value` is greater. Returns true if this changes `greatest`.
bool raise(std::int64_t& greatest, std::int64_t value) {
    if (value <= greatest) return false;
    greatest = value;
    return true;
}

/// Raises the caps and the greatest constants of `location` to cover `constraints`.
void compare(const Network& network, const std::vector<Network::ClockConstraint>& constraints, std::uint32_t location,
             ProcessClocks& clocks) {
    for (const Network::ClockConstraint& constraint : constraints) {
        const ClockInterval interval = admitted(network, constraint);
        const std::uint32_t clock = constraint.clock.index;
        raise(clocks.cap[location][clock], cap_of(interval));
        raise(clocks.lower[location][clock], interval.low);
        if (interval.high < ClockInterval::unbounded)
            raise(clocks.upper[location][clock], std::max<std::int64_t>(interval.high, 0));
    }
}

/// Propagates the constants and bounds at the target of each edge to its source, for each clock that the edge does not
/// reset. The propagation is repeated until a fixed point is reached.
ProcessClocks analyse(const Network& network, const Network::Template& automaton) {
    const std::size_t clocks = automaton.clocks.size();
    ProcessClocks result;
    result.cap.assign(automaton.locations.size(), std::vector<std::int64_t>(clocks, ProcessClocks::dead));
    result.bounded.assign(automaton.locations.size(), std::vector<bool>(clocks, false));
    result.greatest.assign(clocks, 0);
    result.lower.assign(automaton.locations.size(), std::vector<std::int64_t>(clocks, 0));
    result.upper.assign(automaton.locations.size(), std::vector<std::int64_t>(clocks, ProcessClocks::no_upper));
    if (clocks == 0) return result;
    std::vector<std::vector<std::uint32_t>> entering(automaton.locations.size());
    for (const Id<Network::Edge> edge : automaton.edges.ids())
        entering[automaton.edges[edge].to.index].push_back(edge.index);

    std::vector<std::uint32_t> changed;
    for (const Id<Network::Location> location : automaton.locations.ids()) {
        compare(network, automaton.locations[location].invariant, location.index, result);
        for (const Network::ClockConstraint& bound : automaton.locations[location].invariant)
            result.bounded[location.index][bound.clock.index] = true;
        changed.push_back(location.index);
    }
    for (const Network::Edge& edge : automaton.edges) compare(network, edge.constraint, edge.from.index, result);
    while (!changed.empty()) {
        const std::uint32_t target = changed.back();
        changed.pop_back();
        for (const std::uint32_t index : entering[target]) {
            const Network::Edge& edge = automaton.edges[{index}];
            bool grew = false;
            for (std::uint32_t clock = 0; clock < clocks; ++clock) {
                if (resets(edge, {clock})) continue;
                const std::uint32_t source = edge.from.index;
                for (auto* constants : {&result.cap, &result.lower, &result.upper})
                    grew = raise((*constants)[source][clock], (*constants)[target][clock]) || grew;
                if (!result.bounded[target][clock] || result.bounded[source][clock]) continue;
                result.bounded[source][clock] = true;
                grew = true;
            }
            if (grew) changed.push_back(edge.from.index);
        }
    }
    for (const std::vector<std::int64_t>& caps : result.cap)
        for (std::size_t clock = 0; clock < clocks; ++clock)
            result.greatest[clock] = std::max(result.greatest[clock], caps[clock]);
    return result;
}

}  // namespace

ClockInterval admitted(Op relation, std::int64_t bound) {
    switch (relation) {
    case Op::Less: return {0, bound - 1};
    case Op::LessEqual: return {0, bound};
    case Op::Equal: return {bound, bound};
    case Op::GreaterEqual: return {bound, ClockInterval::unbounded};
    case Op::Greater: return {bound + 1, ClockInterval::unbounded};
    default: unreachable();
    }
}

ClockInterval admitted(const Network& network, const Network::ClockConstraint& constraint) {
    return admitted(constraint.relation, constant(network, constraint.bound));
}

std::vector<ClockInterval> admitted(const Network& network, const std::vector<Network::ClockConstraint>& constraints,
                                    std::size_t clocks) {
    std::vector<ClockInterval> result(clocks);
    for (const Network::ClockConstraint& constraint : constraints) {
        const ClockInterval one = admitted(network, constraint);
        ClockInterval& all = result[constraint.clock.index];
        all = {std::max(all.low, one.low), std::min(all.high, one.high)};
    }
    return result;
}

bool resets(const Network::Edge& edge, Id<Network::Clock> clock) {
    return std::ranges::find(edge.resets, clock) != edge.resets.end();
}

bool waits_only(const Network::Edge& edge) {
    return std::ranges::all_of(edge.constraint, [](const Network::ClockConstraint& constraint) {
        return constraint.relation == Op::Greater || constraint.relation == Op::GreaterEqual;
    });
}

EdgeTiming timing_of(const Network& network, const ProcessClocks& clocks, const Network::Template& automaton,
                     const Network::Edge& edge) {
    const std::size_t count = automaton.clocks.size();
    const auto& invariant = automaton.locations[edge.from].invariant;
    const std::vector<ClockInterval> wanted = admitted(network, edge.constraint, count);
    const std::vector<ClockInterval> given = admitted(network, invariant, count);
    const std::vector<ClockInterval> after = admitted(network, automaton.locations[edge.to].invariant, count);
    EdgeTiming timing{.always = true, .at_last = true};
    std::vector<std::uint32_t> relevant;
    for (std::uint32_t clock = 0; clock < count; ++clock) {
        const bool reset = resets(edge, {clock});
        const bool stays = reset ? after[clock].contains(0) : after[clock].low <= 0;
        const bool free = stays && wanted[clock].low <= 0 && wanted[clock].high >= given[clock].high &&
                          (reset || given[clock].high <= after[clock].high);
        if (!free) relevant.push_back(clock);
        timing.always = timing.always && free;
        timing.at_last = timing.at_last && wanted[clock].high >= ClockInterval::unbounded &&
                         (reset ? stays : after[clock].high >= ClockInterval::unbounded);
    }
    for (std::size_t bound = 0; bound < std::min<std::size_t>(invariant.size(), 63); ++bound) {
        const std::uint32_t clock = invariant[bound].clock.index;
        const std::int64_t value = admitted(network, invariant[bound]).high;
        const bool reset = resets(edge, {clock});
        const bool other = std::ranges::any_of(relevant, [&](std::uint32_t one) { return one != clock; });
        if (other || !wanted[clock].contains(value) || !after[clock].contains(reset ? 0 : value)) continue;
        timing.covers |= std::uint64_t{1} << bound;
        if (reset || !clocks.bounded[edge.to.index][clock]) timing.frees |= std::uint64_t{1} << bound;
    }
    return timing;
}

std::vector<ProcessClocks> analyse_clocks(const Network& network) {
    std::vector<ProcessClocks> result;
    for (const Network::Process& process : network.processes)
        result.push_back(analyse(network, network.templates[process.automaton]));
    return result;
}

}  // namespace grafverif
