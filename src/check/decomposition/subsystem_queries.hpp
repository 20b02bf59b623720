// SPDX-License-Identifier: MIT
// Queries of the timed engine for compositional checking: the verdicts to give, and the parts that each one reads.
#pragma once

#include <cstdint>
#include <vector>

#include "check/timed/timed.hpp"
#include "ir/network_subsystems.hpp"

namespace grafverif {

/// Numbers of parts of a network, increasing.
using PartNumbers = std::vector<std::uint32_t>;

/// A query for one verdict.
struct SubsystemQuery {
    Property property = {};  ///< named as its verdict; for an expanded one, about one state
    Verdict verdict = {};
    PartNumbers reads = {};
    bool each = false;  ///< requested for every part separately
    bool race = false;  ///< if `each`: asks for an action race
};

/// The selected properties, with a separate query for each step of an expanded one, and `no timelock` unless `options`
/// exclude it.
std::vector<SubsystemQuery> subsystem_queries(const Network& network, const NetworkSubsystems& parts,
                                              const TimedOptions& options);

}  // namespace grafverif
