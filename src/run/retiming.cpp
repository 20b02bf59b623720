// SPDX-License-Identifier: MIT
#include "run/retiming.hpp"

#include <algorithm>
#include <utility>

#include "ir/network_run.hpp"
#include "ir/patterns.hpp"

namespace grafverif {

namespace {

/// Maximum number of moves by which a run is continued.
constexpr std::size_t most_moves = 10'000;

}  // namespace

/// A constraint: the time of point `to` minus the time of point `from` is at least `least`.
struct Retiming::Difference {
    std::size_t from = 0, to = 0;
    std::int64_t least = 0;
};

Retiming::Retiming(const Network& network, const Run& run) {
    const auto states = replay(network, run);
    if (!states) return;
    std::vector<std::vector<std::size_t>> resets;
    for (const auto& clocks : states->front().clocks) resets.emplace_back(clocks.size(), 0);
    points_.push_back({{}, true, resets, states->front().locations});
    const auto add = [&](std::optional<Fire> fire, const NetworkState& before) {
        points_.push_back({fire, urgent_edge_waits(network, before), resets, before.locations});
    };
    for (std::size_t i = 0; i < run.moves.size(); ++i) {
        const NetworkState& before = (*states)[i];
        if (run.loop == i) {
            add({}, before);
            loop_ = points_.size() - 1;
        }
        const auto* fire = std::get_if<Fire>(&run.moves[i]);
        if (fire == nullptr) continue;
        add(*fire, before);
        for (const Id<Network::Clock> clock : taken_edge(network, *fire).resets)
            resets[fire->process.index][clock.index] = points_.size() - 1;
    }
    add({}, states->back());
}

std::vector<Retiming::Difference> Retiming::differences(const Network& member) const {
    std::vector<Difference> all;
    const auto limit = [&](const std::vector<Network::ClockConstraint>& constraints,
                           const std::vector<std::size_t>& resets, std::size_t at) {
        for (const Network::ClockConstraint& constraint : constraints) {
            const ClockInterval interval = admitted(member, constraint);
            const std::size_t reset = resets[constraint.clock.index];
            if (interval.low > 0) all.push_back({reset, at, interval.low});
            if (interval.high < ClockInterval::unbounded) all.push_back({at, reset, -interval.high});
        }
    };
    for (std::size_t i = 1; i < points_.size(); ++i) {
        const Point& point = points_[i];
        all.push_back({i - 1, i, 0});
        if (point.immediate) all.push_back({i, i - 1, 0});
        for (const Id<Network::Process> process : member.processes.ids())
            limit(automaton(member, process).locations[point.locations[process.index]].invariant,
                  point.resets[process.index], i);
        if (!point.fire) continue;
        const Id<Network::Process> process = point.fire->process;
        const Network::Edge& edge = taken_edge(member, *point.fire);
        limit(edge.constraint, point.resets[process.index], i);
        std::vector<std::size_t> after = point.resets[process.index];
        for (const Id<Network::Clock> clock : edge.resets) after[clock.index] = i;
        limit(automaton(member, process).locations[edge.to].invariant, after, i);
    }
    return all;
}

std::optional<Run> Retiming::fit(const Network& member) const {
    if (points_.empty()) return {};
    const std::vector<Difference> all = differences(member);
    std::vector<std::int64_t> times(points_.size(), 0);
    bool changed = true;
    for (std::size_t round = 0; changed; ++round) {
        if (round > points_.size()) return {};  // the differences contradict each other
        changed = false;
        for (const auto& [from, to, least] : all)
            if (times[to] < times[from] + least) {
                times[to] = times[from] + least;
                changed = true;
            }
    }
    Run run;
    for (std::size_t i = 1; i < points_.size(); ++i) {
        if (const std::int64_t units = times[i] - times[i - 1]; units > 0) run.moves.emplace_back(Delay{units});
        if (loop_ == i) run.loop = run.moves.size();
        if (points_[i].fire) run.moves.emplace_back(*points_[i].fire);
    }
    if (run.loop == run.moves.size()) run.moves.emplace_back(Delay{1});  // adds a delay to a loop without moves
    return run;
}

namespace {

/// Returns the state in which clock values that no constraint distinguishes are replaced by one common value.
NetworkState capped(NetworkState state, const std::vector<ProcessClocks>& clocks) {
    for (std::size_t process = 0; process < state.clocks.size(); ++process)
        for (std::size_t clock = 0; clock < state.clocks[process].size(); ++clock) {
            std::int64_t& value = state.clocks[process][clock];
            value = std::min(value, std::max<std::int64_t>(clocks[process].greatest[clock], 0));
        }
    return state;
}

/// True if the loop of a run can be repeated forever: after some repetitions, each clock has the same value as before
/// the last repetition, or no constraint distinguishes both values.
bool repeats(const Network& network, const Run& run, NetworkState now) {
    const std::vector<ProcessClocks> clocks = analyse_clocks(network);
    const std::size_t length = run.moves.size() - *run.loop;
    NetworkState before = capped(now, clocks);
    for (std::size_t moves = 0; moves < most_moves; moves += length) {
        for (std::size_t i = *run.loop; i < run.moves.size(); ++i)
            if (perform(network, now, run.moves[i]).result != Step::Result::Done) return false;
        const NetworkState after = capped(now, clocks);
        if (after.clocks == before.clocks) return true;
        before = after;
    }
    return false;
}

/// True if no edge can be taken from the state, immediately or after a delay. Sets `stops` to true if time cannot pass
/// forever either.
bool has_no_edges(const Network& network, NetworkState now, bool& stops) {
    const std::vector<ProcessClocks> clocks = analyse_clocks(network);
    for (std::size_t moves = 0; moves < most_moves; ++moves) {
        if (!enabled(network, now).empty()) return false;
        NetworkState next = now;
        stops = perform(network, next, Delay{1}).result != Step::Result::Done;
        if (stops || capped(next, clocks) == capped(now, clocks)) return true;
        now = std::move(next);
    }
    return false;
}

}  // namespace

bool decides(const Network& network, const Run& run, Pattern pattern) {
    const auto states = replay(network, run);
    if (!states) return false;
    if (is_about_states(pattern)) return true;
    const bool live = is_liveness(pattern);
    if (live && run.loop) return repeats(network, run, states->back());
    const bool ends = live || pattern == Pattern::NoTimelock || pattern == Pattern::NoDeadlock;
    // A strict bound may permit a delay of less than one unit.
    if (!ends || run.loop || ClockFacts(network).strict()) return false;
    bool stops = false;
    return has_no_edges(network, states->back(), stops) && (stops || pattern == Pattern::NoDeadlock);
}

}  // namespace grafverif
