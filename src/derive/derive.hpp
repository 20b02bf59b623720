// SPDX-License-Identifier: MIT
// derive: translates a Chart to Equations, the algebraic model of CEP13 section 5, equations (11) to (13), extended by
// stored actions and by timers for time conditions.
//
// Elements of the equations for each element of the chart:
//   Variable: a variable with the same index, type and initial value; the variables of the chart precede all others.
//   Step 2: the variable X_2, or X_G2_2 in the partial chart G2, and its activity, equation (12).
//   Transition T0: the variable CF_T0 and its firing condition, equation (11).
//   Time condition 3s/X2: the timer T_X2_3s and its output T_X2_3s_Q, one per step and duration.
//   Output: its equation (13), which is the constant false if the output has no action.
//   Variable with stored actions: its next value, its race condition, and its value after the first evolution.
// If a name is already used, a number is appended: `X_2_2`.
//
// A continuous output in a condition is replaced by its equation (13), so that no equation depends on the value that
// was last written. A cycle of outputs that read each other has no defined value and is rejected (`output-cycle`).
// Substitution can increase the size of terms exponentially. A term of more than a million nodes is rejected
// (`too-large`).
#pragma once

#include <optional>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Returns the equations of `chart`, or nullopt after at least one error. It is an error if the chart belongs to a PLC
/// program; controller_equations derives the equations of programs. Requires verify(chart).empty().
std::optional<Equations> derive(const Chart& chart, Diagnostics& diagnostics);

}  // namespace grafverif
