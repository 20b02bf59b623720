// SPDX-License-Identifier: MIT
// Names of step variables in verdicts and traces. A step variable has the same name as in conditions of the chart:
// `X7`, or `G2.X7` for a step of the partial chart G2. With several controllers, the name of the controller precedes
// the name of the step variable: `press.X7`.
#pragma once

#include <string>

#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Returns the name of the step variable `variable` of the network. Requires that the role of `variable` is Step.
std::string step_variable_name(const Network& network, Id<Network::Variable> variable);

}  // namespace grafverif
