// SPDX-License-Identifier: MIT
// layered: places for a drawing of states and arrows that is read in one direction.
//
// A layer holds the nodes that are equally many arrows away from the first node: an arrow leads to the next layer, stays
// in its own or goes back. It leaves its node on the far side, in a row of its own, and its label lies along that row.
// Between the layers is a channel, where arrows to one node meet in one line: those that come from the layer before it
// enter the node on the near side, all others on the far side, above its rows. A line that goes back has a lane of its own
// in each layer that it passes.
//
// Guaranteed: no two of the boxes of nodes and labels overlap, no line runs through one, lines are horizontal or
// vertical, and those of different nodes meet in crossings only. The result depends on the graph alone.
#pragma once

#include <cstddef>
#include <vector>

#include "emit/layout/layout.hpp"

namespace grafverif::layout {

/// What is to be drawn, with the room that texts need.
struct States {
    struct Arrow {
        std::size_t from = 0, to = 0;
        Size label = {};
        bool ends = false;  ///< it leads nowhere
    };
    std::vector<Size> nodes = {};
    std::vector<Arrow> arrows = {};
    std::size_t first = 0;
};

/// Which way layers follow each other.
enum class Direction { Across, Down };

struct Layered {
    struct Arrow {
        std::vector<Point> points = {};
        Box label = {};
    };
    std::vector<Box> nodes = {};
    std::vector<Arrow> arrows = {};
    std::vector<Point> joints = {};  ///< where arrows to one node meet
    Size size = {};                  ///< all of it lies between the origin and this corner
};

Layered layered(const States& states, Direction direction);

}  // namespace grafverif::layout
