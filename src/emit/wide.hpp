// SPDX-License-Identifier: MIT
// What programs that compute with 32 bits (NuSMV 2.6, UPPAAL) cannot be given: they find other values, and say nothing.
#pragma once

#include <string_view>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "ir/flat_system.hpp"

namespace grafverif {

/// Why a property is left out.
inline constexpr const char* too_wide = "it may need integers of more than 32 bits";

/// Per term of the table, whether something in it may need more than 32 bits. Of a network: terms without parameters.
std::vector<bool> wide_terms(const Network& network);
std::vector<bool> wide_terms(const FlatSystem& flat);

/// Whether 32 bits do for all that the model does, its properties apart; an error (`beyond-32-bits`) for each place where they may
/// not. Parameters of templates have the values of their arguments.
bool fits(const Network& network, std::string_view target, Diagnostics& diagnostics);
bool fits(const TransitionSystem& system, std::string_view target, Diagnostics& diagnostics);

}  // namespace grafverif
