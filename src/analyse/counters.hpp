// SPDX-License-Identifier: MIT
// Counters: integers that are only incremented, set to constants and compared with constants. All values above the
// greatest of these constants behave identically, so that the analysis represents them by one value. A chart that
// counts parts without limit then has only as many situations as its thresholds distinguish. The abstraction ignores
// that the counter can leave its range.
#pragma once

#include <optional>
#include <vector>

#include "grafverif/ir/equations.hpp"

namespace grafverif::analysis {

struct Counter {
    Type type = {};         ///< range of distinguished values; the last value represents itself and all greater values
    std::int64_t most = 0;  ///< maximum increment in one evolution
    std::int64_t safe = 0;  ///< number of evolutions in which it cannot leave its range
};

/// Returns the counter of each variable if the abstraction saves bits.
std::vector<std::optional<Counter>> counters(const Equations& equations);

}  // namespace grafverif::analysis
