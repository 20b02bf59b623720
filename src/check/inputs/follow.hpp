// SPDX-License-Identifier: MIT
// Guided search of the complete network. The guide is a run of its input abstraction (ir/network_inputs.hpp), called
// the abstract run.
//
// The abstract run is divided into stages; a new stage begins whenever a step or an internal variable of a controller
// changes. The search is best-first. Every second expanded state belongs to the latest stage that is reached; all other
// expanded states belong to the reached stages in turn. Within a stage, the search prefers states in which the fewest
// variables differ from the next stage. Among states with equal priority, the search is breadth-first.
//
// An autonomous instance reads only its own variables. At the level Chosen, an autonomous instance moves only if its
// outputs differ from the valuations that some sampling of the stage requires. Other autonomous instances move freely,
// or only in stages in which they move in the abstract run (PanelMoves). All moves are moves of the complete network;
// therefore each run that the search finds is a run of the complete network. The search finds a run quickly if the
// complete network can perform the abstract run with longer delays. If the search finds no run, the complete network
// may still have a run that decides the property.
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
    /// Memory limit, which `follow` ignores.
    std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();
    Deadline deadline = {};
    const std::atomic<bool>* stop = nullptr;
};

/// Returns the steps and internal variables of all controllers.
std::vector<Id<Network::Variable>> signature_variables(const Network& network);

struct ConcreteRun {
    std::optional<Run> run = {};  ///< run of the complete network to a state that decides the property

    /// If no run was found: the instances whose outputs the samplings of the last reached stage constrain.
    std::vector<std::size_t> blamed = {};
};

/// Selects the stages in which autonomous instances may move, except for instances of the level Chosen.
enum class PanelMoves : std::uint8_t { Any, OfAbstractRun };

/// Searches `network` for a run that decides `property`, guided by `abstract`. Requires that `network` is expanded, is
/// not an abstraction, and has the observers of the abstraction. `network` may have a longer time unit
/// (in_longer_unit). `property` is a property of `network` about single states, or `reachable all steps` for one step.
ConcreteRun follow(const Network& network, const Property& property, const AbstractRun& abstract, PanelMoves moves,
                   const FollowLimits& limits);

}  // namespace grafverif
