// SPDX-License-Identifier: MIT
// schedule_together: translates Equations and plant automata to a TransitionSystem in which controllers and automata
// are synchronized.
//
// synchronous (DESDES06 section 6): in one step, every controller executes one PLC cycle and every automaton takes one
// edge. All controllers and automata read the values before the step. An automaton stays in its location only if none
// of its urgent edges is enabled.
//
// sequenced (WODES06 III.E; Algorithm 2 and Figs. 4, 5 of the paper are reconstructed). A general sequencer lets the
// controllers and the plant run alternately. The plant sequencer has the four states PIR, PTR, POU and PTE of the
// paper. One variable of main represents both sequencers:
//
//   controllers  the controllers execute cycles until they are quiescent; controllers that write outputs in every cycle
//                execute only one cycle
//   controlled   the evolution of the controllers has ended: properties are evaluated
//   PIR          the plant reads the outputs of the controllers, which are constant, because the controllers do not
//                run. Timers may expire
//   PTR          rounds: in each round, each automaton in turn (`move`, any order) takes one edge; an automaton may
//                stay in its location only if it has no enabled urgent edge. Timed edges are taken only in the first
//                round, so that at most one movement of each automaton ends in an evolution of the plant. A round
//                without changes is the last round
//   POU          the controllers receive the sensor values; from this state on, the state of the plant is constant
//   PTE          the evolution of the plant has ended: properties are evaluated
//
// The state-marking variables of the paper (Algorithm 1) are the variables whose value the location determines
// (automaton_module.hpp). If the plant never becomes quiescent, the property `plant_settles` is violated; if the
// controllers never become quiescent, `controllers_settle` is violated.
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
/// Requires that the schedule is synchronous or sequenced. `options` selects the schedule; if `options` contains no
/// schedule, the schedule of the loop applies. If a variable has too many values for a symbolic model, reports an error
/// and returns nullopt.
std::optional<TransitionSystem> schedule_together(const Model& model, const ClosedLoop& loop,
                                                  std::span<const Equations> equations, const Network& plant,
                                                  const ScheduleOptions& options, Diagnostics& diagnostics);

}  // namespace grafverif
