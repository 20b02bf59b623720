// SPDX-License-Identifier: MIT
// Type: the range of a variable. Integers are bounded because engines pack them, and UPPAAL and NuSMV require ranges.
#pragma once

#include <cstdint>

namespace grafverif {

struct Type {
    bool boolean = true;
    std::int64_t low = 0;   ///< minimum value; 0 for Booleans
    std::int64_t high = 1;  ///< maximum value; 1 for Booleans

    bool operator==(const Type&) const = default;
};

inline Type integer_type(std::int64_t low, std::int64_t high) { return {false, low, high}; }

/// Ranges must fit UPPAAL's default integers: [-32768, 32767].
inline constexpr std::int64_t least_integer = -32768;
inline constexpr std::int64_t greatest_integer = 32767;

}  // namespace grafverif
