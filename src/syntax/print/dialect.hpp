// SPDX-License-Identifier: MIT
// Prints expressions in several languages (dialects). A dialect is a function that maps each operator to its spelling:
// a token and a precedence. A new operator causes a compile error in each dialect to which it is not added.
//
// The printer adds brackets if precedence requires them and, for readability, around an `and` that is an operand of an
// `or`. The grouping of arithmetic terms is kept: `a - (b - c)` and `a + (b + c)` keep their brackets, but `(a - b) -
// c` does not. Comparisons are not associative: a comparison that is an operand of a comparison always has brackets.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "grafverif/ir/expr.hpp"

namespace grafverif {

/// Spelling of an operator in a dialect. Leaves and numbers have no token. The precedence of a leaf
/// determines whether the leaf needs brackets as an operand; for example, `3s/X2` needs brackets. A
/// Conditional with the precedence `atom_precedence` always has brackets. If an operator encloses
/// its operand with `open` and `close`, the term needs no outer brackets; in this case,
/// `precedence` applies to the text between `open` and `close`.
struct Spelling {
    std::string_view token = {};
    int precedence = 0;
    std::string_view open = {}, close = {};
    /// For a Conditional that is printed as a call: the texts before the condition, before the value for false, and
    /// before the value for true.
    std::array<std::string_view, 3> arguments = {};
};

inline constexpr int atom_precedence = 10;

using Dialect = Spelling (*)(Op);

Spelling chart_spelling(Op op);            ///< input language: `a && !b`
Spelling plain_spelling(Op op);            ///< equations as plain text: `a and not b`
Spelling latex_spelling(Op op);            ///< LaTeX equations: `a \wedge \neg b`
Spelling uppaal_spelling(Op op);           ///< UPPAAL: `a && !b`, `c ? a : b`
Spelling nusmv_spelling(Op op);            ///< NuSMV: `a & !b`, `(c ? a : b)`
Spelling c_language_spelling(Op op);       ///< C99: `a && !b`, `(c ? a : b)`
Spelling structured_text_spelling(Op op);  ///< IEC 61131-3: `a AND NOT b`, `SEL(c, b, a)`
Spelling scl_spelling(Op op);              ///< Structured Text of Siemens: `SEL(G := c, IN0 := b, IN1 := a)`

/// A function that prints one leaf: a Variable, Step, Timed, Parameter or At.
using LeafPrinter = std::function<void(std::ostream&, const Expr&)>;

/// Prints the term `root` in `dialect`. The function is recursive; its stack is sufficient because the readers limit
/// the depth of terms.
void print_expr(std::ostream& out, const Exprs& exprs, Id<Expr> root, Dialect dialect, const LeafPrinter& leaf);

/// Returns the text that print_expr prints.
std::string expr_text(const Exprs& exprs, Id<Expr> root, Dialect dialect, const LeafPrinter& leaf);

/// Returns a duration in a uniform notation: `3s` for whole seconds, otherwise `250ms`.
std::string duration_text(std::int64_t milliseconds);
/// Converts a duration such as `3s`, `250 ms` or `2min` to milliseconds. The result is empty if `text` is not a
/// positive duration or exceeds the limit of durations.
std::optional<std::int64_t> duration_ms(std::string_view text);

}  // namespace grafverif
