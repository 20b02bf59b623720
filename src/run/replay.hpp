// SPDX-License-Identifier: MIT
// Replay of a run according to IEC 60848: the interpreter repeats each action of each controller, evolution by
// evolution, on the chart itself. It uses the inputs and the values of time conditions that were sampled in the run. If
// a run fails the replay, it is not a run of the chart. This is an internal error between derive and the engine.
//
//   starts      the first evolution: situation and stored variables agree
//   samples     the age of the observed term agrees with its timer, if timers are exact
//   evolves     transitions cleared, situation, stored variables agree; stable and races, if the model includes them
//   writes      outputs agree; otherwise no output changes
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

struct Disagreement {
    std::size_t move = 0;    ///< index of the move in the projected run
    std::string where = {};  ///< position such as `controller press, evolution 12`
    std::string what = {};   ///< values in the run and according to the rules

    bool operator==(const Disagreement&) const = default;
};

/// Returns the first disagreement, if any. `charts` are those of the run's controllers, in order. Requires charts that
/// derive accepts.
std::optional<Disagreement> disagreement(const ChartRun& run, std::span<const Chart* const> charts);

/// Contradictory actions in one evolution.
struct ContradictoryActions {
    std::string controller = {};
    /// The variable to which two stored actions assign different values; empty if forcing orders contradict each other.
    std::string variable = {};
};
/// Returns the contradiction at the end of a run that ends in a race, or nothing if the rules find none.
std::optional<ContradictoryActions> clash(const ChartRun& run, std::span<const Chart* const> charts);

/// In an untimed run: two time conditions on one step. A cycle samples the longer one as true and the shorter one as
/// false. This run is not possible with any plant.
struct UntimelyConditions {
    StepName step = {};
    std::int64_t longer_ms = 0, shorter_ms = 0;
};
std::optional<UntimelyConditions> untimely(const ChartRun& run);

}  // namespace grafverif
