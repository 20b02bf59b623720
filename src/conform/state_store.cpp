// SPDX-License-Identifier: MIT
#include "conform/moves.hpp"

#include <algorithm>
#include <utility>

namespace grafverif::conform {

namespace {

std::uint64_t hash(std::span<const std::uint64_t> words) {
    std::uint64_t result = 0x9E3779B97F4A7C15U;
    for (const std::uint64_t word : words) {
        result = (result ^ word) * 0xBF58476D1CE4E5B9U;
        result ^= result >> 29U;
    }
    return result;
}

}  // namespace

bool StateStore::is(StateId state, std::span<const std::uint64_t> words) const { return std::ranges::equal(at(state), words); }

StateId StateStore::intern(std::span<const std::uint64_t> state) {
    if (2 * (size() + 1) > slots_.size()) grow();
    std::size_t slot = hash(state) & (slots_.size() - 1);
    while (slots_[slot] != no_state) {
        if (is(slots_[slot], state)) return slots_[slot];
        slot = (slot + 1) & (slots_.size() - 1);
    }
    slots_[slot] = static_cast<StateId>(size());
    packed_.insert(packed_.end(), state.begin(), state.end());
    return slots_[slot];
}

void StateStore::grow() {
    slots_.assign(2 * slots_.size(), no_state);
    for (StateId state = 0; state < size(); ++state) {
        std::size_t slot = hash(at(state)) & (slots_.size() - 1);
        while (slots_[slot] != no_state) slot = (slot + 1) & (slots_.size() - 1);
        slots_[slot] = state;
    }
}

}  // namespace grafverif::conform
