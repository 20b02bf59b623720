// SPDX-License-Identifier: MIT
// Finds the elements of a run that a name denotes. Names can be written as in traces, automata, tests and properties.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

/// Returns the steps that a name may denote: the steps with this complete name or, if there are no such steps, the
/// steps with this name after a qualifier (controller or partial chart).
std::vector<Id<ChartRun::Step>> steps_called(const ChartRun& run, std::string_view name);
/// Returns the steps that a step variable may denote: `X3`, `G1.X3`, `press.G1.X3`.
std::vector<Id<ChartRun::Step>> step_variables_called(const ChartRun& run, std::string_view name);

/// Returns the signals that a name may denote, such as `N` or `press.N`. An internal variable X of the instance Gate
/// may be written as `Gate.X`, or as `Gate_X`, its name in generated models.
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

/// Returns the name of the step variable in conditions: `press.G1.X3`, without the controller if there is only one
/// controller.
std::string variable_of(const ChartRun::Step& step);

/// Returns the reason why a variable of this type cannot have the value, or an empty string if the value is possible.
std::string range_text(std::string_view name, const Type& type, std::int64_t value);

/// Returns the error message that `name` denotes several elements. `all` contains the complete names of the elements
/// that `name` denotes.
std::string ambiguous_text(std::string_view name, const std::vector<std::string>& all);

}  // namespace grafverif
