// SPDX-License-Identifier: MIT
// Queries of the timed engine for compositional checking: the verdicts to give, and the parts that each one reads.
#pragma once

#include <cstdint>
#include <vector>

#include "check/timed/timed.hpp"
#include "ir/network_subsystems.hpp"

namespace grafverif {

/// Indices of parts of a network, increasing.
using PartNumbers = std::vector<std::uint32_t>;

/// A query for one verdict.
struct SubsystemQuery {
    Property property = {};  ///< property with the name of its verdict; for an expanded property, it concerns one step
    Verdict verdict = {};
    PartNumbers reads = {};
    bool each = false;  ///< true if the query is decided for every part separately
    bool race = false;  ///< true if the query concerns an action race; only with `each`
};

/// Returns the selected properties, with a separate query for each step of an expanded property. `no timelock` is
/// included unless `options` exclude it.
std::vector<SubsystemQuery> subsystem_queries(const Network& network, const NetworkSubsystems& parts,
                                              const TimedOptions& options);

}  // namespace grafverif
