// SPDX-License-Identifier: MIT
// interface_of: the chart that represents a Program as a controller of a closed loop. The chart declares the variables
// and steps that the loop can read or write. The behaviour of the controller is the behaviour of the program
// (derive/program/controller.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "ir/program/program.hpp"

namespace grafverif {

/// Returns the memory cells that are variables of the chart and of the equations of a scan, in the order of these
/// variables. The result contains all cells except constants and temporary variables.
std::vector<std::size_t> variable_cells(const ProgramLayout& layout);
/// Returns the memory cells that represent a step of the chart, in the order of these steps.
std::vector<std::size_t> step_cells(const ProgramLayout& layout);
/// Returns the name of the step that the cell `cell` represents. For the cell `Filling.X`, this is step `Filling`; for
/// the cell `Tank.Filling.X`, this is step `Filling` of the partial chart `Tank`.
StepName step_name(const std::string& cell);

/// Returns the declarations of the variables in a path such as `Line.T1.Q`, in order, up to the first name that is
/// unknown. Names are compared case-insensitively; indices of array elements are ignored.
std::vector<Span> declarations_in(const Program& program, std::string_view path);

/// Returns the chart of `program`. `variable_cells` and `step_cells` return the cells that correspond to the variables
/// and steps of the chart.
Chart interface_of(ProgramReference program, std::string name, Span origin);

/// The test of one transition: the statement that assigns true if the transition is cleared, and the instance that
/// executes the statement. `sequence_tests` returns the tests of the transitions of `drawn_chart`, in order.
struct SequenceTest {
    Id<Program::Statement> statement = {};
    Id<Program::Unit> unit = {};  ///< unit of the instance that executes the statement
    std::uint32_t frame = 0;
};
std::vector<SequenceTest> sequence_tests(const Program& program, const ProgramLayout& layout);

/// Returns the chart of `interface_of` with the initial steps, transitions and actions of the Sequential Function
/// Charts of the program, for drawings. All conditions are true. An action block is a continuous action on an output
/// with its label as name, such as `D T#2s Lamp`.
Chart drawn_chart(const Chart& interface);

}  // namespace grafverif
