// SPDX-License-Identifier: MIT
// Explains a violated `no timelock`: finds the instances whose invariants prevent time from passing, or the processes
// that take edges forever while no time passes.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// The end of a run at which time cannot pass: the last state or, if the run ends in a loop, all states of the loop.
struct Standstill {
    struct Blocker {
        Id<Network::Process> process = {};
        Id<Network::Location> location = {};
        /// Clock constraints in the invariant of the current location that a delay of one time unit would violate.
        std::vector<Network::ClockConstraint> bounds = {};
    };
    /// Processes whose invariants prevent time from passing; none of their edges is enabled at the end of the run.
    std::vector<Blocker> blockers = {};
    std::vector<Id<Network::Process>> repeating =
        {};                  ///< processes whose edges repeat forever; empty if no edge is enabled
    bool continued = false;  ///< true if the run was continued by edges without delay
};

/// Determines the cause of a timelock at the end of `run`; a finite run is first continued (see
/// continue_without_delay). The result is empty if `run` is not a run of the network, if time may pass at the end of
/// the run, or if the continuation becomes too long.
Standstill standstill(const Network& network, const Run& run);

/// Returns one sentence for each process that blocks time, with its invariant and its edges, or one sentence that lists
/// the repeating processes. The text ends with a remedy. If there are neither blocking nor repeating processes, the
/// text is empty.
std::string standstill_words(const Network& network, const Standstill& found);

}  // namespace grafverif
