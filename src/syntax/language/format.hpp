// SPDX-License-Identifier: MIT
// format: prints a syntax tree in the canonical layout (command `fmt`).
//
// Layout: one declaration per line, blocks indented by four spaces, one spelling of each operator. Durations keep the
// unit of the source. Brackets appear only where precedence requires them, or where `&&` and `||` are mixed. Comments
// are kept. A comment on a separate line stays before the following element, and an end-of-line comment stays on its
// line. If a step is printed on several lines, a comment after the step is placed after its first line. A comment
// inside a declaration is moved before the declaration. Single blank lines are kept; top-level declarations are
// separated by blank lines. The function is idempotent: format(parse(format(t))) == format(t).
#pragma once

#include <iosfwd>
#include <string>

#include "syntax/language/tree.hpp"

namespace grafverif {

/// Prints the file. Requires that the file and its declarations have no syntax error (`broken` is false).
void format(const tree::File& file, std::ostream& out);
std::string formatted(const tree::File& file);
/// Returns an expression in the notation of `format`.
std::string formatted(const tree::File& file, Id<tree::Expr> expression);
/// Returns a name with its indices, such as `slot[i][2]`.
std::string formatted(const tree::File& file, tree::Name name);
/// Returns the text of an index variable with its range, such as `i in 1..4`.
std::string formatted(const tree::File& file, const tree::Replication& replication);

}  // namespace grafverif
