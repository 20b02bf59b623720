// SPDX-License-Identifier: MIT
// Writes a state profile as text and as JSON: the components that contribute most states to a search.
#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>

#include "grafverif/ir/state_profile.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

/// Sets the source positions of the components and clocks.
void name_places(StateProfile& profile, const Sources& sources);

/// Prints one line per component and clock in the order of decreasing factor, followed by remarks about the states. If
/// the component or clock were ignored, the number of states would be divided by the factor.
void print_profile(const StateProfile& profile, std::ostream& out);

/// Returns `{"states", "sampled", "inside_cycles", "parts":[{"name", "kind", "combinations", "factor", "place"}],
/// "clocks":[{"instance", "clock", "greatest", "values", "factor", "place"}], "finest":{"duration", "unit", "coarser",
/// "factor", "place"}}`. Durations and units are in ms.
nlohmann::ordered_json profile_json(const StateProfile& profile);

}  // namespace grafverif
