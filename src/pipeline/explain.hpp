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

/// A violated property and a counterexample, which has been replayed.
struct Violation {
    std::size_t answer = 0;  ///< index in Report::answers
    Run run = {};
};

/// A function that checks the properties of `network` with the given names. The result may also contain verdicts on
/// other properties.
using PropertyChecker = std::function<std::vector<Verdict>(const Network& network, std::vector<std::string> names)>;

/// Adds explanations to `report`, which concerns `network`. `search` is empty if another search would take a long time.
/// In all functions of this file, only the deadline and the stop flag of `limits` apply.
void explain(const Network& network, const std::vector<Violation>& violations, const PropertyChecker& search,
             const Limits& limits, Report& report);

/// Adds explanations to `answer`, the result for a property of an untimed model. `run` is the counterexample to this
/// property.
void explain(const SystemToCheck& check, const SystemRun& run, const Limits& limits, PropertyResult& answer);

/// Returns the deadline of a search for explanations, after a search that took `seconds`. The deadline is two seconds
/// plus `seconds` from now, but not after `deadline`.
Deadline explanation_deadline(const Deadline& deadline, double seconds);

/// Explains each unreachable step of `report`: lists the transitions to it that are never cleared, with a conjunct of
/// their conditions that is never true. A statement is included only if `search` proves it.
void explain_dead_steps(const Network& network, const std::vector<const Chart*>& charts, const PropertyChecker& search,
                        Report& report);
/// Explains each unreachable step of an untimed model: lists the transitions to it that are never cleared. Ends at
/// `explanation_deadline`.
void explain_dead_steps(const SystemToCheck& check, const Limits& limits, Report& report);

/// Explains the result `answer`, which states that `chart` does not become stable. If `answer` has a trace, adds the
/// explanations to the trace.
void explain(const Chart& chart, ExecutionMode mode, const Limits& limits, PropertyResult& answer);

}  // namespace grafverif
