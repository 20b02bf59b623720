// SPDX-License-Identifier: MIT
// The expressions of a tree as canonical text.
#pragma once

#include <string>

#include "syntax/language/tree.hpp"

namespace grafverif {

/// Brackets where the author put them and where the grammar asks for them.
std::string format_expr(const tree::File& file, Id<tree::Expr> expr);

}  // namespace grafverif
