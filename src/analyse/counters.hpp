// SPDX-License-Identifier: MIT
// Counters: integers that are only counted up, set to constants and compared with constants. All values above the
// greatest of those constants behave alike, so the analysis keeps one value for them: a chart that counts parts without
// end has no more situations than its thresholds tell apart. What is lost is where the counter leaves its range.
#pragma once

#include <optional>
#include <vector>

#include "grafverif/ir/equations.hpp"

namespace grafverif::analysis {

struct Counter {
    Type type = {};         ///< the values kept apart; the last stands for itself and all above
    std::int64_t most = 0;  ///< what one evolution adds at most
    std::int64_t safe = 0;  ///< in so many evolutions it does not leave its range
};

/// Per variable: the counter it is, where that saves bits.
std::vector<std::optional<Counter>> counters(const Equations& equations);

}  // namespace grafverif::analysis
