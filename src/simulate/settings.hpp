// SPDX-License-Identifier: MIT
// What simulations of loops and of charts have in common: what somebody may do next.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "grafverif/ir/choice.hpp"

namespace grafverif {

/// An input and the value it is to have.
struct Setting {
    std::string name = {};
    std::int64_t value = 0;
    bool operator==(const Setting&) const = default;
};

/// How time can pass while nobody chooses, in units.
struct Patience {
    std::int64_t unit_ms = 1;
    bool may_pass = false;
    std::optional<std::int64_t> limit = {};   ///< until something must be chosen; empty: for ever
    std::optional<std::int64_t> change = {};  ///< until something happens by itself or can be chosen; empty: never
    bool operator==(const Patience&) const = default;
};

}  // namespace grafverif
