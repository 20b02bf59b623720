// SPDX-License-Identifier: MIT
// analyse: a Chart and its Equations -> an Analysis; a verb. It asks, of all sequences of inputs at once, what can happen
// in the chart and what never does (codes: ir/finding.hpp).
//
// All evolutions are computed exactly, as sets of points: a point is a situation with the stored variables that matter,
// the ends of timers and the inputs, about to make an evolution. An instant begins when inputs are sampled. Under
// stability search it is made of the evolutions, with inputs that stay, until one changes nothing (IEC 60848, 4.6: input
// events occur in stable situations only); in every_cycle mode it is one evolution. Where an instant does not end, the
// points it goes on through for ever are the total instability: evolutions are functions, so they are those that have
// endless histories.
//
// The chart is looked at part by part: each part depends on nothing outside of it (analyse/cones.hpp), so what never happens in
// it never happens; what comes about in it is shown by a run that the whole chart confirms. What the parts leave open is asked
// of the whole. Parts take turns, the work of a turn growing fourfold from round to round, so that none waits for another;
// counters are followed up to their thresholds only (analyse/counters.hpp). A question that is not decided when the time or
// the memory is used up is open, and the analysis tells how many instants were looked at for it.
//
// An evolution with a race, or with a value that does not exist or fit, has no successor (see run/interpreter.hpp);
// what would come after it is not looked at, and the notes of the analysis say so.
//
// Time: between instants a timer may end, if its step is active, and among timers on one step shorter ones end first.
// That is all that is known of time during the search; evidence is then given times by solving for the moments of its
// instants, and replayed on the rules with them.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/finding.hpp"

namespace grafverif {

/// How far an analysis is.
struct AnalyseProgress {
    std::size_t questions = 0, open = 0, findings = 0;
    std::size_t part = 0, parts = 0;  ///< which part of the chart is looked at, of how many
    std::size_t instant = 0;
};

struct AnalyseOptions {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::vector<Exclusion> exclusions = {};
    bool instability_only = false;  ///< ask for total instability and nothing else
    /// Counters that stay in their range for so many evolutions at least are followed up to their thresholds only.
    std::int64_t longest_count = 256;
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< bytes, for decision diagrams
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;                    ///< set by somebody else: end with what is known
    std::function<void(const Finding&)> found = {};             ///< called as soon as there is a finding
    std::function<void(const AnalyseProgress&)> progress = {};  ///< called now and then
    std::uint64_t first_slice =
        50'000'000;  ///< work on each part in the first round, in steps of operations on diagrams
};

/// Requires that `equations` are those that derive gives for `chart`.
Analysis analyse(const Chart& chart, const Equations& equations, const AnalyseOptions& options = {});

}  // namespace grafverif
