// SPDX-License-Identifier: MIT
// Returns the texts in the cells of the table of a run. All reports that show the table of a run use these functions.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

/// Entries of a row: time, event, inputs, cleared transitions, situation, outputs.
using Cells = std::array<std::string, 6>;
inline const Cells column_titles = {"time", "event", "inputs", "cleared", "situation", "outputs"};

/// Returns row `index`, compared with the previously shown row. If `complete` is true, situation and outputs are
/// included even if they have not changed.
Cells cells(const ChartRun& run, std::size_t index, bool complete);

/// Returns the cleared transitions, such as `T0; TW0`.
std::string cleared_text(const ChartRun& run, const ChartRun::Row& row);

/// Returns the event, such as `V_Act: going_out, V 0 -> 1`. The event of a controller also contains the stored values.
std::string happening(const ChartRun& run, std::size_t index);

/// Returns the active steps, such as `0` or `3 4`; `none` if no step is active.
std::string situation_text(const ChartRun& run, const ChartRun::State& state);

/// Returns the signals of the role that are not 0, such as `X`, `N = 3`; `none` if there are no such signals.
std::string standing_text(const ChartRun& run, ChartRun::Role role, const ChartRun::State& state);

/// Returns `text` as lines for `width` columns of a terminal, broken at blanks, or within a word that is longer than a
/// line. Each line has at least one character. `later_width` is the width of all lines except the first, if it differs.
std::vector<std::string> wrapped(std::string_view text, std::size_t width, std::optional<std::size_t> later_width = {});

}  // namespace grafverif
