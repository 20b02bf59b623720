// SPDX-License-Identifier: MIT
// Explanations that a check adds to its results.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "check/shares.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/ir/report.hpp"
#include "grafverif/ir/verdict.hpp"
#include "ir/flat_system.hpp"
#include "pipeline/untimed.hpp"

namespace grafverif {

/// A violated property, and the run that shows it, which replays.
struct Violation {
    std::size_t answer = 0;  ///< in Report::answers
    Run run = {};
};

/// Decides the properties of these names of a network; the result may contain verdicts on others.
using PropertyChecker = std::function<std::vector<Verdict>(const Network& network, std::vector<std::string> names)>;

/// Adds explanations to `report`, which is about `network`. `search`: empty if another search would take long. Of
/// `limits` only the deadline and the stop flag apply, also below.
void explain(const Network& network, const std::vector<Violation>& violations, const PropertyChecker& search,
             const Limits& limits, Report& report);

/// Adds explanations to a result on an untimed model that `run` violates.
void explain(const SystemToCheck& check, const SystemRun& run, const Limits& limits, PropertyResult& answer);

/// End of a search that only explains, after one of `seconds`: after two seconds more than that, or at `deadline`.
Deadline explanation_deadline(const Deadline& deadline, double seconds);

/// Explains each unreachable step of `report`: the transitions to it that are never cleared, with the part of their
/// conditions that is never true. `search` proves each statement, or it is omitted.
void explain_dead_steps(const Network& network, const std::vector<const Chart*>& charts, const PropertyChecker& search,
                        Report& report);
/// The same for an untimed model, until `explanation_deadline`.
void explain_dead_steps(const SystemToCheck& check, const Limits& limits, Report& report);

/// Adds explanations to the result that `chart` does not become stable, if it has a trace.
void explain(const Chart& chart, ExecutionMode mode, const Limits& limits, PropertyResult& answer);

}  // namespace grafverif
