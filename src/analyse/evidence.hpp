// SPDX-License-Identifier: MIT
// Witness traces: converts a path to a run of the chart that the interpreter replays according to IEC 60848.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyse/search.hpp"
#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/finding.hpp"

namespace grafverif::analysis {

/// The required properties of the evolution at the end of a path.
struct EvolutionRequirement {
    std::vector<Id<Chart::Transition>> fired = {};
    Id<Chart::Variable> race = {};  ///< two actions must store different values in this variable
    bool fault = false;             ///< a value must be undefined or out of range
    bool endless = false;           ///< the instant must never end
    bool settles = false;           ///< the instant must end without being aborted
    bool ends = true;               ///< true if the instant is printed to its end, false if only to the end of the path
};

struct WitnessTrace {
    ChartRun trace = {};
    Finding::Timing timing = Finding::Timing::Untimed;
    std::vector<Id<Chart::StoredAction>> racing = {};  ///< the two actions of a race
    std::vector<std::vector<bool>> endless = {};       ///< the situations that repeat forever
    Span fault = {};                                   ///< position of a value that is undefined or out of range
    std::string failure = {};                          ///< reason why the interpreter does not confirm the run
};

WitnessTrace evidence(const Chart& chart, const Equations& equations, const Machine& machine, ExecutionMode mode,
                      const Path& path, const EvolutionRequirement& demand);

}  // namespace grafverif::analysis
