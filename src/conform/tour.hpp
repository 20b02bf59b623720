// SPDX-License-Identifier: MIT
// Tours: walks through a directed graph from `start` that cross every arc to cover, of least length.
#pragma once

#include <cstdint>
#include <vector>

namespace grafverif::conform {

/// An arc of the graph, crossed by one step; `wait`: it has to follow a step with the same inputs.
struct TourArc {
    std::uint32_t from = 0, to = 0;
    std::uint32_t inputs = 0;  ///< their number, whatever it counts
    std::uint32_t answer = 0;
    std::int64_t wait_ms = 0;
    bool stays = false;  ///< the machine stays in `to` under these inputs
};

struct Tour {
    std::vector<std::vector<std::uint32_t>> sequences = {};  ///< arcs, each sequence from `start`
    std::uint64_t length = 0;                                ///< arcs in all, which no tour undercuts
};

/// A tour that crosses every arc of `arcs`, all of which can be reached from `start` through arcs of `arcs`: one
/// sequence where every node can be reached from every other one; else as many as make the total least, and of those the
/// fewest.
Tour least_tour(std::uint32_t nodes, std::uint32_t start, const std::vector<TourArc>& arcs);

/// A tour through every node that an arc enters, always on to the nearest one that is new.
Tour visiting_tour(std::uint32_t nodes, std::uint32_t start, const std::vector<TourArc>& arcs);

}  // namespace grafverif::conform
