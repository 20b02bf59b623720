// SPDX-License-Identifier: MIT
// Replay of a run according to IEC 60848: the interpreter repeats each action of each controller, evolution by
// evolution, on the chart itself, with the inputs and the values of time conditions sampled in the run. If a run fails
// the replay, it is not a run of the chart: an internal error between derive and the engine.
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
    std::size_t move = 0;    ///< index in the projected run
    std::string where = {};  ///< `controller press, evolution 12`
    std::string what = {};   ///< values in the run and according to the rules

    bool operator==(const Disagreement&) const = default;
};

/// The first disagreement, if any. `charts`: those of the run's controllers, in order. Requires charts that derive
/// accepts.
std::optional<Disagreement> disagreement(const ChartRun& run, std::span<const Chart* const> charts);

/// Contradictory actions in one evolution.
struct ContradictoryActions {
    std::string controller = {};
    std::string variable = {};  ///< two stored actions give it different values; empty: contradictory forcing orders
};
/// The contradiction at the end of a run that ends in a race; empty if the rules find none.
std::optional<ContradictoryActions> clash(const ChartRun& run, std::span<const Chart* const> charts);

/// In an untimed run: two time conditions on one step, of which a cycle samples the longer as true and the shorter as
/// false. This run is not possible with any plant.
struct UntimelyConditions {
    StepName step = {};
    std::int64_t longer_ms = 0, shorter_ms = 0;
};
std::optional<UntimelyConditions> untimely(const ChartRun& run);

}  // namespace grafverif
