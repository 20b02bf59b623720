// SPDX-License-Identifier: MIT
// Covers: computes short conditions over few variables that are true on one set of states and false on another set.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bdd/bdd.hpp"

namespace grafverif::supervise {

/// A condition as an irredundant sum of products: no product and no literal of the sum can be removed. If `negated` is
/// true, the sum represents the negation of the condition.
struct Cover {
    /// Products of the sum; without products, the sum is the constant false.
    std::vector<std::vector<BddLiteral>> products = {};
    bool negated = false;
};

/// Returns a condition that is true on the set `on` and false on the set `off`. The two sets must be disjoint. The
/// function tries to eliminate each variable from the condition, in the order of `variables`. The result represents the
/// condition or its negation, whichever has the shorter sum of products. Returns nullopt if both sums have more than
/// `most` products.
std::optional<Cover> cover(const BddSpace& space, Bdd on, Bdd off, std::span<const std::uint32_t> variables,
                           std::size_t most);

}  // namespace grafverif::supervise
