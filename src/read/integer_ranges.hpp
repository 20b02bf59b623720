// SPDX-License-Identifier: MIT
// Ranges of integers that an imported file does not specify. For a variable that is only compared with constants and
// assigned constants, these values suffice, and for an input also one value below and one above: the chart cannot
// distinguish others. Any other variable has the complete range of its type.
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
    std::int64_t least = 0, greatest = 0;  ///< range of its type
};

struct FoundRange {
    std::int64_t low = 0, high = 0;
    bool exact = false;  ///< other values are indistinguishable
};

/// The range of each of `integers`, in order.
std::vector<FoundRange> ranges_of(const tree::File& file, const tree::Chart& chart,
                                  const std::vector<OpenInteger>& integers);

}  // namespace grafverif
