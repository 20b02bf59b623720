// SPDX-License-Identifier: MIT
// What a check adds to what it found: why.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/report.hpp"
#include "grafverif/ir/verdict.hpp"
#include "ir/flat_system.hpp"
#include "pipeline/untimed.hpp"

namespace grafverif {

/// An answer `violated`, and the run that shows it, which replays.
struct Violation {
    std::size_t answer = 0;  ///< in Report::answers
    Run run = {};
};

/// Decides the properties of these names of a network; the verdicts of others may be among those it gives.
using Search = std::function<std::vector<Verdict>(const Network& network, std::vector<std::string> names)>;

/// Adds to the answers of `report`, which is about `network`. `search`: empty where another search would take long. Of `limits`
/// the deadline and the stop count; likewise below.
void explain(const Network& network, const std::vector<Violation>& violations, const Search& search,
             const Limits& limits, Report& report);

/// Adds to an answer on an untimed model, which `run` shows violated.
void explain(const SystemToCheck& check, const SystemRun& run, const Limits& limits, Answer& answer);

/// Adds to the answer that `chart` does not become stable, as the trace of the answer, if it has one, shows.
void explain(const Chart& chart, ExecutionMode mode, const Limits& limits, Answer& answer);

}  // namespace grafverif
