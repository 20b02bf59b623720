// SPDX-License-Identifier: MIT
// Explains a violated `no timelock`: the instances whose invariants block time, or those that never let it pass.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// The end of a run in which time cannot pass: the last state or, if the run repeats, each state that it repeats.
struct Standstill {
    struct Blocker {
        Id<Network::Process> process = {};
        Id<Network::Location> location = {};
        std::vector<Network::ClockConstraint> bounds = {};  ///< of its invariant; another time unit violates each
    };
    std::vector<Blocker> blockers = {};  ///< none of their edges is enabled there
    std::vector<Id<Network::Process>> repeating =
        {};                  ///< processes whose edges repeat without end; none: no edge is enabled
    bool continued = false;  ///< the run was continued by edges without delay to get there
};

/// Continues a finite run by enabled edges until none is enabled or a state repeats. No blockers and no repeating
/// process if it is not a run of the network, if time may pass there, or if the continuation becomes too long.
Standstill standstill(const Network& network, const Run& run);

/// One sentence per blocker with its invariant and its edges, or one that names the repeating processes; with a remedy.
/// Empty if there are neither.
std::string standstill_words(const Network& network, const Standstill& found);

}  // namespace grafverif
