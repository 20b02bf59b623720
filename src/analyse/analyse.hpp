// SPDX-License-Identifier: MIT
// analyse: a Chart and its Equations -> an Analysis; a pass. It decides, for all input sequences at the same time, what
// can happen in the chart and what never does (codes: ir/finding.hpp).
//
// All evolutions are computed exactly, as sets of points. A point is a situation with the stored variables that matter,
// the timer outputs and the inputs, before an evolution. An instant begins when inputs are sampled. Under stability
// search it consists of the evolutions, with constant inputs, until one changes nothing (IEC 60848: input events
// occur in stable situations only); in every_cycle mode it is one evolution. If an instant does not end, the points
// that it repeats forever are the total instability. Since evolutions are functions, these are the points with infinite
// histories.
//
// The chart is analysed part by part. A part depends on nothing outside it (analyse/cones.hpp), so what never happens
// in the part never happens in the chart. What can happen in the part is confirmed by a run of the complete chart.
// Queries that the parts leave open are decided on the complete chart. Parts are searched in turns, whose work grows
// fourfold from round to round, so that no part delays another. Counters are followed up to their thresholds only
// (analyse/counters.hpp). A query that is undecided when the time or the memory is used up stays open, and the analysis
// reports how many instants were searched for it.
//
// An evolution with a race, or with a value that is undefined or out of range, has no successor (see
// run/interpreter.hpp); the notes of the analysis state that its continuation is not explored.
//
// Time: between instants a timer may expire if its step is active, and among timers on one step shorter ones expire
// first. The search uses no other knowledge of time. The runs that show a finding are then given times by solving for
// the event times of their instants, and replayed by the interpreter with these times.
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

/// Progress of an analysis.
struct AnalyseProgress {
    std::size_t questions = 0, open = 0, findings = 0;
    std::size_t part = 0, parts = 0;  ///< the current part of the chart, and the number of parts
    std::size_t instant = 0;
};

struct AnalyseOptions {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::vector<Exclusion> exclusions = {};
    bool instability_only = false;  ///< decide total instability only
    /// Counters that stay in their range for at least this number of evolutions are followed up to their thresholds
    /// only.
    std::int64_t longest_count = 256;
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< bytes, for decision diagrams
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;                    ///< cancellation flag: return the results so far
    std::function<void(const Finding&)> found = {};             ///< called for each finding as soon as it is known
    std::function<void(const AnalyseProgress&)> progress = {};  ///< called periodically
    std::uint64_t first_slice = 50'000'000;  ///< work on each part in the first round, in steps of BDD operations
};

/// Requires that `equations` are the result of derive for `chart`.
Analysis analyse(const Chart& chart, const Equations& equations, const AnalyseOptions& options = {});

}  // namespace grafverif
