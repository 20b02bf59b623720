// SPDX-License-Identifier: MIT
#include "explain/moves.hpp"

#include <algorithm>
#include <utility>

#include "explain/ablation.hpp"
#include "ir/network_run.hpp"

namespace grafverif {

namespace {

/// Compares states of a network with states of the module `main`, which represents a part of the network state.
class MainView {
public:
    MainView(const Network& network, const TransitionSystem& system) : network_(network) {
        for (const Id<Network::Controller> id : network.controllers.ids()) {
            const auto& here = network.controllers[id].words;
            const auto& there = system.controllers[id.index].words;
            add(here.steps, there.steps);
            add(here.inputs, there.inputs);
            add(here.outputs, there.outputs);
            add(here.internals, there.internals);
            for (std::size_t k = 0; k < here.timers.size(); ++k)
                variables_.emplace_back(here.timers[k].end, there.timers[k].end.index);
        }
        std::size_t component = 0;
        for (const Id<Network::Process> id : network.processes.ids()) {
            const Network::ProcessKind kind = network.processes[id].kind;
            if (kind == Network::ProcessKind::Controller || kind == Network::ProcessKind::Observer) continue;
            add_component(id, system, system.components[component++]);
        }
    }

    /// True if the state `main` of the module `main` represents `state`.
    bool shows(const NetworkState& state, const std::vector<std::int64_t>& main) const {
        const auto same_value = [&](const auto& each) {
            return network_.variables[each.first].scratch || state.variables[each.first.index] == main[each.second];
        };
        const auto same_place = [&](const Place& each) {
            return state.locations[each.process.index].index + each.low == main[each.symbol];
        };
        return std::ranges::all_of(variables_, same_value) && std::ranges::all_of(places_, same_place);
    }

private:
    struct Place {
        Id<Network::Process> process = {};
        std::uint32_t symbol = 0;
        std::int64_t low = 0;
    };

    template <class Here, class There>
    void add(const Here& here, const There& there) {
        for (std::size_t k = 0; k < here.size(); ++k)
            variables_.emplace_back(here[k].variable, there[k].variable.index);
    }

    void add_component(Id<Network::Process> process, const TransitionSystem& system,
                       const TransitionSystem::Component& component) {
        if (component.location.valid())
            places_.push_back(
                {process, component.location.index, system.modules[system.main].symbols[component.location].type.low});
        for (const TransitionSystem::Named& named : component.variables)
            for (const Id<Network::Variable> id : network_.variables.ids())
                if (network_.variables[id].role == Network::Role::Plant &&
                    network_.variables[id].display_name() == named.name)
                    variables_.emplace_back(id, named.variable.index);
    }

    const Network& network_;
    std::vector<std::pair<Id<Network::Variable>, std::uint32_t>> variables_ = {};
    std::vector<Place> places_ = {};
};

/// Returns the symbol of the module `main` that selects the next move: a process, no process, or time.
std::optional<std::uint32_t> mover_variable_of(const Network& network, const TransitionSystem& system) {
    const auto& symbols = system.modules[system.main].symbols;
    for (const auto id : symbols.ids())
        if (std::holds_alternative<TransitionSystem::ChoiceSymbol>(symbols[id].kind) &&
            symbols[id].values.size() == network.processes.size() + (system.ticks.valid() ? 2 : 1))
            return id.index;
    return {};
}

}  // namespace

Network without_clocks(Network network) {
    for (const Id<Network::Process> process : network.processes.ids()) drop_timing(network, process);
    return network;
}

std::optional<Moves> moves_of(const Network& network, const TransitionSystem& system, const SystemRun& run) {
    const auto mover_variable = mover_variable_of(network, system);
    if (!mover_variable || run.loop) return {};
    const MainView view(network, system);
    const auto processes = static_cast<std::int64_t>(network.processes.size());
    NetworkState state = initial_state(network);
    Moves made;
    for (std::size_t step = 0; step + 1 < run.states.size(); ++step) {
        const std::int64_t who = run.states[step][*mover_variable];
        std::vector<Move> choices;
        if (who < processes) {
            for (const Fire& fire : enabled(network, state))
                if (fire.process.index == who) choices.emplace_back(fire);
        } else if (who > processes) {
            choices.emplace_back(Delay{1});
        }
        const auto leads_on = [&](const Move& move) {
            NetworkState next = state;
            if (perform(network, next, move).result != Step::Result::Done || !view.shows(next, run.states[step + 1]))
                return false;
            state = std::move(next);
            return true;
        };
        const auto taken = std::ranges::find_if(choices, leads_on);
        if (taken == choices.end()) {
            if (who != processes) return {};
            continue;
        }
        made.run.moves.push_back(*taken);
        made.steps.push_back(step);
    }
    return made;
}

bool mark(const Moves& moves, const std::vector<std::size_t>& left_out, ChartRun& chart_run) {
    std::vector<std::size_t> found;
    for (const std::size_t move : left_out) {
        const std::size_t before = found.size();
        for (std::size_t moment = 1; moment < chart_run.moments.size(); ++moment)
            if (chart_run.moments[moment].move == moves.steps[move] && chart_run.moments[moment].instance.valid())
                found.push_back(moment);
        if (found.size() != before + 1) return false;
    }
    chart_run.left_out = std::move(found);
    return true;
}

}  // namespace grafverif
