// SPDX-License-Identifier: MIT
// Static variable order for decision diagrams, in which variables that are read together are adjacent.
#pragma once

#include <vector>

#include "grafverif/ir/equations.hpp"

namespace grafverif::analysis {

/// Returns the variables that `wanted` marks, each once, beginning with the topmost variable of the diagrams. The
/// initial order follows the transitions in the chart: each variable is at the position of its first read or write. The
/// initial order is then improved with the dependencies of the next values (FORCE: Aloul, Markov, Sakallah 2003), if
/// this reduces the total distance of related variables. Integers that one term reads are adjacent, so that their bits
/// can be interleaved.
std::vector<Id<Equations::Variable>> variable_order(const Equations& equations, const std::vector<bool>& wanted);

/// Returns groups of integers that are compared or combined with each other: for each variable, the first variable of
/// its group, which may be the variable itself.
std::vector<std::uint32_t> integer_groups(const Equations& equations);

/// Marks the variables on which evolutions depend: the variables that firing conditions, stability, races, faults and
/// outputs read, and transitively the variables that determine the values of marked stored variables. Steps are always
/// marked.
std::vector<bool> variables_that_matter(const Equations& equations);

}  // namespace grafverif::analysis
