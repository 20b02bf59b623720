// SPDX-License-Identifier: MIT
// interface_of: the chart that represents a Program as a controller of a closed loop. The chart declares the names that
// the loop can use; its behaviour is that of the program (derive/program/controller.hpp).
#pragma once

#include <string>

#include "grafverif/ir/chart.hpp"
#include "ir/program/program.hpp"

namespace grafverif {

/// Returns the cells of which a chart or the equations of a scan have a variable, in the order of these variables: all
/// except constants and temporary variables.
std::vector<std::size_t> variable_cells(const ProgramLayout& layout);
/// Returns the cells of which the chart has a step, in order.
std::vector<std::size_t> step_cells(const ProgramLayout& layout);
/// Returns the name of a step, such as `Filling`, or `Filling` of the instance `Tank`, for the cell `Tank.Filling.X`.
StepName step_name(const std::string& cell);

/// Returns the chart of `program`. Its variables and steps are those of `variable_cells` and `step_cells`.
Chart interface_of(ProgramReference program, std::string name, Span origin);

}  // namespace grafverif
