// SPDX-License-Identifier: MIT
// Pairs of 32-bit numbers, each pair numbered once, in the order of its insertion: a level of the tree in which states
// are stored (see Store).
//
// The pairs are in chunks in the order of their numbers. A full chunk is packed: each of its pairs uses the bytes that
// the greatest numbers of the chunk need. The index is split into shards by hash. A shard is doubled separately when it
// is four fifths full, so that only one shard is duplicated at a time. A slot of 32 bits contains a pair's number. The
// bits that no number uses yet contain a print of the hash, which distinguishes most other pairs without reading them.
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
    static constexpr std::uint32_t most = (1U << 30U) - 2;  ///< maximum count; above it, `intern` throws bad_alloc

    explicit Pairs(unsigned shard_bits);

    static std::uint64_t hash(Word pair);
    static Word pair(std::uint32_t low, std::uint32_t high) { return low | Word{high} << 32U; }
    static std::uint32_t low(Word pair) { return static_cast<std::uint32_t>(pair); }
    static std::uint32_t high(Word pair) { return static_cast<std::uint32_t>(pair >> 32U); }

    struct Interned {
        std::uint32_t number = none;
        bool fresh = false;
    };
    /// The number of the pair; a new one if it has none. Complete, or without effect if memory is exhausted.
    Interned intern(Word pair);
    /// The next number, for a pair that has none; the pair is not found before it is indexed.
    std::uint32_t append(Word pair);
    // The following functions may run in several threads: each accesses only its own shards.
    struct Share {
        unsigned member = 0, members = 1;
    };
    /// Reserves memory for further pairs; it may not suffice if unusually many of them fall into one shard.
    void free_memory(std::size_t more, Share share);
    /// The shard of the pair; it belongs to the member whose number equals it modulo the number of members.
    std::uint8_t shard_of(Word pair) const { return static_cast<std::uint8_t>(shard_at(hash(pair))); }
    /// Makes an appended pair findable.
    void index(Word pair, std::uint32_t number);

    /// The number of the pair, or none.
    std::uint32_t find(Word pair) const;
    /// Prefetches the first slot of the pair, and then the pair that it refers to.
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
    /// Frees the index: from here on no pair can be found.
    void drop_index();

private:
    static constexpr std::size_t shift = 9, chunk = std::size_t{1} << shift;
    struct Chunk {
        std::unique_ptr<std::uint8_t[]> bytes = {};
        std::uint32_t low = 0, high = 0;  // masks
        std::uint8_t low_bits = 0, each = 0;
    };
    struct Shard {
        std::vector<std::uint32_t> slots = {};  // print and number + 1; 0: free
        std::size_t used = 0;                   // including appended ones
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
    std::unique_ptr<Word[]> open_;  // the last chunk
    std::vector<Shard> shards_;
};

}  // namespace grafverif::timed
