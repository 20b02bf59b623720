// SPDX-License-Identifier: MIT
// layered: layout of a graph of states and arrows in one reading direction.
//
// A layer contains the nodes with equal distance from the first node: an arrow leads to the next layer, stays in its
// layer or goes back. It leaves its node on the far side, in a separate row, and its label lies along that row. Between
// the layers is a channel, where arrows to one node join in one line. Arrows from the previous layer enter the node on
// the near side, all others on the far side, above its rows. A backward line has a separate lane in each layer that it
// passes.
//
// Guaranteed: boxes of nodes and labels do not overlap, and no line runs through one. Lines are horizontal or vertical,
// and those of different nets meet only in crossings. The result depends only on the graph.
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
        bool ends = false;  ///< without target
    };
    std::vector<Size> nodes = {};
    std::vector<Arrow> arrows = {};
    std::size_t first = 0;
};

/// Direction in which layers follow each other.
enum class Direction { Across, Down };

struct Layered {
    struct Arrow {
        std::vector<Point> points = {};
        Box label = {};
    };
    std::vector<Box> nodes = {};
    std::vector<Arrow> arrows = {};
    std::vector<Point> joints = {};  ///< points where arrows to one node join
    Size size = {};                  ///< the drawing lies between the origin and this corner
};

Layered layered(const States& states, Direction direction);

}  // namespace grafverif::layout
