// SPDX-License-Identifier: MIT
// Drop: a model without one of its elements, to see whether a proof needs it.
//
//   a transition          it is never cleared
//   a timing              clocks have no say in one instance or timer: what takes time there may take any time, or for ever
//   an instance           it is anywhere at any moment, and gives its outputs any value at any moment
//
// Without a timing or an instance a loop does all that it did, and more: every state that could be reached can be, that of an
// instance left out apart from its own locations and clocks. So what holds in all states without it holds with it, and needs
// it not. A loop without a transition is another loop.
#pragma once

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/network.hpp"

namespace grafverif {

/// Its condition is false.
void drop_transition(Chart& chart, Id<Chart::Transition> transition);

/// `network` is expanded, as below. Whether clocks had a say.
bool drop_timing(Network& network, Id<Network::Process> process);

/// Of an instance. `roams`: somebody asks where it is (a property, or `settled`); else it stays at its first location. False, and
/// nothing done: it has too many values to give, or calls procedures.
bool drop_instance(Network& network, Id<Network::Process> process, bool roams = true);

}  // namespace grafverif
