// SPDX-License-Identifier: MIT
// The shortest change: the fewest free moves of a run without which a property about single states holds along it.
//
// A move is free where nothing forces it: an edge of the plant or its environment that is not urgent and leaves a location
// without invariant. A set of them is left out by making the run again, without them, from power-on:
//   free moves and delays   as they were, in the same order, each after as much time; where one cannot be, the rest is no
//                           run any more, and the set is no change
//   all other moves         follow: as they were where they can be, else they are left out
//   what must be            where time may not pass, or a free move not be made, the first edge of the network that can
//                           fire and is not free comes before it; so at the end, where an urgent one can
// What is made is a run of the network. The property must hold in all of its states.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "explain/smallest.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// The run without some of its free moves.
struct Change {
    std::vector<std::size_t> left_out = {};  ///< moves of the run, increasing
    Run run = {};                            ///< what is left, and follows
};

struct ShortestChange {
    std::optional<Change> found = {};  ///< of those with the fewest moves the first one
    std::size_t free_moves = 0;        ///< how many there are in the run
    std::size_t tried = 0;             ///< sets of them
    bool exhausted = false;            ///< the effort allowed is spent, and there were more to try
};

/// Requires that `run` replays and shows that `property` is violated. Nothing is found for properties that are not about
/// single states. `effort`: at most so many moves are tried in all.
ShortestChange shortest_change(const Network& network, const Property& property, const Run& run,
                               std::size_t effort = 5000, const StopAsked& stopped = {});
/// The same of a run of `network` without clocks (explain/moves.hpp); `timed` has them, and says what is free.
ShortestChange shortest_change(const Network& network, const Network& timed, const Property& property, const Run& run,
                               std::size_t effort = 5000, const StopAsked& stopped = {});

}  // namespace grafverif
