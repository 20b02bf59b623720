// SPDX-License-Identifier: MIT
// Covers: a condition that is true here and false there, and anywhere else as is shortest, over few variables.
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

/// True on `on`, false on `off`, which exclude each other; over as few of `variables` as leaving out one after the other
/// finds, the first first. It is the shorter one of the condition and its negation. Empty: more than `most` products.
std::optional<Cover> cover(const BddSpace& space, Bdd on, Bdd off, std::span<const std::uint32_t> variables,
                           std::size_t most);

}  // namespace grafverif::supervise
