// SPDX-License-Identifier: MIT
#include "run/manual_situation.hpp"

#include <algorithm>
#include <string_view>
#include <variant>

#include "run/hierarchy.hpp"

namespace grafverif {

namespace {

/// Returns the variable that is bound to the Boolean parameter `name` of the process, or an invalid id if its template
/// has no such parameter.
Id<Network::Variable> argument(const Network& network, Id<Network::Process> id, std::string_view name) {
    const Network::Process& process = network.processes[id];
    const auto& parameters = network.templates[process.automaton].parameters;
    const auto found = std::ranges::find(parameters, name, &Network::Parameter::name);
    if (found == parameters.end()) return {};
    const auto* const variable =
        std::get_if<Id<Network::Variable>>(&process.arguments[static_cast<std::size_t>(found - parameters.begin())]);
    return variable == nullptr ? Id<Network::Variable>{} : *variable;
}

std::string named(const Chart& chart, Id<Chart::Step> step) { return "step `" + name_of(chart, step).text() + "`"; }

}  // namespace

ManualSituation by_hand(const Chart& chart, const std::vector<bool>& situation, Id<Chart::Step> step, bool active) {
    const auto refuse = [](std::string why) { return ManualSituation{.refusal = std::move(why)}; };
    const std::string subject = named(chart, step);
    if (situation[step.index] == active) return refuse(subject + (active ? " is already active" : " is not active"));
    const Levels levels(chart);
    const Chart::PartialChart& partial = chart.partial_charts[chart.steps[step].chart];
    if (const Id<Chart::Step> holder = levels.holder(chart.steps[step].chart, situation); holder.valid())
        return refuse(subject + " is held by the forcing order of " + named(chart, holder) +
                      "; deactivate that step first");
    if (partial.kind == Chart::PartialKind::Enclosed && !situation[partial.owner.index])
        return refuse(subject + " is enclosed by " + named(chart, partial.owner) + ", which is not active");
    std::vector<bool> made = levels.by_hand(situation, step, active);
    if (made[step.index] != active)
        return refuse("the hierarchy of the chart does not allow " + subject + " to be " +
                      (active ? "active" : "inactive"));
    if (const Id<Chart::ForcingOrder> order = levels.conflict(made); order.valid())
        return refuse("two contradictory forcing orders would be active, one of which belongs to " +
                      named(chart, chart.forcing[order].step));
    return {std::move(made), {}};
}

std::vector<bool> situation_of(const Network& network, const NetworkState& state, Id<Network::Controller> controller) {
    std::vector<bool> situation;
    for (const auto& step : network.controllers[controller].words.steps)
        situation.push_back(state.variables[step.variable.index] != 0);
    return situation;
}

void put_situation(const Network& network, NetworkState& state, Id<Network::Controller> id,
                   const std::vector<bool>& situation) {
    const Network::Controller& controller = network.controllers[id];
    const std::vector<bool> before = situation_of(network, state, id);
    for (std::size_t k = 0; k < situation.size(); ++k)
        state.variables[controller.words.steps[k].variable.index] = situation[k] ? 1 : 0;
    for (std::size_t k = 0; k < controller.timers.size(); ++k) {
        const std::optional<std::size_t> step = controller.words.timers[k].step;
        if (!step || before[*step] == situation[*step]) continue;
        // `P` is the request parameter of a timer in compose/timers.cpp.
        if (const auto request = argument(network, controller.timers[k].process, "P"); request.valid())
            state.variables[request.index] = 1;
    }
    // With a task cycle and stability search, the request for a cycle would continue the last scan, which does not
    // sample the inputs again. The request is not necessary, because the next scan has at least one evolution.
    if (controller.words.cycle && controller.words.mode == ExecutionMode::StabilitySearch) return;
    state.variables[controller.stable.index] = 0;
}

}  // namespace grafverif
