// SPDX-License-Identifier: MIT
// Random well-formed charts of all that derive takes, for the laws, and the way back from a chart that breaks a law to
// a small one that breaks it too.
//
// A chart has one to four partial charts of a few steps, plain ones, expansions and enclosed ones, rings with
// alternatives, parallel branches, sources and sinks, some under forcing orders; bool and small int variables; continuous
// actions, conditional, delayed and limited ones among them; stored actions of all four kinds, whose arithmetic sometimes
// leaves the range; conditions over inputs, steps, internals, outputs, edges and time.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"

namespace grafverif {

using Random = std::mt19937_64;

/// A number from `low` to `high`, the same on every platform.
std::int64_t random_number(Random& random, std::int64_t low, std::int64_t high);
/// True `percent` times in a hundred.
bool chance(Random& random, int percent);

/// What time conditions watch: any Boolean term and both its edges, in delayed and limited actions too; or, as `t/X`,
/// the time for which a step has been active.
enum class TimedTerms { Any, Steps };

Chart random_chart(Random& random, TimedTerms timed = TimedTerms::Any);

/// The same chart without terms and time conditions that nothing uses, in order of first use: as if read from its text.
Chart tidied(const Chart& chart);

/// A chart with fewer elements that still `fails`: steps, transitions, actions are dropped and conditions simplified
/// until nothing more can go. Variables stay, so that inputs keep their meaning.
Chart shrunk(Chart chart, const std::function<bool(const Chart&)>& fails);

/// The chart in its own language, for the message of a failed law.
std::string chart_text(const Chart& chart);

}  // namespace grafverif
