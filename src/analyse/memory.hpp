// SPDX-License-Identifier: MIT
// What equations remember from one evolution to the next besides steps and stored variables, and their clocks.
#pragma once

#include <cstdint>
#include <vector>

#include "grafverif/ir/equations.hpp"

namespace grafverif::analysis {

/// A variable that holds the value of a term.
struct Remembered {
    Id<Equations::Variable> variable = {};
    Id<Expr> value = {};
    bool after = false;   ///< over the values after the evolution; else over those before it
};

inline std::vector<Remembered> remembered(const Equations& equations) {
    std::vector<Remembered> result;
    for (const Equations::Previous& previous : equations.previous)
        result.push_back({previous.variable, previous.value, false});
    for (const Equations::Watch& watch : equations.watches) result.push_back({watch.variable, watch.value, true});
    return result;
}

/// `rise/watched/fall`, in milliseconds: `end` is true from `rise` after `watched` rises until `fall` after it falls.
struct Clock {
    Id<Equations::Variable> watched = {}, end = {};
    std::int64_t rise = 0, fall = 0;
};

inline std::vector<Clock> clocks(const Equations& equations) {
    std::vector<Clock> result;
    for (const Equations::Timer& timer : equations.timers)
        result.push_back({timer.watched, timer.end, timer.rise_ms, timer.fall_ms});
    return result;
}

}  // namespace grafverif::analysis
