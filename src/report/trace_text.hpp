// SPDX-License-Identifier: MIT
// Text of trace rows: the effect of one event.
#pragma once

#include <string>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

/// `going_out, H 4 -> 6`: the location, if it changed, and changed plant variables. `inputs`: also changed inputs of
/// controllers.
std::string instance_text(const ChartRun& run, std::size_t moment, bool inputs = false);

/// `3s/X2 is true`, `a/2s is false`: one of its delays has expired, and its output is `value` now.
std::string timer_text(const ChartRun::Timer& timer, bool value);

/// `X`, `!X`, `N = 3`.
std::string value_text(const ChartRun::Signal& signal, std::int64_t value);

/// `X`, `!X`, `N 3 -> 4`.
std::string change_text(const ChartRun::Signal& signal, std::int64_t before, std::int64_t after);

/// A cause as terms have it: `X2`, `!a`, `N = 3`, `H_Act.going_out`, `!3s/X2`.
std::string cause_text(const ChartRun& run, const ChartRun::Cause& cause);

/// All causes of a run in one line: `at 13 s: X2, !a; from 14 s on: !L`; beyond a limit they are counted. Empty: none.
std::string causes_text(const ChartRun& run);

/// The shortest change: `without Start (START) at 1 s the property holds along the run`. Empty: none.
std::string counterfactual_text(const ChartRun& run);
/// The new value of a signal, `START`, `!a`, `N = 3`, or the expired timer, `3s/X2`.
std::string counterfactual_text(const ChartRun& run, const ChartRun::Counterfactual& left_out);

}  // namespace grafverif
