// SPDX-License-Identifier: MIT
// schedule_controllers: translates Equations to a TransitionSystem that represents the controllers without a plant,
// according to DESDES06 section 6.1. Inputs and timer outputs are free variables of `main`; each controller is an
// instance of a separate module.
//
// One step of the system is one PLC cycle. In every state:
//   - the inputs have the values that the next cycle reads; the inputs are free;
//   - firing conditions, `stable` and `settled` are definitions over the current activities and inputs;
//   - activities, internal variables and outputs have their values after the previous cycle.
// State 0 is power-on. If the first evolution has a visible effect, it is the first step of the system: `started` is
// false in this step and true in all later steps. If the first evolution has no visible effect, the first step is the
// first cycle.
//
// Mapping:
//   step             X_2, init and next by equation (12)
//   transition       CF_T0, a definition: equation (11)
//   output           with stability search: a state variable, next(TEST) := stable ? TEST_now : TEST; TEST_now is
//                    equation (13). In the mode every_cycle: a definition with equation (13), or a state variable if
//                    equation (13) reads an input, because a cycle reads the sampled input
//   stored action    the next value is a conditional term; with stability search, `LOCK_image` stores the value of an
//                    output until it is written
//   race             `race`, set permanently when two stored actions write different values simultaneously
//   range            `out_of_range`, set permanently when a divisor is zero or an assigned value is outside the range
//                    of its variable; an assignment outside the range does not change the variable
//   constraint       with the approach `constraints`, an invariant of main over the inputs (DESDES06 5.1)
//   observer         a module that observes every step
//   several controllers   a free variable `turn_NAME` for each controller, true infinitely often: the relative speed of
//                         controllers is arbitrary
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

/// True if at least one combination of inputs satisfies all constraints of `loop`. Otherwise, reports the first
/// constraint that contradicts the previous constraints.
bool constraints_agree(const ClosedLoop& loop, Diagnostics& diagnostics);

/// Returns the system of the controllers of `loop`, with its properties. Properties that also depend on the plant are
/// listed in TransitionSystem::omitted. `equations` contains the equations of the charts of the controllers, in the
/// order of the controllers. Requires that `verify` returns an empty list for each argument, and, with the approach
/// `constraints`, that `constraints_agree` returns true.
TransitionSystem schedule_controllers(const Model& model, const ClosedLoop& loop, std::span<const Equations> equations,
                                      const ScheduleOptions& options = {});

/// Returns the system of a single controller that does not belong to a closed loop.
TransitionSystem schedule_controller(const Equations& equations, ExecutionMode mode);

}  // namespace grafverif
