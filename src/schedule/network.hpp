// SPDX-License-Identifier: MIT
// schedule_network: translates a Network to a TransitionSystem: the closed loop with its plant automata, one of which
// moves in each step (schedule `interleaved`).
//
// Mapping:
//   process          an instance of a module, one module per component and set of constants: see automaton_module.hpp.
//                    The PLC is also a process: its cycle, in the grain of the network, with the state of the network
//   moving process   a choice `move` of main: `of_H_Cyl`, `of_PLC`, or `none`, which can be chosen only if no urgent
//                    edge is enabled
//   shared variable  a variable of the module that writes it, or a definition if the location determines its value; a
//                    variable of main if it has several writers (the flags of the PLC)
//   time             abstract: clocks are omitted, so that a timed edge may be taken at any time. The model has all
//                    runs of the timed loop, and further runs. Discrete: clocks are bounded counters of their modules,
//                    with the normalization of the timed engine, and `move = of_time` is a tick. The states are those
//                    of the timed engine. `no deadlock` becomes `always possible` of an edge, and `no timelock` becomes
//                    `always possible` of a tick
//   observer         a module that observes every step
//
// The system is total. If an urgent edge is enabled, its process can move; otherwise `none` can be chosen. If clocks
// are counted, a step from a state without successors leads to the same state.
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

/// Translates `network`, which must be the result of compose for `loop` and the `equations` of its controllers. The
/// result is empty after an error: a variable has too many values for a symbolic model.
std::optional<TransitionSystem> schedule_network(const Model& model, const ClosedLoop& loop,
                                                 std::span<const Equations> equations, const Network& network,
                                                 const ScheduleOptions& options, Diagnostics& diagnostics);

}  // namespace grafverif
