// SPDX-License-Identifier: MIT
// Translates terms of the chart to terms over the variables of the equations, and computes the sizes of these terms.
#include <algorithm>

#include "derivation.hpp"
#include "ir/time_condition.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

constexpr std::uint64_t saturated = std::uint64_t{1} << 40U;

std::uint64_t sum(std::uint64_t left, std::uint64_t right) { return std::min(saturated, left + right); }

/// Returns the size that the term `root` of the chart has after its outputs are replaced by their equations. A subterm
/// that reads no output counts as one node.
std::uint64_t replaced_size(Derivation& derivation, Id<Expr> root,
                            std::unordered_map<std::uint32_t, std::uint64_t>& known) {
    const Chart& chart = derivation.chart;
    const Expr& node = chart.exprs[root];
    if (!derivation.reads_output[root.index]) return 1;
    if (node.op == Op::Variable)
        return derivation.measures.size(derivation.equations.exprs,
                                        derivation.values[static_cast<std::size_t>(node.value)]);
    if (node.op == Op::Timed)
        return sum(1, replaced_size(derivation, chart.time_conditions[{static_cast<std::uint32_t>(node.value)}].watched,
                                    known));
    if (const auto found = known.find(root.index); found != known.end()) return found->second;
    std::uint64_t size = 1;
    for (const Id<Expr> operand : derivation.chart.exprs.operands(root))
        size = sum(size, replaced_size(derivation, operand, known));
    known.emplace(root.index, size);
    return size;
}

Id<Expr> copied(Derivation& derivation, Id<Expr> root, TermPosition reading, Span where);

/// Returns `e and not P_e` for a rising edge and `P_e and not e` for a falling edge. A rising edge of a negated term is
/// a falling edge of the term.
Id<Expr> edge(Derivation& derivation, Id<Expr> now, bool rises, TermPosition reading, Span where) {
    Exprs& exprs = derivation.equations.exprs;
    if (exprs[now].op == Op::Not) {
        now = exprs.operands(now)[0];
        rises = !rises;
    }
    if (reading == TermPosition::First || is_constant(exprs[now].op)) return exprs.constant(false);
    const Id<Expr> before = previous_value(derivation, now, where);
    return rises ? exprs.conjunction(now, exprs.negation(before)) : exprs.conjunction(before, exprs.negation(now));
}

/// Returns the term for the time condition `t1/v/t2`, and creates its timer.
Id<Expr> timed(Derivation& derivation, Id<Chart::TimeCondition> id) {
    Exprs& exprs = derivation.equations.exprs;
    const Chart::TimeCondition& written = derivation.chart.time_conditions[id];
    const Id<Expr> watched = copied(derivation, written.watched, TermPosition::After, written.origin);
    const Id<Equations::Variable> variable = level(derivation, watched, written.origin);
    const Id<Equations::Timer> running = timer(derivation, variable, written.rise_ms, written.fall_ms, written.origin);
    derivation.equations.conditions[id.index] = running;
    return time_condition(exprs, written.rise_ms, watched, written.fall_ms, end_leaf(derivation, running));
}

/// Translates a term of the chart to a term over the equations, for one TermPosition.
Id<Expr> copied(Derivation& derivation, Id<Expr> root, TermPosition reading, Span where) {
    Exprs& exprs = derivation.equations.exprs;
    const auto leaf = [&](const Expr& node) {
        const auto index = static_cast<std::uint32_t>(node.value);
        if (node.op == Op::Step) return derivation.step_leaves[index];
        if (node.op == Op::Timed) return timed(derivation, {index});
        const Id<Expr> value = derivation.values[index];
        return value.valid() ? value : exprs.leaf(Op::Variable, index);
    };
    return TermCopier(derivation.chart.exprs, exprs, leaf,
                      [&](Op op, Id<Expr> now) { return edge(derivation, now, op == Op::Rise, reading, where); })(root);
}

}  // namespace

void Measures::extend(const Exprs& exprs) {
    for (auto index = static_cast<std::uint32_t>(sizes_.size()); index < exprs.size(); ++index) {
        std::uint64_t size = 1;
        std::uint32_t depth = 0;
        for (const Id<Expr> operand : exprs.operands(Id<Expr>{index})) {
            size = sum(size, sizes_[operand.index]);
            depth = std::max(depth, depths_[operand.index]);
        }
        sizes_.push_back(size);
        depths_.push_back(depth + 1);
    }
}

std::uint64_t Measures::size(const Exprs& exprs, Id<Expr> term) {
    extend(exprs);
    return sizes_[term.index];
}

std::uint32_t Measures::depth(const Exprs& exprs, Id<Expr> term) {
    extend(exprs);
    return depths_[term.index];
}

bool is_continuous(const Derivation& derivation, Id<Chart::Variable> variable) {
    return derivation.chart.variables[variable].kind == Chart::VariableKind::Output &&
           derivation.stored[variable.index].empty();
}

Id<Expr> variable_leaf(Derivation& derivation, Id<Equations::Variable> variable) {
    return derivation.equations.exprs.leaf(Op::Variable, variable.index);
}

Id<Expr> consistent(Exprs& exprs, Id<Expr> term) {
    if (exprs[term].op != Op::And) return term;
    std::unordered_set<std::uint32_t> denied;
    for (const Id<Expr> operand : exprs.operands(term))
        if (exprs[operand].op == Op::Not) denied.insert(exprs.operands(operand)[0].index);
    const bool contradicts =
        std::ranges::any_of(exprs.operands(term), [&](Id<Expr> operand) { return denied.contains(operand.index); });
    return contradicts ? exprs.constant(false) : term;
}

bool afford(Derivation& derivation, std::uint64_t size) {
    derivation.added = sum(derivation.added, size);
    if (derivation.added <= total_size_limit) return true;
    if (!derivation.exhausted)
        derivation.diagnostics.add(
            messages::terms_too_large(derivation.chart.origin, derivation.chart.name, total_size_limit));
    derivation.exhausted = true;
    return false;
}

Id<Expr> over_equations(Derivation& derivation, Id<Expr> root, TermPosition reading, Span where,
                        const std::string& what) {
    if (derivation.reads_output[root.index]) {
        std::unordered_map<std::uint32_t, std::uint64_t> known;
        const std::uint64_t size = replaced_size(derivation, root, known);
        if (size > term_size_limit) {
            derivation.diagnostics.add(messages::term_too_large(where, what, term_size_limit));
            return {};
        }
        if (!afford(derivation, size)) return {};
    }
    const Id<Expr> term = copied(derivation, root, reading, where);
    if (derivation.measures.depth(derivation.equations.exprs, term) <= term_depth_limit) return term;
    derivation.diagnostics.add(messages::term_too_deep(where, what, term_depth_limit));
    return {};
}

}  // namespace grafverif
