// SPDX-License-Identifier: MIT
// Counters: integer variables that a chart only increments, sets to constants and compares with
// constants. The chart does not distinguish the values of a counter above the greatest constant of
// the counter; therefore the analysis represents all these values by one value. With this
// abstraction, the number of states of a chart that counts workpieces without limit depends only on
// its thresholds, not on the range of the counter. The abstraction does not represent the fault
// that a counter leaves its range.
#pragma once

#include <optional>
#include <vector>

#include "grafverif/ir/equations.hpp"

namespace grafverif::analysis {

struct Counter {
    Type type = {};         ///< range of distinguished values; the last value represents itself and all greater values
    std::int64_t most = 0;  ///< maximum increment in one evolution
    std::int64_t safe = 0;  ///< number of evolutions in which the counter cannot leave its range
};

/// Returns the Counter of each variable that is a counter, if the abstraction needs fewer bits than the variable;
/// otherwise the entry is empty.
std::vector<std::optional<Counter>> counters(const Equations& equations);

}  // namespace grafverif::analysis
