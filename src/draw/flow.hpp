// SPDX-License-Identifier: MIT
// Flow: the graph of one partial chart as its layout sees it, and the order in which it is read: rows from top to bottom.
//
// Steps stand in even rows, transitions in odd ones. The search goes depth first from the roots; an arc back to a node
// that the search has not left yet is an upward link. Without those, a node stands one row below the lowest that leads
// to it. Everything here is linear in nodes and arcs, and depends on their order alone.
#pragma once

#include <cstddef>
#include <vector>

namespace grafverif::draw {

/// What a node takes up around its centre, its lines to left and right and its texts included.
struct Room {
    int left = 0, right = 0, up = 0, down = 0;
};

struct Flow {
    struct Node {
        bool bar = false;  ///< a transition: several links meet it in a double line
        int port = 0;      ///< from the centre up and down to where links begin
        Room room = {};
        std::vector<std::size_t> in = {}, out = {};  ///< arcs, in their order
    };
    struct Arc {
        std::size_t from = 0, to = 0;
    };
    std::vector<Node> nodes = {};
    std::vector<Arc> arcs = {};
    std::vector<std::size_t> roots = {};  ///< where a reader begins; the nodes that they do not reach follow

    std::size_t add(bool bar, int port, Room room) {
        nodes.push_back({.bar = bar, .port = port, .room = room});
        return nodes.size() - 1;
    }
    void link(std::size_t from, std::size_t to) {
        nodes[from].out.push_back(arcs.size());
        nodes[to].in.push_back(arcs.size());
        arcs.push_back({from, to});
    }
};

struct Order {
    std::vector<std::size_t> rows = {};   ///< per node
    std::vector<std::size_t> found = {};  ///< per node: when the search came to it
    std::vector<bool> upward = {};        ///< per arc
    std::size_t row_count = 0;
};

Order order_of(const Flow& flow);

}  // namespace grafverif::draw
