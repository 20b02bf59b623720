// SPDX-License-Identifier: MIT
// Computes skeletons of names (UTS 39, section 4). Names that look the same have equal skeletons.
#pragma once

#include <string>
#include <string_view>

namespace grafverif {

bool all_ascii(std::string_view text);

/// Returns the skeleton of a name, computed with the tables of the library ICU. Requires UTF-8.
std::string skeleton(std::string_view name);

}  // namespace grafverif
