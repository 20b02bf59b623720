// SPDX-License-Identifier: MIT
// Static variable order for decision diagrams: places variables that are read together next to each other.
#pragma once

#include <vector>

#include "grafverif/ir/equations.hpp"

namespace grafverif::analysis {

/// The variables that `wanted` marks, each once, the topmost first. The initial order follows the transitions as
/// written in the chart, with each variable at its first read or write. It is then improved with the dependencies of
/// the next values (FORCE: Aloul, Markov, Sakallah 2003), if that shortens the total distance of related variables.
/// Integers that one term reads are neighbours, so that their bits can be interleaved.
std::vector<Id<Equations::Variable>> variable_order(const Equations& equations, const std::vector<bool>& wanted);

/// Groups of integers that are compared or computed with each other: per variable the first of its group, possibly
/// itself.
std::vector<std::uint32_t> integer_groups(const Equations& equations);

/// Marks the variables on which evolutions depend: those read by firing conditions, stability, races, faults and
/// outputs, and transitively by the values of stored variables among them. Steps are always marked.
std::vector<bool> variables_that_matter(const Equations& equations);

}  // namespace grafverif::analysis
