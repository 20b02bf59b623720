// SPDX-License-Identifier: MIT
// Tours: walks of minimal length through a directed graph from `start` that traverse every arc to cover.
#pragma once

#include <cstdint>
#include <vector>

namespace grafverif::conform {

/// An arc of the graph, which one step traverses. If `wait` is true, it must follow a step with the same inputs.
struct TourArc {
    std::uint32_t from = 0, to = 0;
    std::uint32_t inputs = 0;  ///< an arbitrary number that identifies the inputs
    std::uint32_t answer = 0;
    std::int64_t wait_ms = 0;
    bool stays = false;  ///< true if the machine stays in `to` under these inputs
};

struct Tour {
    std::vector<std::vector<std::uint32_t>> sequences = {};  ///< sequences of arcs; each starts at `start`
    std::uint64_t length = 0;                                ///< total number of arcs, which is proved minimal
};

/// Returns a tour that traverses every arc of `arcs`, all of which must be reachable from `start` through arcs of
/// `arcs`. If the graph is strongly connected, there is one sequence. Otherwise the total length is minimal, and among
/// such tours the number of sequences is minimal.
Tour least_tour(std::uint32_t nodes, std::uint32_t start, const std::vector<TourArc>& arcs);

/// Returns a tour through every node that an arc enters. It always goes to the nearest unvisited node.
Tour visiting_tour(std::uint32_t nodes, std::uint32_t start, const std::vector<TourArc>& arcs);

}  // namespace grafverif::conform
