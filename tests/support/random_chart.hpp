// SPDX-License-Identifier: MIT
// Generates random well-formed charts with all elements that derive supports, for randomized tests. Also reduces a
// chart for which a test fails to a small chart for which the test still fails.
//
// A chart has one to four partial charts of a few steps, which are plain charts, expansions or enclosed charts. The
// partial charts have rings with alternatives, parallel branches, sources and sinks, and some are subject to forcing
// orders. Variables are Booleans and small integers. Continuous actions may be conditional, delayed or limited. Stored
// actions of each kind use arithmetic that sometimes leaves the range. Conditions read inputs, steps, internal
// variables, outputs, edges and time.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"

namespace grafverif {

using Random = std::mt19937_64;

/// Returns a number from `low` to `high`, which is the same on all platforms.
std::int64_t random_number(Random& random, std::int64_t low, std::int64_t high);
/// Returns true with a probability of `percent`.
bool chance(Random& random, int percent);

/// The time conditions of a random chart. Any: `t1/v/t2` for any Boolean term v, and delayed and limited actions.
/// Steps: only `t/X`, which is true if step X has been active for the time t.
enum class TimedTerms { Any, Steps };

Chart random_chart(Random& random, TimedTerms timed = TimedTerms::Any);

/// Returns the same chart without unused terms and time conditions. The remaining terms and time conditions are in the
/// order of their first use, as if the chart was read from its text.
Chart tidied(const Chart& chart);

/// Returns a smaller chart for which `fails` is still true. The function removes steps, transitions and actions, and
/// simplifies conditions, until no reduction is possible. The function keeps variables, so that
/// inputs keep their meaning.
Chart shrunk(Chart chart, const std::function<bool(const Chart&)>& fails);

/// Returns the chart as text, for the message of a failed test.
std::string chart_text(const Chart& chart);

}  // namespace grafverif
