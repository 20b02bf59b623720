// SPDX-License-Identifier: MIT
#include "check/inputs/packed_states.hpp"

#include <algorithm>
#include <functional>
#include <string_view>

namespace grafverif {

PackedStates::Added PackedStates::add(const timed::Word* words) {
    const auto state = static_cast<std::uint32_t>(size());
    states_.insert(states_.end(), words, words + words_);
    const auto [known, is_new] = known_.insert(state);
    if (!is_new) states_.resize(states_.size() - words_);
    return {*known, is_new};
}

std::uint64_t PackedStates::bytes() const {
    constexpr std::uint64_t entry = sizeof(std::size_t) + 2 * sizeof(void*);  // size in a list of the hash table
    return states_.capacity() * sizeof(timed::Word) + known_.bucket_count() * sizeof(void*) + known_.size() * entry;
}

std::size_t PackedStates::Hash::operator()(std::uint32_t state) const {
    const auto* const bytes = reinterpret_cast<const char*>(states.words(state));
    return std::hash<std::string_view>()({bytes, states.words_ * sizeof(timed::Word)});
}

bool PackedStates::Equal::operator()(std::uint32_t a, std::uint32_t b) const {
    return std::equal(states.words(a), states.words(a) + states.words_, states.words(b));
}

}  // namespace grafverif
