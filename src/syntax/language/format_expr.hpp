// SPDX-License-Identifier: MIT
// Prints the expressions of a tree in canonical notation.
#pragma once

#include <string>

#include "syntax/language/tree.hpp"

namespace grafverif {

/// Returns the text of an expression. Brackets are printed if the source has them or the grammar requires them.
std::string format_expr(const tree::File& file, Id<tree::Expr> expr);

}  // namespace grafverif
