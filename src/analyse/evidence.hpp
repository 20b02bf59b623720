// SPDX-License-Identifier: MIT
// Witness traces: a path as a run of the chart, replayed by the interpreter according to IEC 60848.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyse/search.hpp"
#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/finding.hpp"

namespace grafverif::analysis {

/// Required properties of the evolution at the end of a path.
struct EvolutionRequirement {
    std::vector<Id<Chart::Transition>> fired = {};
    Id<Chart::Variable> race = {};  ///< two actions store different values in it
    bool fault = false;             ///< a value is undefined or out of range
    bool endless = false;           ///< the instant never ends
    bool settles = false;           ///< the instant ends, and nothing aborts it
    bool ends = true;               ///< print the instant to its end; otherwise to the end of the path
};

struct WitnessTrace {
    ChartRun trace = {};
    Finding::Timing timing = Finding::Timing::Untimed;
    std::vector<Id<Chart::StoredAction>> racing = {};  ///< the two actions of a race
    std::vector<std::vector<bool>> endless = {};       ///< the situations that repeat forever
    Span fault = {};                                   ///< location of a value that is undefined or out of range
    std::string failure = {};                          ///< the reason why the interpreter does not confirm it
};

WitnessTrace evidence(const Chart& chart, const Equations& equations, const Machine& machine, ExecutionMode mode,
                      const Path& path, const EvolutionRequirement& demand);

}  // namespace grafverif::analysis
