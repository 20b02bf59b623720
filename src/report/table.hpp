// SPDX-License-Identifier: MIT
// The cells of a run's table, shared by the writers that show rows to people.
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
inline const Cells column_titles = {"time", "what happened", "inputs", "cleared", "situation", "outputs"};

/// Of row `index`, against the row shown before it. `complete`: situation and outputs even where they have not
/// changed.
Cells cells(const ChartRun& run, std::size_t index, bool complete);

/// `T0; TW0`
std::string cleared_words(const ChartRun& run, const ChartRun::Row& row);

/// `V_Act: going_out, V 0 -> 1`; of a controller also what it has stored.
std::string happening(const ChartRun& run, std::size_t index);

/// `0`, `3 4`; no step is active: `none`.
std::string situation_words(const ChartRun& run, const ChartRun::State& state);

/// The signals of the role that are not 0: `X`, `N = 3`; none: `none`.
std::string standing_words(const ChartRun& run, ChartRun::Role role, const ChartRun::State& state);

/// The lines of `text` in `width` columns of a terminal, broken at blanks, or between any characters of a word that is too
/// long; a line has a character at least. `later_width`: of all lines but the first, if they have another one.
std::vector<std::string> wrapped(std::string_view text, std::size_t width, std::optional<std::size_t> later_width = {});

}  // namespace grafverif
