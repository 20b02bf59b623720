// SPDX-License-Identifier: MIT
// Names of step variables in verdicts and traces: as in conditions of the chart, `X7`, or `G2.X7` for the partial chart
// G2; with several controllers, qualified by the controller: `press.X7`.
#pragma once

#include <string>

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Name of the step variable `variable` of the network. Requires the role Step.
std::string step_variable_name(const Network& network, Id<Network::Variable> variable);

}  // namespace grafverif
