// SPDX-License-Identifier: MIT
// plant: Components and their arguments -> a Network of the plant alone (CEP13 section 4). One template per component,
// one process per instance, communication by shared variables only; a verb.
//
// What becomes what:
//   shared variable        Variable at the same index, inputs and outputs of controllers included; its value at
//   power-on is
//                          that of its writer (the default of the output, then the `with` values of the initial
//                          location)
//   variable of a component Variable `Instance_name` behind them, bound to a Written parameter
//   parameter              Parameter at the same index: input -> Read, output -> Written, constant -> Constant
//   duration               whole number of time units: those of the loop, or the greatest common divisor of all
//   durations instance               Process at the same index
//
// Integer variables that the processes of one template share a parameter for are widened to the hull of their ranges: a
// parameter has one type (UPPAAL asks that of reference parameters).
#pragma once

#include <optional>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Requires verify(model).empty() and that `loop` is one of the model's. Nothing after an error: a duration that is no
/// whole number of time units, a variable with two writers, an urgent edge whose target invariant can fail, an initial
/// value outside its range.
std::optional<Network> plant(const Model& model, const ClosedLoop& loop, Diagnostics& diagnostics);

}  // namespace grafverif
