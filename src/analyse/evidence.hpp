// SPDX-License-Identifier: MIT
// Evidence: a path as a run in the words of the chart, made again on the rules of IEC 60848 by the interpreter.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analyse/search.hpp"
#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/finding.hpp"

namespace grafverif::analysis {

/// What the evolution at the end of a path must show.
struct Demand {
    std::vector<Id<Chart::Transition>> fired = {};
    Id<Chart::Variable> race = {};  ///< two actions store different values in it
    bool fault = false;             ///< a value does not exist or does not fit
    bool endless = false;           ///< the instant never ends
    bool settles = false;           ///< the instant ends, and nothing breaks it off
    bool ends = true;               ///< tell the instant to its end; else to the end of the path
};

struct Evidence {
    ChartRun trace = {};
    Finding::Timing timing = Finding::Timing::Untimed;
    std::vector<Id<Chart::StoredAction>> racing = {};  ///< the two actions of a race
    std::vector<std::vector<bool>> endless = {};       ///< the situations that follow each other for ever
    Span fault = {};                                   ///< where a value does not exist or fit
    std::string failure = {};                          ///< the rules do not confirm it: what they say
};

Evidence evidence(const Chart& chart, const Equations& equations, const Machine& machine, ExecutionMode mode,
                  const Path& path, const Demand& demand);

}  // namespace grafverif::analysis
