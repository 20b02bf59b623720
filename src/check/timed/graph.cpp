// SPDX-License-Identifier: MIT
#include "check/timed/graph.hpp"

#include <algorithm>

#include "support/overloaded.hpp"

namespace grafverif::timed {

void Graph::urgent_successors(std::uint32_t state, std::vector<std::uint32_t>& found) {
    found.clear();
    each_action(state, [&](std::uint32_t next) { found.push_back(next); });
    expand(state);
    std::size_t move = 0;  // index of the move that leads to the next successor; moves and successors are in the same
                           // order
    std::erase_if(found, [&](std::uint32_t) { return !machine.urgent(moves_.edges[move++]); });
}

std::vector<AbstractState> Graph::moves_between(std::vector<Word>& words, std::uint32_t to) {
    const auto stored = static_cast<std::ptrdiff_t>(machine.layout().stored);
    const std::vector<Word> target(load(to), load(to) + stored);
    std::vector<Word> later = words;
    machine.expand(words.data(), moves_);
    if (!moves_.urgent && machine.delay(later.data()) && macro_steps.are_equivalent(later.data(), target.data())) {
        words = std::move(later);
        return {{Delay{1}, state_of(words.data()), std::vector<Word>(machine.choices().size())}};
    }
    std::vector<AbstractState> moves;
    for (MacroSteps::Step& step : macro_steps.between(words.data(), target.data())) {
        words = std::move(step.words);
        moves.push_back({Fire{machine.process_of(step.edge), machine.edge_of(step.edge)}, state_of(words.data()),
                         std::move(step.chosen)});
    }
    if (moves.empty()) unreachable();
    return moves;
}

void Graph::read(std::uint32_t number, NetworkState& state) { unpack(load(number), state); }

NetworkState Graph::state_of(const Word* words) const {
    NetworkState state;
    unpack(words, state);
    return state;
}

/// Stores the packed state in `state`. Reuses the memory of `state`.
void Graph::unpack(const Word* words, NetworkState& state) const {
    const Network& network = machine.network();
    const Layout& layout = machine.layout();
    state.locations.clear();
    for (const Field& location : layout.locations)
        state.locations.push_back({static_cast<std::uint32_t>(location.get(words))});
    state.variables.clear();
    for (const Id<Network::Variable> id : network.variables.ids())
        state.variables.push_back(network.variables[id].scratch ? network.variables[id].initial
                                                                : layout.variables[id.index].get(words));
    state.clocks.resize(layout.clocks.size());
    for (std::size_t process = 0; process < layout.clocks.size(); ++process) {
        std::vector<std::int64_t>& values = state.clocks[process];
        values.clear();
        for (const Field& clock : layout.clocks[process]) values.push_back(clock.get(words));
    }
}

/// Returns the first state of a path in packed form. Variables that are not stored have correct values only if this is
/// the initial state.
std::vector<Word> Graph::first_words(const std::vector<std::uint32_t>& path) {
    if (path.front() == 0) return packed_initial(machine.network(), machine.layout());
    const Word* const words = load(path.front());
    return {words, words + machine.layout().words};
}

std::vector<AbstractState> Graph::states_along(const std::vector<std::uint32_t>& path) {
    std::vector<AbstractState> states;
    std::vector<Word> words = first_words(path);
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        for (AbstractState& state : moves_between(words, path[i + 1])) {
            state.state.clocks.clear();
            states.push_back(std::move(state));
        }
    return states;
}

Run Graph::run_along(const std::vector<std::uint32_t>& path, std::optional<std::size_t> loop) {
    Run run;
    std::vector<Word> words = first_words(path);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        bool joins = loop != i && !run.moves.empty();
        if (loop == i) run.loop = run.moves.size();
        for (const AbstractState& state : moves_between(words, path[i + 1])) {
            Delay* const before = joins ? std::get_if<Delay>(&run.moves.back()) : nullptr;
            if (before && std::holds_alternative<Delay>(state.move)) before->units += 1;
            else run.moves.push_back(state.move);
            joins = true;
        }
    }
    return run;
}

std::vector<std::uint32_t> Graph::path_to(std::uint32_t state) const {
    std::vector<std::uint32_t> path = {state};
    while (path.back() != 0) path.push_back(parent[path.back()]);
    std::ranges::reverse(path);
    return path;
}

}  // namespace grafverif::timed
