// SPDX-License-Identifier: MIT
// The cache of results: operation and operands to the edge that came out. It may forget anything at any time; a new
// result takes the place of an old one with the same slot. One table for all operations, so those that are used share
// it; it grows with the nodes.
//
// Entries survive a garbage collection while all their nodes do. In an entry the operands' edges leave two bits each,
// where the operation is kept. An entry of zeroes is none: no operation asks about constants.
#pragma once

#include <cstdint>

#include "bdd/nodes.hpp"
#include "bdd/watch.hpp"

namespace grafverif::bdd {

enum class Operation : std::uint32_t {
    And,
    Xor,
    Ite,
    Exists,
    AndExists,
    Cofactor,
    Simplify,
    Rename  ///< the third operand is the number of a renaming, no edge
};

class Cache {
public:
    explicit Cache(Budget& budget) : entries_(budget) {}

    bool find(Operation operation, Edge f, Edge g, std::uint32_t h, Edge& result) const {
        const Entry asked = packed(operation, f, g, h, 0);
        const Entry& entry = entries_[slot(asked)];
        if (entry.f != asked.f || entry.g != asked.g || entry.h != asked.h) return false;
        result = entry.result;
        return true;
    }

    void insert(Operation operation, Edge f, Edge g, std::uint32_t h, Edge result) {
        const Entry entry = packed(operation, f, g, h, result);
        entries_[slot(entry)] = entry;
    }

    /// Twice as large, what is known kept; or unchanged where that does not fit. The first time: some entries.
    bool grow(Watch& watch);
    std::size_t size() const { return size_; }
    /// Forgets everything.
    void clear(Watch& watch);
    /// Forgets what has to do with a node that is not marked.
    void keep_marked(const NodeTable& table, Watch& watch);

    struct Known {
        Operation operation = Operation::And;
        Edge f = 0, g = 0;
        std::uint32_t h = 0;
        Edge result = 0;
    };
    /// The entry of a slot; f is 0: none.
    Known known(std::size_t slot) const;

private:
    struct Entry {
        std::uint32_t f = 0, g = 0, h = 0, result = 0;
    };
    static constexpr std::uint32_t edge_mask = (std::uint32_t{1} << 30U) - 1;

    static Entry packed(Operation operation, Edge f, Edge g, std::uint32_t h, Edge result) {
        const auto name = static_cast<std::uint32_t>(operation);
        return {f | (name & 3U) << 30U, g | name >> 2U << 30U, h, result};
    }

    std::size_t slot(const Entry& key) const {
        const std::uint64_t pair = (std::uint64_t{key.f} << 32U | key.g) * 0x9E3779B97F4A7C15U;
        return ((pair ^ pair >> 32U) + key.h) * 0xD6E8FEB86659FD93U >> shift_;
    }

    void shrink_to_nothing();

    Block<Entry> entries_;
    std::size_t size_ = 0;  ///< a power of two; the block may be larger
    unsigned shift_ = 63;
};

}  // namespace grafverif::bdd
