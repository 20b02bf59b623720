// SPDX-License-Identifier: MIT
// A static order of the variables of equations for decision diagrams: along the transitions, as the chart is written,
// each variable where it is first read or written.
#pragma once

#include <vector>

#include "grafverif/ir/equations.hpp"

namespace grafverif::analysis {

/// The variables that `wanted` marks, each once, the topmost first.
std::vector<Id<Equations::Variable>> variable_order(const Equations& equations, const std::vector<bool>& wanted);

/// Marks the variables on which evolutions depend: those that firing conditions, stability, races, faults and outputs
/// read, and so on for the values of stored variables among them. Steps always are.
std::vector<bool> variables_that_matter(const Equations& equations);

}  // namespace grafverif::analysis
