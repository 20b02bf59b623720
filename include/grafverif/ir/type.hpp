// SPDX-License-Identifier: MIT
// Type: range of a variable. Integers are bounded: engines pack them, UPPAAL and NuSMV require ranges.
#pragma once

#include <cstdint>

namespace grafverif {

struct Type {
    bool boolean = true;
    std::int64_t low = 0;   ///< least value; Booleans: 0
    std::int64_t high = 1;  ///< greatest value; Booleans: 1

    bool operator==(const Type&) const = default;
};

inline Type integer_type(std::int64_t low, std::int64_t high) { return {false, low, high}; }

/// Ranges must fit UPPAAL's default integers: [-32768, 32767].
inline constexpr std::int64_t least_integer = -32768;
inline constexpr std::int64_t greatest_integer = 32767;

}  // namespace grafverif
