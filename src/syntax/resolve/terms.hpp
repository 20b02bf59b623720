// SPDX-License-Identifier: MIT
// Terms: translates expressions of the syntax tree to typed terms of an intermediate representation. Callbacks of the
// caller resolve names and may handle some operators. The typing rules are the same for charts, components and
// properties.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "grafverif/ir/expr.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

/// `Wrong` means that an error about the term or a subterm has been reported.
enum class TermKind { Wrong, Boolean, Integer, Duration, Clock };

struct Term {
    Id<Expr> expr = {};
    TermKind kind = TermKind::Wrong;
};

/// Returns a description such as `an integer` or `a condition`.
std::string_view described(TermKind kind);

class Terms {
public:
    Terms(const tree::File& file, Exprs& exprs, Diagnostics& diagnostics)
        : file_(&file), exprs_(&exprs), diagnostics_(&diagnostics) {}

    /// Resolves a Name or Member node.
    std::function<Term(const tree::Expr&)> name = {};
    /// Handles operators for which the caller has special rules. If the result is empty, the common rules apply.
    std::function<std::optional<Term>(const tree::Expr&)> special = {};
    bool edges_allowed = false;
    bool places_allowed = false;  ///< true if `Gate in open` is allowed; `name` resolves this test

    Term resolve(Id<tree::Expr> node);
    /// Resolves `node` to a term of type `kind`; invalid after an error. `user` describes the term in messages.
    Id<Expr> resolve(Id<tree::Expr> node, TermKind kind, std::string_view user);
    /// Returns the value of a term without variables; empty after an error.
    std::optional<std::int64_t> constant(Id<tree::Expr> node, TermKind kind, std::string_view user);

    const tree::Expr& node(Id<tree::Expr> id) const { return file_->exprs[id]; }
    Exprs& exprs() { return *exprs_; }
    Diagnostics& diagnostics() { return *diagnostics_; }

private:
    Term implication(const tree::Expr& node);
    Term place(const tree::Expr& node);
    Term junction(const tree::Expr& node);
    Term comparison(const tree::Expr& node);
    Term arithmetic(const tree::Expr& node);
    Term boolean_operand(const tree::Expr& node, Op op);
    Term mismatch(const tree::Expr& operand, TermKind found, std::string_view user, std::string_view expected);
    bool is(const tree::Expr& operand, const Term& term, TermKind kind, std::string_view user);

    const tree::File* file_;
    Exprs* exprs_;
    Diagnostics* diagnostics_;
};

/// A time condition written as divisions (IEC 60848): `t1/v/t2`, `t1/v`, `v/t2`.
struct WrittenTime {
    Id<tree::Expr> rise = {}, watched = {}, fall = {};  ///< `watched`: invalid if the division is not a time condition
};
WrittenTime written_time(const tree::File& file, const tree::Expr& node);
/// Returns the value of a duration in milliseconds; 0 if the duration is omitted. Reports a duration of zero.
std::int64_t milliseconds(const tree::File& file, Id<tree::Expr> duration, Diagnostics& diagnostics);

/// True for the member names by which IEC 61131-3 denotes the elapsed time and the activity of a step: `Fill.T`,
/// `Fill.X`.
inline bool is_step_member(std::string_view name) { return name == "T" || name == "t" || name == "X" || name == "x"; }

Op ir_op(tree::Op op);
/// Returns the spelling of an operator in the input language, such as `&&` or `rise`.
std::string_view spelling(tree::Op op);

}  // namespace grafverif
