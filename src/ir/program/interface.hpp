// SPDX-License-Identifier: MIT
// interface_of: the chart that represents a Program as a controller of a closed loop. The chart declares the names that
// the loop can use; its behaviour is that of the program (derive/program/controller.hpp).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

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

/// For each transition of `drawn_chart`, in order: the statement that assigns true if the transition is cleared, and the
/// address of the instance that executes the statement.
struct SequenceTest {
    Id<Program::Statement> statement = {};
    Id<Program::Unit> unit = {};  ///< unit of the instance
    std::uint32_t frame = 0;
};
std::vector<SequenceTest> sequence_tests(const Program& program, const ProgramLayout& layout);

/// Returns the chart of `interface_of` with the transitions and actions of the Sequential Function Charts of the
/// program, for drawings. All conditions are true. An action block is a continuous action on an output with its label as name, such as `D T#2s Lamp`.
Chart drawn_chart(const Chart& interface);

}  // namespace grafverif
