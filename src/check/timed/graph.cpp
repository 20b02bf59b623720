// SPDX-License-Identifier: MIT
#include "check/timed/graph.hpp"

#include <algorithm>

#include "support/overloaded.hpp"

namespace grafverif::timed {

void Graph::urgent_successors(std::uint32_t state, std::vector<std::uint32_t>& found) {
    found.clear();
    each_action(state, [&](std::uint32_t next) { found.push_back(next); });
    expand(state);
    std::size_t move = 0;  // index of the move to the next successor; moves and successors have one order
    std::erase_if(found, [&](std::uint32_t) { return !machine.urgent(moves_.edges[move++]); });
}

Move Graph::move_between(std::uint32_t from, std::uint32_t to) {
    load(to);
    const std::vector<Word> target(now_.words.data(), now_.words.data() + machine.layout().stored);
    const auto leads = [&](const Word* words) { return std::equal(target.begin(), target.end(), words); };
    expand(from);
    if (!moves_.urgent && machine.delay(now_.words.data()) && leads(now_.words.data())) return Delay{1};
    for (std::size_t i = 0; i < moves_.edges.size(); ++i) {
        if (!leads(moves_.words.data() + i * machine.layout().words)) continue;
        taken_ = i;
        return Fire{machine.process_of(moves_.edges[i]), machine.edge_of(moves_.edges[i])};
    }
    unreachable();
}

NetworkState Graph::state(std::uint32_t number) {
    const Network& network = machine.network();
    const Layout& layout = machine.layout();
    const Word* const words = load(number);
    NetworkState state;
    for (const Field& location : layout.locations)
        state.locations.push_back({static_cast<std::uint32_t>(location.get(words))});
    for (const Id<Network::Variable> id : network.variables.ids())
        state.variables.push_back(network.variables[id].scratch ? network.variables[id].initial
                                                                : layout.variables[id.index].get(words));
    for (const std::vector<Field>& clocks : layout.clocks) {
        std::vector<std::int64_t>& values = state.clocks.emplace_back();
        for (const Field& clock : clocks) values.push_back(clock.get(words));
    }
    return state;
}

std::vector<AbstractState> Graph::states_along(const std::vector<std::uint32_t>& path) {
    std::vector<AbstractState> states;
    const std::size_t choices = machine.choices().size();
    moves_.record_choices = true;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        AbstractState& state = states.emplace_back();
        state.move = move_between(path[i], path[i + 1]);
        state.possible.assign(choices, 0);
        if (std::holds_alternative<Fire>(state.move))
            std::copy_n(moves_.chosen.begin() + static_cast<std::ptrdiff_t>(taken_ * choices), choices,
                        state.possible.begin());
        state.state = this->state(path[i + 1]);
        state.state.clocks.clear();
    }
    moves_.record_choices = false;
    return states;
}

Run Graph::run_along(const std::vector<std::uint32_t>& path, std::optional<std::size_t> loop) {
    Run run;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const bool joins = loop != i && !run.moves.empty();
        if (loop == i) run.loop = run.moves.size();
        const Move move = move_between(path[i], path[i + 1]);
        Delay* const before = joins ? std::get_if<Delay>(&run.moves.back()) : nullptr;
        if (before && std::holds_alternative<Delay>(move)) before->units += 1;
        else run.moves.push_back(move);
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
