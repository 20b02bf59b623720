// SPDX-License-Identifier: MIT
// Pairs: a table of pairs of 32-bit numbers. The pairs are numbered in the order of insertion; equal pairs have the
// same number. The state store has such a table for each inner node of its tree (see Store).
//
// The pairs are stored in chunks, in the order of their numbers. A full chunk is packed: each pair of the chunk uses as
// many bytes as the largest numbers of the chunk need. The index is split into shards by hash. When a shard is four
// fifths full, only the size of this shard is doubled, so that the additional memory is small. A slot of the index has
// 32 bits. The slot contains the number of a pair and, in the remaining bits, a *print*: some bits of the hash of the
// pair. The print distinguishes the pair from most other pairs without an access to the stored pairs.
#pragma once

#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#include "check/timed/layout.hpp"

namespace grafverif::timed {

class Pairs {
public:
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    /// Maximum number of pairs; if a further pair is added, `intern` throws std::bad_alloc.
    static constexpr std::uint32_t most = (1U << 30U) - 2;

    explicit Pairs(unsigned shard_bits);

    static std::uint64_t hash(Word pair);
    static Word pair(std::uint32_t low, std::uint32_t high) { return low | Word{high} << 32U; }
    static std::uint32_t low(Word pair) { return static_cast<std::uint32_t>(pair); }
    static std::uint32_t high(Word pair) { return static_cast<std::uint32_t>(pair >> 32U); }

    struct Interned {
        std::uint32_t number = none;
        bool fresh = false;
    };
    /// Returns the number of the pair, and adds the pair if the table does not contain it. If memory is exhausted, the
    /// function throws and does not change the table.
    Interned intern(Word pair);
    /// Adds a pair and returns its number. Requires that the table does not contain the pair. `find` does not find the
    /// pair until `index` is called for the pair.
    std::uint32_t append(Word pair);
    // Several threads may call `free_memory` and `index` at the same time, if each thread accesses only the shards of
    // its Share.
    struct Share {
        unsigned member = 0, members = 1;
    };
    /// Reserves memory for `more` further pairs. The reserved memory is insufficient if unusually many of these pairs
    /// belong to one shard.
    void free_memory(std::size_t more, Share share);
    /// Returns the shard of the pair. Shard s belongs to the thread `s % members` (see Share).
    std::uint8_t shard_of(Word pair) const { return static_cast<std::uint8_t>(shard_at(hash(pair))); }
    /// Adds an appended pair to the index, so that `find` finds it.
    void index(Word pair, std::uint32_t number);

    /// Returns the number of the pair, or `none` if the table does not contain the pair.
    std::uint32_t find(Word pair) const;
    /// `prefetch` loads the first slot of the pair into the cache. `prefetch_met` loads the stored pair to which this
    /// slot refers into the cache.
    void prefetch(Word pair) const;
    void prefetch_met(Word pair) const;

    Word operator[](std::uint32_t number) const {
        const std::size_t at = number & (chunk - 1);
        if ((number >> shift) == packed_.size()) return open_[at];
        const Chunk& packed = packed_[number >> shift];
        Word word = 0;
        std::memcpy(&word, packed.bytes.get() + at * packed.each, sizeof word);
        return (word & packed.low) | (word >> packed.low_bits & packed.high) << 32U;
    }

    std::size_t size() const { return size_; }
    std::size_t bytes() const { return chunk_bytes_ + index_bytes(); }
    std::size_t index_bytes() const;
    /// Frees the index; after this call, `find` does not find any pair.
    void drop_index();

private:
    static constexpr std::size_t shift = 9, chunk = std::size_t{1} << shift;
    struct Chunk {
        std::unique_ptr<std::uint8_t[]> bytes = {};
        std::uint32_t low = 0, high = 0;  // masks of the two numbers
        std::uint8_t low_bits = 0, each = 0;
    };
    struct Shard {
        std::vector<std::uint32_t> slots = {};  // a slot contains a print and the number of a pair plus 1; a free slot
                                                // is 0
        std::size_t used = 0;                   // number of used slots, including slots reserved for appended pairs
        unsigned number_bits = 0;
    };

    std::size_t shard_at(std::uint64_t hash) const { return hash >> 58U & (shards_.size() - 1); }
    void count(Shard& shard);
    static void put(Shard& shard, std::uint64_t hash, std::uint32_t number);
    void prefetch_pair(std::uint32_t number) const {
        if (const std::size_t at = number >> shift; at < packed_.size())
            __builtin_prefetch(packed_[at].bytes.get() + (number & (chunk - 1)) * packed_[at].each);
    }
    void rebuild(Shard& shard, std::size_t slots, std::size_t more);
    void pack();

    std::size_t size_ = 0;
    std::size_t chunk_bytes_ = 0;
    std::vector<Chunk> packed_ = {};
    std::unique_ptr<Word[]> open_;  // pairs of the last chunk, which is not packed yet
    std::vector<Shard> shards_;
};

}  // namespace grafverif::timed
