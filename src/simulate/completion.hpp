// SPDX-License-Identifier: MIT
// Completes command lines in a simulation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "simulate/simulation.hpp"

namespace grafverif {

/// Returns the commands and names that are allowed as the last word of `line` and begin with this word, which may be
/// empty.
std::vector<std::string> completions(const Simulation& simulation, std::string_view line);

/// Returns the position at which the last word of `line` begins.
std::size_t last_word(std::string_view line);

}  // namespace grafverif
