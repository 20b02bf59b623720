// SPDX-License-Identifier: MIT
#include "check/inputs/found_states.hpp"

#include <algorithm>

namespace grafverif {

std::optional<std::size_t> FoundStates::add(const timed::Word* words, std::size_t parent, std::size_t mark,
                                            const Move& move) {
    added_.assign(words, words + layout_.stored);
    added_.push_back(mark);
    const auto [state, is_new] = states_.add(added_.data());
    if (!is_new) return {};
    nodes_.push_back({parent, move});
    return state;
}

void FoundStates::load(std::size_t state, std::vector<timed::Word>& words) const {
    words.assign(layout_.words, 0);
    std::copy_n(states_.words(state), layout_.stored, words.begin());
}

Run FoundStates::run_to(std::size_t state) const {
    std::vector<Move> moves;
    for (; state != 0; state = nodes_[state].parent) moves.push_back(nodes_[state].move);
    Run run;
    for (auto move = moves.rbegin(); move != moves.rend(); ++move) {
        Delay* const before = run.moves.empty() ? nullptr : std::get_if<Delay>(&run.moves.back());
        if (before && std::holds_alternative<Delay>(*move)) before->units += 1;
        else run.moves.push_back(*move);
    }
    return run;
}

}  // namespace grafverif
