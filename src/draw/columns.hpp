// SPDX-License-Identifier: MIT
// Columns: horizontal positions. The parts of a Series share one axis; parallel parts keep a distance; upward links run
// in lanes next to the smallest block that contains both of their ends.
//
// No two of these share a column in a common row, for every flow: a vertical line never runs through a node.
#pragma once

#include <vector>

#include "draw/blocks.hpp"
#include "draw/flow.hpp"

namespace grafverif::draw {

/// Path of upward links from below a node to above another one: `low` and `high` are channels.
struct Lane {
    int x = 0;
    std::size_t low = nowhere, high = 0;
};

struct Columns {
    std::vector<int> nodes = {};
    std::vector<int> arcs = {};                 ///< for arcs that are not upward
    std::vector<int> exits = {}, entries = {};  ///< for arcs that have one
    std::vector<std::size_t> lane_of = {};      ///< per upward arc
    std::vector<Lane> lanes = {};
    int width = 0;
};

/// `pitch`: minimal distance of vertical lines.
Columns columns_of(const Flow& flow, const Order& order, const Blocks& blocks, int pitch);

}  // namespace grafverif::draw
