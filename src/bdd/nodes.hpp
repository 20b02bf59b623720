// SPDX-License-Identifier: MIT
// The nodes of a space and the table that finds them.
//
// An edge is a node's index, doubled, plus one where the function is the complement of the node's (Brace, Rudell and
// Bryant 1990). Node 0 is the constant: edge 0 is false, edge 1 true. A node says "if my variable then high else low";
// its low edge is never a complement, which makes nodes canonical: of a function and its complement only that one is
// stored that is false where all variables are false.
//
// A node stores its level, the place of its variable in the order; the levels below are larger, and largest is that of
// the constant. One table, with chains through the nodes, finds the node of a triple (level, low, high). No node is
// stored twice, so equal functions are equal edges.
//
// Nodes are not counted where they are used; handles are counted, per node (`refs`). What no handle, no frame of a
// running operation and no live node reaches is garbage, kept until room is needed: until then it may be found again.
//
// While the chains are being rebuilt they are `stale`. Who is stopped in the midst of that leaves them so, and the next
// operation completes it first.
#pragma once

#include <cstdint>
#include <limits>

#include "bdd/block.hpp"

namespace grafverif::bdd {

using Edge = std::uint32_t;
constexpr Edge false_edge = 0, true_edge = 1;

constexpr bool is_constant(Edge edge) { return edge < 2; }
constexpr Edge complement_bit(Edge edge) { return edge & 1U; }
constexpr std::uint32_t index_of(Edge edge) { return edge >> 1U; }

/// Not a level; `free_level` marks a node that stands for nothing.
constexpr std::uint32_t constant_level = std::numeric_limits<std::uint32_t>::max() - 1, free_level = constant_level + 1;

/// Edges have 30 bits: the cache keeps the name of an operation beside them.
constexpr std::uint64_t most_nodes = std::uint64_t{1} << 29U;

struct Node {
    std::uint32_t level = free_level;
    Edge low = 0, high = 0;
    std::uint32_t next = 0;  ///< in the chain, in the list of free nodes, or in the list of those to be marked; 0: none
};

class NodeTable {
public:
    explicit NodeTable(Budget& budget) : nodes(budget), refs(budget), marks(budget), buckets(budget) {}

    std::uint32_t bucket(std::uint32_t level, Edge low, Edge high) const {
        const std::uint64_t pair = (std::uint64_t{low} << 32U | high) * 0x9E3779B97F4A7C15U;
        return static_cast<std::uint32_t>(((pair ^ pair >> 32U) + level) * 0xD6E8FEB86659FD93U >> shift);
    }

    /// The node of the triple; 0: there is none.
    std::uint32_t find(std::uint32_t level, Edge low, Edge high) const {
        for (std::uint32_t n = buckets[bucket(level, low, high)]; n != 0; n = nodes[n].next)
            if (const Node& node = nodes[n]; node.low == low && node.high == high && node.level == level) return n;
        return 0;
    }

    bool has_room() const { return free != 0 || used < capacity; }
    std::uint64_t room() const { return capacity - in_use; }

    /// A new node for a triple that has none. Requires room.
    std::uint32_t add(std::uint32_t level, Edge low, Edge high) {
        const std::uint32_t n = take();
        nodes[n] = {level, low, high, 0};
        link(n);
        return n;
    }

    std::uint32_t take() {
        assert(has_room());
        ++in_use;
        if (free == 0) return used++;
        const std::uint32_t n = free;
        free = nodes[n].next;
        return n;
    }

    /// Requires that the node is in no chain.
    void release(std::uint32_t n) {
        nodes[n] = {free_level, 0, 0, free};
        free = n;
        --in_use;
    }

    void link(std::uint32_t n) {
        std::uint32_t& first = buckets[bucket(nodes[n].level, nodes[n].low, nodes[n].high)];
        nodes[n].next = first;
        first = n;
    }

    void unlink(std::uint32_t n) {
        std::uint32_t* at = &buckets[bucket(nodes[n].level, nodes[n].low, nodes[n].high)];
        while (*at != n) at = &nodes[*at].next;
        *at = nodes[n].next;
    }

    bool marked(std::uint32_t n) const { return (marks[n >> 6U] >> (n & 63U) & 1U) != 0; }
    void mark(std::uint32_t n) { marks[n >> 6U] |= std::uint64_t{1} << (n & 63U); }
    void unmark(std::uint32_t n) { marks[n >> 6U] &= ~(std::uint64_t{1} << (n & 63U)); }

    Block<Node> nodes;
    Block<std::uint32_t> refs;     ///< handles per node; of free nodes 0
    Block<std::uint64_t> marks;    ///< one bit per node, 0 except while a walk or a collection lasts
    Block<std::uint32_t> buckets;  ///< a power of two; the first of each chain
    unsigned shift = 63;           ///< turns a hash into a bucket
    std::uint32_t capacity = 0;    ///< nodes that fit; the blocks may be larger
    std::uint32_t used = 0;        ///< nodes from here on were never in use
    std::uint32_t in_use = 0;      ///< garbage counts
    std::uint32_t free = 0;        ///< list of nodes below `used` that are not in use
    bool stale = false;            ///< chains and list of free nodes are to be rebuilt,
    bool sweeping = false;         ///< and nodes that are not marked freed by that
};

}  // namespace grafverif::bdd
