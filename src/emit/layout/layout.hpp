// SPDX-License-Identifier: MIT
// layout: places for the nodes, links and labels of a small drawing, such as an automaton in an editor.
//
// Nodes stand on a line where the links form a path, else on an ellipse, in an order that keeps links short. Links
// between the same two nodes run in lanes beside each other, loops are petals that point into the widest gap around
// their node. Labels are then placed one by one, each at the first of its candidate places that overlaps nothing and
// is crossed by no link. Where a label finds none, the drawing is stretched and tried again; the best attempt wins, and
// a label that still has no place (never seen on charts of the samples) is put below the drawing.
//
// Guaranteed: no two of the boxes of nodes and labels overlap. The result depends on the graph alone.
#pragma once

#include <cstddef>
#include <vector>

namespace grafverif::layout {

struct Point {
    int x = 0, y = 0;  ///< pixels; y grows downwards
    bool operator==(const Point&) const = default;
};

struct Size {
    int width = 0, height = 0;
    bool operator==(const Size&) const = default;
};

struct Box {
    Point at = {};  ///< its upper left corner
    Size size = {};
};

bool overlap(const Box& left, const Box& right);

/// What is to be drawn. An empty size is no label.
struct Graph {
    struct Link {
        std::size_t from = 0, to = 0;
        Size label = {};
    };
    std::vector<Size> nodes = {};  ///< the label of each node
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

/// The square around a node.
Box node_box(Point centre);

Drawing draw(const Graph& graph);

}  // namespace grafverif::layout
