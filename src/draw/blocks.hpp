// SPDX-License-Identifier: MIT
// Blocks: the series-parallel decomposition of a flow (the graph of a partial chart).
//
// Each node connects two ends, one above and one below the node. Arcs connect ends of different nodes. The graph is
// reduced by the two rules of series-parallel graphs. Two elements form a Series if they meet at an end to which no
// other element is connected. Two elements between the same ends form a Parallel. Charts that consist of sequences,
// selections and parallel branches are reduced to one block. If the reduction does not result in one block, the
// remaining blocks form a Core: its parts (strips) are connected arbitrarily at their ends.
//
// If the last node of a branch is a sink or has only upward links, the branch has no continuation; similarly, a branch
// may have no beginning. A branch without continuation or beginning is attached at one end only; it is placed in
// parallel with another branch at this end.
//
// An upward link has a stub if it leaves a node, or enters a bar, together with other links. A stub is a separate
// position on the shared line. The algorithm is linear in the size of the flow.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "draw/flow.hpp"

namespace grafverif::draw {

inline constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();

struct Block {
    enum class Kind { Node, Arc, Exit, Entry, Series, Parallel, Core };
    Kind kind = Kind::Node;
    /// For the kind Node: index of the node in the flow. For Arc, Exit and Entry: index of the arc in the flow; for
    /// Exit and Entry, this arc is an upward link.
    std::size_t what = nowhere;
    std::size_t parent = nowhere, first = nowhere, last = nowhere, next = nowhere;  ///< indices of related blocks
    std::size_t key = 0;  ///< parallel blocks are placed in the order of their keys
    bool open = false;    ///< true if this part of a Parallel does not extend from one end to the other

    /// For a strip in a Core: indices of the upper and the lower end of the strip.
    std::size_t above = nowhere, below = nowhere;
    /// Vertical range. Row r has the index 2r + 1, the channel above the row has the index 2r, and the channel below
    /// the row has the index 2r + 2.
    std::size_t low = nowhere, high = 0;
};

/// All blocks of a flow. The index of a block is greater than the indices of its parts. `root` is a Parallel of all
/// components. Unused blocks have no parent.
struct Blocks {
    std::vector<Block> blocks = {};
    std::size_t root = nowhere;
    std::vector<std::size_t> of_node = {};              ///< block of each node
    std::vector<std::size_t> of_arc = {};               ///< block of each arc, except upward arcs
    std::vector<std::size_t> exits = {}, entries = {};  ///< stubs of each arc; nowhere if the arc has no stub

    bool contains(std::size_t block) const { return block == root || blocks[block].parent != nowhere; }
};

Blocks blocks_of(const Flow& flow, const Order& order);

}  // namespace grafverif::draw
