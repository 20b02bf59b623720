// SPDX-License-Identifier: MIT
// Queries of the timed engine for compositional checking. Each verdict has one query, which
// contains the parts (independent subsystems) that the property reads.
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
    /// The property, with the name of its verdict. `reachable all steps` is expanded to one property per step.
    Property property = {};
    Verdict verdict = {};
    PartNumbers reads = {};
    bool each = false;  ///< true if the query is decided for every part separately
    bool race = false;  ///< true if the query concerns an action race; if `race` is true, `each` is also true
};

/// Returns a query for each selected property; for `reachable all steps`, one query for each step. A query for `no
/// timelock` is included unless `options` exclude it.
std::vector<SubsystemQuery> subsystem_queries(const Network& network, const NetworkSubsystems& parts,
                                              const TimedOptions& options);

}  // namespace grafverif
