// SPDX-License-Identifier: MIT
// The one printer of expressions, and the dialects it speaks. A dialect is a function from operator to spelling: its
// token and how tightly it binds. Adding an operator breaks each dialect at compile time, as it should.
//
// Brackets stand where precedence asks for them, and around an `and` below an `or`, which people misread. The grouping
// of arithmetic is kept as written: `a - (b - c)` and `a + (b + c)` keep their brackets, `(a - b) - c` loses them.
// Comparisons do not associate, so a comparison of comparisons is always bracketed.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "grafverif/ir/expr.hpp"

namespace grafverif {

/// How a dialect writes an operator. Leaves and numbers have no token; their precedence says whether they need brackets
/// below an operator (`3s/X2` does). A Conditional of precedence `atom_precedence` is always bracketed. What is enclosed,
/// from `open` to `close`, needs no brackets around it; `precedence` is then that of its inside.
struct Spelling {
    std::string_view token = {};
    int precedence = 0;
    std::string_view open = {}, close = {};
};

inline constexpr int atom_precedence = 10;

using Dialect = Spelling (*)(Op);

Spelling chart_spelling(Op op);            ///< our own language: `a && !b`
Spelling plain_spelling(Op op);            ///< equations to read: `a and not b`
Spelling latex_spelling(Op op);            ///< equations to print: `a \wedge \neg b`
Spelling uppaal_spelling(Op op);           ///< UPPAAL: `a && !b`, `c ? a : b`
Spelling nusmv_spelling(Op op);            ///< NuSMV: `a & !b`, `(c ? a : b)`
Spelling structured_text_spelling(Op op);  ///< IEC 61131-3: `a AND NOT b`, `SEL(c, b, a)`

/// Writes one leaf: Variable, Step, Timed, Parameter or At.
using LeafPrinter = std::function<void(std::ostream&, const Expr&)>;

/// Writes the term `root` in `dialect`. Recurses over the term, whose depth the reader bounds.
void print_expr(std::ostream& out, const Exprs& exprs, Id<Expr> root, Dialect dialect, const LeafPrinter& leaf);

/// The same as a string.
std::string expr_text(const Exprs& exprs, Id<Expr> root, Dialect dialect, const LeafPrinter& leaf);

/// A duration as it is written everywhere: `3s` for whole seconds, else `250ms`.
std::string duration_text(std::int64_t milliseconds);
/// The milliseconds of `3s`, `250 ms` or `2min`; empty where `text` is no positive duration, or one beyond all reason.
std::optional<std::int64_t> duration_ms(std::string_view text);

}  // namespace grafverif
