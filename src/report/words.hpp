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

}  // namespace grafverif
