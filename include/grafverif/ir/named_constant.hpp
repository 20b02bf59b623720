// SPDX-License-Identifier: MIT
// NamedConstant: a constant of a closed loop with its current value, for display. The terms of the closed loop contain
// the value of the constant, not its name.
#pragma once

#include <cstdint>
#include <string>

#include "grafverif/support/source.hpp"

namespace grafverif {

struct NamedConstant {
    enum class Kind { Boolean, Integer, Duration };
    std::string name = {};
    Kind kind = Kind::Integer;
    std::int64_t value = 0;  ///< Booleans 0 and 1, durations in milliseconds
    bool set = false;        ///< true if the user has overridden the value of the loop
    Span origin = {};
    bool operator==(const NamedConstant&) const = default;
};

}  // namespace grafverif
