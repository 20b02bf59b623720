// SPDX-License-Identifier: MIT
// by_hand: somebody makes a step active, or not, to see what would follow. That is a trial: what comes of it is no run of the
// chart or of the model any more. The situation that it leads to is one that the rules of hierarchy allow:
//
//   ordinary step    it alone; a step of an expansion has its macro-steps active with it
//   macro-step       its entry step is activated; all of its expansion is deactivated
//   enclosing step   its activation links are activated; all that it encloses is deactivated
//   forcing step     its orders are obeyed
//
// Refused is what the rules would take back: a step that an active order holds, one whose enclosing step is not active, and
// orders that cannot be obeyed together. No stored action is run; continuous ones follow.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "ir/network_run.hpp"

namespace grafverif {

struct ByHand {
    std::vector<bool> situation = {};  ///< per step of the chart
    std::string refusal = {};          ///< why there is none; empty: there is
};

/// Requires a situation that the rules allow.
ByHand by_hand(const Chart& chart, const std::vector<bool>& situation, Id<Chart::Step> step, bool active);

/// Per step of the chart of `controller`.
std::vector<bool> situation_of(const Network& network, const NetworkState& state, Id<Network::Controller> controller);
/// The controller waits for its next cycle, has `situation` from now on, and reason for a cycle; timers of steps that
/// change are started and stopped.
void put_situation(const Network& network, NetworkState& state, Id<Network::Controller> controller,
                   const std::vector<bool>& situation);

}  // namespace grafverif
