// SPDX-License-Identifier: MIT
// A report and its traces as text, at most 100 columns wide.
//
// A trace is a table: time; what happened; the inputs that changed (`V_IN`, `!V_IN`, `LEVEL = 3`; all that are not 0 at
// power-on); the transitions cleared, `;` between evolutions; the situation and the outputs where they changed, and
// in the first and the last row. Time is written where it goes on. Rows that repeat for ever have a bar before them.
#pragma once

#include <array>
#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>

#include "grafverif/ir/chart_run.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "report/report.hpp"

namespace grafverif {

struct TextOptions {
    bool verbose = false;  ///< witnesses of `reachable` too, and how long it took
    Colour colour = Colour::Plain;
};

/// What a verdict rests on: engine, mode, grain, time, states; of an untimed one what it says of the timed loop.
std::string basis_words(const Report& report, const Answer& answer);

/// What is wrong where a finite counterexample ends; empty: the state there says it.
std::string_view end_of(const Verdict& verdict);

void print_report(const Report& report, const TextOptions& options, std::ostream& out);

/// The whole table, its columns as wide as their content asks for.
void print_trace(const ChartRun& run, std::ostream& out);

/// Widths of time, what happened, inputs, cleared, situation, outputs.
using TableWidths = std::array<std::size_t, 6>;
/// For a table whose rows are not known yet.
inline constexpr TableWidths usual_widths = {8, 30, 16, 10, 12, 12};
void print_header(const TableWidths& widths, std::ostream& out);
/// Row `index` of the run. `complete`: situation and outputs even where they have not changed.
void print_row(const ChartRun& run, std::size_t index, bool complete, const TableWidths& widths, std::ostream& out);

}  // namespace grafverif
