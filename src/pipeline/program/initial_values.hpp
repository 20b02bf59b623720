// SPDX-License-Identifier: MIT
// Finds variables of a PLC program that are read before any statement assigns them.
#pragma once

#include <vector>

#include "grafverif/ir/finding.hpp"
#include "ir/program/program.hpp"

namespace grafverif {

/// Returns a finding `variable-never-assigned` for each variable that has no explicit initial value, that no statement
/// assigns, and that is an output or is read by a statement. Returns a finding `read-before-assignment` for each
/// temporary variable and each variable of a function that is read although no earlier statement of the same call
/// assigns it. Both findings follow from the program text alone: they apply to every execution of the statement that
/// reads the variable.
std::vector<Finding> findings_about_initial_values(const Program& program, const ProgramLayout& layout);

}  // namespace grafverif
