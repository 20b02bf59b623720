// SPDX-License-Identifier: MIT
// Resolves names in a run as users write them: in the notation of traces, automata, tests and properties.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

/// The candidate steps: those with this complete name, otherwise those with this name after the qualifier by controller
/// or partial chart.
std::vector<Id<ChartRun::Step>> steps_called(const ChartRun& run, std::string_view name);
/// The same for a step variable: `X3`, `G1.X3`, `press.G1.X3`.
std::vector<Id<ChartRun::Step>> step_variables_called(const ChartRun& run, std::string_view name);

/// The candidate signals: `N`, `press.N`; for an internal variable of an instance `Gate.X`, or `Gate_X` as in models.
std::vector<Id<ChartRun::Signal>> signals_called(const ChartRun& run, std::string_view name);

/// `Gate.open`, the location of an instance; invalid if there is none of that name.
struct LocationOfRun {
    Id<ChartRun::Instance> instance = {};
    std::string location = {};
};
LocationOfRun location_called(const ChartRun& run, std::string_view name);

/// Names allowed in an expectation: signals and step variables.
std::vector<std::string> names_of(const ChartRun& run);
/// Instances that commands can move.
std::vector<std::string> instances_of(const ChartRun& run);

/// Name in conditions: `press.G1.X3`, without the controller if it is the only one.
std::string variable_of(const ChartRun::Step& step);

/// Reason why a variable of this type cannot have the value; empty if it can.
std::string range_text(std::string_view name, const Type& type, std::int64_t value);

/// Message: several elements are called `name`; `all`: their complete names.
std::string ambiguous_text(std::string_view name, const std::vector<std::string>& all);
/// Message: there is no `what` of this name; suggests the nearest known one.
std::string unknown_reason_text(std::string_view what, std::string_view name, const std::vector<std::string>& known);

}  // namespace grafverif
