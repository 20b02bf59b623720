// SPDX-License-Identifier: MIT
// Completion of command lines in a simulation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "simulate/simulation.hpp"

namespace grafverif {

/// Returns the commands and names that are allowed at this position and that begin with the last word of `line`, which
/// may be empty.
std::vector<std::string> completions(const Simulation& simulation, std::string_view line);

/// Returns the start of the last word of `line`.
std::size_t last_word(std::string_view line);

}  // namespace grafverif
