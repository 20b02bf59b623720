// SPDX-License-Identifier: MIT
// Guided search: a run of the complete network along a run of its input abstraction (ir/network_inputs.hpp).
//
// The abstract run is cut into stages, one per valuation of the steps and internal variables of the controllers. The
// search is best-first: by the last stage that a run has shown, then by the number of variables that differ from the next
// stage, then breadth-first. An autonomous Chosen instance moves only if its outputs are not among those that the abstract run samples
// on the way to the next stage. So what it finds is a real run, and it finds it quickly if the abstract run can be
// stretched in time; that it finds none proves nothing.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "check/timed/timed.hpp"
#include "ir/network_inputs.hpp"

namespace grafverif {

/// The abstract run, and the networks that it belongs to.
struct AbstractRun {
    const Network& network;  ///< expanded, in which it was found
    const std::vector<AbstractableProcess>& instances;
    const std::vector<InputLevel>& levels;
    const std::vector<InputChoice>& choices;
    const std::vector<AbstractState>& path;
};

struct FollowLimits {
    std::size_t states = 200'000;
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;
};

struct Followed {
    std::optional<Run> run = {};           ///< of the complete network, to a state that decides the property
    std::vector<std::size_t> blamed = {};  ///< without a run: the instances that the last stage waits for
};

/// Where a process by itself, among the values that a run shows of the others, cannot show what the run has of it.
struct Impossible {
    std::size_t at = 0;     ///< in the path
    InputLevel level = {};  ///< an abstraction with this level excludes this run
};

/// The first such place, if there is one; `waits`: at the beginning and where all PLCs are stable, any time may pass before
/// the run continues. What the run does not show (Chosen instances, flags) is taken as the process needs it.
/// `complete`: the expanded network, whose time unit divides that of the abstract run.
std::optional<Impossible> impossible(const Network& complete, const AbstractRun& abstract, std::size_t instance,
                                     bool waits);

/// `network`: complete, expanded, with the same observer; `property`: one of its properties about single states, or one
/// step of `reachable all steps`.
Followed follow(const Network& network, const Property& property, const AbstractRun& abstract,
                const FollowLimits& limits);

}  // namespace grafverif
