// SPDX-License-Identifier: MIT
// A run of an input abstraction (ir/network_inputs.hpp), and the inputs that PLCs sample in this run.
#pragma once

#include <cstddef>
#include <vector>

#include "check/timed/machine.hpp"
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

/// One sampling of inputs by a PLC. `possible` contains a word for each instance; bit k of the word
/// is set if the output valuation k is consistent with all edges of the PLC cycle.
struct Sampling {
    std::size_t at = 0;  // index of the sampling in AbstractRun::path
    Id<Network::Process> plc = {};
    std::vector<timed::Word> possible = {};
};

/// Returns all samplings in order. Each later edge of the same PLC cycle removes the valuations that contradict the
/// edge from the possible valuations of the sampling.
std::vector<Sampling> samplings(const AbstractRun& run);

}  // namespace grafverif
