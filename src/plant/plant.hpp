// SPDX-License-Identifier: MIT
// plant: translates components and their arguments to a Network of the plant alone (CEP13 section 4). Each component
// becomes a template, and each instance becomes a process. Processes communicate only through shared variables.
//
// Mapping:
//   shared variable        Variable at the same index, including the inputs and outputs of controllers; the writer
//                          determines the value at power-on: the `with` value of its initial location, otherwise the
//                          default of the output
//   variable of a component Variable `Instance_name` after the shared variables, bound to a Written parameter
//   parameter              Parameter at the same index: input -> Read, output -> Written, constant -> Constant
//   duration               integer number of time units; the time unit is that of the loop, or the greatest common
//                          divisor of all durations
//   instance               Process at the same index
//
// Integer variables that are bound to one parameter of a template are widened to the hull of their ranges, because a
// parameter has one type. UPPAAL requires equal ranges for the variables that are bound to a reference parameter.
#pragma once

#include <optional>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

/// Translates the plant of a loop. Requires verify(model).empty() and that `loop` belongs to the model. The result is
/// empty after an error. Errors: a duration is not a multiple of the time unit; a variable has two writers; the target
/// invariant of an urgent edge can be false; an initial value is outside its range.
std::optional<Network> plant(const Model& model, const ClosedLoop& loop, Diagnostics& diagnostics);

}  // namespace grafverif
