// SPDX-License-Identifier: MIT
// The states found, numbered in the order of discovery, and columns of facts about them.
//
// Memory grows in chunks, so that nothing is copied and no growth doubles the peak. The index of states is split into
// shards by hash; a shard grows by half when it is four fifths full, alone, so that only one shard is ever held twice.
// A slot keeps 32 bits of the hash beside the state's number: strangers are told apart without a look at the states.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "check/timed/layout.hpp"

namespace grafverif::timed {

/// A vector that never moves its elements.
template <class T>
class Column {
public:
    static constexpr std::size_t shift = 12, chunk = std::size_t{1} << shift;

    T& operator[](std::size_t i) { return chunks_[i >> shift][i & (chunk - 1)]; }
    const T& operator[](std::size_t i) const { return chunks_[i >> shift][i & (chunk - 1)]; }
    void push_back(T value) {
        make_room();
        (*this)[size_++] = value;
    }
    /// The next `push_back` needs no memory.
    void make_room() {
        if ((size_ & (chunk - 1)) == 0 && (size_ >> shift) == chunks_.size())
            chunks_.push_back(std::make_unique_for_overwrite<T[]>(chunk));
    }
    void pop_back() { --size_; }
    T& back() { return (*this)[size_ - 1]; }
    void assign(std::size_t size, T value) {
        clear();
        while (size_ < size) push_back(value);
    }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    std::size_t bytes() const { return chunks_.size() * chunk * sizeof(T); }
    void clear() {
        chunks_.clear();
        size_ = 0;
    }

private:
    std::vector<std::unique_ptr<T[]>> chunks_ = {};
    std::size_t size_ = 0;
};

class Store {
public:
    static constexpr std::uint32_t none = 0xFFFFFFFF;
    static constexpr std::uint32_t most = (1U << 29U) - 2;  ///< states that can be numbered (see Graph)

    explicit Store(const Layout& layout);

    struct Interned {
        std::uint32_t state = none;
        bool fresh = false;
    };
    /// The number of the state in `words`; a new one if it is not there.
    Interned intern(const Word* words, std::uint64_t hash);
    /// The number of the state, or none.
    std::uint32_t find(const Word* words, std::uint64_t hash) const;
    /// Fetches the place where `hash` is looked up first.
    void prefetch(std::uint64_t hash) const;

    void load(std::uint32_t state, Word* words) const;
    bool is(std::uint32_t state, const Word* words) const;

    std::size_t size() const { return size_; }
    /// One state, packed.
    std::size_t state_bytes() const { return halves_ * 4; }
    std::size_t bytes() const { return chunks_.size() * chunk * halves_ * 4 + slots_ * sizeof(Slot); }
    /// Gives the index back: from here on no state can be looked up.
    void drop_index();

private:
    static constexpr std::size_t shift = 12, chunk = std::size_t{1} << shift;
    static constexpr unsigned shard_bits = 6;
    struct Slot {
        std::uint32_t print = 0;
        std::uint32_t state = 0;
    };  // state + 1; 0: free
    struct Shard {
        std::vector<Slot> slots = {};
        std::size_t used = 0;
    };

    const std::uint32_t* at(std::uint32_t state) const {
        return chunks_[state >> shift].get() + (state & (chunk - 1)) * halves_;
    }
    static std::size_t home(std::uint32_t print, std::size_t slots) {
        return static_cast<std::size_t>((std::uint64_t{print} * slots) >> 32U);
    }
    void grow(Shard& shard);
    std::uint32_t append(const Word* words);

    std::size_t halves_;
    std::size_t size_ = 0;
    std::size_t slots_ = 0;
    std::vector<std::unique_ptr<std::uint32_t[]>> chunks_ = {};
    std::vector<Shard> shards_;
};

}  // namespace grafverif::timed
