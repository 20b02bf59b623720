// SPDX-License-Identifier: MIT
// A lasso is an infinite run that consists of a stem and a loop, which is repeated forever. The loop can be chosen to
// start after any tick that is not in the stem. Let the loop of a part have k ticks, and let tick n
// be outside of the stem of this part; then the actions of the part after ticks n and n + k are
// equal. Therefore the joined run has a loop whose number of ticks is the least common multiple of
// the numbers of ticks in the loops of all parts.
#include "check/decomposition/join.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "ir/network_run.hpp"

namespace grafverif {

namespace {

constexpr std::int64_t longest_loop = 20'000;  // maximum length of a loop in units of time

struct TimedFire {
    std::int64_t time = 0;
    Fire fire = {};
};

/// Returns the number of time units that pass during the moves [first, last).
std::int64_t ticks(const Run& run, std::size_t first, std::size_t last) {
    std::int64_t units = 0;
    for (std::size_t i = first; i < last; ++i)
        if (const auto* const delay = std::get_if<Delay>(&run.moves[i])) units += delay->units;
    return units;
}
std::int64_t stem_ticks(const Run& run) { return ticks(run, 0, run.loop.value_or(run.moves.size())); }
std::int64_t loop_ticks(const Run& run) { return run.loop ? ticks(run, *run.loop, run.moves.size()) : 0; }

/// Appends to `events` all events of `run` before time `end`. Events at time 0 are appended even if `end` is 0. If
/// `run` is a lasso, the loop of `run` is repeated until time `end`, and time must pass in this loop.
void add_fires(const Run& run, std::int64_t end, std::vector<TimedFire>& events) {
    std::int64_t time = 0;
    for (std::size_t i = 0;; ++i) {
        if (i == run.moves.size() && !run.loop) return;
        if (i == run.moves.size()) i = *run.loop;
        if (const auto* const fire = std::get_if<Fire>(&run.moves[i])) {
            events.push_back({time, *fire});
            continue;
        }
        time += std::get<Delay>(run.moves[i]).units;
        if (time >= end) return;
    }
}

/// Builds a run from events with times: inserts a delay between events at different times.
class Writer {
public:
    void wait_until(std::int64_t time) {
        if (time > now_) run.moves.emplace_back(Delay{time - now_});
        now_ = time;
    }
    void write(std::vector<TimedFire> events) {
        std::ranges::stable_sort(events, {}, &TimedFire::time);
        for (const TimedFire& event : events) {
            wait_until(event.time);
            run.moves.emplace_back(event.fire);
        }
    }
    Run run = {};

private:
    std::int64_t now_ = 0;
};

/// Returns the values of all variables, locations and clocks of a state, so that different states have different
/// results.
std::vector<std::int64_t> values_of(const NetworkState& state) {
    std::vector<std::int64_t> values = state.variables;
    for (const Id<Network::Location> location : state.locations) values.push_back(location.index);
    for (const std::vector<std::int64_t>& clocks : state.clocks)
        values.insert(values.end(), clocks.begin(), clocks.end());
    return values;
}

}  // namespace

std::optional<Run> joined(const Run& shown, const std::vector<Run>& others, Ending ending) {
    const std::int64_t shown_ticks = loop_ticks(shown);
    std::vector<TimedFire> events;
    Writer writer;
    if (shown_ticks == 0) {
        const std::int64_t end = stem_ticks(shown);
        for (const Run& other : others) add_fires(other, ending == Ending::Waiting ? end + 1 : end, events);
        const std::size_t stem = shown.loop.value_or(shown.moves.size());
        add_fires({{shown.moves.begin(), shown.moves.begin() + static_cast<std::ptrdiff_t>(stem)}, {}}, end + 1,
                  events);
        writer.write(std::move(events));
        writer.wait_until(end);
        if (shown.loop) writer.run.loop = writer.run.moves.size();
        writer.run.moves.insert(writer.run.moves.end(), shown.moves.begin() + static_cast<std::ptrdiff_t>(stem),
                                shown.moves.end());
        return std::move(writer.run);
    }

    std::int64_t start = stem_ticks(shown), period = shown_ticks;
    for (const Run& other : others) {
        start = std::max(start, stem_ticks(other));
        period = std::lcm(period, loop_ticks(other));
        if (period > longest_loop) return {};
    }
    start += 1;
    for (const Run& other : others) add_fires(other, start + period, events);
    add_fires(shown, start + period, events);
    const auto loop = std::stable_partition(events.begin(), events.end(),
                                            [start](const TimedFire& event) { return event.time < start; });
    writer.write({events.begin(), loop});
    writer.wait_until(start);
    writer.run.loop = writer.run.moves.size();
    writer.write({loop, events.end()});
    writer.wait_until(start + period);
    return std::move(writer.run);
}

Run continued(const Network& network, Run run) {
    NetworkState state = initial_state(network);
    for (const Move& move : run.moves) perform(network, state, move);
    std::map<std::vector<std::int64_t>, std::size_t> seen;  // number of moves before each state of the run
    while (run.moves.size() <= most_moves) {
        const auto [known, fresh] = seen.emplace(values_of(state), run.moves.size());
        if (!fresh) {
            run.loop = known->second;
            return run;
        }
        const std::vector<Fire> moves = enabled(network, state);
        const auto done = std::ranges::find_if(
            moves, [&](const Fire& move) { return perform(network, state, move).result == Step::Result::Done; });
        if (done == moves.end()) return run;
        run.moves.emplace_back(*done);
    }
    return run;
}

}  // namespace grafverif
