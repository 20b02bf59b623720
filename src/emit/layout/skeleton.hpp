// SPDX-License-Identifier: MIT
// The skeleton of a drawing: positions of nodes and routes of links. The skeleton is computed before labels are placed.
#pragma once

#include <vector>

#include "emit/layout/layout.hpp"
#include "emit/layout/plane.hpp"

namespace grafverif::layout {

/// The arrangement of the nodes, independent of the scale.
struct Arrangement {
    bool line = false;                    ///< true if the nodes are on a horizontal line, false if on an ellipse
    std::vector<std::size_t> order = {};  ///< nodes on the line or ellipse, from first to last
    struct Pendant {
        std::size_t node = 0, anchor = 0;  ///< `node` has links only to `anchor` and is placed next to it
    };
    std::vector<Pendant> pendants = {};
};

Arrangement arrangement(const Graph& graph);

struct Route {
    std::vector<Vector> nails = {};
    Segment middle = {};  ///< segment of the link next to its label; for a loop, both ends are its outermost point
    Vector outward = {};  ///< unit vector from `middle` towards the label
};

struct Skeleton {
    std::vector<Vector> nodes = {};
    std::vector<Route> routes = {};  ///< one route per link of Graph::links
};

Skeleton skeleton(const Graph& graph, const Arrangement& arrangement, double scale);

}  // namespace grafverif::layout
