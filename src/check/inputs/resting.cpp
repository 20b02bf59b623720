// SPDX-License-Identifier: MIT
#include "check/inputs/resting.hpp"

#include <algorithm>
#include <deque>
#include <utility>

#include "ir/network_clocks.hpp"

namespace grafverif {

namespace {

/// True if the PLCs have no clocks, and each of their edges is urgent.
bool plcs_are_instant(const Network& network) {
    return std::ranges::all_of(network.controllers, [&](const Network::Controller& controller) {
        const Network::Template& plc = network.templates[network.processes[controller.process].automaton];
        return plc.clocks.empty() && std::ranges::all_of(plc.edges, &Network::Edge::urgent);
    });
}

/// Explores each process except PLCs separately. The result is empty if a process is not supported, or if an edge of a
/// PLC is not urgent.
std::deque<ProcessStates> explored(const Network& network, const VariableUsers& users, const timed::Limits& limits) {
    const std::vector<ProcessClocks> clocks = analyse_clocks(network);
    std::deque<ProcessStates> processes;
    if (!plcs_are_instant(network)) return {};
    for (const Id<Network::Process> id : network.processes.ids())
        if (!users.plcs.contains(id) && !processes.emplace_back(network, users, clocks[id.index], id, limits).explore())
            return {};
    return processes;
}

}  // namespace

std::vector<TimerRequest> requests_of(const Network& network) {
    const TimedOptions options;
    const timed::Limits limits(options);  // default options, without limits
    const VariableUsers users(network);
    const std::vector<ProcessClocks> clocks = analyse_clocks(network);
    std::vector<TimerRequest> requests;
    for (const Id<Network::Process> id : network.processes.ids()) {
        if (network.processes[id].kind != Network::ProcessKind::Timer) continue;
        ProcessStates timer(network, users, clocks[id.index], id, limits);
        if (timer.explore()) std::ranges::move(timer.requests(), std::back_inserter(requests));
    }
    return requests;
}

bool takes_time(const Network& network) {
    const TimedOptions options;
    const timed::Limits limits(options);  // default options, without limits
    const VariableUsers users(network);
    const std::deque<ProcessStates> processes = explored(network, users, limits);
    return !processes.empty() && std::ranges::all_of(processes, &ProcessStates::repeats_slowly);
}

bool lets_time_pass(const Network& network, const InputAblations& ablations) {
    const TimedOptions options;
    const timed::Limits limits(options);  // default options, without limits
    const VariableUsers users(network);
    const std::deque<ProcessStates> processes = explored(network, users, limits);
    if (processes.empty()) return false;
    for (const ProcessStates& process : processes)
        if ((!ablations.ignore_bounds && !process.leaves_bounds()) ||
            (!ablations.ignore_moves && !process.moves_finitely()))
            return false;
    if (ablations.ignore_outputs) return true;
    std::vector<bool> steady(network.variables.size(), false);  // true if the variable is constant from some time on
    std::vector<bool> shown(processes.size(), false);
    const auto grow = [&] {
        for (bool grows = true; grows;) {
            grows = false;
            for (std::size_t i = 0; i < processes.size(); ++i) {
                if (shown[i] || !processes[i].shows_finitely(steady, false)) continue;
                for (const Id<Network::Variable> variable : processes[i].own()) steady[variable.index] = true;
                shown[i] = grows = true;
            }
        }
    };
    grow();
    for (const ProcessStates& process : processes)
        if (!process.shows_finitely(steady, true)) return false;
    for (const Id<Network::Variable> id : network.variables.ids()) {
        const std::set<Id<Network::Process>>& writers = users.writers[id.index];
        steady[id.index] = steady[id.index] || std::ranges::includes(users.plcs, writers);
    }
    grow();
    return std::ranges::find(shown, false) == shown.end();
}

}  // namespace grafverif
