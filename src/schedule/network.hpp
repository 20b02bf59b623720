// SPDX-License-Identifier: MIT
// schedule_network: translates a Network to a TransitionSystem: the closed loop with its plant automata. In each step,
// at most one process moves (schedule `interleaved`).
//
// Mapping:
//   process          an instance of a module (automaton_module.hpp); instances of the same component with equal
//                    constants share a module. The PLC is also a process: its module represents the PLC cycle with the
//                    grain of the network
//   moving process   a choice `move` of main: `of_H_Cyl`, `of_PLC`, or `none`, which can be chosen only if no urgent
//                    edge is enabled
//   shared variable  a variable of the module that writes it, or a definition if the location determines its value. A
//                    shared variable with several writers (the flags of the PLC) is a variable of main
//   time             abstract: clocks are omitted, so that a timed edge may be taken at any time. The model has all
//                    runs of the timed loop, and may have further runs. Discrete: each clock is a counter in its
//                    module, bounded by the cap of the clock as in the timed engine, and a step with `move = of_time`
//                    is a tick. The model has the same states as the timed engine. `no deadlock` becomes `always
//                    possible p`; p states that an edge can be taken. For `no timelock`, p states that time can pass
//   observer         a module that observes every step
//
// The system is total. If an urgent edge is enabled, the process of this edge can move; otherwise `none` can be chosen.
// With discrete time, a step from a state in which no edge can be taken and time cannot pass leads to the same state.
#pragma once

#include <optional>
#include <span>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/ir/transition_system.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Translates `network`. Requires that `network` is the result of compose for `loop` and the `equations` of its
/// controllers. If a variable has too many values for a symbolic model, reports an error and returns nullopt.
std::optional<TransitionSystem> schedule_network(const Model& model, const ClosedLoop& loop,
                                                 std::span<const Equations> equations, const Network& network,
                                                 const ScheduleOptions& options, Diagnostics& diagnostics);

/// Translates an abstraction of the network of `loop`: an expanded network with the same controllers, processes and
/// variables, in which clock constraints may be missing. The properties of the result are those properties of
/// `abstraction` that concern all states, and the properties that exclude races and values outside their ranges. If
/// some process has clock constraints, time is discrete. If a variable has too many values for a symbolic model,
/// returns nullopt.
std::optional<TransitionSystem> schedule_abstraction(const Model& model, const ClosedLoop& loop,
                                                     std::span<const Equations> equations, const Network& abstraction);

}  // namespace grafverif
