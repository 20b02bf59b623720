// SPDX-License-Identifier: MIT
// The skeleton of a drawing: positions of nodes and routes of links. It is computed before labels are placed.
#pragma once

#include <vector>

#include "emit/layout/layout.hpp"
#include "emit/layout/plane.hpp"

namespace grafverif::layout {

/// Arrangement of the nodes, independent of the scale.
struct Arrangement {
    bool line = false;                    ///< true: the nodes are on a horizontal line; false: on an ellipse, clockwise
    std::vector<std::size_t> order = {};  ///< nodes on the line or ellipse, from first to last
    struct Pendant {
        std::size_t node = 0, beside = 0;  ///< `node` has links only to `beside`, and is placed outside next to it
    };
    std::vector<Pendant> pendants = {};
};

Arrangement arrangement(const Graph& graph);

struct Route {
    std::vector<Vector> nails = {};
    Segment middle = {};  ///< part with the label; for a loop, its tip as both ends
    Vector outward = {};  ///< unit vector from the middle towards the label
};

struct Skeleton {
    std::vector<Vector> nodes = {};
    std::vector<Route> routes = {};  ///< one route per link of Graph::links
};

Skeleton skeleton(const Graph& graph, const Arrangement& arrangement, double scale);

}  // namespace grafverif::layout
