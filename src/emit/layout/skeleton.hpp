// SPDX-License-Identifier: MIT
// The skeleton of a drawing: where the nodes stand and how the links run, before any label is placed.
#pragma once

#include <vector>

#include "emit/layout/layout.hpp"
#include "emit/layout/plane.hpp"

namespace grafverif::layout {

/// How the nodes are arranged, whatever the scale.
struct Arrangement {
    bool line = false;                    ///< on a horizontal line; else on an ellipse, clockwise
    std::vector<std::size_t> order = {};  ///< the nodes on it, first to last
    struct Pendant {
        std::size_t node = 0, beside = 0;  ///< linked with one node only: stands outside, beside it
    };
    std::vector<Pendant> pendants = {};
};

Arrangement arrangement(const Graph& graph);

struct Route {
    std::vector<Vector> nails = {};
    Segment middle = {};  ///< the part that carries the label; of a loop: its tip, twice
    Vector outward = {};  ///< from the middle to where the label should stand, of length 1
};

struct Skeleton {
    std::vector<Vector> nodes = {};
    std::vector<Route> routes = {};  ///< beside Graph::links
};

Skeleton skeleton(const Graph& graph, const Arrangement& arrangement, double scale);

}  // namespace grafverif::layout
