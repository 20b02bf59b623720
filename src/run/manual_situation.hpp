// SPDX-License-Identifier: MIT
// by_hand: activates or deactivates a step on behalf of the user, who explores the consequences ("what if"). After a
// change by the user, the trace is not a run of the chart or of the model. The new situation is consistent with the
// rules of hierarchy:
//
//   ordinary step    only the activity of this step changes; an active step of an expansion also activates its
//                    macro-steps
//   macro-step       if activated, its entry step is also activated; if deactivated, all steps of its expansion are
//                    deactivated
//   enclosing step   if activated, the steps of its activation links are activated; if deactivated, all enclosed steps
//                    are deactivated
//   forcing step     if activated, its forcing orders take effect
//
// A change is rejected if the rules would revert it: if an active forcing order forces the step's chart, if its
// enclosing step is inactive, or if forcing orders are contradictory. Stored actions are not executed; continuous
// actions follow the situation.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "ir/network_run.hpp"

namespace grafverif {

struct ManualSituation {
    std::vector<bool> situation = {};  ///< for each step of the chart: true if the step is active
    std::string refusal = {};          ///< reason for rejection; empty if the change is accepted
};

/// Activates or deactivates a step. Requires that `situation` is consistent with the rules of the hierarchy.
ManualSituation by_hand(const Chart& chart, const std::vector<bool>& situation, Id<Chart::Step> step, bool active);

/// Returns the situation of the chart of `controller`: for each step, true if it is active.
std::vector<bool> situation_of(const Network& network, const NetworkState& state, Id<Network::Controller> controller);
/// Sets the situation of a controller. The controller then waits for its next cycle, and a cycle is requested. Timers
/// of steps that change are started and stopped.
void put_situation(const Network& network, NetworkState& state, Id<Network::Controller> controller,
                   const std::vector<bool>& situation);

}  // namespace grafverif
