// SPDX-License-Identifier: MIT
// Static detection of possible model errors, which an abstraction must not hide.
#pragma once

#include <cstdint>
#include <set>

#include "ir/network_fragments.hpp"

namespace grafverif {

/// True if each term of the expanded network has a value in every state: no divisor can be zero, and no integer exceeds
/// 64 bits.
bool terms_have_values(const Network& network);

/// A set of fragments such that each model error of the network is found in every abstraction that contains the
/// appropriate one of them: the error is a value that leaves its range, or a true `race`. Requires
/// terms_have_values(network).
std::set<std::uint32_t> cells_that_may_err(const Network& network, const NetworkFragments& cells);

}  // namespace grafverif
