// SPDX-License-Identifier: MIT
// Fault analysis: decides which combinations of faults of a closed loop violate its properties.
//
// Each combination is checked in the model of pipeline/variants/fault_model.hpp, in which its faults may occur at any
// time or never. If a property `reachable` holds without faults, it also holds in this model; therefore it is checked
// in a model in which all faults of the combination are present from power-on. Combinations with two faults of one
// instance are not considered, because at most one fault of an instance can occur.
//
// A combination is minimal if it violates the property and none of its subsets does. If the verdict for a subset is
// unknown, the result states this.
//
// A fault of a combination may also never occur. Therefore every run of the model with the set of faults F is also a
// run of the model with each superset of F. If F violates a property about all runs, each superset violates it too, and
// no superset is checked. The model of the superset does not always show this violation: for example, a fault that can
// still occur can end a deadlock. Therefore, a combination satisfies a property about all runs only if all its subsets
// satisfy the property. Only `reachable` and `reachable all steps` can be violated by a combination and satisfied by a
// superset.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/grafverif.hpp"
#include "ir/fault_analysis.hpp"

namespace grafverif {

/// Maximum number of combinations that are checked.
constexpr std::uint64_t most_combinations = 100'000;

/// Maximum number of faults of a combination. The maximum is low because properties about runs from power-on need a
/// check for each subset.
constexpr std::uint64_t most_faults = 8;

struct FaultsRequest {
    std::size_t order = 1;                     ///< maximum number of faults of a combination: 1..most_faults
    std::vector<std::string> properties = {};  ///< names of properties; all if empty
    bool visible = true;  ///< true: also determine how steps, outputs and proposed properties show each fault
    ModelOptions how = {};
    Limits limits = {};
    /// Maximum number of states of the first search for a combination. Unless another limit is reached, the verdicts do
    /// not depend on this number.
    std::uint64_t first_states = std::uint64_t{1} << 17U;
    unsigned jobs = 0;  ///< threads; 0 selects one per core; the result does not depend on it
};

/// Returns the number of combinations of at most `order` faults; a number above most_combinations is returned as
/// most_combinations + 1.
std::uint64_t combination_count(const ClosedLoop& loop, std::size_t order);

/// True if `loop` has faults, `order` is within the limit, and the number of combinations is within the limit.
/// Otherwise, adds errors.
bool faults_can_be_combined(const ClosedLoop& loop, std::uint64_t order, Diagnostics& diagnostics);

/// Analyses the faults of `loop`. Requires that combination_count is at most most_combinations. The result is empty
/// after an error: a property does not exist, or the model with a fault is rejected. If a limit is reached, the
/// verdicts for combinations that were not checked are unknown.
std::optional<FaultAnalysis> analysed_faults(const Model& model, Id<ClosedLoop> loop, const FaultsRequest& request,
                                             Diagnostics& diagnostics);

}  // namespace grafverif
