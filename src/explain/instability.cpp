// SPDX-License-Identifier: MIT
#include "explain/instability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "ir/network_run.hpp"
#include "ir/patterns.hpp"

namespace grafverif {

namespace {

using Event = ChartRun::Event;

/// Returns the active steps of `controller`, or `none` if no step is active.
std::string situation_of(const ChartRun& run, const ChartRun::Controller& controller, const ChartRun::State& state) {
    std::string text;
    for (const Id<ChartRun::Step> step : state.situation)
        if (std::ranges::find(controller.steps, step) != controller.steps.end())
            text += (text.empty() ? "" : " ") + run.steps[step].short_name;
    return text.empty() ? "none" : text;
}

bool same_inputs(const ChartRun::Controller& controller, const ChartRun::State& left, const ChartRun::State& right) {
    return std::ranges::all_of(controller.inputs, [&](Id<ChartRun::Signal> input) {
        return left.values[input.index] == right.values[input.index];
    });
}

bool is_of_controllers(const Event& moment) {
    return moment.kind == ChartRun::Kind::Controller || (moment.kind == ChartRun::Kind::Timer && moment.internal);
}

/// Returns the situations of `controller` in the loop of the run, as a sequence that ends with the first situation
/// again. The result is empty if an evolution in the loop is stable, if there is no evolution, or if another controller
/// changes the inputs of `controller`.
std::string cycle_of(const ChartRun& run, Id<ChartRun::Controller> controller) {
    const ChartRun::Controller& named = run.controllers[controller];
    std::string last = situation_of(run, named, run.moments.back().after), cycle = last;
    bool evolves = false;
    for (std::size_t k = *run.loop; k < run.moments.size(); ++k)
        for (const ChartRun::Act& act : run.moments[k].acts) {
            if (!same_inputs(named, run.moments[k].after, run.moments.back().after)) return {};
            if (act.controller != controller || !act.evolves) continue;
            if (act.stable != false) return {};
            evolves = true;
            const std::string now = situation_of(run, named, run.moments[k].after);
            if (now != last) cycle += " -> " + now;
            last = now;
        }
    return evolves ? cycle : "";
}

}  // namespace

bool is_violated_at_power_on(const Network& network, const Property& property, const Run& run) {
    if (!is_about_all_states(property.pattern) || property.at_stable || !network.settled.valid()) return false;
    NetworkState state = initial_state(network);
    if (value(network, state, network.settled) != 0) return false;
    return std::ranges::all_of(run.moves, [&](const Move& move) {
        return std::holds_alternative<Fire>(move) && perform(network, state, move).result == Step::Result::Done &&
               value(network, state, network.settled) == 0;
    });
}

std::string power_on_text(const Verdict& at_stable) {
    const std::string trap = "violated at power-on, before the first outputs are written";
    if (at_stable.outcome == Outcome::Holds && !at_stable.vacuous)
        return trap + "; holds in every quiescent state: append `at stable` to check only those";
    if (at_stable.outcome == Outcome::Violated) return trap + "; also violated with `at stable`";
    return trap + "; append `at stable` to check only quiescent states";
}

std::string unstable_text(const ChartRun& run) {
    if (!run.loop || *run.loop == 0 || *run.loop >= run.moments.size()) return {};
    if (!std::all_of(run.moments.begin() + static_cast<std::ptrdiff_t>(*run.loop), run.moments.end(),
                     is_of_controllers))
        return {};
    std::string text;
    for (const Id<ChartRun::Controller> controller : run.controllers.ids()) {
        const std::string cycle = cycle_of(run, controller);
        if (cycle.empty()) continue;
        const bool changes = cycle.find("->") != std::string::npos;
        text += fmt::format("{}with these inputs, `{}` never becomes stable: {} {}, forever within one instant",
                            text.empty() ? "" : "; ", run.controllers[controller].name,
                            changes ? "its situation cycles" : "evolutions repeat in situation", cycle);
    }
    return text.empty() ? text : text + "; make a transition of the cycle wait for an input change";
}

}  // namespace grafverif
