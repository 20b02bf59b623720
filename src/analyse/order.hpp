// SPDX-License-Identifier: MIT
// A static order of the variables of equations for decision diagrams: what is read together stands together.
#pragma once

#include <vector>

#include "grafverif/ir/equations.hpp"

namespace grafverif::analysis {

/// The variables that `wanted` marks, each once, the topmost first: along the transitions, as the chart is written, each
/// variable where it is first read or written; then drawn together by what each variable becomes (FORCE: Aloul, Markov,
/// Sakallah 2003) where that shortens the ways between what belongs together. Integers that one term reads are
/// neighbours, so that their bits can be interleaved.
std::vector<Id<Equations::Variable>> variable_order(const Equations& equations, const std::vector<bool>& wanted);

/// Integers that are compared or computed with each other, per variable the first of them: itself where there is no other.
std::vector<std::uint32_t> integer_groups(const Equations& equations);

/// Marks the variables on which evolutions depend: those that firing conditions, stability, races, faults and outputs
/// read, and so on for the values of stored variables among them. Steps always are.
std::vector<bool> variables_that_matter(const Equations& equations);

}  // namespace grafverif::analysis
