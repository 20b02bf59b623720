// SPDX-License-Identifier: MIT
// layered: computes the layout of a graph of states and arrows in one reading direction.
//
// A layer contains the nodes with equal distance from the first node. An arrow leads to the next layer, to the same
// layer or to a previous layer. An arrow leaves its node at the side that faces the next layer, in a separate row, and
// its label is placed along this row. Between two layers is a channel, in which arrows to one node join in one line. An
// arrow from the previous layer ends at the side of its target node that faces the previous layer. All other arrows end
// at the opposite side, above the rows of the node. A backward arrow has a separate lane in each layer that it crosses.
//
// Guarantees: boxes of nodes and labels do not overlap, and no line intersects a box. Lines are horizontal or vertical,
// and lines of different nets meet only in crossings. The result depends only on the graph.
#pragma once

#include <cstddef>
#include <vector>

#include "emit/layout/layout.hpp"

namespace grafverif::layout {

/// The graph to draw, with the sizes of its texts.
struct States {
    struct Arrow {
        std::size_t from = 0, to = 0;
        Size label = {};
        bool ends = false;  ///< true if the arrow has no target
    };
    std::vector<Size> nodes = {};
    std::vector<Arrow> arrows = {};
    std::size_t first = 0;
};

/// The direction from one layer to the next.
enum class Direction { Across, Down };

struct Layered {
    struct Arrow {
        std::vector<Point> points = {};
        Box label = {};
    };
    std::vector<Box> nodes = {};
    std::vector<Arrow> arrows = {};
    std::vector<Point> joints = {};  ///< points where arrows to one node join
    Size size = {};                  ///< size of the drawing, which begins at the origin
};

Layered layered(const States& states, Direction direction);

}  // namespace grafverif::layout
