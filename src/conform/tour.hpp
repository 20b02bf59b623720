// SPDX-License-Identifier: MIT
// Tours: walks of minimal length through a directed graph from `start` that traverse every arc to cover.
#pragma once

#include <cstdint>
#include <vector>

namespace grafverif::conform {

/// An arc of the graph, traversed by one step; `wait`: it must follow a step with the same inputs.
struct TourArc {
    std::uint32_t from = 0, to = 0;
    std::uint32_t inputs = 0;  ///< an opaque number
    std::uint32_t answer = 0;
    std::int64_t wait_ms = 0;
    bool stays = false;  ///< the machine stays in `to` under these inputs
};

struct Tour {
    std::vector<std::vector<std::uint32_t>> sequences = {};  ///< arcs, each sequence from `start`
    std::uint64_t length = 0;                                ///< total number of arcs, proved minimal
};

/// A tour that traverses every arc of `arcs`, all of which must be reachable from `start` through arcs of `arcs`. One
/// sequence if the graph is strongly connected; otherwise the total length is minimal, and then the number of
/// sequences.
Tour least_tour(std::uint32_t nodes, std::uint32_t start, const std::vector<TourArc>& arcs);

/// A tour through every node that an arc enters, always to the nearest unvisited one.
Tour visiting_tour(std::uint32_t nodes, std::uint32_t start, const std::vector<TourArc>& arcs);

}  // namespace grafverif::conform
