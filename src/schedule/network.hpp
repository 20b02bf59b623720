// SPDX-License-Identifier: MIT
// schedule_network: Network -> TransitionSystem, the closed loop with its plant automata, one of which moves in each
// step (schedule `interleaved`).
//
// What becomes what:
//   process          an instance of a module, one module per component and set of constants: see automaton_module.hpp.
//                    The PLC is one of them: its cycle, in the grain of the network, with the state of the network
//   who moves        a choice `move` of main: `of_H_Cyl`, `of_PLC`, or `none`, which is on offer only where no urgent edge
//                    is enabled
//   shared variable  a variable of the module that writes it, or a definition where the location tells its value; a
//                    variable of main where several write it (the flags of the PLC)
//   time             abstract: clocks are left out, so that a timed edge may fire at any moment: the model has every run
//                    of the timed loop, and more. Discrete: clocks are bounded counters of their modules, with the
//                    normalisation of the timed engine, and `move = of_time` is a tick: the states are the engine's.
//                    `no deadlock` and `no timelock` become `always possible` an edge, a tick
//   observer         a module that follows every step
//
// The system is total: where an urgent edge is enabled its process can move, elsewhere nobody need; with clocks that
// count, a state that nothing can leave repeats itself.
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

/// Requires that `network` is what compose made of `loop` and the `equations` of its controllers. Nothing after an
/// error: a variable with too many values for a symbolic model.
std::optional<TransitionSystem> schedule_network(const Model& model, const ClosedLoop& loop,
                                                 std::span<const Equations> equations, const Network& network,
                                                 const ScheduleOptions& options, Diagnostics& diagnostics);

}  // namespace grafverif
