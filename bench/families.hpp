// SPDX-License-Identifier: MIT
// Scalable families of charts, as text, to measure location automata and test sequences.
//
// A chart with T transitions has n = ceil(log2 T) inputs; the condition of transition c is the conjunction of all of
// them, input k negated if bit k of c is 1, so that conditions are mutually exclusive. Each ring's first step has an
// output.
#pragma once

#include <cstddef>
#include <string>

namespace grafverif::bench {

/// A ring of `steps` steps.
std::string basic_sequence(std::size_t steps);

/// `rings` independent rings of `steps` steps.
std::string hierarchical_parallel(std::size_t rings, std::size_t steps);

/// Step 1 opens an AND divergence into `branches` branches, each a step followed by the same structure one level
/// deeper, `levels` levels in all; at the last level one step; then a convergence and a closing step per branch. All
/// converge to a last step, which leads back to 1.
std::string basic_parallel(std::size_t levels, std::size_t branches);

}  // namespace grafverif::bench
