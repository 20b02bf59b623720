// SPDX-License-Identifier: MIT
// Cache of operation results: maps an operation and its operands to the resulting edge. The cache is lossy: a new
// result replaces any earlier result in the same slot. All operations share one table, which grows with the number of
// nodes.
//
// A garbage collection keeps a cache entry if it keeps all nodes to which the entry refers. Two unused bits of each of
// the first two operand edges encode the operation. An entry whose bits are all zero is empty. No stored result is zero
// in all bits, because the cache is not used for operations whose first operand is constant.
#pragma once

#include <cstdint>

#include "bdd/interrupt_poll.hpp"
#include "bdd/nodes.hpp"

namespace grafverif::bdd {

enum class Operation : std::uint32_t {
    And,
    Xor,
    Ite,
    Exists,
    AndExists,
    Cofactor,
    Simplify,
    Rename  ///< the third operand of the entry is the number of a renaming, not an edge
};

class Cache {
public:
    explicit Cache(Budget& budget) : entries_(budget) {}

    bool find(Operation operation, Edge f, Edge g, std::uint32_t h, Edge& result) const {
        const Entry requested = packed(operation, f, g, h, 0);
        const Entry& entry = entries_[slot(requested)];
        if (entry.f != requested.f || entry.g != requested.g || entry.h != requested.h) return false;
        result = entry.result;
        return true;
    }

    void insert(Operation operation, Edge f, Edge g, std::uint32_t h, Edge result) {
        const Entry entry = packed(operation, f, g, h, result);
        entries_[slot(entry)] = entry;
    }

    /// Doubles the number of slots and keeps all entries. If the memory is not available, returns false and leaves the
    /// cache unchanged. The first call allocates the initial entries.
    bool grow(InterruptPoll& watch);
    std::size_t size() const { return size_; }
    /// Removes all entries.
    void clear(InterruptPoll& watch);
    /// Removes entries that refer to unmarked nodes.
    void keep_marked(const NodeTable& table, InterruptPoll& watch);

    struct CachedResult {
        Operation operation = Operation::And;
        Edge f = 0, g = 0;
        std::uint32_t h = 0;
        Edge result = 0;
    };
    /// Returns the entry of a slot. If the member `f` of the result is 0, the slot is empty.
    CachedResult known(std::size_t slot) const;

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
    std::size_t size_ = 0;  ///< number of slots, a power of two; the block may be larger
    unsigned shift_ = 63;
};

}  // namespace grafverif::bdd
