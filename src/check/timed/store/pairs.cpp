// SPDX-License-Identifier: MIT
#include "check/timed/store/pairs.hpp"

#include <algorithm>
#include <bit>
#include <new>

namespace grafverif::timed {

namespace {

constexpr std::size_t first_slots = 32;
// `rebuild` prefetches the pair of the slot that is this number of slots ahead.
constexpr std::uint32_t pairs_fetched_ahead = 32;
// Minimum number of bits of a slot for the number of a pair. The remaining at most 20 bits of the slot contain the
// print, which consists of bits of the hash; other bits of the hash select the slot.
constexpr unsigned least_number_bits = 12;

// The topmost bits of a hash select the shard, the lowest bits are the print, and the bits between them select the slot
// in the shard.

std::uint32_t print_of(std::uint64_t hash, unsigned number_bits) {
    return static_cast<std::uint32_t>(hash) & ((1U << (32U - number_bits)) - 1);
}

std::size_t home_slot(std::uint64_t hash, std::size_t slots) {
    return static_cast<std::size_t>(((hash >> 22U & 0xFFFFFFFFU) * slots) >> 32U);
}

std::uint32_t mask_of(unsigned bits) { return bits == 0 ? 0 : 0xFFFFFFFFU >> (32U - bits); }

}  // namespace

/// Mixing function of SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
std::uint64_t Pairs::hash(Word pair) {
    std::uint64_t hash = pair + 0x9E3779B97F4A7C15U;
    hash = (hash ^ (hash >> 30U)) * 0xBF58476D1CE4E5B9U;
    hash = (hash ^ (hash >> 27U)) * 0x94D049BB133111EBU;
    return hash ^ (hash >> 31U);
}

Pairs::Pairs(unsigned shard_bits)
    : open_(std::make_unique_for_overwrite<Word[]>(chunk)), shards_(std::size_t{1} << shard_bits) {
    chunk_bytes_ = chunk * sizeof(Word);
    for (Shard& shard : shards_) rebuild(shard, first_slots, 1);
}

void Pairs::prefetch(Word pair) const {
    const std::uint64_t hash = Pairs::hash(pair);
    const Shard& shard = shards_[shard_at(hash)];
    __builtin_prefetch(shard.slots.data() + home_slot(hash, shard.slots.size()));
}

void Pairs::prefetch_met(Word pair) const {
    const std::uint64_t hash = Pairs::hash(pair);
    const Shard& shard = shards_[shard_at(hash)];
    const std::uint32_t slot = shard.slots[home_slot(hash, shard.slots.size())];
    if (slot != 0) prefetch_pair((slot & mask_of(shard.number_bits)) - 1);
}

std::uint32_t Pairs::find(Word pair) const {
    const std::uint64_t hash = Pairs::hash(pair);
    const Shard& shard = shards_[shard_at(hash)];
    const std::uint32_t print = print_of(hash, shard.number_bits);
    const std::size_t slots = shard.slots.size();
    for (std::size_t place = home_slot(hash, slots);; place = place + 1 == slots ? 0 : place + 1) {
        const std::uint32_t slot = shard.slots[place];
        if (slot == 0) return none;
        if (slot >> shard.number_bits != print) continue;
        const std::uint32_t number = (slot & mask_of(shard.number_bits)) - 1;
        if ((*this)[number] == pair) return number;
    }
}

Pairs::Interned Pairs::intern(Word pair) {
    const std::uint32_t known = find(pair);
    if (known != none) return {known, false};
    const std::uint32_t number = append(pair);
    const std::uint64_t hash = Pairs::hash(pair);
    put(shards_[shard_at(hash)], hash, number);
    return {number, true};
}

std::uint32_t Pairs::append(Word pair) {
    if (size_ >= most) throw std::bad_alloc();
    if (size_ != 0 && (size_ & (chunk - 1)) == 0 && packed_.size() << shift != size_) pack();
    count(shards_[shard_at(hash(pair))]);
    open_[size_ & (chunk - 1)] = pair;
    return static_cast<std::uint32_t>(size_++);
}

/// Counts a further pair in the shard. Enlarges the shard if it has too few slots or too few bits for the number of the
/// pair.
void Pairs::count(Shard& shard) {
    const bool full = 5 * (shard.used + 1) > 4 * shard.slots.size();
    const std::size_t slots = full ? 2 * shard.slots.size() : shard.slots.size();
    if (full || (size_ + 1) >> shard.number_bits != 0) rebuild(shard, slots, 1);
    ++shard.used;
}

void Pairs::put(Shard& shard, std::uint64_t hash, std::uint32_t number) {
    const std::size_t slots = shard.slots.size();
    std::size_t place = home_slot(hash, slots);
    while (shard.slots[place] != 0) place = place + 1 == slots ? 0 : place + 1;
    shard.slots[place] = print_of(hash, shard.number_bits) << shard.number_bits | (number + 1);
}

void Pairs::free_memory(std::size_t more, Share share) {
    const std::size_t each = more / shards_.size() + more / shards_.size() / 8 + 16;
    for (std::size_t i = share.member; i < shards_.size(); i += share.members) {
        Shard& shard = shards_[i];
        std::size_t slots = shard.slots.size();
        while (5 * (shard.used + each) > 4 * slots) slots *= 2;
        if (slots != shard.slots.size() || (size_ + more) >> shard.number_bits != 0) rebuild(shard, slots, more);
    }
}

void Pairs::index(Word pair, std::uint32_t number) {
    const std::uint64_t hash = Pairs::hash(pair);
    put(shards_[shard_at(hash)], hash, number);
}

/// Packs the open chunk, which contains the latest pairs. Requires that the open chunk is full.
void Pairs::pack() {
    std::uint32_t lows = 0, highs = 0;
    for (std::size_t i = 0; i < chunk; ++i) {
        lows |= low(open_[i]);
        highs |= high(open_[i]);
    }
    Chunk packed;
    packed.low_bits = static_cast<std::uint8_t>(std::bit_width(lows));
    packed.low = mask_of(packed.low_bits);
    packed.high = mask_of(static_cast<unsigned>(std::bit_width(highs)));
    packed.each = static_cast<std::uint8_t>((packed.low_bits + std::bit_width(highs) + 7) / 8);
    const std::size_t bytes = chunk * packed.each + sizeof(Word);  // the last pair is read as a complete word
    packed.bytes = std::make_unique<std::uint8_t[]>(bytes);
    for (std::size_t i = 0; i < chunk; ++i) {
        const Word word = low(open_[i]) | Word{high(open_[i])} << packed.low_bits;
        std::memcpy(packed.bytes.get() + i * packed.each, &word, sizeof word);
    }
    packed_.push_back(std::move(packed));
    chunk_bytes_ += bytes + sizeof(Chunk);
}

/// Rebuilds the shard with `slots` slots. Afterwards, each slot has enough bits for the numbers of all present pairs
/// and of further pairs. The number of further pairs is `more` or half of the present number of pairs, whichever is
/// greater.
void Pairs::rebuild(Shard& shard, std::size_t slots, std::size_t more) {
    Shard wider{std::vector<std::uint32_t>(slots), shard.used, 0};
    wider.number_bits =
        std::max(least_number_bits, static_cast<unsigned>(std::bit_width(size_ + std::max(size_ / 2, more))));
    const std::uint32_t numbers_of = mask_of(shard.number_bits);
    for (std::size_t at = 0; at < shard.slots.size(); ++at) {
        if (const std::size_t soon = at + pairs_fetched_ahead; soon < shard.slots.size() && shard.slots[soon] != 0)
            prefetch_pair((shard.slots[soon] & numbers_of) - 1);
        if (shard.slots[at] == 0) continue;
        const std::uint32_t number = (shard.slots[at] & numbers_of) - 1;
        const std::uint64_t hash = Pairs::hash((*this)[number]);
        put(wider, hash, number);
    }
    shard = std::move(wider);
}

std::size_t Pairs::index_bytes() const {
    std::size_t slots = 0;
    for (const Shard& shard : shards_) slots += shard.slots.size();
    return slots * sizeof(std::uint32_t);
}

void Pairs::drop_index() { shards_ = {}; }

}  // namespace grafverif::timed
