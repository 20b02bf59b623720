// SPDX-License-Identifier: MIT
// layout: computes positions of nodes, links and labels of a small drawing, such as an automaton in an editor. Drawings
// of charts have a separate layout (draw/).
//
// Nodes are placed on a line if the links form a path, otherwise on an ellipse, in an order that keeps links short.
// Links between the same two nodes run in parallel lanes. Each loop is drawn as a petal in the widest gap between the
// links of its node. Labels are then placed sequentially. Each label is placed at the first of its candidate positions
// at which it overlaps no other element and intersects no link. If there is no such position for a label, the drawing
// is enlarged and the layout is repeated; the best attempt is used. A label that still has no position is placed below
// the drawing, which is not necessary for any chart in the samples.
//
// Guarantee: boxes of nodes and labels do not overlap. The result depends only on the graph.
#pragma once

#include <cstddef>
#include <vector>

namespace grafverif::layout {

struct Point {
    int x = 0, y = 0;  ///< position in pixels; y grows downwards
    bool operator==(const Point&) const = default;
};

struct Size {
    int width = 0, height = 0;
    bool operator==(const Size&) const = default;
};

struct Box {
    Point at = {};  ///< upper-left corner
    Size size = {};
};

bool overlap(const Box& left, const Box& right);

/// The graph to draw. An empty label size means that there is no label.
struct Graph {
    struct Link {
        std::size_t from = 0, to = 0;
        Size label = {};
    };
    std::vector<Size> nodes = {};  ///< size of the label of each node
    std::vector<Link> links = {};
};

struct Drawing {
    struct Node {
        Point centre = {}, label = {};
    };
    struct Link {
        std::vector<Point> nails = {};
        Point label = {};
    };
    std::vector<Node> nodes = {};
    std::vector<Link> links = {};
};

inline constexpr int node_radius = 14;

/// Returns the square around a node.
Box node_box(Point centre);

Drawing draw(const Graph& graph);

}  // namespace grafverif::layout
