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

#include "check/shares.hpp"
#include "check/timed/timed.hpp"
#include "ir/network_inputs.hpp"

namespace grafverif {

/// The abstract run and the networks to which it belongs.
struct AbstractRun {
    const Network& network;  ///< expanded network in which the run was found
    const std::vector<AbstractableProcess>& instances;
    const std::vector<InputLevel>& levels;
    const std::vector<InputChoice>& choices;
    const std::vector<AbstractState>& path;
};

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

/// A position in an abstract run at which a single process cannot perform what the run requires, given the values of
/// the variables of other processes.
struct SpuriousMove {
    std::size_t at = 0;     ///< index in the path
    InputLevel level = {};  ///< level of the process at which the abstraction excludes this run
};

/// Returns the first position at which the process of `instance` cannot perform what the run requires, for the least
/// precise level that excludes the run; nullopt if no level excludes the run. If `waits` is true, any time may pass
/// initially and whenever all PLCs are stable. Variables whose values the run does not contain (Chosen instances,
/// flags) may have any value that the process requires. `complete` is the expanded network; its time unit divides that
/// of the abstract run.
std::optional<SpuriousMove> impossible(const Network& complete, const AbstractRun& abstract, std::size_t instance,
                                       bool waits);

/// Searches for a run along the abstract run. `network` is complete, expanded, and has the observers of the
/// abstraction. `property` is one of its properties about single states, or one step of `reachable all steps`.
ConcreteRun follow(const Network& network, const Property& property, const AbstractRun& abstract,
                   const FollowLimits& limits);

}  // namespace grafverif
