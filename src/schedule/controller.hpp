// SPDX-License-Identifier: MIT
// schedule_controllers: translates Equations to a TransitionSystem of the controllers without plant, according to
// DESDES06 section 6.1. Inputs and timer outputs are free variables of `main`; each controller is an instance of a
// separate module.
//
// One step of the system is one PLC cycle. In every state:
//   - the inputs are those that the next cycle will read; they are free;
//   - firing conditions, `stable` and `settled` are definitions over the current activities and inputs;
//   - activities, internal variables and outputs are those after the previous cycle.
// State 0 is power-on. If the first evolution has a visible effect, it is the first step of the system: `started` is
// false in this step and true in all later steps. Otherwise the first step is the first cycle.
//
// Mapping:
//   step             X_2, init and next by equation (12)
//   transition       CF_T0, a definition: equation (11)
//   output           with stability search a state variable: next(TEST) := stable ? TEST_now : TEST, where TEST_now
//                    is equation (13); in every cycle a definition, equation (13) itself, or, if it
//                    reads an input, a state variable, because the cycle reads the sampled input
//   stored action    next by cases; with stability search, `LOCK_image` stores the value of an output until it is
//                    written
//   race             `race`, set permanently when two stored actions write different values simultaneously
//   range            `out_of_range`, set permanently when an assignment would leave the range of its variable, which
//                    then keeps its value, or when a divisor is zero
//   constraint       with the approach `constraints`, an invariant of main over the inputs (DESDES06 5.1)
//   observer         a module that observes every step
//   several controllers   a free `turn_NAME` for each, true infinitely often: the relative speed of controllers is
//                         arbitrary
//
// The system is total: every next value is defined in every state, and contradictory constraints are rejected.
#pragma once

#include <optional>
#include <span>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/transition_system.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// True if at least one combination of inputs satisfies all constraints of `loop`. Otherwise reports the first
/// constraint that contradicts the previous ones.
bool constraints_agree(const ClosedLoop& loop, Diagnostics& diagnostics);

/// Returns the system of the controllers of `loop`, with its properties. Properties that also depend on the plant are
/// in `omitted`. `equations` are those of the controllers' charts, in order. Requires that verify is empty for each
/// argument, and that constraints_agree holds if the approach is `constraints`.
TransitionSystem schedule_controllers(const Model& model, const ClosedLoop& loop, std::span<const Equations> equations,
                                      const ScheduleOptions& options = {});

/// Returns the system of a single controller without a loop.
TransitionSystem schedule_controller(const Equations& equations, ExecutionMode mode);

}  // namespace grafverif
