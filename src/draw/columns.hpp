// SPDX-License-Identifier: MIT
// Columns: computes horizontal positions. The parts of a Series share one axis. Parallel parts have a minimum distance.
// An upward link runs in a lane next to the smallest block that contains both ends of the link.
//
// Guarantee: two parts or lanes never have the same column in the same row. Therefore a vertical line never runs
// through a node.
#pragma once

#include <vector>

#include "draw/blocks.hpp"
#include "draw/flow.hpp"

namespace grafverif::draw {

/// Vertical path of upward links, from below their first node to above their last node. `low` and `high` are the first
/// and last channel of the lane.
struct Lane {
    int x = 0;
    std::size_t low = nowhere, high = 0;
};

struct Columns {
    std::vector<int> nodes = {};
    /// Column of each arc that is not upward.
    std::vector<int> arcs = {};
    /// Column of the exit stub and of the entry stub of each arc with stubs.
    std::vector<int> exits = {}, entries = {};
    std::vector<std::size_t> lane_of = {};  ///< lane of each upward arc
    std::vector<Lane> lanes = {};
    int width = 0;
};

/// Computes the columns. `pitch` is the minimum distance of vertical lines.
Columns columns_of(const Flow& flow, const Order& order, const Blocks& blocks, int pitch);

}  // namespace grafverif::draw
