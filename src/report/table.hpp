// SPDX-License-Identifier: MIT
// The entries of a run's table, shared by the writers that display rows.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

/// Time, what happened, inputs, cleared, situation, outputs.
using Cells = std::array<std::string, 6>;
inline const Cells column_titles = {"time", "event", "inputs", "cleared", "situation", "outputs"};

/// Row `index`, compared with the row shown before it. `complete`: situation and outputs even if they have not changed.
Cells cells(const ChartRun& run, std::size_t index, bool complete);

/// `T0; TW0`
std::string cleared_text(const ChartRun& run, const ChartRun::Row& row);

/// `V_Act: going_out, V 0 -> 1`; for a controller also the stored values.
std::string happening(const ChartRun& run, std::size_t index);

/// `0`, `3 4`; if no step is active: `none`.
std::string situation_text(const ChartRun& run, const ChartRun::State& state);

/// The signals of the role that are not 0: `X`, `N = 3`; if there are none: `none`.
std::string standing_text(const ChartRun& run, ChartRun::Role role, const ChartRun::State& state);

/// The lines of `text` in `width` columns of a terminal, broken at blanks, or within a word that is too long; each line
/// has at least one character. `later_width`: the width of all lines but the first, if it differs.
std::vector<std::string> wrapped(std::string_view text, std::size_t width, std::optional<std::size_t> later_width = {});

}  // namespace grafverif
