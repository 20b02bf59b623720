// SPDX-License-Identifier: MIT
// Where the states of a search come from, in words and in JSON.
#pragma once

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>

#include "grafverif/ir/state_profile.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

/// Looks up the places.
void name_places(StateProfile& profile, const Sources& sources);

/// A line per thing that multiplies, the largest first, and what else is to be known of the states.
void print_profile(const StateProfile& profile, std::ostream& out);

/// `{"states","sampled","inside_cycles","parts":[{"name","kind","combinations","factor","place"}],"clocks":[{"instance",
/// "clock","greatest","values","factor","place"}],"finest":{"duration","unit","coarser","place"}}`; durations and units in ms.
nlohmann::ordered_json profile_json(const StateProfile& profile);

}  // namespace grafverif
