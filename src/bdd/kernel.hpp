// SPDX-License-Identifier: MIT
// Kernel: all data of a BddSpace, namely the variable order, the nodes, the cache, and the frames of the running
// operation. The operations on a kernel are functions in several files: kernel.cpp (allocation), collect.cpp,
// connectives.cpp, quantify.cpp, restrict.cpp, rename.cpp, reorder.cpp, verify.cpp; walks.cpp and count.cpp contain
// operations that create no nodes.
//
// The creation of a node may collect garbage or throw BddExhausted. Therefore each edge that an operation still needs
// must be in one of its frames or be an argument of `make`. The operands of a public operation are protected by
// handles.
#pragma once

#include <initializer_list>
#include <vector>

#include "bdd/cache.hpp"
#include "bdd/interrupt_poll.hpp"
#include "bdd/nodes.hpp"

namespace grafverif::bdd {

/// A pending call of an operation. Operands and results are edges, so that a garbage collection can mark their nodes.
struct Frame {
    Edge f = 0, g = 0, h = 0;            ///< operands of the call
    Edge low = 0;                        ///< result of the low branch, valid if `has_low`
    std::uint32_t level = 0;             ///< level at which the operation splits its operands
    bool has_low = false, flip = false;  ///< `flip` is true if the result must be complemented
};

/// The explicit stack of frames.
class Frames {
public:
    explicit Frames(Budget& budget) : frames_(budget) {}

    std::size_t size() const { return size_; }
    Frame& top() { return frames_[size_ - 1]; }
    const Frame& operator[](std::size_t index) const { return frames_[index]; }
    void pop() { --size_; }
    void clear() { size_ = 0; }
    void push(const Frame& frame) {
        if (size_ == frames_.size()) enlarge();
        frames_[size_++] = frame;
    }

private:
    void enlarge();

    Block<Frame> frames_;
    std::size_t size_ = 0;
};

/// The variable order: a map between variables and levels, and the groups of variables.
class Order {
public:
    explicit Order(Budget& budget) : level_of(budget), variable_at(budget), group_of(budget) {}

    std::uint32_t size() const { return size_; }
    /// Adds `count` variables at the bottom of the order. Returns false if the memory is not available.
    bool add(std::uint32_t count);

    Block<std::uint32_t> level_of, variable_at;
    Block<std::uint32_t> group_of;  ///< for each variable: the first variable of its group; a group is contiguous
    std::uint64_t version = 0;      ///< version number of the order; every change of the order increases it

private:
    std::uint32_t size_ = 0;
};

struct Kernel {
    explicit Kernel(const BddLimits& limits)
        : budget{limits.memory, 0}, watch(limits), order(budget), table(budget), cache(budget), frames(budget) {}
    Kernel(const Kernel&) = delete;
    Kernel& operator=(const Kernel&) = delete;

    const Node& node(Edge edge) const { return table.nodes[index_of(edge)]; }
    std::uint32_t level(Edge edge) const { return node(edge).level; }
    Edge low(Edge edge) const { return node(edge).low ^ complement_bit(edge); }
    Edge high(Edge edge) const { return node(edge).high ^ complement_bit(edge); }
    /// Return the low or high branch of an edge if its node is at `level`; otherwise, return the edge itself.
    Edge low(Edge edge, std::uint32_t level) const { return node(edge).level == level ? low(edge) : edge; }
    Edge high(Edge edge, std::uint32_t level) const { return node(edge).level == level ? high(edge) : edge; }

    Budget budget;
    InterruptPoll watch;
    Order order;
    NodeTable table;
    Cache cache;
    Frames frames;
    /// Last number that was assigned to a renaming; the number identifies the renaming in the cache.
    std::uint32_t numbers = 0;
    std::uint64_t handles = 0;  ///< number of all handles of the space, the sum of NodeTable::refs

    /// Number of nodes above which operations reorder; 0 disables automatic reordering.
    std::uint64_t reorder_above = 0;
};

/// Obtains memory for a node by growth of the table or by a garbage collection, which does not free the nodes of `low`
/// and `high`. Throws BddExhausted if no memory can be obtained.
void free_memory(Kernel& kernel, Edge low, Edge high);
/// Rebuilds the hash chains and the free list of the node table, and completes an interrupted sweep.
void relink(Kernel& kernel);
/// Frees the nodes that are not reachable from handles, frames or the edges `spared`.
void collect(Kernel& kernel, std::initializer_list<Edge> spared);
/// Doubles the capacity of the node table, or grows it as far as the memory limit permits. Returns false if the limit
/// permits less than a sixteenth of additional nodes, or if there is no memory for the hash table or the cache.
bool grow(Kernel& kernel);

/// Returns the function "if the variable of `level` then high else low". Requires that `low` and `high` depend only on
/// variables below `level`.
inline Edge make(Kernel& kernel, std::uint32_t level, Edge low, Edge high) {
    if (low == high) return low;
    const Edge flip = complement_bit(low);
    low ^= flip;
    high ^= flip;
    NodeTable& table = kernel.table;
    if (!table.has_free_node()) [[unlikely]] {
        if (table.capacity != 0)
            if (const std::uint32_t n = table.find(level, low, high)) return n << 1U | flip;
        free_memory(kernel, low, high);
    }
    std::uint32_t& first = table.buckets[table.bucket(level, low, high)];
    for (std::uint32_t n = first; n != 0; n = table.nodes[n].next)
        if (const Node& node = table.nodes[n]; node.low == low && node.high == high && node.level == level)
            return n << 1U | flip;
    const std::uint32_t n = table.take();
    table.nodes[n] = {level, low, high, first};
    first = n;
    return n << 1U | flip;
}

/// Session: exists during one public operation. The constructor completes an interrupted sweep, and the destructor
/// removes the frames of the operation.
class Session {
public:
    explicit Session(Kernel& kernel);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    ~Session() { kernel_.frames.clear(); }

private:
    Kernel& kernel_;
};

Edge conjunction(Kernel& kernel, Edge f, Edge g);
inline Edge disjunction(Kernel& kernel, Edge f, Edge g) { return conjunction(kernel, f ^ 1U, g ^ 1U) ^ 1U; }
Edge exclusive(Kernel& kernel, Edge f, Edge g);
Edge if_then_else(Kernel& kernel, Edge f, Edge g, Edge h);
Edge quantified(Kernel& kernel, Edge f, Edge cube);
Edge product_quantified(Kernel& kernel, Edge f, Edge g, Edge cube);
Edge restricted(Kernel& kernel, Edge f, Edge cube);
Edge simplified(Kernel& kernel, Edge f, Edge care);

/// Improves the variable order by sifting. The variables of a group remain adjacent.
void reorder(Kernel& kernel);

/// Returns the nodes of a function, except the constant node, with children before parents. On return, all marks are
/// cleared.
std::vector<std::uint32_t> nodes_of(Kernel& kernel, Edge root);

}  // namespace grafverif::bdd
