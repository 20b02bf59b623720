// SPDX-License-Identifier: MIT
// Families of charts that grow at will, as text: what location automata and test sequences are measured on.
//
// A chart with T transitions has n = ceil(log2 T) inputs; the condition of transition c is the conjunction of all of them,
// input k negated where bit k of c is 1, so that no two conditions hold at once. Each ring's first step has an output.
#pragma once

#include <cstddef>
#include <string>

namespace grafverif::bench {

/// A ring of `steps` steps.
std::string basic_sequence(std::size_t steps);

/// `rings` independent rings of `steps` steps.
std::string hierarchical_parallel(std::size_t rings, std::size_t steps);

/// Step 1 opens an AND divergence into `branches` branches, each a step, then the same again one level deeper, `levels`
/// levels in all; at the last level one step; then a convergence and a closing step per branch, all converging to a
/// last step, which leads back to 1.
std::string basic_parallel(std::size_t levels, std::size_t branches);

}  // namespace grafverif::bench
