// SPDX-License-Identifier: MIT
// What verdicts and traces call a step variable: as conditions of the chart write it, `X7`, `G2.X7` of the partial chart
// G2; where several controllers stand side by side, after the name of its own: `press.X7`.
#pragma once

#include <string>

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// The step variable that `variable` of the network stands for. Requires its role to be Step.
std::string step_variable_name(const Network& network, Id<Network::Variable> variable);

}  // namespace grafverif
