// SPDX-License-Identifier: MIT
#include "schedule/automaton_edges.hpp"

#include <algorithm>
#include <unordered_map>

#include "schedule/ranges.hpp"

namespace grafverif::schedule {

namespace {

using Place = Id<Network::Variable>;

class Walk {
public:
    Walk(const Slots& slots, const std::vector<Id<TransitionSystem::Symbol>>& symbols, const Draft& draft)
        : slots_(slots), symbols_(symbols), exprs_(draft.exprs), types_(draft.types()) {}

    EdgeTerms run(const Network::Edge& edge, const std::function<Id<Expr>(const EdgeValue&)>& name) {
        EdgeTerms result;
        result.fault = exprs_.constant(false);
        const Total guard = total(exprs_, term(edge.guard), types_);
        result.guard_fault = guard.undefined;
        result.guard = exprs_.conjunction(exprs_.negation(guard.undefined), guard.term);
        const std::vector<Network::Assignment> all = slots_.assignments(edge);
        for (std::size_t k = 0; k < all.size(); ++k) {
            const Place target = slots_.variable(slots_.network.exprs[all[k].target]);
            const Id<Expr> before = value_of(target);
            Id<Expr> value = guarded(result, target, term(all[k].value), before);
            const Network::Variable& of = slots_.network.variables[target];
            const bool cleared = of.scratch && of.role == Network::Role::FiringCondition;
            if (cleared || (is_large(value) && read_later(all, k, target))) value = name({target, value});
            now_[target.index] = value;
            if (std::ranges::find(order_, target) == order_.end()) order_.push_back(target);
        }
        for (const Place variable : order_)
            if (!slots_.network.variables[variable].scratch) result.values.push_back({variable, now_[variable.index]});
        return result;
    }

private:
    /// Returns the current value of a variable as a term. The result is invalid for a scratch variable that is not yet
    /// assigned, and for a variable of main that the automaton writes but does not read.
    Id<Expr> value_of(Place variable) {
        const auto found = now_.find(variable.index);
        if (found != now_.end()) return found->second;
        const Id<TransitionSystem::Symbol> symbol = symbols_[variable.index];
        return symbol.valid() ? exprs_.leaf(Op::Variable, symbol.index) : Id<Expr>{};
    }

    Id<Expr> term(Id<Expr> root) {
        return translate(slots_.network.exprs, root, exprs_, [&](const Expr& leaf) {
            if (leaf.op == Op::Integer) return exprs_.integer(leaf.value);
            const Place variable = slots_.variable(leaf);
            if (variable.valid()) return value_of(variable);
            return slots_.literal_of(leaf, exprs_);
        });
    }

    bool is_large(Id<Expr> value) const {
        const Op op = exprs_[value].op;
        return !is_leaf(op) && !is_constant(op);
    }

    bool read_later(const std::vector<Network::Assignment>& all, std::size_t from, Place variable) const {
        const Exprs& exprs = slots_.network.exprs;
        return std::any_of(all.begin() + static_cast<std::ptrdiff_t>(from) + 1, all.end(), [&](const auto& later) {
            return std::ranges::any_of(leaves(exprs, later.value),
                                       [&](Id<Expr> leaf) { return slots_.variable(exprs[leaf]) == variable; });
        });
    }

    /// True if the guard compares `value` with constants and can be true only if `value` is in `range`.
    bool kept_by_guard(Id<Expr> guard, Id<Expr> value, Type range) const {
        Interval bounds = interval(exprs_, value, types_);
        std::vector<Id<Expr>> conjuncts{guard};
        if (exprs_[guard].op == Op::And) conjuncts.assign(exprs_.operands(guard).begin(), exprs_.operands(guard).end());
        for (const Id<Expr> conjunct : conjuncts) {
            const Op op = exprs_[conjunct].op;
            if (op < Op::Equal || op > Op::GreaterEqual) continue;
            const auto sides = exprs_.operands(conjunct);
            if (sides[0] != value || exprs_[sides[1]].op != Op::Integer) continue;
            const std::int64_t bound = exprs_[sides[1]].value;
            if (op == Op::Less) bounds.high = std::min(bounds.high, bound - 1);
            if (op == Op::LessEqual || op == Op::Equal) bounds.high = std::min(bounds.high, bound);
            if (op == Op::Greater) bounds.low = std::max(bounds.low, bound + 1);
            if (op == Op::GreaterEqual || op == Op::Equal) bounds.low = std::max(bounds.low, bound);
        }
        return range.low <= bounds.low && bounds.high <= range.high;
    }

    /// Returns `value`, or `kept` if `value` is undefined or outside the range of `target`. The fault is recorded
    /// unless the guard excludes it. The returned term always tests the range, because a model checker also evaluates
    /// the term for values that do not occur in any run.
    Id<Expr> guarded(EdgeTerms& edge, Place target, Id<Expr> value, Id<Expr> kept) {
        const Type type = slots_.network.variables[target].type;
        const auto [safe, undefined] = total(exprs_, value, types_);
        const Id<Expr> outside = leaves_range(exprs_, safe, type, types_);
        const bool excluded = type.boolean || kept_by_guard(edge.guard, safe, type);
        edge.fault = exprs_.disjunction(edge.fault, undefined);
        if (!excluded) edge.fault = exprs_.disjunction(edge.fault, outside);
        const Id<Expr> invalid = exprs_.disjunction(undefined, outside);
        if (is_false(exprs_, invalid)) return safe;
        if (!kept.valid()) kept = literal(exprs_, type, type.low);
        return exprs_.conditional(invalid, kept, safe);
    }

    const Slots& slots_;
    const std::vector<Id<TransitionSystem::Symbol>>& symbols_;
    Exprs& exprs_;
    const TypeOf types_;
    std::unordered_map<std::uint32_t, Id<Expr>> now_ = {};
    std::vector<Place> order_ = {};
};

}  // namespace

EdgeTerms edge_terms(const Slots& slots, const Network::Edge& edge,
                     const std::vector<Id<TransitionSystem::Symbol>>& symbols, const Draft& draft,
                     const std::function<Id<Expr>(const EdgeValue&)>& name) {
    return Walk(slots, symbols, draft).run(edge, name);
}

namespace {

/// Returns the value of a variable after an edge, given its value before the edge, or nullopt if the new value is not
/// constant.
std::optional<std::int64_t> value_after(const Slots& slots, const Network::Edge& edge, Id<Network::Variable> variable,
                                        std::int64_t before) {
    const Exprs& exprs = slots.network.exprs;
    std::optional<std::int64_t> value = before;
    for (const auto& [target, term] : slots.assignments(edge)) {
        if (slots.variable(exprs[target]) != variable) continue;
        bool constant = true;
        for (const Id<Expr> leaf : leaves(exprs, term)) constant = constant && !slots.variable(exprs[leaf]).valid();
        if (!constant) return {};
        value = evaluate(exprs, term, [&](const Expr& leaf) { return slots.constant(leaf); });
        if (!value) return {};
    }
    return value;
}

}  // namespace

std::optional<std::vector<std::int64_t>> location_values(const Slots& slots, Id<Network::Variable> variable) {
    const std::int64_t initial = slots.network.variables[variable].initial;
    const Type type = slots.network.variables[variable].type;
    std::vector<std::optional<std::int64_t>> known(slots.automaton.locations.size());
    known[slots.process.initial.index] = initial;
    for (bool grew = true; grew;) {
        grew = false;
        for (const Network::Edge& edge : slots.automaton.edges) {
            if (!known[edge.from.index]) continue;
            const auto value = value_after(slots, edge, variable, *known[edge.from.index]);
            if (!value || *value < type.low || *value > type.high) return {};
            std::optional<std::int64_t>& there = known[edge.to.index];
            if (there && *there != *value) return {};
            grew = grew || !there;
            there = value;
        }
    }
    std::vector<std::int64_t> values;
    for (const std::optional<std::int64_t>& value : known) values.push_back(value.value_or(initial));
    return values;
}

}  // namespace grafverif::schedule
