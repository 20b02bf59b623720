// SPDX-License-Identifier: MIT
// Replay of a run according to IEC 60848: the interpreter repeats each evolution and each other action of each
// controller on the chart. The replay uses the inputs and the values of time conditions that were sampled in the run.
// If the replay reports a difference, the run is not a run of the chart. The cause is an internal error in derive, in
// the engine, or in a stage between them.
//
//   starts      the first evolution: situation and stored variables agree with the chart
//   samples     the age of the observed term agrees with its timer, if timers are exact
//   evolves     transitions cleared, situation, stored variables agree; stable and races, if the model includes them
//   writes      outputs agree; an act that does not write changes no output
//
// If the controller is a PLC program, the replay executes the program on its memory cells
// (run/program/controller_replay.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/chart_run.hpp"
#include "ir/program/program.hpp"

namespace grafverif {

struct Disagreement {
    std::size_t move = 0;    ///< index of the move in the original run
    std::string where = {};  ///< position such as `controller press, evolution 12`
    std::string what = {};   ///< values in the run and according to the rules

    bool operator==(const Disagreement&) const = default;
};

/// Returns the first disagreement between the run and the rules, or nothing if they agree. `charts` contains the charts
/// of the run's controllers, in order. Requires charts that `derive` accepts.
std::optional<Disagreement> disagreement(const ChartRun& run, std::span<const Chart* const> charts);

/// Contradictory actions in one evolution.
struct ContradictoryActions {
    std::string controller = {};
    /// The variable to which two stored actions assign different values; empty if forcing orders contradict each other.
    std::string variable = {};
    std::optional<ProgramFault> fault = {};  ///< the run-time fault, if the controller is a program
};
/// Returns the contradiction at the end of a run that ends in a race, or nothing if the rules yield no contradiction.
std::optional<ContradictoryActions> clash(const ChartRun& run, std::span<const Chart* const> charts);

/// Two time conditions on one step in an untimed run that no plant can produce: a cycle samples the condition with the
/// longer time as true and the condition with the shorter time as false.
struct UntimelyConditions {
    StepName step = {};
    std::int64_t longer_ms = 0, shorter_ms = 0;
};
std::optional<UntimelyConditions> untimely(const ChartRun& run);

}  // namespace grafverif
