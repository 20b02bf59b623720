// SPDX-License-Identifier: MIT
// Removes elements of charts (see ablation.hpp).
#include <algorithm>
#include <span>
#include <vector>

#include "explain/ablation.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

namespace {

/// Returns the elements of `table` that do not belong to `step`.
template <class Entity>
Table<Entity> without(const Table<Entity>& table, Id<Chart::Step> step) {
    Table<Entity> rest;
    for (const Entity& entity : table)
        if (entity.step != step) rest.add(entity);
    return rest;
}

bool has_edge(const Exprs& exprs, Id<Expr> term) {
    const Op op = exprs[term].op;
    return op == Op::Rise || op == Op::Fall ||
           std::ranges::any_of(exprs.operands(term), [&](Id<Expr> operand) { return has_edge(exprs, operand); });
}

bool is_list(Op op) { return op == Op::And || op == Op::Or; }

/// Returns the complete condition that contains the term at `place`.
template <class ChartOrConst>
auto& condition_of(ChartOrConst& chart, const TermPlace& place) {
    switch (place.of) {
    case TermPlace::Of::Transition: return chart.transitions[{place.index}].condition;
    case TermPlace::Of::Action: return chart.continuous[{place.index}].condition;
    case TermPlace::Of::Event: return chart.stored[{place.index}].event;
    }
    unreachable();
}

/// Adds the places of the operands of all conjunctions and disjunctions in `term`, including the operands of `term`
/// itself if it is a conjunction or disjunction. `place` is the place of `term`.
void collect_operands(const Exprs& exprs, Id<Expr> term, const TermPlace& place, std::vector<TermPlace>& found) {
    const Op op = exprs[term].op;
    if (!is_list(op) && op != Op::Not) return;
    for (std::uint32_t k = 0; k < exprs[term].count; ++k) {
        const Id<Expr> operand = exprs.operands(term)[k];
        TermPlace below = place;
        below.path.push_back(k);
        if (is_list(op) && (place.of != TermPlace::Of::Event || !has_edge(exprs, operand))) found.push_back(below);
        collect_operands(exprs, operand, below, found);
    }
}

void collect_terms(const Exprs& exprs, Id<Expr> condition, const TermPlace& place, std::vector<TermPlace>& found) {
    const Op op = exprs[condition].op;
    if (!is_list(op) && !is_constant(op) && place.of != TermPlace::Of::Event) found.push_back(place);
    collect_operands(exprs, condition, place, found);
}

/// Returns `term` without the operand at the end of `path`.
Id<Expr> without_term(Exprs& exprs, Id<Expr> term, std::span<const std::uint32_t> path) {
    if (path.empty()) return exprs.constant(true);
    const Op op = exprs[term].op;
    std::vector<Id<Expr>> operands(exprs.operands(term).begin(), exprs.operands(term).end());
    if (path.size() == 1) operands.erase(operands.begin() + path.front());
    else operands[path.front()] = without_term(exprs, operands[path.front()], path.subspan(1));
    return exprs.apply(op, operands);
}

}  // namespace

void drop_transition(Chart& chart, Id<Chart::Transition> transition) {
    chart.transitions[transition].condition = chart.exprs.constant(false);
}

bool drop_actions(Chart& chart, Id<Chart::Step> step) {
    const std::size_t had = chart.continuous.size() + chart.forcing.size();
    chart.continuous = without(chart.continuous, step);
    chart.forcing = without(chart.forcing, step);
    bool any = chart.continuous.size() + chart.forcing.size() != had;
    // Without its actions, the variable would not be a stored variable, which keeps its value. Therefore the action is
    // not removed, but waits for an event that never occurs.
    for (Chart::StoredAction& action : chart.stored) {
        if (action.step != step || action.on == Chart::StoredOn::Clearing) continue;
        action.on = Chart::StoredOn::Event;
        action.event = chart.exprs.constant(false);
        any = true;
    }
    return any;
}

std::vector<TermPlace> terms_of(const Chart& chart) {
    std::vector<TermPlace> found;
    const auto collect = [&](TermPlace::Of of, std::uint32_t index, Id<Expr> condition) {
        if (condition.valid()) collect_terms(chart.exprs, condition, {of, index, {}}, found);
    };
    for (const auto id : chart.transitions.ids())
        collect(TermPlace::Of::Transition, id.index, chart.transitions[id].condition);
    for (const auto id : chart.continuous.ids())
        collect(TermPlace::Of::Action, id.index, chart.continuous[id].condition);
    for (const auto id : chart.stored.ids()) collect(TermPlace::Of::Event, id.index, chart.stored[id].event);
    return found;
}

Id<Expr> term_at(const Chart& chart, const TermPlace& place) {
    Id<Expr> term = condition_of(chart, place);
    for (const std::uint32_t operand : place.path) term = chart.exprs.operands(term)[operand];
    return term;
}

void remove_term(Chart& chart, const TermPlace& place) {
    condition_of(chart, place) = without_term(chart.exprs, condition_of(chart, place), place.path);
}

std::string owner_text(const Chart& chart, const TermPlace& place) {
    const auto action = [&](const auto& of, Id<Chart::Variable> variable) {
        return chart.variables[variable].name + " in step " + name_of(chart, of.step).text();
    };
    switch (place.of) {
    case TermPlace::Of::Transition: return chart.transitions[{place.index}].name;
    case TermPlace::Of::Action: {
        const Chart::ContinuousAction& of = chart.continuous[{place.index}];
        return action(of, of.output);
    }
    case TermPlace::Of::Event: {
        const Chart::StoredAction& of = chart.stored[{place.index}];
        return action(of, of.target);
    }
    }
    unreachable();
}

}  // namespace grafverif
