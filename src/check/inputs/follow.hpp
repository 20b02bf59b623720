// SPDX-License-Identifier: MIT
// Guided search of the complete network. The guide is a run of its input abstraction (ir/network_inputs.hpp), called
// the abstract run.
//
// The abstract run is divided into stages; a new stage begins whenever a step or an internal variable of a controller
// changes. The search is best-first. Every second expanded state belongs to the latest stage that is reached; all
// others belong to the reached stages in turn. Within a stage, the search prefers states with the fewest variables that differ
// from the next stage. Among states with equal priority, the search is breadth-first.
//
// An autonomous Chosen instance moves only if its outputs differ from the valuations that some sampling of the stage
// requires. Other autonomous instances move freely, or only in stages in which they move in the abstract run
// (PanelMoves). All moves are moves of the complete network; therefore each run that is found is a real run.
// The search finds a run quickly if the complete network can perform the abstract run with longer delays. If the search
// finds no run, the property may still have a run in the complete network.
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
    std::optional<Run> run = {};  ///< run of the complete network to a state that decides the property
    /// If no run was found: the instances whose sampled outputs the last reached stage requires.
    std::vector<std::size_t> blamed = {};
};

/// The stages in which autonomous instances that are not Chosen may move.
enum class PanelMoves : std::uint8_t { Any, OfAbstractRun };

/// Searches `network` for a run that decides `property`, guided by `abstract`. Requires that `network` is complete and
/// expanded, possibly in a longer time unit (in_longer_unit), and has the observers of the abstraction. `property` is a
/// property of `network` about single states, or `reachable all steps` for one step.
ConcreteRun follow(const Network& network, const Property& property, const AbstractRun& abstract, PanelMoves moves,
                   const FollowLimits& limits);

}  // namespace grafverif
