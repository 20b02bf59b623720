// SPDX-License-Identifier: MIT
// Resolves names in a run in the notations that users enter: those of traces, automata, tests and properties.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

/// Returns the candidate steps: those with this complete name, otherwise those with this name after the qualifier by
/// controller or partial chart.
std::vector<Id<ChartRun::Step>> steps_called(const ChartRun& run, std::string_view name);
/// Returns the candidate steps for a step variable: `X3`, `G1.X3`, `press.G1.X3`.
std::vector<Id<ChartRun::Step>> step_variables_called(const ChartRun& run, std::string_view name);

/// Returns the candidate signals: `N`, `press.N`; for an internal variable of an instance `Gate.X`, or `Gate_X` as in
/// models.
std::vector<Id<ChartRun::Signal>> signals_called(const ChartRun& run, std::string_view name);

/// A location of an instance, such as `Gate.open`; invalid if there is no location with this name.
struct LocationOfRun {
    Id<ChartRun::Instance> instance = {};
    std::string location = {};
};
LocationOfRun location_called(const ChartRun& run, std::string_view name);

/// Returns the names that are allowed in an expectation: signals and step variables.
std::vector<std::string> names_of(const ChartRun& run);
/// Returns the instances that commands can move.
std::vector<std::string> instances_of(const ChartRun& run);

/// Returns the name in conditions: `press.G1.X3`, without the controller if it is the only one.
std::string variable_of(const ChartRun::Step& step);

/// Returns the reason why a variable of this type cannot have the value, or an empty string if it can.
std::string range_text(std::string_view name, const Type& type, std::int64_t value);

/// Returns the message that several elements are called `name`. `all` contains their complete names.
std::string ambiguous_text(std::string_view name, const std::vector<std::string>& all);
/// Returns the message that there is no `what` with this name. It suggests the nearest known name.
std::string unknown_reason_text(std::string_view what, std::string_view name, const std::vector<std::string>& known);

}  // namespace grafverif
