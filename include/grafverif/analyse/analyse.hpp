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
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/finding.hpp"

namespace grafverif {

/// Two Boolean inputs that are never true together.
struct Exclusion {
    Id<Chart::Variable> first = {}, second = {};
    std::string reason = {};
    Span origin = {};

    bool operator==(const Exclusion&) const = default;
};

struct AnalyseOptions {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::vector<Exclusion> exclusions = {};
    std::uint64_t max_memory = std::uint64_t{2} << 30U;   ///< bytes, for decision diagrams
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;              ///< set by somebody else: end with what is known
};

/// Requires that `equations` are those that derive gives for `chart`.
Analysis analyse(const Chart& chart, const Equations& equations, const AnalyseOptions& options = {});

}  // namespace grafverif
