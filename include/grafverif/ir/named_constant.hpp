// SPDX-License-Identifier: MIT
// NamedConstant: a constant of a closed loop with the value in force. Terms hold the value itself; this is what verdicts
// and models are told with.
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
    bool set = false;        ///< from outside, whatever the loop says
    Span origin = {};
    bool operator==(const NamedConstant&) const = default;
};

}  // namespace grafverif
