// SPDX-License-Identifier: MIT
// Skeletons of names (UTS 39, section 4), which are equal for names that look the same.
#pragma once

#include <string>
#include <string_view>

namespace grafverif {

bool all_ascii(std::string_view text);

/// Returns the skeleton of a name. Requires UTF-8. The function uses the tables of ICU.
std::string skeleton(std::string_view name);

}  // namespace grafverif
