// SPDX-License-Identifier: MIT
#include "derive/misplaced_edges.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "grafverif/support/messages.hpp"

namespace grafverif {

namespace {

/// For every term: whether an edge occurs in it, whether it is false wherever there is no edge. Children precede
/// parents: one pass.
struct Edges {
    std::vector<bool> occur = {};
    std::vector<bool> needed = {};
    std::vector<bool> nested = {};   ///< an edge of an edge occurs in it
};

bool needs_edge(const Exprs& exprs, Id<Expr> term, const std::vector<bool>& needed) {
    const std::span<const Id<Expr>> operands = exprs.operands(term);
    const auto needs = [&](Id<Expr> operand) -> bool { return needed[operand.index]; };
    switch (exprs[term].op) {
    case Op::Rise: case Op::Fall: case Op::False: return true;
    case Op::And:                                 return std::ranges::any_of(operands, needs);
    case Op::Or:                                  return std::ranges::all_of(operands, needs);
    default:                                      return false;
    }
}

Edges edges(const Exprs& exprs) {
    Edges result{std::vector<bool>(exprs.size()), std::vector<bool>(exprs.size()), std::vector<bool>(exprs.size())};
    for (std::uint32_t index = 0; index < exprs.size(); ++index) {
        const Id<Expr> id{index};
        const bool is_edge = exprs[id].op == Op::Rise || exprs[id].op == Op::Fall;
        result.occur[index] = is_edge;
        for (const Id<Expr> operand : exprs.operands(id)) {
            if (result.occur[operand.index]) result.occur[index] = true;
            if (result.nested[operand.index] || (is_edge && result.occur[operand.index])) result.nested[index] = true;
        }
        result.needed[index] = needs_edge(exprs, id, result.needed);
    }
    return result;
}

struct Refusal {
    const Chart& chart;
    Diagnostics& diagnostics;
    Edges edge;

    void time_conditions() const {
        for (const Chart::TimeCondition& timed : chart.time_conditions)
            if (edge.occur[timed.watched.index]) diagnostics.add(messages::edge_under_time(timed.origin));
    }

    void edges_of_edges() const {
        for (const Chart::Transition& transition : chart.transitions)
            if (edge.nested[transition.condition.index]) diagnostics.add(messages::edge_of_edge(transition.origin));
        for (const Chart::StoredAction& action : chart.stored)
            if (edge.nested[action.value.index] || (action.event.valid() && edge.nested[action.event.index]))
                diagnostics.add(messages::edge_of_edge(action.origin));
    }

    /// 4.8.2: the action would not be continuous.
    void continuous_actions() const {
        for (const Chart::ContinuousAction& action : chart.continuous)
            if (edge.occur[action.condition.index])
                diagnostics.add(
                    messages::edge_in_assignation(action.origin, chart.variables[action.output].name));
    }

    /// 4.8.3: an event is an instant, so it needs an edge.
    void events() const {
        for (const Chart::StoredAction& action : chart.stored)
            if (action.on == Chart::StoredOn::Event && !edge.needed[action.event.index])
                diagnostics.add(messages::event_without_edge(action.origin, chart.variables[action.target].name));
    }
};

}  // namespace

bool misplaced_edges(const Chart& chart, Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    const Refusal refusal{chart, diagnostics, edges(chart.exprs)};
    refusal.time_conditions();
    refusal.edges_of_edges();
    refusal.continuous_actions();
    refusal.events();
    return diagnostics.errors() != errors;
}

}  // namespace grafverif
