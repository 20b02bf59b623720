// SPDX-License-Identifier: MIT
// Where a network may break off, found without a search: a local network must not hide it.
#pragma once

#include <cstdint>
#include <set>

#include "ir/network_cells.hpp"

namespace grafverif {

/// Whether each term of the expanded network has a value in every state: nothing divides by what may be zero, and no
/// integer outgrows 64 bits.
bool terms_have_values(const Network& network);

/// Cells such that a model error of the network is one of the local network of each choice of cells with the right one of
/// these in it: values that may leave a range, and what makes `race` true. Requires: terms_have_values(network).
std::set<std::uint32_t> cells_that_may_err(const Network& network, const NetworkCells& cells);

}  // namespace grafverif
