// SPDX-License-Identifier: MIT
// Text of models and programs in lines of a readable length.
#pragma once

#include <iosfwd>
#include <string_view>

namespace grafverif {

/// `text` with each line beyond 118 columns broken between tokens, unless it begins with `comment`.
void print_wrapped(std::ostream& out, std::string_view text, std::string_view comment);

}  // namespace grafverif
