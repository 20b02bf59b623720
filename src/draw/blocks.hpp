// SPDX-License-Identifier: MIT
// Blocks: a flow taken apart into what stands below each other and what stands beside each other.
//
// Each node is split into two ends with the node between them; arcs join ends. Two rules of series-parallel graphs then
// melt the graph: two things in a row at an end that nothing else meets are a Series, two things between the same ends
// are a Parallel. A branch that leads nowhere (its last node goes upward, or is a sink) or comes from nowhere stands
// beside another one at the end that it hangs on. Charts that are written as sequences, selections and parallel branches
// melt to one block. What does not melt is a Core: strips that are joined at their ends in any way.
//
// An upward link that leaves a node beside other links, or enters a bar beside others, has a Stub: a place of its own on
// the line that they share. Linear in the size of the flow.
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
    std::size_t what = nowhere;  ///< Node: of the flow; Arc, Exit, Entry: an arc of the flow, the latter of upward ones
    std::size_t parent = nowhere, first = nowhere, last = nowhere, next = nowhere;  ///< blocks
    std::size_t key = 0;  ///< blocks stand beside each other in the order of their keys
    bool open = false;    ///< of a Parallel: it does not reach from one end to the other
    /// Of a strip in a Core: its ends, numbered.
    std::size_t above = nowhere, below = nowhere;
    /// What it lies in: row r is 2r + 1, the channel above it 2r, that below it 2r + 2.
    std::size_t low = nowhere, high = 0;
};

/// A block comes after all that it is made of; `root` is a Parallel of everything. Some belong to nothing any more, and
/// have no parent.
struct Blocks {
    std::vector<Block> blocks = {};
    std::size_t root = nowhere;
    std::vector<std::size_t> of_node = {};              ///< per node
    std::vector<std::size_t> of_arc = {};               ///< per arc; not of upward ones
    std::vector<std::size_t> exits = {}, entries = {};  ///< per arc; nowhere: it has none

    bool contains(std::size_t block) const { return block == root || blocks[block].parent != nowhere; }
};

Blocks blocks_of(const Flow& flow, const Order& order);

}  // namespace grafverif::draw
