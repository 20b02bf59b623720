// SPDX-License-Identifier: MIT
// PackedStates: a set of packed states, which are numbered in the order of insertion.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "check/timed/layout.hpp"

namespace grafverif {

class PackedStates {
public:
    /// Creates an empty set of states that have `words` words each.
    explicit PackedStates(std::size_t words) : words_(words) {}

    struct Added {
        std::uint32_t state = 0;
        bool is_new = false;
    };
    /// Adds a state, unless the set contains it, and returns its number. The set can contain 2^32 - 1 states.
    Added add(const timed::Word* words);
    bool contains(const timed::Word* words) const;
    /// Removes all states.
    void clear();

    std::size_t size() const { return size_; }
    /// Returns a state as packed words. The address of the result remains valid when states are added.
    const timed::Word* words(std::size_t state) const { return chunks_[state / chunk].get() + state % chunk * words_; }
    /// Returns the approximate memory in bytes.
    std::uint64_t bytes() const {
        return (chunks_.size() * chunk * words_ + slots_.capacity()) * sizeof(std::uint64_t);
    }

private:
    static constexpr std::size_t chunk = 4096;  // number of states in one memory block

    /// A slot of the hash table: the number of a state plus 1, and the lower half of the hash value of the state; 0 for
    /// a free slot.
    using Slot = std::uint64_t;
    std::optional<std::uint32_t> find(const timed::Word* words, std::uint32_t hash) const;
    void put(Slot slot);
    void grow();

    const std::size_t words_;
    std::size_t size_ = 0;
    std::vector<std::unique_ptr<timed::Word[]>> chunks_ = {};
    std::vector<Slot> slots_ = {};  // the number of slots is a power of two; at least a quarter of the slots are free
};

}  // namespace grafverif
