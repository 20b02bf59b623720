// SPDX-License-Identifier: MIT
// Determines the ranges of integers for which an imported file does not specify a range. If a chart only compares a
// variable with constants and assigns only constants to it, the values of these constants are sufficient. The range of
// an input additionally has one smaller and one larger value, because the chart cannot distinguish further values. Any
// other variable has the complete range of its type.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "syntax/language/tree.hpp"

namespace grafverif {

struct OpenInteger {
    Id<tree::Word> variable = {};
    bool input = false;
    std::int64_t initial = 0;
    std::int64_t least = 0, greatest = 0;  ///< limits of the variable's type
};

struct FoundRange {
    std::int64_t low = 0, high = 0;
    bool exact = false;  ///< true if a larger range would not change the behaviour
};

/// Returns the range of each of `integers`, in order.
std::vector<FoundRange> ranges_of(const tree::File& file, const tree::Chart& chart,
                                  const std::vector<OpenInteger>& integers);

}  // namespace grafverif
