// SPDX-License-Identifier: MIT
// Explains a violated `no timelock`: the instances whose invariants block time, or the processes whose edges never let
// time pass.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// The end of a run in which time cannot pass: the last state or, if the run repeats, each state of the repetition.
struct Standstill {
    struct Blocker {
        Id<Network::Process> process = {};
        Id<Network::Location> location = {};
        /// Constraints of its invariant that another time unit would violate.
        std::vector<Network::ClockConstraint> bounds = {};
    };
    std::vector<Blocker> blockers = {};  ///< none of their edges is enabled at the end of the run
    std::vector<Id<Network::Process>> repeating =
        {};                  ///< processes whose edges repeat forever; empty if no edge is enabled
    bool continued = false;  ///< true if the run was continued by edges without delay up to this end
};

/// Continues a finite run by enabled edges until none is enabled or a state repeats. The result has neither blockers
/// nor repeating processes if the run is not a run of the network. The same applies if time may pass at its end, or if
/// the continuation becomes too long.
Standstill standstill(const Network& network, const Run& run);

/// Returns one sentence per blocker with its invariant and its edges, or one sentence that names the repeating
/// processes, each with a remedy. Empty if there are neither.
std::string standstill_words(const Network& network, const Standstill& found);

}  // namespace grafverif
