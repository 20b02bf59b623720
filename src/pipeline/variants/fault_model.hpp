// SPDX-License-Identifier: MIT
// The model of a closed loop with faults: instances that may behave as other components.
//
// The component of an instance with a fault is the union of its component and of the component of the fault. An edge
// without guard, which is not urgent, leads from each location of the normal behaviour to the initial location of the
// fault, at any time. When this edge is taken, the fault occurs; the fault is permanent. The edge resets the clocks of
// the fault and assigns the values of its initial location (`with`); all other outputs keep their values. The union is
// an ordinary component: the engines and the composition need no knowledge about faults.
//
// At power-on, the edge can be taken before the first evolution of each controller, which determines the previous
// values of terms whose edges (IEC 60848) are read (compose/procedures.cpp). Therefore each state that is reachable
// with a fault from power-on is also reachable with this edge, apart from the flag EVOL_PL, which the first cycle
// resets. A property about runs from power-on (`inevitable`, or with an observer) also needs the model in which the run
// begins in the initial location of the fault.
#pragma once

#include <vector>

#include "grafverif/ir/closed_loop.hpp"

namespace grafverif {

struct ActiveFault {
    Id<ClosedLoop::Fault> fault = {};
    bool from_power_on = false;  ///< true: present from power-on; false: it occurs at any time or never
    /// True: when the fault occurs, its instance is in an additional location for an instant. This location is the last
    /// one of the component.
    bool announced = false;
};

/// Returns the model, in whose loop the faults may occur. Requires faults of different instances. Ids of instances,
/// variables, locations and properties are unchanged. The loop of the returned model declares no faults.
Model with_faults(const Model& model, Id<ClosedLoop> loop, const std::vector<ActiveFault>& faults);

}  // namespace grafverif
