// SPDX-License-Identifier: MIT
// Random well-formed charts with all elements that derive supports, for randomized tests, and reduction of a failing
// chart to a small one that still fails.
//
// A chart has one to four partial charts of a few steps: plain ones, expansions and enclosed ones. They have rings with
// alternatives, parallel branches, sources and sinks, some under forcing orders. There are bool and small int
// variables, and continuous actions, including conditional, delayed and limited ones. Stored actions of each kind have
// arithmetic that sometimes leaves the range; conditions are over inputs, steps, internals, outputs, edges and time.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"

namespace grafverif {

using Random = std::mt19937_64;

/// A number from `low` to `high`, platform-independent.
std::int64_t random_number(Random& random, std::int64_t low, std::int64_t high);
/// True with a probability of `percent`.
bool chance(Random& random, int percent);

/// The terms in time conditions: any Boolean term with both edges, in delayed and limited actions too; or, as `t/X`,
/// the time for which a step has been active.
enum class TimedTerms { Any, Steps };

Chart random_chart(Random& random, TimedTerms timed = TimedTerms::Any);

/// The same chart without unused terms and time conditions, in order of first use: as if read from its text.
Chart tidied(const Chart& chart);

/// A smaller chart that still `fails`: removes steps, transitions and actions, and simplifies conditions, until no
/// reduction is possible. Keeps variables, so that inputs keep their meaning.
Chart shrunk(Chart chart, const std::function<bool(const Chart&)>& fails);

/// The chart as text, for the message of a failed test.
std::string chart_text(const Chart& chart);

}  // namespace grafverif
