// SPDX-License-Identifier: MIT
// FORCE (Aloul, Markov, Sakallah 2003): an order of vertices in which those of each hyperedge stand near each other. In
// turn every hyperedge moves to the mean place of its members and every member to the mean place of its hyperedges,
// until the total span of the hyperedges shrinks no more.
#pragma once

#include <cstdint>
#include <vector>

namespace grafverif {

/// A hyperedge: the vertices it holds together.
using ForceEdge = std::vector<std::uint32_t>;

/// The place of each of `vertices` vertices, beginning with the order of their numbers, from which the first move is made.
std::vector<double> force_places(std::size_t vertices, const std::vector<ForceEdge>& edges);

}  // namespace grafverif
