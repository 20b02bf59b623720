// SPDX-License-Identifier: MIT
// NodeTable: the table of all nodes of a BddSpace.
//
// An edge represents a function by a node. The value of an edge is twice the index of the node, plus one if the
// function is the complement of the node's function (Brace, Rudell and Bryant 1990). Node 0 is the constant: edge 0 is
// false, edge 1 is true. A node represents the function "if the variable of the node then high else low". The low edge
// of a node is never complemented, so that each function has a unique edge. A function and its complement share one
// node. Because low edges are not complemented, the function of every node is false if all variables are false.
//
// A node stores its level, which is the position of its variable in the order. The topmost variable has level 0, and
// the constant node has the largest level. One hash table, with chains through the nodes, maps a triple (level, low,
// high) to its node. The table contains each triple at most once, so that equal functions have equal edges.
//
// `refs` counts the handles of each node; edges from other nodes are not counted. Nodes that are reachable neither from
// handles nor from frames of a running operation are garbage. Garbage nodes stay in the table until memory is needed.
// An operation that needs the triple of a garbage node uses this node again.
//
// A garbage collection and other changes of the table set the flag `stale`, which is true until the hash chains are
// rebuilt. If the rebuild is interrupted, `stale` stays true, and the next operation first completes the rebuild.
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

/// `constant_level`: level of the constant node, which has no variable. `free_level`: marks an unused node.
constexpr std::uint32_t constant_level = std::numeric_limits<std::uint32_t>::max() - 1, free_level = constant_level + 1;

/// Edges have 30 bits, because the cache uses the other two bits of a 32-bit word to encode the operation.
constexpr std::uint64_t most_nodes = std::uint64_t{1} << 29U;

struct Node {
    std::uint32_t level = free_level;
    Edge low = 0, high = 0;
    std::uint32_t next = 0;  ///< next node in the chain, the free list or the list of nodes to mark; 0 ends the list
};

class NodeTable {
public:
    explicit NodeTable(Budget& budget) : nodes(budget), refs(budget), marks(budget), buckets(budget) {}

    std::uint32_t bucket(std::uint32_t level, Edge low, Edge high) const {
        const std::uint64_t pair = (std::uint64_t{low} << 32U | high) * 0x9E3779B97F4A7C15U;
        return static_cast<std::uint32_t>(((pair ^ pair >> 32U) + level) * 0xD6E8FEB86659FD93U >> shift);
    }

    /// Returns the node of the triple; 0 if the table does not contain the triple.
    std::uint32_t find(std::uint32_t level, Edge low, Edge high) const {
        for (std::uint32_t n = buckets[bucket(level, low, high)]; n != 0; n = nodes[n].next)
            if (const Node& node = nodes[n]; node.low == low && node.high == high && node.level == level) return n;
        return 0;
    }

    bool has_free_node() const { return free != 0 || used < capacity; }
    std::uint64_t free_nodes() const { return capacity - in_use; }

    /// Creates a node for a triple that does not have a node yet. Requires a free node.
    std::uint32_t add(std::uint32_t level, Edge low, Edge high) {
        const std::uint32_t n = take();
        nodes[n] = {level, low, high, 0};
        link(n);
        return n;
    }

    std::uint32_t take() {
        assert(has_free_node());
        ++in_use;
        if (free == 0) return used++;
        const std::uint32_t n = free;
        free = nodes[n].next;
        return n;
    }

    /// Frees a node, which must not be in a chain.
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
    Block<std::uint32_t> refs;     ///< number of handles per node; 0 for free nodes
    Block<std::uint64_t> marks;    ///< one bit per node; all bits are 0 except during a walk or a garbage collection
    Block<std::uint32_t> buckets;  ///< first node of each chain; the size is a power of two
    unsigned shift = 63;           ///< number of bits by which a hash is shifted to select a bucket
    std::uint32_t capacity = 0;    ///< number of usable nodes; the blocks may be larger
    std::uint32_t used = 0;        ///< index of the first node that was never used
    std::uint32_t in_use = 0;      ///< number of nodes in use, including garbage

    /// First node of the list of unused nodes with an index below `used`; 0 if the list is empty.
    std::uint32_t free = 0;
    bool stale = false;     ///< true if the chains and the free list must be rebuilt
    bool sweeping = false;  ///< true if the rebuild must also free unmarked nodes
};

}  // namespace grafverif::bdd
