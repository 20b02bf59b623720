// SPDX-License-Identifier: MIT
// Types used by loop and chart simulations: inputs to set and possible delays.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "grafverif/ir/choice.hpp"

namespace grafverif {

/// An input, and the value to which a command sets it.
struct Setting {
    std::string name = {};
    std::int64_t value = 0;
    bool operator==(const Setting&) const = default;
};

/// Delays that are possible without a choice, in time units.
struct DelayBounds {
    std::int64_t unit_ms = 1;
    bool may_pass = false;
    /// Time until a choice is required; empty if time can pass forever without a choice.
    std::optional<std::int64_t> limit = {};
    /// Time until the next spontaneous or possible event; empty if there is no such event.
    std::optional<std::int64_t> change = {};
    bool operator==(const DelayBounds&) const = default;
};

}  // namespace grafverif
