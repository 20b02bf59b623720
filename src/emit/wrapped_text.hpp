// SPDX-License-Identifier: MIT
// Breaks the lines of generated models and programs.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string_view>
#include <vector>

namespace grafverif {

/// Returns `text` in lines of at most `width` columns, broken at spaces for which `breaks(text before the space)` is
/// true.
std::vector<std::string_view> wrapped(std::string_view text, std::size_t width, bool (*breaks)(std::string_view));

/// Prints `text`. Lines beyond 118 columns are broken between tokens, unless they begin with `comment`.
void print_wrapped(std::ostream& out, std::string_view text, std::string_view comment);

}  // namespace grafverif
