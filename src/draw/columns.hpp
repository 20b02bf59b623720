// SPDX-License-Identifier: MIT
// Columns: how far to the right everything stands. What is in one Series stands on one axis; what is beside each other
// keeps apart; upward links go in lanes beside the smallest block that holds both of their ends.
//
// No two of these share a column where their rows meet, whatever the flow: a vertical line never runs through a node.
#pragma once

#include <vector>

#include "draw/blocks.hpp"
#include "draw/flow.hpp"

namespace grafverif::draw {

/// The way of upward links from below a node to above another one: `low` and `high` are channels.
struct Lane {
    int x = 0;
    std::size_t low = nowhere, high = 0;
};

struct Columns {
    std::vector<int> nodes = {};
    std::vector<int> arcs = {};                 ///< of those that are not upward
    std::vector<int> exits = {}, entries = {};  ///< of arcs that have one
    std::vector<std::size_t> lane_of = {};      ///< per arc: upward ones have one
    std::vector<Lane> lanes = {};
    int width = 0;
};

/// `pitch`: from one vertical line to the next, at least.
Columns columns_of(const Flow& flow, const Order& order, const Blocks& blocks, int pitch);

}  // namespace grafverif::draw
