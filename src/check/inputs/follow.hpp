// SPDX-License-Identifier: MIT
// Guided search for a run of the complete network along a run of its input abstraction (ir/network_inputs.hpp).
//
// The abstract run is divided into stages, one per valuation of the steps and internal variables of the controllers.
// The search is best-first. It prefers states whose run has reached the latest stage, then those with the fewest
// variables that differ from the next stage; among equals, it is breadth-first. An autonomous Chosen instance moves only if its outputs are not among those that
// the abstract run samples before the next stage. All moves are moves of the complete network; therefore each run that
// is found is a real run. A run is found quickly if the abstract run becomes possible with longer delays. If no run is
// found, nothing is proved.
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "check/inputs/abstract_run.hpp"
#include "check/shares.hpp"
#include "check/timed/timed.hpp"

namespace grafverif {

inline constexpr std::size_t search_poll_interval = 1024;  ///< number of states between two tests of the time limit

struct FollowLimits {
    std::size_t states = 200'000;
    std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();  ///< memory limit; `follow` ignores it
    Deadline deadline = {};
    const std::atomic<bool>* stop = nullptr;
};

/// Returns the steps and internal variables of all controllers.
std::vector<Id<Network::Variable>> signature_variables(const Network& network);

struct ConcreteRun {
    std::optional<Run> run = {};           ///< run of the complete network to a state that decides the property
    std::vector<std::size_t> blamed = {};  ///< if there is no run: the instances that the last reached stage constrains
};

/// Searches for a run along the abstract run. `network` is complete, expanded, and has the observers of the
/// abstraction. `property` is one of its properties about single states, or one step of `reachable all steps`.
ConcreteRun follow(const Network& network, const Property& property, const AbstractRun& abstract,
                   const FollowLimits& limits);

}  // namespace grafverif
