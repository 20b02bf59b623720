// SPDX-License-Identifier: MIT
#include "bdd/cache.hpp"

#include <algorithm>
#include <bit>

namespace grafverif::bdd {

namespace {

constexpr std::size_t first_size = std::size_t{1} << 10U;

}  // namespace

bool Cache::grow(InterruptPoll& watch) {
    const std::size_t before = size_, after = before == 0 ? first_size : 2 * before;
    if (entries_.size() < after && !entries_.resize(after)) return false;
    size_ = after;
    shift_ = static_cast<unsigned>(64 - std::countr_zero(after));
    try {
        if (before == 0) {
            clear(watch);
            return true;
        }
        // Entries are moved from last to first, because entry i moves to slot 2i or 2i + 1.
        for (std::size_t i = before; i-- > 0;) {
            watch.step();
            const Entry moved = entries_[i];
            entries_[2 * i] = entries_[2 * i + 1] = {};
            if (moved.f != 0) entries_[slot(moved)] = moved;
        }
    } catch (...) {
        shrink_to_nothing();
        throw;
    }
    return true;
}

/// Removes all entries after an interruption of `clear` or `grow`.
void Cache::shrink_to_nothing() {
    size_ = std::min(size_, first_size);
    shift_ = static_cast<unsigned>(64 - std::countr_zero(size_));
    std::fill_n(entries_.data(), size_, Entry{});
    (void)entries_.resize(size_);
}

void Cache::clear(InterruptPoll& watch) {
    try {
        for (std::size_t i = 0; i < size_; ++i) {
            watch.step();
            entries_[i] = {};
        }
    } catch (...) {
        shrink_to_nothing();
        throw;
    }
}

void Cache::keep_marked(const NodeTable& table, InterruptPoll& watch) {
    const auto lives = [&](Edge edge) { return is_constant(edge) || table.marked(index_of(edge)); };
    for (std::size_t i = 0; i < size_; ++i) {
        watch.step();
        const CachedResult entry = known(i);
        if (entry.f == 0) continue;
        const bool numbered = entry.operation == Operation::Rename;
        if (!lives(entry.f) || !lives(entry.g) || !lives(entry.result) || (!numbered && !lives(entry.h)))
            entries_[i] = {};
    }
}

Cache::CachedResult Cache::known(std::size_t slot) const {
    const Entry& entry = entries_[slot];
    const auto operation = static_cast<Operation>(entry.f >> 30U | entry.g >> 30U << 2U);
    return {operation, entry.f & edge_mask, entry.g & edge_mask, entry.h, entry.result};
}

}  // namespace grafverif::bdd
