// SPDX-License-Identifier: MIT
// The cells of a trace's table, shared by the writers that show steps to people.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "grafverif/ir/trace.hpp"

namespace grafverif {

/// Time, what happened, inputs, cleared, situation, outputs.
using Cells = std::array<std::string, 6>;
inline const Cells column_titles = {"time", "what happened", "inputs", "cleared", "situation", "outputs"};

/// Of step `index`, against the step shown before it. `complete`: situation and outputs even where they have not
/// changed.
Cells cells(const Trace& trace, std::size_t index, bool complete);

/// `T0; TW0`
std::string cleared_words(const Trace::Step& step);

/// `V_Act: going_out, V 0 -> 1`; of a controller also what it has stored.
std::string happening(const Trace& trace, std::size_t index);

/// `0`, `3 4`; no step is active: `none`.
std::string situation_words(const Trace& trace, const Trace::State& state);

/// The signals that are not 0: `X`, `N = 3`; none: `none`.
std::string standing_words(const std::vector<Trace::Signal>& signals, const std::vector<std::int64_t>& values);

}  // namespace grafverif
