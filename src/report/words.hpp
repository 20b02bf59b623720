// SPDX-License-Identifier: MIT
// The words of a row: what one moment did.
#pragma once

#include <string>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

/// `going_out, H 4 -> 6`: the location reached, unless it is where the instance was, and what changed in the plant.
/// `inputs`: what changed among the inputs of controllers, too.
std::string instance_words(const ChartRun& run, std::size_t moment, bool inputs = false);

/// `3s/X2 is true`, `a/2s is false`: one of its delays is over, and its end is `value` now.
std::string timer_words(const ChartRun::Timer& timer, bool value);

/// `X`, `!X`, `N = 3`.
std::string value_words(const ChartRun::Signal& signal, std::int64_t value);

/// `X`, `!X`, `N 3 -> 4`.
std::string change_words(const ChartRun::Signal& signal, std::int64_t before, std::int64_t after);

/// What a cause is, as terms have it: `X2`, `!a`, `N = 3`, `H_Act.going_out`, `!3s/X2`.
std::string cause_words(const ChartRun& run, const ChartRun::Cause& cause);

/// All causes of a run in a line: `at 13 s: X2, !a; from 14 s on: !L`; what is beyond some is counted. Empty: there are none.
std::string causes_words(const ChartRun& run);

/// What could have been left out: `without Start (START) at 1 s the property holds along the run`. Empty: there is nothing.
std::string left_out_words(const ChartRun& run);
/// What a signal becomes, `START`, `!a`, `N = 3`, or the time that is over, `3s/X2`.
std::string left_out_words(const ChartRun& run, const ChartRun::LeftOut& left_out);

}  // namespace grafverif
