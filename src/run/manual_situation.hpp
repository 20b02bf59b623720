// SPDX-License-Identifier: MIT
// by_hand: the user activates or deactivates a step to explore the consequences ("what if"). The result is no longer a
// run of the chart or of the model. The new situation is consistent with the rules of hierarchy:
//
//   ordinary step    only this step; a step of an expansion activates its macro-steps
//   macro-step       its entry step is activated; all of its expansion is deactivated
//   enclosing step   its activation links are activated; all enclosed steps are deactivated
//   forcing step     its orders take effect
//
// Rejected are changes that the rules would revert: a step in a chart forced by an active order, a step whose enclosing
// step is inactive, and contradictory orders. Stored actions are not executed; continuous ones follow the situation.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "ir/network_run.hpp"

namespace grafverif {

struct ManualSituation {
    std::vector<bool> situation = {};  ///< per step of the chart
    std::string refusal = {};          ///< reason for rejection; empty if accepted
};

/// Requires a situation that is consistent with the rules.
ManualSituation by_hand(const Chart& chart, const std::vector<bool>& situation, Id<Chart::Step> step, bool active);

/// Per step of the chart of `controller`.
std::vector<bool> situation_of(const Network& network, const NetworkState& state, Id<Network::Controller> controller);
/// The controller waits for its next cycle, has `situation` from now on, and is due to run a cycle; timers of steps
/// that change are started and stopped.
void put_situation(const Network& network, NetworkState& state, Id<Network::Controller> controller,
                   const std::vector<bool>& situation);

}  // namespace grafverif
