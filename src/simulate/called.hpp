// SPDX-License-Identifier: MIT
// What a name means in a run, as a person writes it: what a trace, an automaton or a test prints, and what a property takes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

/// The steps that may be meant: by their whole name, else by what is left of it without the controller or the partial chart.
std::vector<Id<ChartRun::Step>> steps_called(const ChartRun& run, std::string_view name);
/// The same of a step variable: `X3`, `G1.X3`, `press.G1.X3`.
std::vector<Id<ChartRun::Step>> step_variables_called(const ChartRun& run, std::string_view name);

/// The signals that may be meant: `N`, `press.N`; of an instance's own `Gate.X`, or `Gate_X`, as models call it.
std::vector<Id<ChartRun::Signal>> signals_called(const ChartRun& run, std::string_view name);

/// `Gate.open`, the location of an instance; not valid: there is none of that name.
struct LocationOfRun {
    Id<ChartRun::Instance> instance = {};
    std::string location = {};
};
LocationOfRun location_called(const ChartRun& run, std::string_view name);

/// What a claim may name: signals, step variables.
std::vector<std::string> names_of(const ChartRun& run);
/// Whom somebody may make move.
std::vector<std::string> instances_of(const ChartRun& run);

/// As a condition writes it: `press.G1.X3`, and without the controller where there is one alone.
std::string variable_of(const ChartRun::Step& step);

/// Why a variable of that type cannot have the value; empty: it can.
std::string range_words(std::string_view name, const Type& type, std::int64_t value);

/// Several are called `name`; `all` are their whole names.
std::string ambiguous_words(std::string_view name, const std::vector<std::string>& all);
/// There is no `what` of that name; the one that may be meant is told.
std::string unknown_words(std::string_view what, std::string_view name, const std::vector<std::string>& known);

}  // namespace grafverif
