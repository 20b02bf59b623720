// SPDX-License-Identifier: MIT
// State profile as text and as JSON: the components that contribute most states to a search.
#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>

#include "grafverif/ir/state_profile.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

/// Determines the source locations.
void name_places(StateProfile& profile, const Sources& sources);

/// One line per component and clock by decreasing factor, followed by remarks on the states.
void print_profile(const StateProfile& profile, std::ostream& out);

/// `{"states", "sampled", "inside_cycles", "parts":[{"name", "kind", "combinations", "factor", "place"}],
/// "clocks":[{"instance", "clock", "greatest", "values", "factor", "place"}], "finest":{"duration", "unit", "coarser",
/// "place"}}`; durations and units in ms.
nlohmann::ordered_json profile_json(const StateProfile& profile);

}  // namespace grafverif
