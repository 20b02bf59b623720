// SPDX-License-Identifier: MIT
#include "syntax/resolve/terms.hpp"

#include <array>
#include <string>
#include <vector>

#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

std::string_view described(TermKind kind) {
    switch (kind) {
    case TermKind::Wrong: return "an error";
    case TermKind::Boolean: return "a condition";
    case TermKind::Integer: return "an integer";
    case TermKind::Duration: return "a duration";
    case TermKind::Clock: return "a clock";
    }
    unreachable();
}

Op ir_op(tree::Op op) {
    switch (op) {
    case tree::Op::False: return Op::False;
    case tree::Op::True: return Op::True;
    case tree::Op::Number: return Op::Integer;
    case tree::Op::Duration: return Op::Duration;
    case tree::Op::Name: return Op::Variable;
    case tree::Op::Member: return Op::Variable;
    case tree::Op::In: return Op::Variable;
    case tree::Op::All:
    case tree::Op::Any:
    case tree::Op::Each: break;  // already expanded
    case tree::Op::Not: return Op::Not;
    case tree::Op::Rise: return Op::Rise;
    case tree::Op::Fall: return Op::Fall;
    case tree::Op::Negate: return Op::Negate;
    case tree::Op::And: return Op::And;
    case tree::Op::Or: return Op::Or;
    case tree::Op::Implies: return Op::Or;  // Terms::implication negates the premise
    case tree::Op::Equal: return Op::Equal;
    case tree::Op::NotEqual: return Op::NotEqual;
    case tree::Op::Less: return Op::Less;
    case tree::Op::LessEqual: return Op::LessEqual;
    case tree::Op::Greater: return Op::Greater;
    case tree::Op::GreaterEqual: return Op::GreaterEqual;
    case tree::Op::Plus: return Op::Plus;
    case tree::Op::Minus: return Op::Minus;
    case tree::Op::Times: return Op::Times;
    case tree::Op::Divide: return Op::Divide;
    case tree::Op::Modulo: return Op::Modulo;
    }
    unreachable();
}

std::string_view spelling(tree::Op op) {
    switch (op) {
    case tree::Op::False: return "false";
    case tree::Op::True: return "true";
    case tree::Op::Number: return "a number";
    case tree::Op::Duration: return "a duration";
    case tree::Op::Name: return "a name";
    case tree::Op::Member: return ".";
    case tree::Op::In: return "in";
    case tree::Op::All: return "all";
    case tree::Op::Any: return "any";
    case tree::Op::Each: return "for";
    case tree::Op::Not: return "!";
    case tree::Op::Rise: return "rise";
    case tree::Op::Fall: return "fall";
    case tree::Op::Negate: return "-";
    case tree::Op::And: return "&&";
    case tree::Op::Or: return "||";
    case tree::Op::Implies: return "=>";
    case tree::Op::Equal: return "==";
    case tree::Op::NotEqual: return "!=";
    case tree::Op::Less: return "<";
    case tree::Op::LessEqual: return "<=";
    case tree::Op::Greater: return ">";
    case tree::Op::GreaterEqual: return ">=";
    case tree::Op::Plus: return "+";
    case tree::Op::Minus: return "-";
    case tree::Op::Times: return "*";
    case tree::Op::Divide: return "/";
    case tree::Op::Modulo: return "%";
    }
    unreachable();
}

namespace {

std::string quoted(tree::Op op) { return '`' + std::string(spelling(op)) + '`'; }

}  // namespace

WrittenTime written_time(const tree::File& file, const tree::Expr& node) {
    if (node.op != tree::Op::Divide) return {};
    const auto is_duration = [&file](Id<tree::Expr> id) { return file.exprs[id].op == tree::Op::Duration; };
    if (is_duration(node.last)) {
        const tree::Expr& left = file.exprs[node.first];
        if (left.op == tree::Op::Divide && !left.bracketed && is_duration(left.first))
            return {left.first, left.last, node.last};
        return {{}, node.first, node.last};
    }
    if (is_duration(node.first)) return {node.first, node.last, {}};
    return {};
}

std::int64_t milliseconds(const tree::File& file, Id<tree::Expr> duration, Diagnostics& diagnostics) {
    if (!duration.valid()) return 0;
    const tree::Expr& written = file.exprs[duration];
    if (written.value == 0) diagnostics.add(messages::zero_duration(written.where));
    return written.value;
}

Term Terms::resolve(Id<tree::Expr> id) {
    const tree::Expr& node = file_->exprs[id];
    if (special) {
        if (const auto taken = special(node)) return *taken;
    }
    switch (node.op) {
    case tree::Op::False: return {exprs_->constant(false), TermKind::Boolean};
    case tree::Op::True: return {exprs_->constant(true), TermKind::Boolean};
    case tree::Op::Number: return {exprs_->integer(node.value), TermKind::Integer};
    case tree::Op::Duration: return {exprs_->duration(node.value), TermKind::Duration};
    case tree::Op::Name:
    case tree::Op::Member: return name(node);
    case tree::Op::In: return place(node);
    case tree::Op::All:
    case tree::Op::Any:
    case tree::Op::Each: break;  // already expanded
    case tree::Op::Not: return boolean_operand(node, Op::Not);
    case tree::Op::Rise: return boolean_operand(node, Op::Rise);
    case tree::Op::Fall: return boolean_operand(node, Op::Fall);
    case tree::Op::And:
    case tree::Op::Or: return junction(node);
    case tree::Op::Implies: return implication(node);
    case tree::Op::Equal:
    case tree::Op::NotEqual:
    case tree::Op::Less:
    case tree::Op::LessEqual:
    case tree::Op::Greater:
    case tree::Op::GreaterEqual: return comparison(node);
    case tree::Op::Negate:
    case tree::Op::Plus:
    case tree::Op::Minus:
    case tree::Op::Times:
    case tree::Op::Divide:
    case tree::Op::Modulo: return arithmetic(node);
    }
    unreachable();
}

Id<Expr> Terms::resolve(Id<tree::Expr> id, TermKind kind, std::string_view user) {
    const Term term = resolve(id);
    const tree::Expr& written = node(id);
    if (kind == TermKind::Duration && term.kind == TermKind::Integer) {
        diagnostics_->add(messages::missing_unit(written.where, "this duration"));
        return {};
    }
    return is(written, term, kind, user) ? term.expr : Id<Expr>{};
}

std::optional<std::int64_t> Terms::constant(Id<tree::Expr> id, TermKind kind, std::string_view user) {
    const std::size_t errors = diagnostics_->errors();
    const Id<Expr> term = resolve(id, kind, user);
    if (!term.valid() || diagnostics_->errors() != errors) return {};
    if (!leaves(*exprs_, term).empty()) {
        diagnostics_->add(messages::not_constant(node(id).where, user));
        return {};
    }
    const auto value = evaluate(*exprs_, term, [](const Expr& leaf) { return leaf.value; });
    if (!value) diagnostics_->add(messages::number_too_large(node(id).where));
    return value;
}

Term Terms::mismatch(const tree::Expr& operand, TermKind found, std::string_view user, std::string_view expected) {
    if (found != TermKind::Wrong)
        diagnostics_->add(messages::type_mismatch(operand.where, user, expected, described(found)));
    return {};
}

/// True if the operand has the type `kind`. Otherwise, reports a type mismatch, unless an error has already been
/// reported for the operand.
bool Terms::is(const tree::Expr& operand, const Term& term, TermKind kind, std::string_view user) {
    if (term.kind == kind) return true;
    mismatch(operand, term.kind, user, described(kind));
    return false;
}

Term Terms::boolean_operand(const tree::Expr& written, Op op) {
    if (op != Op::Not && !edges_allowed) {
        diagnostics_->add(messages::edge_outside_chart(written.where));
        return {};
    }
    const Term operand = resolve(written.first);
    const tree::Expr& below = node(written.first);
    if (operand.kind == TermKind::Duration) {
        const std::string text = below.op == tree::Op::Duration ? duration_text(below.value) : "3s";
        diagnostics_->add(messages::duration_below(below.where, spelling(written.op), text));
        return {};
    }
    if (!is(below, operand, TermKind::Boolean, quoted(written.op))) return {};
    const std::array operands = {operand.expr};
    return {exprs_->apply(op, operands), TermKind::Boolean};
}

Term Terms::junction(const tree::Expr& written) {
    std::vector<Id<Expr>> operands;
    bool right = true;
    for (Id<tree::Expr> id = written.first; id.valid(); id = node(id).next) {
        const Term operand = resolve(id);
        if (is(node(id), operand, TermKind::Boolean, quoted(written.op))) operands.push_back(operand.expr);
        else right = false;
    }
    if (!right) return {};
    return {written.op == tree::Op::And ? exprs_->conjunction(operands) : exprs_->disjunction(operands),
            TermKind::Boolean};
}

/// Resolves a location test such as `Gate in open`, which is allowed only in properties.
Term Terms::place(const tree::Expr& written) {
    if (places_allowed) return name(written);
    diagnostics_->add(messages::place_outside_property(written.where));
    return {};
}

Term Terms::implication(const tree::Expr& written) {
    const Term left = resolve(written.first), right = resolve(written.last);
    const bool left_right = is(node(written.first), left, TermKind::Boolean, quoted(written.op));
    if (!is(node(written.last), right, TermKind::Boolean, quoted(written.op)) || !left_right) return {};
    return {exprs_->disjunction(exprs_->negation(left.expr), right.expr), TermKind::Boolean};
}

Term Terms::comparison(const tree::Expr& written) {
    const Term left = resolve(written.first), right = resolve(written.last);
    if (left.kind == TermKind::Wrong || right.kind == TermKind::Wrong) return {};
    if (left.kind == TermKind::Clock || right.kind == TermKind::Clock) {
        diagnostics_->add(messages::clock_not_conjunct(written.where));
        return {};
    }
    if (left.kind == TermKind::Duration || right.kind == TermKind::Duration) {
        diagnostics_->add(messages::type_mismatch(written.where, quoted(written.op), "integers or clocks",
                                                  "a comparison of durations"));
        return {};
    }
    const bool equality = written.op == tree::Op::Equal || written.op == tree::Op::NotEqual;
    if (!equality || left.kind == TermKind::Integer || right.kind == TermKind::Integer) {
        const bool both = is(node(written.first), left, TermKind::Integer, quoted(written.op)) &&
                          is(node(written.last), right, TermKind::Integer, quoted(written.op));
        if (!both) return {};
    }
    return {exprs_->apply(ir_op(written.op), left.expr, right.expr), TermKind::Boolean};
}

Term Terms::arithmetic(const tree::Expr& written) {
    if (written.op == tree::Op::Negate) {
        const Term operand = resolve(written.first);
        if (!is(node(written.first), operand, TermKind::Integer, "`-`")) return {};
        const std::array operands = {operand.expr};
        return {exprs_->apply(Op::Negate, operands), TermKind::Integer};
    }
    const Term left = resolve(written.first), right = resolve(written.last);
    if (left.kind == TermKind::Wrong || right.kind == TermKind::Wrong) return {};
    const bool some_duration = left.kind == TermKind::Duration || right.kind == TermKind::Duration;
    const bool sum = written.op == tree::Op::Plus && left.kind == right.kind;
    const bool multiple =
        written.op == tree::Op::Times && (left.kind == TermKind::Integer || right.kind == TermKind::Integer);
    if (some_duration && (sum || multiple))
        return {exprs_->apply(ir_op(written.op), left.expr, right.expr), TermKind::Duration};
    const bool both = is(node(written.first), left, TermKind::Integer, quoted(written.op)) &&
                      is(node(written.last), right, TermKind::Integer, quoted(written.op));
    if (!both) return {};
    const bool divides = written.op == tree::Op::Divide || written.op == tree::Op::Modulo;
    const Expr& divisor = (*exprs_)[right.expr];
    if (divides && divisor.op == Op::Integer && divisor.value == 0) {
        diagnostics_->add(messages::division_by_zero(node(written.last).where));
        return {};
    }
    return {exprs_->apply(ir_op(written.op), left.expr, right.expr), TermKind::Integer};
}

}  // namespace grafverif
