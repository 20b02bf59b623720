// SPDX-License-Identifier: MIT
// Blocks: series-parallel decomposition of a flow.
//
// Each node is split into two ends with the node between them; arcs connect ends. The graph is reduced by the two rules
// of series-parallel graphs. Two elements in sequence at an end without others form a Series; two elements between the
// same ends form a Parallel. Charts written as sequences, selections and parallel branches are reduced to one block. An
// irreducible rest is a Core: strips connected arbitrarily at their ends.
//
// A branch has no continuation if its last node leads upward or is a sink; similarly it may have no beginning. Such a
// branch is put in parallel with another one at the end to which it is attached.
//
// An upward link that leaves a node together with other links, or enters a bar together with others, has a Stub: a
// separate place on the shared line. The algorithm is linear in the size of the flow.
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
    std::size_t what = nowhere;  ///< Node: index in the flow; Arc, Exit, Entry: an arc of the flow, for the latter two
                                 ///< an upward one
    std::size_t parent = nowhere, first = nowhere, last = nowhere, next = nowhere;  ///< blocks
    std::size_t key = 0;  ///< parallel blocks are placed in the order of their keys
    bool open = false;    ///< for a Parallel: it does not extend from one end to the other
    /// For a strip in a Core: numbers of its ends.
    std::size_t above = nowhere, below = nowhere;
    /// Vertical range: row r is 2r + 1, the channel above it 2r, that below it 2r + 2.
    std::size_t low = nowhere, high = 0;
};

/// A block comes after its parts; `root` is a Parallel of all components. Blocks that are no longer used have no
/// parent.
struct Blocks {
    std::vector<Block> blocks = {};
    std::size_t root = nowhere;
    std::vector<std::size_t> of_node = {};              ///< per node
    std::vector<std::size_t> of_arc = {};               ///< per arc; not for upward ones
    std::vector<std::size_t> exits = {}, entries = {};  ///< per arc; nowhere: it has none

    bool contains(std::size_t block) const { return block == root || blocks[block].parent != nowhere; }
};

Blocks blocks_of(const Flow& flow, const Order& order);

}  // namespace grafverif::draw
