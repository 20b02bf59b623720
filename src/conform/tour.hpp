// SPDX-License-Identifier: MIT
// Tours: walks through a directed graph that begin at `start` and together traverse every arc, or visit every node.
#pragma once

#include <cstdint>
#include <vector>

namespace grafverif::conform {

/// An arc of the graph, which one step of a test traverses. An arc with a positive `wait_ms` must follow an arc with
/// the same inputs.
struct TourArc {
    std::uint32_t from = 0, to = 0;
    std::uint32_t inputs = 0;  ///< number that identifies the input combination of the arc
    std::uint32_t answer = 0;
    std::int64_t wait_ms = 0;
    bool stays = false;  ///< true if the machine stays in `to` when the inputs of the arc are applied again
};

struct Tour {
    /// Sequences of arcs; each sequence begins at the node `start`.
    std::vector<std::vector<std::uint32_t>> sequences = {};
    std::uint64_t length = 0;  ///< total number of arcs
};

/// Returns a tour that traverses every arc in `arcs`. Requires that every arc is reachable from `start` through arcs in
/// `arcs`. If the graph is strongly connected, the result is a single sequence of minimum length. Otherwise the result
/// has the minimum total length and, among the tours of this length, the minimum number of sequences.
Tour least_tour(std::uint32_t nodes, std::uint32_t start, const std::vector<TourArc>& arcs);

/// Returns a tour through every node that an arc enters. From each node, the tour continues to the nearest unvisited
/// node.
Tour visiting_tour(std::uint32_t nodes, std::uint32_t start, const std::vector<TourArc>& arcs);

}  // namespace grafverif::conform
