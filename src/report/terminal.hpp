// SPDX-License-Identifier: MIT
// A report and its traces as text, at most 100 columns wide.
//
// A trace is a table: time; what happened; the inputs that changed (`V_IN`, `!V_IN`, `LEVEL = 3`; all that are not 0 at
// power-on); the transitions cleared, `;` between evolutions; the situation and the outputs where they changed, and
// in the first and the last row. Time is written where it goes on. Rows that repeat for ever have a bar before them, those
// with which a cause begins a star; the causes, and what could have been left out, stand below.
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
    bool failures_only = false;  ///< what is violated against expectation or undecided; nothing where there is no such
    Colour colour = Colour::Plain;
    std::size_t columns = 0;  ///< of the terminal, into which the closing table fits; 0: as wide as it gets
};

/// What is wrong where a finite counterexample ends; empty: the state there says it.
std::string_view end_of(const Verdict& verdict);

/// What the verdicts rest on, once; in full what is violated or unknown; a table of all verdicts, and their number. The
/// steps of `reachable all steps` that are reached are one line of it.
void print_report(const Report& report, const TextOptions& options, std::ostream& out);

/// Of a line of text, in columns.
inline constexpr std::size_t widest_line = 100;

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
