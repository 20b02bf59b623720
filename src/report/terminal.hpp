// SPDX-License-Identifier: MIT
// A report and its traces as text, at most 100 columns wide.
//
// A trace is a table: time; event; the inputs that changed (`V_IN`, `!V_IN`, `LEVEL = 3`; all nonzero inputs at
// power-on); the transitions cleared, with `;` between evolutions; the situation and the outputs if they changed, and
// in the first and the last row. Time is printed when it advances. Rows that repeat forever are marked with a bar, rows
// in which a cause begins with a star. The causes, and the shortest change, are printed below.
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
    bool verbose = false;        ///< witnesses of `reachable` too, and how long it took
    bool failures_only = false;  ///< unexpected violations and undecided properties; nothing if there are none
    Colour colour = Colour::Plain;
    std::size_t columns = 0;  ///< of the terminal, which limits the closing table; 0: unlimited
};

/// The error at the end of a finite counterexample; empty if its last state shows it.
std::string_view end_of(const Verdict& verdict);

/// The assumptions of the verdicts, once; violated and unknown properties with details; a table of all verdicts, and
/// their number. The reached steps of `reachable all steps` share one row.
void print_report(const Report& report, const TextOptions& options, std::ostream& out);

/// The maximum width of a line of text, in columns.
inline constexpr std::size_t widest_line = 100;

/// The complete table, with columns as wide as their content.
void print_trace(const ChartRun& run, std::ostream& out);

/// Widths of time, what happened, inputs, cleared, situation, outputs.
using TableWidths = std::array<std::size_t, 6>;
/// For a table whose rows are not known yet.
inline constexpr TableWidths usual_widths = {8, 30, 16, 10, 12, 12};
void print_header(const TableWidths& widths, std::ostream& out);
/// Row `index` of the run. `complete`: situation and outputs even where they have not changed.
void print_row(const ChartRun& run, std::size_t index, bool complete, const TableWidths& widths, std::ostream& out);

}  // namespace grafverif
