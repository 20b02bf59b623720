// SPDX-License-Identifier: MIT
// Checks a closed loop with faults in several passes. Each pass checks the properties that are still undecided.
//
// The first pass explores at most FaultsRequest::first_states states in each search. A network with faults often has
// only a few more states than the limit above which localization is used. Therefore the second pass searches the
// complete network, which then needs less time than localization. The last pass has no limit on the number of states.
//
// If the network is expected to have more states than the first pass explores, but not more than the second pass
// explores, the second pass is made first. It then has half of the time, and the first pass follows for all undecided
// properties. Therefore, without a time limit, both orders decide the same properties.
#pragma once

#include <string>
#include <vector>

#include "pipeline/check.hpp"
#include "pipeline/variants/faults.hpp"

namespace grafverif {

/// Returns the name of the property in the model to which a verdict belongs. A property `S` of the form `reachable all
/// steps` has verdicts such as `S.X7`.
std::string base_name(const std::string& property, Pattern pattern);

/// Adds those model errors of `found` that `errors` does not contain.
void add_errors(std::vector<ModelErrorTrace>&& found, std::vector<ModelErrorTrace>& errors);

/// Returns the maximum number of states that a search of the report explored; 0 if a limit ended a search.
double states_of(const Report& report);

/// Checks the properties of `options` in passes. If `timelock` is false, an undeclared `no timelock` has no verdict, and
/// model errors that no requested property needs may remain unknown. `expected` is the expected number of states of the
/// network; 0 if unknown.
Report check_in_passes(const LoopToCheck& loop, CheckOptions options, const FaultsRequest& request, bool timelock,
                       double expected);

}  // namespace grafverif
