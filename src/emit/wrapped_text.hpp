// SPDX-License-Identifier: MIT
// Text of models and programs in lines of a readable length.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string_view>
#include <vector>

namespace grafverif {

/// `text` in lines of at most `width` columns, as far as it has blanks where `breaks(what stands before the blank)`.
std::vector<std::string_view> wrapped(std::string_view text, std::size_t width, bool (*breaks)(std::string_view));

/// `text` with each line beyond 118 columns broken between tokens, unless it begins with `comment`.
void print_wrapped(std::ostream& out, std::string_view text, std::string_view comment);

}  // namespace grafverif
