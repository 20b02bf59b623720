// SPDX-License-Identifier: MIT
// Translates expressions of Structured Text to terms of a chart.
#include <algorithm>

#include "read/sfc/sfc.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

bool is_constant(const Draft& draft, Id<tree::Expr> term, bool value) {
    return draft[term].op == (value ? tree::Op::True : tree::Op::False);
}

/// True if two terms are syntactically equal. The parser limits the depth of expressions and therefore the recursion
/// depth.
bool same(const Draft& draft, Id<tree::Expr> one, Id<tree::Expr> other) {
    const tree::Expr &a = draft[one], &b = draft[other];
    if (a.op != b.op || a.word != b.word || a.value != b.value) return false;
    Id<tree::Expr> x = a.first, y = b.first;
    for (; x.valid() && y.valid(); x = draft[x].next, y = draft[y].next)
        if (!same(draft, x, y)) return false;
    return !x.valid() && !y.valid();
}

tree::Op op_of(st::Op op) {
    switch (op) {
    case st::Op::Less: return tree::Op::Less;
    case st::Op::LessEqual: return tree::Op::LessEqual;
    case st::Op::Greater: return tree::Op::Greater;
    case st::Op::GreaterEqual: return tree::Op::GreaterEqual;
    case st::Op::Equal: return tree::Op::Equal;
    case st::Op::NotEqual: return tree::Op::NotEqual;
    case st::Op::Plus: return tree::Op::Plus;
    case st::Op::Minus: return tree::Op::Minus;
    case st::Op::Times: return tree::Op::Times;
    case st::Op::Divide: return tree::Op::Divide;
    case st::Op::Modulo: return tree::Op::Modulo;
    case st::Op::And:
    case st::Op::AndThen: return tree::Op::And;
    case st::Op::Or:
    case st::Op::OrElse: return tree::Op::Or;
    default: return tree::Op::Not;
    }
}

SfcTerm refused(Sfc& sfc, Span where, std::string_view what,
                std::string_view hint = "write it with Boolean and integer variables") {
    sfc.draft.refuse(where, what, hint);
    return {};
}

/// Returns the value of a variable: its constant value, the term assigned earlier in the body, or the variable itself.
SfcTerm variable_term(Sfc& sfc, const SfcScope& scope, const std::string& path, Span where, SfcKind expected) {
    const SfcVariable& variable = variable_of(sfc, path, where, expected, false);
    if (variable.kind == SfcKind::Bad)
        return refused(sfc, where, "`" + path + "`, which is neither BOOL nor an integer nor TIME,");
    if (variable.constant || variable.kind == SfcKind::Time) {
        if (variable.kind == SfcKind::Time && !variable.constant)
            return refused(sfc, where, "the TIME variable `" + path + "` without a constant value",
                           "declare an initial value, and do not assign the variable");
        if (variable.kind == SfcKind::Boolean)
            return {sfc.draft.constant(variable.initial != 0, where), SfcKind::Boolean};
        if (variable.kind == SfcKind::Time) return {sfc.draft.duration(variable.initial, where), SfcKind::Time};
        return {sfc.draft.number(variable.initial, where), SfcKind::Integer};
    }
    const Id<tree::Expr> itself = sfc.draft.variable(variable.name, where);
    if (scope.reads != nullptr) scope.reads->insert(variable.name);
    if (scope.assigned == nullptr) return {itself, variable.kind};
    const auto assigned = scope.assigned->find(variable.name);
    if (assigned == scope.assigned->end()) return {itself, variable.kind};
    const SfcEffect& effect = assigned->second;
    if (variable.kind == SfcKind::Integer) return {sfc.draft.copy(effect.value), SfcKind::Integer};
    return {either(sfc.draft, sfc.draft.copy(effect.set), both(sfc.draft, sfc.draft.copy(effect.keep), itself)),
            SfcKind::Boolean};
}

/// Translates the activity of a step, such as `S1.X`. The result is empty for other expressions.
std::optional<SfcTerm> step_flag(Sfc& sfc, const st::Expr& node) {
    if (node.op != st::Op::Member) return {};
    const st::Expr& owner = sfc.file.exprs[node.first];
    if (owner.op != st::Op::Name || !sfc.steps.contains(owner.word)) return {};
    const std::string member = st::capitals(sfc.file.text(node.word));
    if (member == "X" || member == "_X")
        return SfcTerm{sfc.draft.variable('X' + sfc.steps.at(owner.word), node.where), SfcKind::Boolean};
    if (member == "T" || member == "_T")
        return refused(sfc, node.where, "the time of a step outside of a comparison", "compare it with a duration");
    return {};
}

/// Returns the step in an expression such as `S1.T` (time of the step S1). The result is invalid for other expressions.
Id<st::Word> timed_step(const Sfc& sfc, Id<st::Expr> expr) {
    const st::Expr& node = sfc.file.exprs[expr];
    if (node.op != st::Op::Member) return {};
    const st::Expr& owner = sfc.file.exprs[node.first];
    const std::string member = st::capitals(sfc.file.text(node.word));
    return owner.op == st::Op::Name && sfc.steps.contains(owner.word) && (member == "T" || member == "_T")
               ? owner.word
               : Id<st::Word>{};
}

/// Translates a comparison of a step time, for example `S1.T >= T#5s` to the time condition `5s/X1`. Only steps
/// upstream of the transition are allowed, because the condition is relevant only while they are active.
std::optional<SfcTerm> step_time(Sfc& sfc, const SfcScope& scope, const st::Expr& node) {
    const Id<st::Word> left = timed_step(sfc, node.first), right = timed_step(sfc, node.last);
    if (!left.valid() && !right.valid()) return {};
    const Id<st::Word> step = left.valid() ? left : right;
    const auto time = duration_of(sfc, scope, left.valid() ? node.last : node.first);
    if (!time) return SfcTerm{};
    if (std::ranges::find(scope.left, step, &st::Name::word) == scope.left.end())
        return refused(sfc, node.where, "the time of a step that this transition does not leave",
                       "use the time in a transition after the step");
    const bool from_below = left.valid() ? node.op == st::Op::Greater || node.op == st::Op::GreaterEqual
                                         : node.op == st::Op::Less || node.op == st::Op::LessEqual;
    const bool ordered = node.op != st::Op::Equal && node.op != st::Op::NotEqual;
    if (!ordered) return refused(sfc, node.where, "a step time compared with `=` or `<>`", "compare it with `>=`");
    const Id<tree::Expr> active = sfc.draft.variable('X' + sfc.steps.at(step), node.where);
    const Id<tree::Expr> elapsed =
        *time == 0 ? active
                   : sfc.draft.node(tree::Op::Divide, {sfc.draft.duration(*time, node.where), active}, node.where);
    return SfcTerm{from_below ? elapsed : opposite(sfc.draft, elapsed), SfcKind::Boolean};
}

/// Converts the integers 0 and 1 to FALSE and TRUE if a Boolean is required.
SfcTerm coerced(Sfc& sfc, SfcTerm term, SfcKind wanted) {
    if (term.kind != SfcKind::Integer || wanted != SfcKind::Boolean) return term;
    const tree::Expr& node = sfc.draft[term.expr];
    if (node.op != tree::Op::Number || node.value > 1) return term;
    return {sfc.draft.constant(node.value == 1, node.where), SfcKind::Boolean};
}

SfcTerm comparison(Sfc& sfc, const SfcScope& scope, const st::Expr& node) {
    if (auto time = step_time(sfc, scope, node)) return *time;
    const auto hint_of = [&](Id<st::Expr> other) {
        const st::Op op = sfc.file.exprs[other].op;
        return op == st::Op::True || op == st::Op::False || op == st::Op::Not || op == st::Op::And ||
                       op == st::Op::Or || op == st::Op::AndThen || op == st::Op::OrElse
                   ? SfcKind::Boolean
                   : SfcKind::Integer;
    };
    SfcTerm left = term_of(sfc, scope, node.first, hint_of(node.last));
    SfcTerm right = term_of(sfc, scope, node.last, left.kind == SfcKind::Bad ? SfcKind::Integer : left.kind);
    left = coerced(sfc, left, right.kind);
    right = coerced(sfc, right, left.kind);
    if (left.kind == SfcKind::Bad || right.kind == SfcKind::Bad) return {};
    if (left.kind == SfcKind::Time && right.kind == SfcKind::Time) {  // both operands are constant
        const std::int64_t one = sfc.draft[left.expr].value, other = sfc.draft[right.expr].value;
        const bool holds = node.op == st::Op::Less           ? one < other
                           : node.op == st::Op::LessEqual    ? one <= other
                           : node.op == st::Op::Greater      ? one > other
                           : node.op == st::Op::GreaterEqual ? one >= other
                           : node.op == st::Op::Equal        ? one == other
                                                             : one != other;
        return {sfc.draft.constant(holds, node.where), SfcKind::Boolean};
    }
    if (left.kind == SfcKind::Boolean && right.kind == SfcKind::Boolean &&
        (node.op == st::Op::Equal || node.op == st::Op::NotEqual)) {
        for (const auto& [one, other] : {std::pair(left.expr, right.expr), std::pair(right.expr, left.expr)})
            if (const bool value = is_constant(sfc.draft, one, true); value || is_constant(sfc.draft, one, false))
                return {value == (node.op == st::Op::Equal) ? other : opposite(sfc.draft, other), SfcKind::Boolean};
    }
    if (left.kind != right.kind) return refused(sfc, node.where, "a comparison of different types");
    return {sfc.draft.node(op_of(node.op), {left.expr, right.expr}, node.where), SfcKind::Boolean};
}

SfcTerm junction(Sfc& sfc, const SfcScope& scope, Id<st::Expr> id, const st::Expr& node) {
    std::vector<Id<tree::Expr>> terms;
    bool bad = false;
    for (const Id<st::Expr> operand : st::operands(sfc.file, id)) {
        terms.push_back(boolean_of(sfc, scope, operand));
        bad = bad || !terms.back().valid();
    }
    if (bad) return {};
    Id<tree::Expr> all = terms.front();
    if (node.op != st::Op::Xor) return {sfc.draft.node(op_of(node.op), terms, node.where), SfcKind::Boolean};
    for (std::size_t i = 1; i < terms.size(); ++i)
        all = sfc.draft.node(tree::Op::NotEqual, {all, terms[i]}, node.where);
    return {all, SfcKind::Boolean};
}

SfcTerm arithmetic(Sfc& sfc, const SfcScope& scope, Id<st::Expr> id, const st::Expr& node) {
    std::vector<SfcTerm> terms;
    for (const Id<st::Expr> operand : st::operands(sfc.file, id)) {
        terms.push_back(term_of(sfc, scope, operand, SfcKind::Integer));
        if (terms.back().kind == SfcKind::Bad) return {};
        if (terms.back().kind != SfcKind::Integer)
            return refused(sfc, node.where, "arithmetic with operands that are not integers");
    }
    Id<tree::Expr> all = terms.front().expr;
    if (node.op == st::Op::Negate) return {sfc.draft.node(tree::Op::Negate, {all}, node.where), SfcKind::Integer};
    for (std::size_t i = 1; i < terms.size(); ++i)
        all = sfc.draft.node(op_of(node.op), {all, terms[i].expr}, node.where);
    return {all, SfcKind::Integer};
}

}  // namespace

SfcTerm term_of(Sfc& sfc, const SfcScope& scope, Id<st::Expr> id, SfcKind expected) {
    const st::Expr node = sfc.file.exprs[id];
    switch (node.op) {
    case st::Op::True:
    case st::Op::False: return {sfc.draft.constant(node.op == st::Op::True, node.where), SfcKind::Boolean};
    case st::Op::Integer: return {sfc.draft.number(node.value, node.where), SfcKind::Integer};
    case st::Op::Time: return {sfc.draft.duration(node.value, node.where), SfcKind::Time};
    case st::Op::Other: return refused(sfc, node.where, "a literal of this type");
    case st::Op::Name:
    case st::Op::Address:
    case st::Op::Member:
        if (const auto flag = step_flag(sfc, node)) return *flag;
        if (const std::string path = path_of(sfc.file, id); !path.empty())
            return variable_term(sfc, scope, path, node.where, expected);
        return refused(sfc, node.where, "an array element or a dereferenced pointer");
    case st::Op::Index:
    case st::Op::Dereference: return refused(sfc, node.where, "an array element or a dereferenced pointer");
    case st::Op::Call:
    case st::Op::Argument:
    case st::Op::Result:
    case st::Op::Range: return refused(sfc, node.where, "a call of a function");
    case st::Op::Power: return refused(sfc, node.where, "a power");
    case st::Op::Not: {
        const Id<tree::Expr> inner = boolean_of(sfc, scope, node.first);
        return inner.valid() ? SfcTerm{sfc.draft.node(tree::Op::Not, {inner}, node.where), SfcKind::Boolean}
                             : SfcTerm{};
    }
    case st::Op::And:
    case st::Op::Or:
    case st::Op::AndThen:
    case st::Op::OrElse:
    case st::Op::Xor: return junction(sfc, scope, id, node);
    case st::Op::Less:
    case st::Op::LessEqual:
    case st::Op::Greater:
    case st::Op::GreaterEqual:
    case st::Op::Equal:
    case st::Op::NotEqual: return comparison(sfc, scope, node);
    case st::Op::Negate:
    case st::Op::Times:
    case st::Op::Divide:
    case st::Op::Modulo:
    case st::Op::Plus:
    case st::Op::Minus: return arithmetic(sfc, scope, id, node);
    }
    return {};
}

Id<tree::Expr> boolean_of(Sfc& sfc, const SfcScope& scope, Id<st::Expr> expr) {
    const SfcTerm term = coerced(sfc, term_of(sfc, scope, expr, SfcKind::Boolean), SfcKind::Boolean);
    if (term.kind == SfcKind::Boolean || term.kind == SfcKind::Bad)
        return term.kind == SfcKind::Bad ? Id<tree::Expr>{} : term.expr;
    refused(sfc, sfc.file.exprs[expr].where, "an integer or time instead of a condition", "compare it with a value");
    return {};
}

std::optional<std::int64_t> duration_of(Sfc& sfc, const SfcScope& scope, Id<st::Expr> expr) {
    const SfcTerm term = term_of(sfc, scope, expr, SfcKind::Time);
    if (term.kind == SfcKind::Time) return sfc.draft[term.expr].value;
    if (term.kind != SfcKind::Bad)
        refused(sfc, sfc.file.exprs[expr].where, "an invalid duration", "write a duration such as `T#5s`");
    return {};
}

Id<tree::Expr> both(Draft& draft, Id<tree::Expr> left, Id<tree::Expr> right) {
    if (!left.valid() || !right.valid()) return {};
    if (is_constant(draft, left, false) || is_constant(draft, right, true)) return left;
    if (is_constant(draft, right, false) || is_constant(draft, left, true)) return right;
    return draft.node(tree::Op::And, {left, right}, draft[left].where);
}

Id<tree::Expr> either(Draft& draft, Id<tree::Expr> left, Id<tree::Expr> right) {
    if (!left.valid() || !right.valid()) return {};
    if (is_constant(draft, left, true) || is_constant(draft, right, false)) return left;
    if (is_constant(draft, right, true) || is_constant(draft, left, false)) return right;
    const auto negates = [&](Id<tree::Expr> one, Id<tree::Expr> other) {
        return draft[one].op == tree::Op::Not && same(draft, draft[one].first, other);
    };
    if (negates(left, right) || negates(right, left)) return draft.constant(true, draft[left].where);
    return draft.node(tree::Op::Or, {left, right}, draft[left].where);
}

Id<tree::Expr> opposite(Draft& draft, Id<tree::Expr> term) {
    if (!term.valid()) return {};
    const tree::Expr node = draft[term];
    if (node.op == tree::Op::True || node.op == tree::Op::False)
        return draft.constant(node.op == tree::Op::False, node.where);
    if (node.op == tree::Op::Not) return node.first;
    return draft.node(tree::Op::Not, {term}, node.where);
}

}  // namespace grafverif
