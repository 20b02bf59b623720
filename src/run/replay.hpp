// SPDX-License-Identifier: MIT
// Replay of a run on the rules of IEC 60848: what each controller did, evolution by evolution, is done again by the
// interpreter on the chart itself, with the inputs and the values of time conditions sampled there. A run that does not
// replay was not one of the chart: a fault of ours, between derive and the engine.
//
//   starts      the first evolution: situation and stored variables agree
//   samples     the age of what a timer watches agrees with it, where timers are exact
//   evolves     transitions cleared, situation, stored variables agree; stable and races, where the model says so
//   writes      outputs agree; whoever does not write changes none
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
    std::size_t move = 0;    ///< index in the run that was projected
    std::string where = {};  ///< `controller press, evolution 12`
    std::string what = {};   ///< what the run has and what the rules give

    bool operator==(const Disagreement&) const = default;
};

/// The first disagreement, if any. `charts`: those of the run's controllers, in order. Requires charts that derive
/// accepts.
std::optional<Disagreement> disagreement(const ChartRun& run, std::span<const Chart* const> charts);

/// What cannot be done together in one evolution.
struct Clash {
    std::string controller = {};
    std::string variable =
        {};  ///< two stored actions give it different values; empty: forcing orders contradict each other
};
/// Of a run that ends in a race; nothing where by the rules none is.
std::optional<Clash> clash(const ChartRun& run, std::span<const Chart* const> charts);

/// Of an untimed run: two times over one step, of which a cycle samples the longer as over and the shorter as not. No
/// plant gives such a run.
struct Untimely {
    StepName step = {};
    std::int64_t longer_ms = 0, shorter_ms = 0;
};
std::optional<Untimely> untimely(const ChartRun& run);

}  // namespace grafverif
