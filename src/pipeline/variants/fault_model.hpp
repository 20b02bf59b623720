// SPDX-License-Identifier: MIT
// Builds the model of a closed loop with faults. A fault makes an instance behave as another component.
//
// The component of an instance with a fault is the union of its normal component and of the component of the fault.
// From each location of the normal behaviour, an edge leads to the initial location of the fault. The edge has no guard
// and is not urgent, so it can be taken at any time. When this edge is taken, the fault occurs; the fault is permanent.
// The edge resets the clocks of the fault and assigns the values of its initial location (`with`); all other outputs
// keep their values. The union is an ordinary component: the engines and the composition do not treat faults specially.
//
// At power-on, the edge can be taken before the first evolution of each controller. The first evolution determines the
// previous values of terms with rising or falling edges (compose/procedures.cpp). Therefore each state that is
// reachable with a fault from power-on is also reachable with this edge, except for the value of the variable EVOL_PL,
// which the first cycle resets. A property about runs from power-on (`inevitable`, or with an observer) also needs the
// model in which the run begins in the initial location of the fault.
#pragma once

#include <vector>

#include "grafverif/ir/closed_loop.hpp"

namespace grafverif {

struct ActiveFault {
    Id<ClosedLoop::Fault> fault = {};
    bool from_power_on = false;  ///< true: the fault is present from power-on; false: at any time or never
    /// If true, the instance is in an additional location for an instant when the fault occurs. This location is the
    /// last location of the component.
    bool announced = false;
};

/// Returns a copy of `model` in which the faults may occur in the loop. Requires faults of different instances. Ids of
/// instances, variables, locations and properties are unchanged. The loop of the returned model declares no faults.
Model with_faults(const Model& model, Id<ClosedLoop> loop, const std::vector<ActiveFault>& faults);

}  // namespace grafverif
