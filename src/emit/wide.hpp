// SPDX-License-Identifier: MIT
// Detects models that programs with 32-bit arithmetic (NuSMV 2.6, UPPAAL) would silently evaluate incorrectly.
#pragma once

#include <string_view>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "ir/flat_system.hpp"

namespace grafverif {

/// The reason for omitting a property.
inline constexpr const char* too_wide = "the property may need integers of more than 32 bits";

/// Returns, for each term of the model, true if the value of the term or of a subterm may exceed 32 bits. For a
/// network, only terms without parameters are included.
std::vector<bool> wide_terms(const Network& network);
std::vector<bool> wide_terms(const FlatSystem& flat);

/// True if 32 bits are sufficient for the behaviour of the model; properties are not checked. Otherwise, reports an
/// error (`beyond-32-bits`) for each position at which more than 32 bits may be necessary. Parameters of templates have
/// the values of their arguments.
bool fits(const Network& network, std::string_view target, Diagnostics& diagnostics);
bool fits(const TransitionSystem& system, std::string_view target, Diagnostics& diagnostics);

}  // namespace grafverif
