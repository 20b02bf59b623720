// SPDX-License-Identifier: MIT
// Cases that occur in the scans of random charts, for tests that compare generated controllers with the interpreter.
#pragma once

#include "run/interpreter.hpp"
#include "support/play.hpp"

namespace grafverif {

/// Counts the cases in the random runs, so that a test fails if the generator no longer produces them.
struct Met {
    int refused = 0, transients = 0, endless = 0, races = 0, out_of_range = 0, outputs = 0, timed = 0;
};

/// Returns the value of FAULT in a generated controller after the cycle.
inline int fault_of(const Cycle& run) {
    if (run.race) return 2;
    if (run.fault) return run.fault->kind == RunFault::Kind::ForcedApart ? 4 : 3;
    return !run.endless.empty() || run.gave_up ? 1 : 0;
}

inline void meet(const Chart& chart, const State& before, const Cycle& run, Met& met) {
    if (run.race) ++met.races;
    if (run.fault) ++met.out_of_range;
    if (!run.endless.empty()) ++met.endless;
    if (run.fired.size() > 2) ++met.transients;
    if (run.state.outputs != before.outputs) ++met.outputs;
    for (const bool elapsed : time_conditions(chart, before)) met.timed += elapsed ? 1 : 0;
}

}  // namespace grafverif
