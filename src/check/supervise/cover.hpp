// SPDX-License-Identifier: MIT
// Covers: computes short conditions over few variables that are true on one set of states and false on another set.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bdd/bdd.hpp"

namespace grafverif::supervise {

/// An irredundant sum of products, from which no product and no literal can be removed. If `negated` is true, the sum
/// of products represents the negation of the condition.
struct Cover {
    /// Products of the sum; without products, the sum is the constant false.
    std::vector<std::vector<BddLiteral>> products = {};
    bool negated = false;
};

/// Returns a condition that is true on `on` and false on `off`, which must be disjoint. Variables are removed greedily,
/// in the order of `variables`. The result represents the condition or its negation, whichever has the shorter sum of
/// products. The result is nullopt if both sums have more than `most` products.
std::optional<Cover> cover(const BddSpace& space, Bdd on, Bdd off, std::span<const std::uint32_t> variables,
                           std::size_t most);

}  // namespace grafverif::supervise
