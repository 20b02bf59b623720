// SPDX-License-Identifier: MIT
// Scalable families of charts as text, for measuring location automata and test sequences.
//
// A chart with T transitions has n = ceil(log2 T) inputs. The condition of transition c is the conjunction of all
// inputs; input k is negated if bit k of c is 1. Therefore the conditions are mutually exclusive. The first step of
// each ring has an output.
#pragma once

#include <cstddef>
#include <string>

namespace grafverif::bench {

/// Returns a ring of `steps` steps.
std::string basic_sequence(std::size_t steps);

/// Returns `rings` independent rings of `steps` steps.
std::string hierarchical_parallel(std::size_t rings, std::size_t steps);

/// Returns a chart with nested AND divergences. Step 1 opens an AND divergence into `branches` branches. Each branch is
/// a step followed by the same structure one level deeper, up to `levels` levels; at the last
/// level, one step takes the place of the structure. A convergence and a closing step follow each
/// branch. All branches converge to a last step, which leads back to step 1.
std::string basic_parallel(std::size_t levels, std::size_t branches);

}  // namespace grafverif::bench
