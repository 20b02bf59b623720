// SPDX-License-Identifier: MIT
// Counters: integers that are only incremented, set to constants and compared with constants. All values above the
// greatest of these constants behave identically, so the analysis represents them by one value: a chart that counts
// parts without end has no more situations than its thresholds distinguish. The abstraction omits that the counter
// leaves its range.
#pragma once

#include <optional>
#include <vector>

#include "grafverif/ir/equations.hpp"

namespace grafverif::analysis {

struct Counter {
    Type type = {};         ///< the values that are distinguished; the last represents itself and all greater ones
    std::int64_t most = 0;  ///< upper bound of the increment of one evolution
    std::int64_t safe = 0;  ///< number of evolutions in which it does not leave its range
};

/// Per variable: its counter, if the abstraction saves bits.
std::vector<std::optional<Counter>> counters(const Equations& equations);

}  // namespace grafverif::analysis
