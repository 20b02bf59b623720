// SPDX-License-Identifier: MIT
// format: prints a tree in the canonical layout, as `fmt` does.
//
// Layout: one declaration per line, blocks indented by four spaces, one spelling of each operator. Brackets appear only
// where precedence requires them, or where `&&` and `||` are mixed. Comments are kept: those on separate lines before
// the following element, end-of-line comments on their line, comments inside a declaration before it. Single blank
// lines are kept; top-level declarations are separated by blank lines. Idempotent: format(parse(format(t))) ==
// format(t).
#pragma once

#include <iosfwd>
#include <string>

#include "syntax/language/tree.hpp"

namespace grafverif {

/// Requires a file that is not `broken`.
void format(const tree::File& file, std::ostream& out);
std::string formatted(const tree::File& file);
/// An expression in the notation of `format`.
std::string formatted(const tree::File& file, Id<tree::Expr> expression);

}  // namespace grafverif
