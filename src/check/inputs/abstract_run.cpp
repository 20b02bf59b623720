// SPDX-License-Identifier: MIT
#include "check/inputs/abstract_run.hpp"

#include <algorithm>

namespace grafverif {

using timed::Word;

namespace {

const Network::Controller* controller_of(const AbstractRun& run, const AbstractState& state) {
    const auto* const fire = std::get_if<Fire>(&state.move);
    if (fire == nullptr) return nullptr;
    const auto found = std::ranges::find(run.network.controllers, fire->process, &Network::Controller::process);
    return found == run.network.controllers.end() ? nullptr : &*found;
}

bool samples(const AbstractRun& run, const AbstractState& state) {
    const Network::Controller* const controller = controller_of(run, state);
    if (controller == nullptr) return false;
    const auto& fire = std::get<Fire>(state.move);
    const Network::Edge& edge = run.network.templates[run.network.processes[fire.process].automaton].edges[fire.edge];
    return std::ranges::any_of(
        edge.calls, [&](Id<Network::Procedure> call) { return call == controller->fire || call == controller->start; });
}

}  // namespace

std::vector<Sampling> samplings(const AbstractRun& run) {
    std::vector<Sampling> found;
    std::vector<std::size_t> last(run.network.processes.size(), 0);  // per PLC: index in `found` of its last sampling,
                                                                     // plus 1; 0 before the first sampling
    for (std::size_t at = 0; at < run.path.size(); ++at) {
        const Network::Controller* const controller = controller_of(run, run.path[at]);
        if (controller == nullptr) continue;
        std::size_t& number = last[controller->process.index];
        if (samples(run, run.path[at])) {
            found.push_back({at, controller->process, std::vector<Word>(run.instances.size(), ~Word{0})});
            number = found.size();
        }
        if (number == 0) continue;
        for (std::size_t i = 0; i < run.choices.size(); ++i)
            if (const Word possible = run.path[at].possible[i]; possible != 0)
                found[number - 1].possible[run.choices[i].instance] &= possible;
    }
    for (Sampling& sampling : found)
        for (std::size_t i = 0; i < run.instances.size(); ++i) {
            const std::size_t valuations = run.instances[i].valuations.size();
            if (valuations == 0) continue;  // the level of the instance is not Chosen (arbitrary outputs)
            const Word all = ~Word{0} >> (64 - valuations);
            if ((sampling.possible[i] & all) == all) sampling.possible[i] = ~Word{0};
        }
    return found;
}

}  // namespace grafverif
