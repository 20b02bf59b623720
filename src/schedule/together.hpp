// SPDX-License-Identifier: MIT
// schedule_together: translates Equations and plant automata to a TransitionSystem in which controllers and automata
// are synchronized.
//
// synchronous (DESDES06 section 6): in one step every controller executes one PLC cycle, and every automaton takes one
// edge, all from the same state. An automaton stays in its location only if none of its urgent edges is enabled.
//
// sequenced (WODES06 III.E; Algorithm 2 and Figs. 4, 5 are reconstructed). A general sequencer lets the controllers and
// the plant run alternately; the plant sequencer has the four states of the paper. One variable of main represents both
// sequencers:
//
//   controllers  the controllers run cycles until they are quiescent; one cycle, if outputs are written in every cycle
//   controlled   the evolution of the controllers has ended: properties are evaluated
//   PIR          the plant reads the orders, which are constant because the controllers do not run. Timers may expire
//   PTR          rounds: each automaton in its turn (`move`, any order) takes one edge, and stays only if it has no
//                enabled urgent edge; timed edges only in the first round, so that an evolution of the
//                plant contains at most one end of movement per automaton. A round without changes is the last round
//   POU          the controllers receive the sensor values: from here on, the state of the plant is constant
//   PTE          the evolution of the plant has ended: properties are evaluated
//
// State-marking variables (Algorithm 1) are the variables that the location determines: see automaton_module.hpp. If
// the plant never becomes quiescent, the property `plant_settles` is violated; if the controllers never become
// quiescent, `controllers_settle` is violated.
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

/// Returns the system of the controllers and the automata of `plant`, which must be the result of plant(model, loop).
/// Requires that the schedule is synchronous or sequenced. The schedule is selected by `options`, or otherwise by the
/// loop. The result is empty after an error: a variable has too many values.
std::optional<TransitionSystem> schedule_together(const Model& model, const ClosedLoop& loop,
                                                  std::span<const Equations> equations, const Network& plant,
                                                  const ScheduleOptions& options, Diagnostics& diagnostics);

}  // namespace grafverif
