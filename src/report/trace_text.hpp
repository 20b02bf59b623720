// SPDX-License-Identifier: MIT
// Returns the texts of trace rows, which describe the effect of one event.
#pragma once

#include <string>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

/// Returns text such as `going_out, H 4 -> 6`: the location, if it changed, and changed plant variables. If `inputs` is
/// true, changed inputs of controllers are included.
std::string instance_text(const ChartRun& run, std::size_t moment, bool inputs = false);

/// Returns text such as `3s/X2 is true` or `a/2s is false` for an expired timer. `value` is the new output of the
/// timer.
std::string timer_text(const ChartRun::Timer& timer, bool value);

/// Returns the value of a signal: `X`, `!X` or `N = 3`.
std::string value_text(const ChartRun::Signal& signal, std::int64_t value);

/// Returns the change of a signal: `X`, `!X` or `N 3 -> 4`.
std::string change_text(const ChartRun::Signal& signal, std::int64_t before, std::int64_t after);

/// Returns a cause in the notation of terms: `X2`, `!a`, `N = 3`, `H_Act.going_out`, `!3s/X2`.
std::string cause_text(const ChartRun& run, const ChartRun::Cause& cause);

/// Returns all causes of a run in one line: `at 13 s: X2, !a; from 14 s on: !L`. If there are many causes, the text
/// contains the first causes and the number of omitted causes. If there are no causes, the text is empty.
std::string causes_text(const ChartRun& run);

/// Returns the smallest change of the run that avoids the violation: `without Start (START) at 1 s the property holds
/// along the run`. Returns an empty string if no such change was found.
std::string counterfactual_text(const ChartRun& run);
/// Returns the new value of a signal, such as `START`, `!a`, `N = 3`, or the expired timer, such as `3s/X2`.
std::string counterfactual_text(const ChartRun& run, const ChartRun::Counterfactual& left_out);

}  // namespace grafverif
