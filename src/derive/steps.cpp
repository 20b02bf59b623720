// SPDX-License-Identifier: MIT
// Derives equations (11) and (12) of CEP13, extended by the hierarchy. Charts that force or enclose other charts are
// processed first, because the equations of the forced or enclosed charts use their new step activities:
//
//   X_s' = X_e' and (raised or ((base or linked) and not cleared))
//     `base`:    The right-hand side of equation (12) for s is true.
//     `X_e'`:    The step e that encloses the chart of s remains or becomes active.
//     `linked`:  The step s has an activation link, and the enclosing step becomes active while no forcing order keeps
//                the chart in its current situation.
//     `raised`:  An active forcing order for the chart of s activates s.
//     `cleared`: An active forcing order for the chart of s deactivates s.
//   X_M' = disjunction of X_s' for all steps s in the expansion of the macro-step M
//
// An active forcing order blocks the transitions of the forced chart. Contradictory forcing orders must not be active
// simultaneously.
#include <algorithm>
#include <array>

#include "derivation.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

using Order = Id<Chart::ForcingOrder>;

/// Returns the conjuncts under which `transition` is enabled, without its transition condition.
std::vector<Id<Expr>> enabling(Derivation& derivation, const Chart::Transition& transition) {
    const Chart& chart = derivation.chart;
    const Hierarchy& hierarchy = derivation.hierarchy;
    std::vector<Id<Expr>> terms;
    for (const Id<Chart::Step> step : transition.from)
        terms.push_back(derivation.step_leaves[hierarchy.left[step.index].index]);
    const Id<Chart::Step> owner = chart.partial_charts[transition.chart].owner;
    if (transition.from.empty() && owner.valid()) terms.push_back(derivation.step_leaves[owner.index]);
    for (const Order order : hierarchy.orders[transition.chart.index])
        terms.push_back(derivation.equations.exprs.negation(derivation.step_leaves[chart.forcing[order].step.index]));
    return terms;
}

class StepEquations {
public:
    explicit StepEquations(Derivation& derivation)
        : derivation_(derivation),
          chart_(derivation.chart),
          hierarchy_(derivation.hierarchy),
          exprs_(derivation.equations.exprs),
          on_(chart_.steps.size()),
          off_(chart_.steps.size()),
          linked_(chart_.steps.size()) {}

    void derive() {
        for (const Id<Chart::Transition> id : chart_.transitions.ids()) {
            const Id<Expr> fires = derivation_.firing_leaves[id.index];
            for (const Id<Chart::Step> step : chart_.transitions[id].from)
                off_[hierarchy_.left[step.index].index].push_back(fires);
            for (const Id<Chart::Step> step : chart_.transitions[id].to)
                on_[hierarchy_.entered[step.index].index].push_back(fires);
        }
        for (const Id<Chart::Step> step : chart_.steps.ids())
            if (chart_.steps[step].activation_link) linked_[hierarchy_.entered[step.index].index] = true;
        std::vector<Equations::StepActivity>& steps = derivation_.equations.steps;
        steps.resize(chart_.steps.size());
        // Expansions by root chart.
        std::vector<std::vector<Id<Chart::PartialChart>>> expansions(chart_.partial_charts.size());
        for (const Id<Chart::PartialChart> id : chart_.partial_charts.ids())
            if (hierarchy_.root_chart[id.index] != id) expansions[hierarchy_.root_chart[id.index].index].push_back(id);
        for (const Id<Chart::PartialChart> root_chart : hierarchy_.order) {
            for (const Id<Chart::Step> step : hierarchy_.region[root_chart.index])
                if (chart_.steps[step].kind != Chart::StepKind::Macro) steps[step.index] = activity(step, root_chart);
            if (failed(derivation_)) return;
            for (const Id<Chart::PartialChart> expansion : expansions[root_chart.index]) derive_macro(expansion);
        }
        for (const Id<Chart::Step> id : chart_.steps.ids()) {
            steps[id.index].variable = derivation_.steps[id.index];
            steps[id.index].step = name_of(chart_, id);
            steps[id.index].origin = chart_.steps[id].origin;
        }
    }

private:
    const Equations::StepActivity& of(Id<Chart::Step> step) const { return derivation_.equations.steps[step.index]; }
    Id<Expr> active(Id<Chart::Step> step) const { return derivation_.step_leaves[step.index]; }

    /// Returns equation (12). Activation has priority over deactivation (IEC 60848, rule 5): a step that is activated
    /// and deactivated simultaneously remains active, and is neither `activated` nor `deactivated`.
    Equations::StepActivity activity(Id<Chart::Step> step, Id<Chart::PartialChart> root_chart) {
        const Id<Chart::PartialChart> chart = chart_.steps[step].chart;
        const Id<Expr> on = exprs_.disjunction(on_[step.index]);
        const Id<Expr> off = exprs_.disjunction(off_[step.index]);
        const Id<Expr> base = exprs_.disjunction(on, exprs_.conjunction(active(step), exprs_.negation(off)));
        const Id<Chart::Step> enclosing = chart_.partial_charts[root_chart].owner;
        if (!enclosing.valid() && hierarchy_.orders[chart.index].empty()) {
            const std::array<Id<Expr>, 3> left{active(step), off, exprs_.negation(on)};
            return {.next = base,
                    .activated = exprs_.conjunction(on, exprs_.negation(active(step))),
                    .deactivated = consistent(exprs_, exprs_.conjunction(left))};
        }
        return changed(step, under_orders(step, root_chart, base));
    }

    Id<Expr> under_orders(Id<Chart::Step> step, Id<Chart::PartialChart> root_chart, Id<Expr> base) {
        std::vector<Id<Expr>> raised, cleared, held;
        for (const Order order : hierarchy_.orders[chart_.steps[step].chart.index]) {
            const Id<Chart::Step> forcing = chart_.forcing[order].step;
            if (chart_.forcing[order].to == Chart::ForcedTo::Current)
                held.push_back(exprs_.conjunction(active(forcing), of(forcing).next));
            else if (std::ranges::binary_search(hierarchy_.forced[order.index], step))
                raised.push_back(of(forcing).next);
            else cleared.push_back(of(forcing).next);
        }
        const Id<Chart::Step> enclosing = chart_.partial_charts[root_chart].owner;
        if (enclosing.valid() && linked_[step.index])
            base = exprs_.disjunction(
                base, exprs_.conjunction(of(enclosing).activated, exprs_.negation(exprs_.disjunction(held))));
        const Id<Expr> free = exprs_.conjunction(base, exprs_.negation(exprs_.disjunction(cleared)));
        raised.push_back(free);
        const Id<Expr> forced = exprs_.disjunction(raised);
        return enclosing.valid() ? exprs_.conjunction(of(enclosing).next, forced) : forced;
    }

    /// Returns the step activity with the new value `next`. Reports an error if `next` is too large.
    Equations::StepActivity changed(Id<Chart::Step> step, Id<Expr> next) {
        const std::string what = "step `" + chart_.steps[step].name + "`";
        if (derivation_.measures.size(exprs_, next) > term_size_limit)
            derivation_.diagnostics.add(messages::term_too_large(chart_.steps[step].origin, what, term_size_limit));
        if (derivation_.measures.depth(exprs_, next) > term_depth_limit)
            derivation_.diagnostics.add(messages::term_too_deep(chart_.steps[step].origin, what, term_depth_limit));
        if (failed(derivation_) || !afford(derivation_, derivation_.measures.size(exprs_, next)))
            next = exprs_.constant(false);
        return {.next = next,
                .activated = consistent(exprs_, exprs_.conjunction(next, exprs_.negation(active(step)))),
                .deactivated = consistent(exprs_, exprs_.conjunction(active(step), exprs_.negation(next)))};
    }

    void derive_macro(Id<Chart::PartialChart> expansion) {
        std::vector<Id<Expr>> members;
        for (const Id<Chart::Step> step : hierarchy_.region[expansion.index])
            if (chart_.steps[step].kind != Chart::StepKind::Macro) members.push_back(of(step).next);
        const Id<Chart::Step> macro = chart_.partial_charts[expansion].owner;
        derivation_.equations.steps[macro.index] = changed(macro, exprs_.disjunction(members));
    }

    Derivation& derivation_;
    const Chart& chart_;
    const Hierarchy& hierarchy_;
    Exprs& exprs_;
    /// For each step: the firing conditions that activate the step, and the firing conditions that deactivate it.
    std::vector<std::vector<Id<Expr>>> on_, off_;
    std::vector<bool> linked_;
};

/// Adds a conflict for each pair of contradictory forcing orders.
void derive_conflicts(Derivation& derivation) {
    const Chart& chart = derivation.chart;
    Equations& equations = derivation.equations;
    const auto next = [&](Order order) { return equations.steps[chart.forcing[order].step.index].next; };
    std::vector<std::vector<Order>> seen(chart.forcing.size());
    for (const Id<Chart::PartialChart> id : chart.partial_charts.ids()) {
        const std::vector<Order>& orders = derivation.hierarchy.orders[id.index];
        for (std::size_t k = 0; k < orders.size(); ++k)
            for (std::size_t i = 0; i < k; ++i) {
                std::vector<Order>& with = seen[orders[k].index];
                if (!conflict(chart, derivation.hierarchy, orders[i], orders[k])) continue;
                if (std::ranges::find(with, orders[i]) != with.end()) continue;
                with.push_back(orders[i]);
                const Id<Expr> together = equations.exprs.conjunction(next(orders[i]), next(orders[k]));
                if (!afford(derivation, derivation.measures.size(equations.exprs, together))) return;
                equations.conflicts.push_back({together, chart.forcing[orders[k]].origin});
            }
    }
}

}  // namespace

Id<Expr> clearing_condition(Derivation& derivation, const Chart::Transition& transition, TermPosition reading) {
    std::vector<Id<Expr>> operands = enabling(derivation, transition);
    const Id<Expr> condition = over_equations(derivation, transition.condition, reading, transition.origin,
                                              "transition `" + transition.name + "`");
    if (condition.valid()) operands.push_back(condition);
    return derivation.equations.exprs.conjunction(operands);
}

void derive_firings(Derivation& derivation) {
    const Chart& chart = derivation.chart;
    for (const Id<Chart::Transition> id : chart.transitions.ids()) {
        const Chart::Transition& transition = chart.transitions[id];
        derivation.equations.firings.push_back({derivation.firings[id.index],
                                                clearing_condition(derivation, transition, TermPosition::Before),
                                                transition.name, transition.origin});
        if (derivation.diagnostics.full() || derivation.exhausted) return;
    }
}

void derive_steps(Derivation& derivation) {
    StepEquations(derivation).derive();
    if (!failed(derivation)) derive_conflicts(derivation);
}

}  // namespace grafverif
