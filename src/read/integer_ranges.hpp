// SPDX-License-Identifier: MIT
// The ranges of integers that another format leaves open. A variable that is only compared with constants, and assigned
// constants only, needs no other values than these and, for an input, one below and one above: nothing in the chart can
// tell the difference. Any other variable takes all that the language has.
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
    std::int64_t least = 0, greatest = 0;  ///< of its type
};

struct FoundRange {
    std::int64_t low = 0, high = 0;
    bool exact = false;  ///< no other value makes a difference
};

/// The range of each of `integers`, in order.
std::vector<FoundRange> ranges_of(const tree::File& file, const tree::Chart& chart,
                                  const std::vector<OpenInteger>& integers);

}  // namespace grafverif
