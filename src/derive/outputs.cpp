// SPDX-License-Identifier: MIT
// Derives equation (13) of CEP13 for every output without stored actions: a disjunction over its continuous actions.
// The operand of an action is the conjunction of its step activity and assignation condition. If a condition of an
// action reads an output, this output is derived before the output that the action sets. A cycle among outputs is an
// error.
#include <algorithm>
#include <array>

#include "derivation.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

/// An output whose equation is being derived, with the outputs that the conditions of its actions read, and the
/// positions of these actions.
struct Visit {
    struct Read {
        Id<Chart::Variable> output = {};
        Span where = {};
    };
    Id<Chart::Variable> output = {};
    std::vector<Read> reads = {};
    std::size_t next = 0;
};

/// Collects the continuous outputs that `term` reads, including the observed terms of time conditions.
void collect_reads(const Derivation& derivation, Id<Expr> term, Span where, Visit& visit) {
    const Chart& chart = derivation.chart;
    if (!derivation.reads_output[term.index]) return;
    for (const Id<Expr> leaf : leaves(chart.exprs, term)) {
        const Expr& node = chart.exprs[leaf];
        const auto index = static_cast<std::uint32_t>(node.value);
        if (node.op == Op::Timed) collect_reads(derivation, chart.time_conditions[{index}].watched, where, visit);
        if (node.op == Op::Variable && is_continuous(derivation, {index})) visit.reads.push_back({{index}, where});
    }
}

Visit visit(const Derivation& derivation, Id<Chart::Variable> output) {
    Visit result{output, {}, 0};
    for (const Id<Chart::ContinuousAction> id : derivation.continuous[output.index]) {
        const Chart::ContinuousAction& action = derivation.chart.continuous[id];
        collect_reads(derivation, action.condition, action.origin, result);
    }
    return result;
}

/// Returns the time condition of an action on the step X: `3s/X` for a delayed action, and `not 3s/X` for a
/// time-limited action. The time limit begins when the delay ends.
Id<Expr> time_of(Derivation& derivation, const Chart::ContinuousAction& action) {
    Exprs& exprs = derivation.equations.exprs;
    const auto active_for = [&](std::int64_t duration) {
        return end_leaf(derivation, timer(derivation, derivation.steps[action.step.index], duration, 0, action.origin));
    };
    std::vector<Id<Expr>> terms;
    if (action.delay_ms > 0) terms.push_back(active_for(action.delay_ms));
    if (action.limit_ms > 0) terms.push_back(exprs.negation(active_for(action.delay_ms + action.limit_ms)));
    return exprs.conjunction(terms);
}

/// Returns the right-hand side of equation (13), or an invalid id if a condition is too large.
Id<Expr> output_value(Derivation& derivation, Id<Chart::Variable> output) {
    const Chart::Variable& variable = derivation.chart.variables[output];
    Exprs& exprs = derivation.equations.exprs;
    if (!variable.type.boolean) return exprs.integer(variable.initial);
    std::vector<Id<Expr>> terms;
    for (const Id<Chart::ContinuousAction> id : derivation.continuous[output.index]) {
        const Chart::ContinuousAction& action = derivation.chart.continuous[id];
        const Id<Expr> condition = over_equations(derivation, action.condition, TermPosition::After, action.origin,
                                                  "output `" + variable.name + "`");
        if (!condition.valid()) return {};
        const Id<Expr> time = time_of(derivation, action);
        terms.push_back(exprs.conjunction(std::array{derivation.step_leaves[action.step.index], condition, time}));
    }
    return exprs.disjunction(terms);
}

/// Reports the cycle at the end of `path`, which begins with the output `closing`.
void report_cycle(Derivation& derivation, const std::vector<Visit>& path, Id<Chart::Variable> closing) {
    if (derivation.diagnostics.full()) return;
    const auto first = std::ranges::find(path, closing, &Visit::output);
    std::vector<std::string> outputs;
    for (auto place = first; place != path.end(); ++place)
        outputs.push_back(derivation.chart.variables[place->output].name);
    derivation.diagnostics.add(messages::output_cycle(first->reads[first->next - 1].where, outputs));
}

}  // namespace

void derive_outputs(Derivation& derivation) {
    enum class Mark { New, Open, Done };
    std::vector<Mark> marks(derivation.chart.variables.size(), Mark::New);
    const Id<Expr> none = derivation.equations.exprs.constant(false);
    for (const Id<Chart::Variable> root : derivation.chart.variables.ids()) {
        if (!is_continuous(derivation, root) || marks[root.index] != Mark::New) continue;
        std::vector<Visit> path{visit(derivation, root)};
        marks[root.index] = Mark::Open;
        while (!path.empty()) {
            Visit& top = path.back();
            if (top.next < top.reads.size()) {
                const Id<Chart::Variable> read = top.reads[top.next++].output;
                if (marks[read.index] == Mark::Open) report_cycle(derivation, path, read);
                if (marks[read.index] != Mark::New) continue;
                marks[read.index] = Mark::Open;
                path.push_back(visit(derivation, read));
                continue;
            }
            // After an error (a cycle of outputs, or a term that is too large), the constant false replaces the output
            // in the terms that read it. The error has already been reported.
            const Id<Expr> value = failed(derivation) ? none : output_value(derivation, top.output);
            derivation.values[top.output.index] = value.valid() ? value : none;
            marks[top.output.index] = Mark::Done;
            path.pop_back();
        }
    }
    for (const Id<Chart::Variable> output : derivation.chart.variables.ids())
        if (is_continuous(derivation, output))
            derivation.equations.outputs.push_back({Id<Equations::Variable>{output.index},
                                                    derivation.values[output.index],
                                                    derivation.chart.variables[output].origin});
}

}  // namespace grafverif
