// SPDX-License-Identifier: MIT
// format: a tree in the canonical layout, which `fmt` prints and the documents show.
//
// One declaration a line, blocks indented by four blanks, operators in one spelling, brackets only where they are
// needed or tell a mixture of `&&` and `||` apart. Comments are kept: those of their own line before what follows them,
// those at the end of a line there, those inside a declaration before it. Single blank lines are kept; declarations of
// a file stand apart. format(parse(format(t))) == format(t).
#pragma once

#include <iosfwd>
#include <string>

#include "syntax/language/tree.hpp"

namespace grafverif {

/// Requires a file that is not broken.
void format(const tree::File& file, std::ostream& out);
std::string formatted(const tree::File& file);
/// An expression as `format` prints it.
std::string formatted(const tree::File& file, Id<tree::Expr> expression);

}  // namespace grafverif
