// SPDX-License-Identifier: MIT
// Witness traces: converts a path of the search to a run of the chart. The interpreter executes this run according to
// IEC 60848.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyse/search.hpp"
#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/finding.hpp"

namespace grafverif::analysis {

/// The properties that the evolution at the end of a path must have.
struct EvolutionRequirement {
    std::vector<Id<Chart::Transition>> fired = {};
    Id<Chart::Variable> race = {};  ///< two actions must store different values in this variable
    bool fault = false;             ///< true if a value must be undefined or out of range
    bool endless = false;           ///< true if the instant must never end
    bool settles = false;           ///< true if the instant must end without being aborted

    /// True if the trace contains the last instant up to its end, false if only up to the end of the path.
    bool ends = true;
};

struct WitnessTrace {
    ChartRun trace = {};
    Finding::Timing timing = Finding::Timing::Untimed;
    std::vector<Id<Chart::StoredAction>> racing = {};  ///< the two stored actions that race
    std::vector<std::vector<bool>> endless = {};       ///< the situations that repeat forever
    Span fault = {};                                   ///< position of a value that is undefined or out of range
    std::string failure = {};                          ///< reason why the interpreter does not confirm the run
};

WitnessTrace evidence(const Chart& chart, const Equations& equations, const Machine& machine, ExecutionMode mode,
                      const Path& path, const EvolutionRequirement& demand);

}  // namespace grafverif::analysis
