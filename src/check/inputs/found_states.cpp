// SPDX-License-Identifier: MIT
#include "check/inputs/found_states.hpp"

#include <algorithm>
#include <functional>
#include <string_view>

namespace grafverif {

std::optional<std::size_t> FoundStates::add(const timed::Word* words, std::size_t parent, std::size_t mark,
                                            const Move& move) {
    const std::size_t state = nodes_.size();
    nodes_.push_back({parent, mark, move});
    words_.insert(words_.end(), words, words + layout_.words);
    if (known_.insert(state).second) return state;
    nodes_.pop_back();
    words_.resize(words_.size() - layout_.words);
    return {};
}

std::uint64_t FoundStates::bytes() const {
    // Memory of an entry in a list of the hash table.
    constexpr std::uint64_t entry = sizeof(std::size_t) + 2 * sizeof(void*);
    return nodes_.capacity() * sizeof(Node) + words_.capacity() * sizeof(timed::Word) +
           known_.bucket_count() * sizeof(void*) + known_.size() * entry;
}

std::size_t FoundStates::Hash::operator()(std::size_t state) const {
    const auto* const bytes = reinterpret_cast<const char*>(states.words(state));
    const std::string_view stored(bytes, states.layout_.stored * sizeof(timed::Word));
    return std::hash<std::string_view>()(stored) ^ (states.mark(state) * 0x9E3779B97F4A7C15U);
}

bool FoundStates::Equal::operator()(std::size_t a, std::size_t b) const {
    const timed::Word* const words = states.words(a);
    return states.mark(a) == states.mark(b) && std::equal(words, words + states.layout_.stored, states.words(b));
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
