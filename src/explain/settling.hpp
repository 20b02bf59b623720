// SPDX-License-Identifier: MIT
// Settling: what is told where a loop has not settled, or never will.
#pragma once

#include <string>

#include "grafverif/ir/chart_run.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// Whether `run`, which shows that `property` is violated, ends at power-on: no state of it is settled, and no time passes in
/// it. Of a property about single states that is judged in all of them; false of any other.
bool is_violated_at_power_on(const Network& network, const Property& property, const Run& run);

/// What is told of such a property; `at_stable` is the verdict on the same, judged in settled states only.
std::string power_on_words(const Verdict& at_stable);

/// Of a run that repeats for ever within one instant, while controllers alone move: whose situation never becomes stable,
/// and how it goes round. Empty: it is not such a run.
std::string unsettled_words(const ChartRun& run);

}  // namespace grafverif
