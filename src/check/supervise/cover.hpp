// SPDX-License-Identifier: MIT
// Covers: short conditions over few variables that are true on one set of states and false on another.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bdd/bdd.hpp"

namespace grafverif::supervise {

/// An irredundant sum of products: no product and no literal can be removed. If `negated`, it covers the complement.
struct Cover {
    std::vector<std::vector<BddLiteral>> products = {};  ///< products; if empty, the sum is false
    bool negated = false;
};

/// Returns a condition that is true on `on` and false on `off`, which are disjoint. Variables are removed greedily, in
/// the order of `variables`. The result is the shorter one of the condition and its negation; it is empty if it has
/// more than `most` products.
std::optional<Cover> cover(const BddSpace& space, Bdd on, Bdd off, std::span<const std::uint32_t> variables,
                           std::size_t most);

}  // namespace grafverif::supervise
