// SPDX-License-Identifier: MIT
#include "explain/counterfactual.hpp"

#include <algorithm>

#include "ir/network_run.hpp"
#include "ir/patterns.hpp"

namespace grafverif {

namespace {

/// Maximum number of edges within one instant. If a run takes more edges in one instant, the loop is assumed to take
/// edges forever without a delay.
constexpr std::size_t most_at_once = 1000;

bool is_free(const Network& network, const Move& move) {
    const Fire* const fire = std::get_if<Fire>(&move);
    if (fire == nullptr) return false;
    const Network::Process& process = network.processes[fire->process];
    const Network::Edge& edge = taken_edge(network, *fire);
    const bool plant = process.kind == Network::ProcessKind::Plant || process.kind == Network::ProcessKind::Environment;
    return plant && !edge.urgent && network.templates[process.automaton].locations[edge.from].invariant.empty();
}

/// Re-executes a run without some of its free moves, move by move.
class Remake {
public:
    /// `timed` is the network with clocks, which determines which moves are free.
    Remake(const Network& network, const Network& timed, std::size_t& effort)
        : network_(network), timed_(timed), effort_(effort), state_(initial_state(network)) {}

    /// Returns true if the move was executed or may be omitted.
    bool make(const Move& move) {
        if (const Delay* const delay = std::get_if<Delay>(&move)) {
            if (perform_it(move) == Step::Result::Done) return true;
            for (std::int64_t unit = 0; unit < delay->units; ++unit)
                if (!after_what_must_be(Delay{1})) return false;
            return true;
        }
        if (is_free(timed_, move)) return after_what_must_be(move);
        const Step::Result result = perform_it(move);
        return result == Step::Result::Done || result == Step::Result::Blocked;
    }

    bool finish() {
        for (std::size_t k = 0; k < most_at_once; ++k) {
            const std::vector<Fire> can = enabled(network_, state_);
            const auto next =
                std::ranges::find_if(can, [&](const Fire& fire) { return taken_edge(network_, fire).urgent; });
            if (next == can.end()) return true;
            if (perform_it(*next) != Step::Result::Done) return false;
        }
        return false;
    }

    Run run() && { return std::move(run_); }

private:
    bool after_what_must_be(const Move& move) {
        for (std::size_t k = 0; k < most_at_once; ++k) {
            const Step::Result result = perform_it(move);
            if (result != Step::Result::Blocked) return result == Step::Result::Done;
            const std::vector<Fire> can = enabled(network_, state_);
            const auto next = std::ranges::find_if(can, [&](const Fire& fire) { return !is_free(timed_, fire); });
            if (next == can.end() || perform_it(*next) != Step::Result::Done) return false;
        }
        return false;
    }

    /// Executes `move`. Returns NoValue also if the maximum effort has been reached.
    Step::Result perform_it(const Move& move) {
        if (effort_ == 0) return Step::Result::NoValue;
        --effort_;
        const Step::Result result = perform(network_, state_, move).result;
        if (result == Step::Result::Done) run_.moves.push_back(move);
        return result;
    }

    const Network& network_;
    const Network& timed_;
    std::size_t& effort_;
    NetworkState state_;
    Run run_ = {};
};

bool checked_good(const Network& network, const Property& property, const NetworkState& state) {
    if (property.at_stable && value(network, state, network.settled) != 1) return true;
    std::size_t holding = 0;
    for (const Id<Expr> operand : property.operands) {
        const auto now = value(network, state, operand);
        if (!now) return false;
        if (*now != 0) ++holding;
    }
    return property.pattern == Pattern::Never ? holding == 0 : holding == 1;
}

bool holds_along(const Network& network, const Property& property, const Run& run) {
    const auto states = replay(network, run);
    return states && std::ranges::all_of(
                         *states, [&](const NetworkState& state) { return checked_good(network, property, state); });
}

/// Returns the run without the free moves `left_out`. Returns nothing if the remaining moves are not a run of the
/// network.
std::optional<Run> without(const Network& network, const Network& timed, const Run& run,
                           const std::vector<std::size_t>& left_out, std::size_t& effort) {
    Remake remake(network, timed, effort);
    for (std::size_t k = 0; k < run.moves.size(); ++k)
        if (std::ranges::find(left_out, k) == left_out.end() && !remake.make(run.moves[k])) return {};
    if (!remake.finish()) return {};
    return std::move(remake).run();
}

}  // namespace

ShortestChange shortest_change(const Network& network, const Property& property, const Run& run, std::size_t effort,
                               const StopRequested& stopped) {
    return shortest_change(network, network, property, run, effort, stopped);
}

ShortestChange shortest_change(const Network& network, const Network& timed, const Property& property, const Run& run,
                               std::size_t effort, const StopRequested& stopped) {
    ShortestChange result;
    if (!is_about_all_states(property.pattern)) return result;
    std::vector<std::size_t> free;
    for (std::size_t k = 0; k < run.moves.size(); ++k)
        if (is_free(timed, run.moves[k])) free.push_back(k);
    result.free_moves = free.size();
    const SmallestSet smallest = smallest_set(free.size(), stopped, [&](const std::vector<std::size_t>& chosen) {
        std::vector<std::size_t> left_out;
        for (const std::size_t each : chosen) left_out.push_back(free[each]);
        auto rest = without(network, timed, run, left_out, effort);
        if (effort == 0) return Attempt::Spent;
        if (!rest || !holds_along(network, property, *rest)) return Attempt::DoesNot;
        result.found = Change{std::move(left_out), std::move(*rest)};
        return Attempt::Does;
    });
    result.tried = smallest.tried;
    result.exhausted = smallest.exhausted;
    return result;
}

}  // namespace grafverif
