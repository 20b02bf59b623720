// SPDX-License-Identifier: MIT
// Detects possible model errors by static analysis. Localization uses this analysis, because an abstraction must not
// hide a model error.
#pragma once

#include <cstdint>
#include <set>

#include "ir/network_fragments.hpp"

namespace grafverif {

/// True if each term of the expanded network has a value in every state: no divisor can be zero, and no integer can
/// exceed 64 bits.
bool terms_have_values(const Network& network);

/// Returns a set of fragments (units of localization) that covers all model errors of the network: assignments of a
/// value outside the range of the variable, and races (flag `race`). For each possible error, the set contains a
/// fragment such that every abstraction with this fragment detects the error. Requires terms_have_values(network).
std::set<std::uint32_t> cells_that_may_err(const Network& network, const NetworkFragments& cells);

}  // namespace grafverif
