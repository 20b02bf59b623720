// SPDX-License-Identifier: MIT
#include "check/timed/store/packed_states.hpp"

#include <algorithm>
#include <bit>
#include <functional>
#include <string_view>
#include <utility>

namespace grafverif {

namespace {

std::uint32_t hash_of(const timed::Word* words, std::size_t count) {
    const auto* const bytes = reinterpret_cast<const char*>(words);
    return static_cast<std::uint32_t>(std::hash<std::string_view>()({bytes, count * sizeof(timed::Word)}));
}

}  // namespace

PackedStates::Added PackedStates::add(const timed::Word* words) {
    if ((size_ + 1) * 4 > slots_.size() * 3) grow();
    const std::uint32_t hash = hash_of(words, words_);
    if (const std::optional<std::uint32_t> known = find(words, hash)) return {*known, false};
    if (size_ == chunks_.size() * chunk)
        chunks_.push_back(std::make_unique_for_overwrite<timed::Word[]>(chunk * words_));
    std::copy_n(words, words_, chunks_[size_ / chunk].get() + size_ % chunk * words_);
    put(Slot{++size_} << 32U | hash);
    return {static_cast<std::uint32_t>(size_ - 1), true};
}

bool PackedStates::contains(const timed::Word* words) const {
    return size_ != 0 && find(words, hash_of(words, words_)).has_value();
}

/// Returns the number of the state, which has the given hash value. Requires that the table has a free slot.
std::optional<std::uint32_t> PackedStates::find(const timed::Word* words, std::uint32_t hash) const {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t at = hash & mask; slots_[at] != 0; at = (at + 1) & mask) {
        if (static_cast<std::uint32_t>(slots_[at]) != hash) continue;
        const auto state = static_cast<std::uint32_t>((slots_[at] >> 32U) - 1);
        if (std::equal(words, words + words_, this->words(state))) return state;
    }
    return {};
}

void PackedStates::clear() {
    // Adapts the size of the table to the number of states, so that frequent calls with few states are cheap.
    slots_.assign(std::bit_ceil(std::max<std::size_t>(2 * size_, 64)), 0);
    size_ = 0;
}

void PackedStates::put(Slot slot) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = static_cast<std::uint32_t>(slot) & mask;
    while (slots_[at] != 0) at = (at + 1) & mask;
    slots_[at] = slot;
}

void PackedStates::grow() {
    const std::size_t size = std::max<std::size_t>(slots_.size() * 2, 64);
    for (const Slot slot : std::exchange(slots_, std::vector<Slot>(size)))
        if (slot != 0) put(slot);
}

}  // namespace grafverif
