// SPDX-License-Identifier: MIT
// Flow: the graph of one partial chart for layout. Order: the reading order of this graph, with rows from top to
// bottom.
//
// Steps are in even rows, transitions in odd rows. A depth-first search starts at the roots; an arc to a node whose
// search is not finished is an upward link. A node is one row below its lowest predecessor, without regard to upward
// links. All algorithms are linear in nodes and arcs, and the result depends only on the graph and on the order of its
// nodes and arcs.
#pragma once

#include <cstddef>
#include <vector>

namespace grafverif::draw {

/// Space that a node occupies around its centre, including its lines to the left and right and its texts.
struct ReservedSpace {
    int left = 0, right = 0, up = 0, down = 0;
};

struct Flow {
    struct Node {
        bool bar = false;  ///< for a transition: true if several links join in a double line
        int port = 0;      ///< distance from the centre to the upper and lower ends of links
        ReservedSpace space = {};
        std::vector<std::size_t> in = {}, out = {};  ///< incoming and outgoing arcs, in order
    };
    struct Arc {
        std::size_t from = 0, to = 0;
    };
    std::vector<Node> nodes = {};
    std::vector<Arc> arcs = {};
    /// Nodes at which the search starts. After the roots, the search starts at nodes that were not reached.
    std::vector<std::size_t> roots = {};

    std::size_t add(bool bar, int port, ReservedSpace space) {
        nodes.push_back({.bar = bar, .port = port, .space = space});
        return nodes.size() - 1;
    }
    void link(std::size_t from, std::size_t to) {
        nodes[from].out.push_back(arcs.size());
        nodes[to].in.push_back(arcs.size());
        arcs.push_back({from, to});
    }
};

struct Order {
    std::vector<std::size_t> rows = {};   ///< row of each node
    std::vector<std::size_t> found = {};  ///< discovery index of each node in the search
    std::vector<bool> upward = {};        ///< true for upward arcs
    std::size_t row_count = 0;
};

Order order_of(const Flow& flow);

}  // namespace grafverif::draw
