// SPDX-License-Identifier: MIT
// Writes a report and its traces as text of at most 100 columns.
//
// A trace is a table with these columns: time; event; the inputs that changed (`V_IN`, `!V_IN`, `LEVEL = 3`; at
// power-on all nonzero inputs); the cleared transitions, with `;` between evolutions; situation; outputs. Situation and
// outputs are printed if they changed, and in the first and the last row. The time is printed only in rows in which it
// differs from the previous row. Rows that repeat forever are marked with a bar. Rows in which a cause of the violation
// begins are marked with a star. Below the table, the text lists the causes and the smallest change of the run that
// avoids the violation.
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
    bool verbose = false;  ///< also print witnesses of `reachable`, and the time of the check
    /// Print only unexpected violations and undecided properties. If there are neither unexpected violations nor
    /// undecided properties, print nothing.
    bool failures_only = false;
    Colour colour = Colour::Plain;
    std::size_t columns = 0;  ///< columns of the terminal, which limit the width of the final table; 0 means unlimited
};

/// Returns text about the end of a finite counterexample, such as `from here, no edge can be taken`. The text is empty
/// if the last state of the counterexample violates the property.
std::string_view end_of(const Verdict& verdict);

/// Prints the assumptions of the verdicts, violated and unknown properties with details, a table of all verdicts, and
/// the number of verdicts. The reached steps of `reachable all steps` share one row.
void print_report(const Report& report, const TextOptions& options, std::ostream& out);

/// Returns `word` in the colour of the result: green for Holds, red for Violated, otherwise yellow.
std::string coloured(std::string_view word, Outcome outcome, Colour colour);

/// The maximum width of a line of text, in columns.
inline constexpr std::size_t widest_line = 100;

/// Prints the complete table, with columns as wide as their content.
void print_trace(const ChartRun& run, std::ostream& out);

/// Widths of the columns time, event, inputs, cleared transitions, situation, outputs.
using TableWidths = std::array<std::size_t, 6>;
/// Widths for a table that is printed before all its rows are known.
inline constexpr TableWidths usual_widths = {8, 30, 16, 10, 12, 12};
void print_header(const TableWidths& widths, std::ostream& out);
/// Prints row `index` of the run. If `complete` is true, situation and outputs are printed even if they have not
/// changed.
void print_row(const ChartRun& run, std::size_t index, bool complete, const TableWidths& widths, std::ostream& out);

}  // namespace grafverif
