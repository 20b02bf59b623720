// SPDX-License-Identifier: MIT
// initial_values: variables of a PLC program that statements read before any statement assigns them.
#pragma once

#include <vector>

#include "grafverif/ir/finding.hpp"
#include "ir/program/program.hpp"

namespace grafverif {

/// Returns a finding for each variable without an explicit initial value that no statement assigns and that a statement
/// or, for an output, the plant reads (`variable-never-assigned`). Returns a finding for each temporary variable and
/// each variable of a function that is read although no statement before the read assigns it in the same call
/// (`read-before-assignment`). Both are properties of the text: they apply to every execution of the statement that
/// reads the variable.
std::vector<Finding> findings_about_initial_values(const Program& program, const ProgramLayout& layout);

}  // namespace grafverif
