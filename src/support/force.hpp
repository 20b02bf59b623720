// SPDX-License-Identifier: MIT
// FORCE (Aloul, Markov, Sakallah 2003): vertex ordering that places the vertices of each hyperedge close together. In
// each iteration, each hyperedge moves to the mean position of its members, and then each member moves to the mean
// position of its hyperedges. The iteration terminates when the total span of the hyperedges no longer decreases.
#pragma once

#include <cstdint>
#include <vector>

namespace grafverif {

/// A hyperedge: vertices that are placed close together.
using ForceEdge = std::vector<std::uint32_t>;

/// Returns the position of each of `vertices` vertices. The initial order is the order of the vertex indices.
std::vector<double> force_places(std::size_t vertices, const std::vector<ForceEdge>& edges);

}  // namespace grafverif
