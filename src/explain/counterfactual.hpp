// SPDX-License-Identifier: MIT
// The shortest change: a smallest set of free moves of a run such that a property about single states holds along the
// run without them.
//
// A move is free if nothing forces it: an edge of the plant or its environment that is not urgent and whose source
// location has no invariant. To omit a set of free moves, the run is re-executed from power-on:
//   free moves and delays   are kept in the same order, each after the same time; if any is impossible, the remaining
//                           moves are not a run, and the set is not a change
//   all other moves         are kept if they are possible, and omitted otherwise
//   forced moves            if time cannot pass, or a free move is impossible, the first edge of the network that is
//                           enabled and not free is taken first; also at the end, if an urgent edge is enabled
// The result is a run of the network. The property must hold in all of its states.
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
    bool exhausted = false;            ///< true if stopped, or at the maximum effort, before all sets were tried
};

/// Searches for the shortest change. Requires that `run` replays and violates `property`. Returns no change for
/// properties that do not concern single states. `effort` is the maximum number of moves executed in total.
ShortestChange shortest_change(const Network& network, const Property& property, const Run& run,
                               std::size_t effort = 5000, const StopRequested& stopped = {});
/// Searches for the shortest change of a run of `network`, which has no clocks (explain/moves.hpp). `timed` is the
/// network with clocks; it determines which moves are free.
ShortestChange shortest_change(const Network& network, const Network& timed, const Property& property, const Run& run,
                               std::size_t effort = 5000, const StopRequested& stopped = {});

}  // namespace grafverif
