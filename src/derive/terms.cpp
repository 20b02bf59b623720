// SPDX-License-Identifier: MIT
// Terms of the chart over the variables of the equations, and how large they get.
#include <algorithm>

#include "derivation.hpp"
#include "grafverif/support/messages.hpp"

namespace grafverif {

namespace {

constexpr std::uint64_t saturated = std::uint64_t{1} << 40U;

std::uint64_t sum(std::uint64_t left, std::uint64_t right) { return std::min(saturated, left + right); }

/// The size of the term `root` of the chart once its outputs are replaced by their equations.
std::uint64_t replaced_size(Derivation& derivation, Id<Expr> root,
                            std::unordered_map<std::uint32_t, std::uint64_t>& known) {
    const Expr& node = derivation.chart.exprs[root];
    if (!derivation.reads_output[root.index] || node.op == Op::Variable) {
        const bool replaced = derivation.reads_output[root.index];
        return replaced ? derivation.measures.size(derivation.equations.exprs,
                                                   derivation.values[static_cast<std::size_t>(node.value)])
                        : 1;
    }
    if (const auto found = known.find(root.index); found != known.end()) return found->second;
    std::uint64_t size = 1;
    for (const Id<Expr> operand : derivation.chart.exprs.operands(root))
        size = sum(size, replaced_size(derivation, operand, known));
    known.emplace(root.index, size);
    return size;
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
    const bool contradicts = std::ranges::any_of(
        exprs.operands(term), [&](Id<Expr> operand) { return denied.contains(operand.index); });
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

Id<Expr> over_equations(Derivation& derivation, Id<Expr> root, Span where, const std::string& what) {
    if (derivation.reads_output[root.index]) {
        std::unordered_map<std::uint32_t, std::uint64_t> known;
        const std::uint64_t size = replaced_size(derivation, root, known);
        if (size > term_size_limit) {
            derivation.diagnostics.add(messages::term_too_large(where, what, term_size_limit));
            return {};
        }
        if (!afford(derivation, size)) return {};
    }
    Exprs& exprs = derivation.equations.exprs;
    const Id<Expr> term = translate(derivation.chart.exprs, root, exprs, [&](const Expr& leaf) {
        const auto index = static_cast<std::uint32_t>(leaf.value);
        if (leaf.op == Op::Step) return derivation.step_leaves[index];
        if (leaf.op == Op::Timed) return variable_leaf(derivation, derivation.ends[index]);
        const Id<Expr> value = derivation.values[index];
        return value.valid() ? value : exprs.leaf(Op::Variable, index);
    });
    if (derivation.measures.depth(exprs, term) <= term_depth_limit) return term;
    derivation.diagnostics.add(messages::term_too_deep(where, what, term_depth_limit));
    return {};
}

}  // namespace grafverif
