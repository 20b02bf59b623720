// SPDX-License-Identifier: MIT
// A run of an input abstraction (ir/network_inputs.hpp), and the inputs that its PLCs sample.
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

/// One sampling of a PLC, with the valuations of each instance that are possible after its cycle.
struct Sampling {
    std::size_t at = 0;  // index in the path
    Id<Network::Process> plc = {};
    std::vector<timed::Word> possible = {};
};

/// Returns all samplings in order. Later edges of a cycle reduce the possible valuations of its sampling.
std::vector<Sampling> samplings(const AbstractRun& run);

}  // namespace grafverif
