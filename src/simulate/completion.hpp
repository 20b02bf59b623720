// SPDX-License-Identifier: MIT
// What may be typed next in a simulation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "simulate/simulation.hpp"

namespace grafverif {

/// The words that the last word of `line`, which may be empty, is the beginning of: commands and names that make sense there.
std::vector<std::string> completions(const Simulation& simulation, std::string_view line);

/// Where the last word of `line` begins.
std::size_t last_word(std::string_view line);

}  // namespace grafverif
