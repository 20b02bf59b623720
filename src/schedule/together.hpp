// SPDX-License-Identifier: MIT
// schedule_together: translates Equations and plant automata to a TransitionSystem in which controllers and automata
// are synchronized.
//
// synchronous (DESDES06 section 6): in one step every controller executes one PLC cycle, and every automaton takes one
// edge, all from the same state. An automaton takes no edge only if it has no enabled urgent edge.
//
// sequenced (WODES06 III.E; Algorithm 2 and Figs. 4, 5 are reconstructed). A general sequencer passes the turn from the
// controllers to the plant and back; the plant sequencer has the four states of the paper. Both sequencers are
// represented by one variable of main:
//
//   controllers  they run cycles until they are quiescent; one cycle, if outputs are written in every cycle
//   controlled   that evolution has ended: properties are evaluated
//   PIR          the orders are read; they are constant, since the controllers are idle. Timers may expire
//   PTR          rounds: each automaton in its turn (`move`, any order) takes one edge, and stays only if it has no
//                enabled urgent edge; timed edges only in the first round, so that an evolution of the
//                plant contains at most one end of movement per automaton. A round without changes is the last one
//   POU          the sensors are passed to the controllers: the plant is constant from here on
//   PTE          the evolution of the plant has ended: properties are evaluated
//
// State-marking variables (Algorithm 1) are the variables determined by a location: see automaton_module.hpp. If the
// plant never becomes quiescent, the property `plant_settles` is violated; if the controllers never do,
// `controllers_settle` is violated.
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

/// Requires that `plant` is the result of plant(model, loop), and that the schedule of `options`, otherwise that of the
/// loop, is synchronous or sequenced. The result is empty after an error: a variable has too many values.
std::optional<TransitionSystem> schedule_together(const Model& model, const ClosedLoop& loop,
                                                  std::span<const Equations> equations, const Network& plant,
                                                  const ScheduleOptions& options, Diagnostics& diagnostics);

}  // namespace grafverif
