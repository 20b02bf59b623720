// SPDX-License-Identifier: MIT
#include "check/timed/store.hpp"

#include <algorithm>
#include <cstring>

namespace grafverif::timed {

namespace {

constexpr std::size_t first_slots = 64;

std::size_t shard_of(std::uint64_t hash, unsigned bits) { return static_cast<std::size_t>(hash >> (64U - bits)); }
std::uint32_t print_of(std::uint64_t hash) { return static_cast<std::uint32_t>(hash); }

}  // namespace

Store::Store(const Layout& layout) : halves_(layout.halves), shards_(std::size_t{1} << shard_bits) {
    for (Shard& shard : shards_) shard.slots.resize(first_slots);
    slots_ = shards_.size() * first_slots;
}

bool Store::is(std::uint32_t state, const Word* words) const {
    const std::uint32_t* const stored = at(state);
    Word different = 0;
    std::size_t half = 0;
    for (; half + 1 < halves_; half += 2) {
        Word word = 0;
        std::memcpy(&word, stored + half, sizeof word);
        different |= word ^ words[half / 2];
    }
    if (half < halves_) different |= stored[half] ^ words[half / 2];
    return different == 0;
}

void Store::load(std::uint32_t state, Word* words) const {
    const std::uint32_t* const stored = at(state);
    std::size_t half = 0;
    for (; half + 1 < halves_; half += 2) std::memcpy(words + half / 2, stored + half, sizeof(Word));
    if (half < halves_) words[half / 2] = stored[half];
}

std::uint32_t Store::append(const Word* words) {
    if ((size_ & (chunk - 1)) == 0) chunks_.push_back(std::make_unique_for_overwrite<std::uint32_t[]>(chunk * halves_));
    const auto state = static_cast<std::uint32_t>(size_++);
    std::uint32_t* const stored = chunks_[state >> shift].get() + (state & (chunk - 1)) * halves_;
    std::size_t half = 0;
    for (; half + 1 < halves_; half += 2) std::memcpy(stored + half, words + half / 2, sizeof(Word));
    if (half < halves_) stored[half] = static_cast<std::uint32_t>(words[half / 2]);
    return state;
}

void Store::prefetch(std::uint64_t hash) const {
    const Shard& shard = shards_[shard_of(hash, shard_bits)];
    __builtin_prefetch(shard.slots.data() + home(print_of(hash), shard.slots.size()));
}

Store::Interned Store::intern(const Word* words, std::uint64_t hash) {
    Shard& shard = shards_[shard_of(hash, shard_bits)];
    if (5 * (shard.used + 1) > 4 * shard.slots.size()) grow(shard);
    const std::uint32_t print = print_of(hash);
    const std::size_t slots = shard.slots.size();
    std::size_t place = home(print, slots);
    for (;; place = place + 1 == slots ? 0 : place + 1) {
        const Slot slot = shard.slots[place];
        if (slot.state == 0) break;
        if (slot.print == print && is(slot.state - 1, words)) return {slot.state - 1, false};
    }
    const std::uint32_t state = append(words);
    shard.slots[place] = {print, state + 1};
    ++shard.used;
    return {state, true};
}

std::uint32_t Store::find(const Word* words, std::uint64_t hash) const {
    const Shard& shard = shards_[shard_of(hash, shard_bits)];
    const std::uint32_t print = print_of(hash);
    const std::size_t slots = shard.slots.size();
    for (std::size_t place = home(print, slots);; place = place + 1 == slots ? 0 : place + 1) {
        const Slot slot = shard.slots[place];
        if (slot.state == 0) return none;
        if (slot.print == print && is(slot.state - 1, words)) return slot.state - 1;
    }
}

/// Slots keep the order of their prints, so the old ones are read and the new ones written nearly in sequence.
void Store::grow(Shard& shard) {
    std::vector<Slot> wider(shard.slots.size() + shard.slots.size() / 2);
    for (const Slot slot : shard.slots) {
        if (slot.state == 0) continue;
        std::size_t place = home(slot.print, wider.size());
        while (wider[place].state != 0) place = place + 1 == wider.size() ? 0 : place + 1;
        wider[place] = slot;
    }
    slots_ += wider.size() - shard.slots.size();
    shard.slots = std::move(wider);
}

void Store::drop_index() {
    shards_.clear();
    slots_ = 0;
}

}  // namespace grafverif::timed
