// SPDX-License-Identifier: MIT
// Queries of the timed engine for compositional checking: one query for each verdict, with the parts that it reads.
#pragma once

#include <cstdint>
#include <vector>

#include "check/timed/timed.hpp"
#include "ir/network_subsystems.hpp"

namespace grafverif {

/// Indices of parts of a network, in increasing order.
using PartNumbers = std::vector<std::uint32_t>;

/// A query for one verdict.
struct SubsystemQuery {
    Property property = {};  ///< property with the name of its verdict; for an expanded property, it concerns one step
    Verdict verdict = {};
    PartNumbers reads = {};
    bool each = false;  ///< true if the query is decided for every part separately
    bool race = false;  ///< true if the query concerns an action race; `each` is then also true
};

/// Returns a query for each selected property; for an expanded property, a separate query for each step. `no timelock`
/// is included unless `options` exclude it.
std::vector<SubsystemQuery> subsystem_queries(const Network& network, const NetworkSubsystems& parts,
                                              const TimedOptions& options);

}  // namespace grafverif
