// SPDX-License-Identifier: MIT
// schedule_together: Equations + plant automata -> TransitionSystem in which controllers and automata keep step.
//
// synchronous (DESDES06 section 6): in one step every controller runs one PLC cycle and every automaton takes one edge,
// all from the same state. An automaton stays only where it has no urgent edge to take.
//
// sequenced (WODES06 III.E; Algorithm 2 and Figs. 4, 5 are reconstructed). A general sequencer hands the turn from the
// controllers to the plant and back; the plant sequencer has the four states of the paper. Both are one variable of main:
//
//   controllers  they run cycles until they settle; one cycle, where outputs are written in every cycle
//   controlled   that evolution is over: judged
//   PIR          the orders are read; they hold still, since the controllers do. Timers may come to their end
//   PTR          rounds: each automaton in its turn (`move`, any order) takes one edge, and stays only where it has
//                nothing urgent to do; timed edges are taken in the first round only, so that an evolution of the
//                plant holds at most one end of movement per automaton. A round that changes nothing is the last
//   POU          the sensors are handed over: the plant holds still from here on
//   PTE          the evolution of the plant is over: judged
//
// State-marking variables (Algorithm 1) are the variables that a location tells: see automaton_module.hpp. A plant that
// never settles violates the property `plant_settles`, and controllers that never do, `controllers_settle`.
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

/// Requires that `plant` is what plant(model, loop) returned, and that the schedule of `options`, or else of the loop,
/// is synchronous or sequenced. Nothing after an error: a variable with too many values.
std::optional<TransitionSystem> schedule_together(const Model& model, const ClosedLoop& loop,
                                                  std::span<const Equations> equations, const Network& plant,
                                                  const ScheduleOptions& options, Diagnostics& diagnostics);

}  // namespace grafverif
