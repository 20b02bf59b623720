// SPDX-License-Identifier: MIT
// Searches for the shortest change of a run that violates a property about single states: a smallest set of free moves
// such that the property holds in every state of the run without these moves.
//
// A move is free if nothing forces it: an edge of the plant or its environment that is not urgent and whose source
// location has no invariant. To omit a set of free moves, the run is re-executed from power-on:
//   - Free moves and delays are kept in the same order, each after the same time. If one of them is impossible, the
//     remaining moves are not a run, and the set is rejected.
//   - Other moves are kept if they are possible, and omitted otherwise.
//   - If time cannot pass, or a free move is impossible, the first edge of the network that is enabled and not free is
//     taken first. Such an edge is also taken at the end of the run, if an urgent edge is enabled.
// The result of the re-execution is a run of the network. The set is a change only if the property holds in all states
// of this run.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "explain/smallest.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// A run without some of its free moves.
struct Change {
    std::vector<std::size_t> left_out = {};  ///< indices of the omitted moves, increasing
    Run run = {};                            ///< the run of the remaining moves
};

struct ShortestChange {
    std::optional<Change> found = {};  ///< the first of the smallest changes; empty if none was found
    std::size_t free_moves = 0;        ///< number of free moves in the run
    std::size_t tried = 0;             ///< number of sets that were tried

    /// True if the search ended before all sets were tried: it was stopped or reached the maximum effort.
    bool exhausted = false;
};

/// Searches for the shortest change. Requires that `run` replays and violates `property`. The result contains no change
/// if the property does not concern single states. `effort` is the maximum number of moves executed in total.
ShortestChange shortest_change(const Network& network, const Property& property, const Run& run,
                               std::size_t effort = 5000, const StopRequested& stopped = {});
/// Searches for the shortest change of a run of `network`, which has no clocks (explain/moves.hpp). `timed` is the
/// network with clocks; it determines which moves are free.
ShortestChange shortest_change(const Network& network, const Network& timed, const Property& property, const Run& run,
                               std::size_t effort = 5000, const StopRequested& stopped = {});

}  // namespace grafverif
