// SPDX-License-Identifier: MIT
// What renaming and substitution put in the places of variables, as the operations look it up: by level.
#pragma once

#include <utility>
#include <vector>

#include "bdd/kernel.hpp"

namespace grafverif {

/// Pairs of variables, by level where they were last used.
struct BddRenaming::Map {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs = {};
    bdd::Kernel* kernel = nullptr;       ///< for which the rest stands
    std::uint64_t version = 0;           ///< of its order
    std::uint32_t number = 0;            ///< its name in the cache
    std::vector<std::uint32_t> to = {};  ///< per level down to the last that is renamed, the new one
};

struct BddSubstitution::Map {
    std::vector<std::pair<std::uint32_t, Bdd>> values = {};
    bdd::Kernel* kernel = nullptr;
    std::uint64_t version = 0;
    std::uint32_t number = 0;
    std::vector<bdd::Edge> by = {};      ///< per level its function
};

}  // namespace grafverif
