// SPDX-License-Identifier: MIT
// Pairs of 32-bit numbers, each pair numbered once, in the order of its insertion: a level of the tree that states are
// kept in (see Store).
//
// The pairs stand in chunks in the order of their numbers; a chunk that is full is packed: each of its pairs takes the
// bytes that the greatest numbers of the chunk need. The index is split into shards by hash; a shard is doubled when
// it is four fifths full, alone, so that only one shard is ever held twice. A slot of 32 bits keeps a pair's number, and
// in the bits that no number needs yet, a print of the hash: strangers are told apart without a look at the pairs.
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
    static constexpr std::uint32_t most =
        (1U << 30U) - 2;  ///< numbers that there are; beyond, `intern` throws bad_alloc

    explicit Pairs(unsigned shard_bits);

    static std::uint64_t hash(Word pair);
    static Word pair(std::uint32_t low, std::uint32_t high) { return low | Word{high} << 32U; }
    static std::uint32_t low(Word pair) { return static_cast<std::uint32_t>(pair); }
    static std::uint32_t high(Word pair) { return static_cast<std::uint32_t>(pair >> 32U); }

    struct Interned {
        std::uint32_t number = none;
        bool fresh = false;
    };
    /// The number of the pair; a new one if it has none. All of it is done, or nothing where memory ends.
    Interned intern(Word pair);
    /// The number that is given next, for a pair that has none; until it is indexed it is not found.
    std::uint32_t append(Word pair);
    // What follows is shared by several threads: each takes the shards of its own.
    struct Share {
        unsigned member = 0, members = 1;
    };
    /// Room for as many more pairs, unless chance has it that more of them fall into one shard.
    void make_room(std::size_t more, Share share);
    /// The shard of the pair; of so many members, the one of this number modulo theirs has it.
    std::uint8_t shard_of(Word pair) const { return static_cast<std::uint8_t>(shard_at(hash(pair))); }
    /// A pair that was appended is found from here on.
    void index(Word pair, std::uint32_t number);

    /// The number of the pair, or none.
    std::uint32_t find(Word pair) const;
    /// Fetches the place where the pair is looked up first, and then, what is met there.
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
    /// Gives the index back: from here on nothing can be looked up.
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
        std::size_t used = 0;                   // with those appended
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
