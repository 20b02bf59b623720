// SPDX-License-Identifier: MIT
// analyse: determines the Analysis of a Chart and its Equations. The analysis considers all input sequences, and
// decides which events are possible in the chart and which are impossible (codes: ir/finding.hpp).
//
// All evolutions are computed exactly, as sets of points. A point is a situation with the relevant stored variables,
// the timer outputs and the inputs, before an evolution. An instant begins when inputs are sampled. Under stability
// search, an instant consists of the evolutions with constant inputs, until an evolution changes nothing (IEC 60848:
// input events occur only in stable situations). In every_cycle mode, an instant is one evolution. If an instant does
// not end (total instability), some of its points repeat forever. An evolution is a function of its point. Therefore an
// instant does not end if and only if its evolutions reach a cycle of points.
//
// The parts of the chart are analysed separately. A part is a cone of influence: a set of variables that does not
// depend on the other equations of the chart (analyse/cones.hpp). Therefore, an event that is impossible in a part is
// impossible in the chart. If an event is possible in a part, a run of the complete chart must confirm it. Queries that
// no part decides are decided on the complete chart. Parts are searched alternately, in rounds with four times the work
// of the previous round, so that no part delays another part. Values of counters are distinguished only up to the
// thresholds of the counters (analyse/counters.hpp). If the time or memory limit is reached, undecided queries remain
// open, and the analysis reports how many instants were searched for each of them.
//
// An evolution with a race, or with a value that is undefined or out of range, has no successor (see
// run/interpreter.hpp); the notes of the analysis state that the continuation is not explored.
//
// Time: between instants, the output of a timer may become true if the term that the timer watches is true, and false
// if the term is false. Among timers without fall times that watch the same term, timers with
// shorter times expire first; the search uses no other information about time. For each run that
// shows a finding, event times are then computed from constraints on the times of its instants. The
// interpreter replays the run with these times.
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

/// The progress of an analysis, for display.
struct AnalyseProgress {
    std::size_t questions = 0, open = 0, findings = 0;
    std::size_t part = 0, parts = 0;  ///< index of the part that is currently searched, and the number of parts
    std::size_t instant = 0;
};

struct AnalyseOptions {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::vector<Exclusion> exclusions = {};
    bool instability_only = false;  ///< true if only total instability is decided

    /// If a counter remains in its range for at least this number of evolutions, its values are distinguished only up
    /// to its thresholds.
    std::int64_t longest_count = 256;
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< memory limit of decision diagrams in bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;  ///< cancellation flag; if it is set, the available
                                              ///< results are returned
    /// Called for each finding as soon as the finding is known.
    std::function<void(const Finding&)> found = {};
    std::function<void(const AnalyseProgress&)> progress = {};  ///< called periodically

    /// Maximum work on each part of the chart in the first round: a number of operation steps (BddSpace::work).
    std::uint64_t first_slice = 50'000'000;
};

/// Sorts findings as in Analysis::findings.
void sort_findings(std::vector<Finding>& findings);

/// Analyses the chart. Requires that `equations` are the result of derive for `chart`.
Analysis analyse(const Chart& chart, const Equations& equations, const AnalyseOptions& options = {});

}  // namespace grafverif
