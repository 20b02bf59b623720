// SPDX-License-Identifier: MIT
#include "conform/state_store.hpp"

#include <algorithm>

namespace grafverif::conform {

StateLayout::StateLayout(const Equations& equations) {
    std::uint32_t bits = 0;
    std::vector<std::uint32_t> first_bit(equations.variables.size());
    for (const Kept& each : kept(equations)) {
        const Type type = equations.variables[each.variable].type;
        const auto width = static_cast<std::uint32_t>(std::max<std::size_t>(1, bit_count(type)));
        if (bits % 64 + width > 64) bits += 64 - bits % 64;  // a field does not cross a word boundary
        fields.push_back({each, type, bits / 64, bits % 64, (std::uint64_t{1} << width) - 1});
        first_bit[each.variable.index] = bits;
        bits += width;
    }
    evolving = fields.size() - equations.watches.size();
    for (const Equations::Timer& timer : equations.timers) {
        timers.push_back({bits, bits + 1, first_bit[timer.watched.index]});
        bits += 2;
    }
    words = std::max<std::size_t>(1, (bits + 63) / 64);
}

std::int64_t StateLayout::value(std::span<const std::uint64_t> state, std::uint32_t field) const {
    const Field& at = fields[field];
    return static_cast<std::int64_t>((state[at.word] >> at.shift) & at.mask) + (at.type.boolean ? 0 : at.type.low);
}

void StateLayout::set(PackedState& state, std::uint32_t field, std::int64_t value) const {
    const Field& at = fields[field];
    const auto packed = static_cast<std::uint64_t>(value - (at.type.boolean ? 0 : at.type.low));
    state[at.word] = (state[at.word] & ~(at.mask << at.shift)) | (packed << at.shift);
}

bool has_bit(std::span<const std::uint64_t> state, std::uint32_t bit) {
    return ((state[bit / 64] >> (bit % 64)) & 1U) != 0;
}

void set_bit(PackedState& state, std::uint32_t bit, bool value) {
    const std::uint64_t mask = std::uint64_t{1} << (bit % 64);
    if (value) state[bit / 64] |= mask;
    else state[bit / 64] &= ~mask;
}

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

StateId StateStore::intern(std::span<const std::uint64_t> state) {
    if (2 * (size() + 1) > slots_.size()) grow();
    std::size_t slot = hash(state) & (slots_.size() - 1);
    while (slots_[slot] != no_state) {
        if (std::ranges::equal(at(slots_[slot]), state)) return slots_[slot];
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
