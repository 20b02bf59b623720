// SPDX-License-Identifier: MIT
// Covers: short conditions over few variables that are true on one set and false on another one.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "bdd/bdd.hpp"

namespace grafverif::supervise {

/// An irredundant sum of products: each product is needed, and each of its literals. `negated`: of the complement.
struct Cover {
    std::vector<std::vector<BddLiteral>> products = {};  ///< none: false
    bool negated = false;
};

/// True on `on` and false on `off`, which are disjoint. Removes variables greedily, in the order of `variables`.
/// Returns the shorter one of the condition and its negation; empty if it has more than `most` products.
std::optional<Cover> cover(const BddSpace& space, Bdd on, Bdd off, std::span<const std::uint32_t> variables,
                           std::size_t most);

}  // namespace grafverif::supervise
