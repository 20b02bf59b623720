// SPDX-License-Identifier: MIT
// Generates charts and closed loops of any size, as text.
#pragma once

#include <cstddef>
#include <string>

namespace grafverif::bench {

/// Returns a closed loop whose chart is one ring of `steps` steps with the same number of
/// transitions. The chart has 16 inputs, driven by free push buttons, and 16 outputs. Every tenth
/// transition has a time condition, and every tenth step increments a counter.
std::string ring(std::size_t steps);

/// Returns a chart of `count` independent assembly stations (DESDES06 Fig. 2).
std::string assembly_stations(std::size_t count);

/// Returns a supervisor with forcing orders for `count` cells. Each cell has nine steps, six inputs and five stored
/// actions. Six cells have 60 steps, 67 transitions, 7 partial charts, 7 forcing orders, 33 stored actions and 38
/// inputs.
std::string production_line(std::size_t count);

}  // namespace grafverif::bench
