// SPDX-License-Identifier: MIT
#include "explain/dead_steps.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "syntax/print/chart.hpp"

namespace grafverif {

namespace {

class Candidates {
public:
    Candidates(const Chart& chart, const ConditionLeaves& leaves, Exprs& exprs)
        : chart_(chart), leaves_(leaves), exprs_(exprs) {}

    void add(Id<Chart::Transition> id) {
        transition_ = id;
        const Chart::Transition& transition = chart_.transitions[id];
        std::vector<Id<Expr>> steps;
        std::string names;
        for (const Id<Chart::Step> step : transition.from) {
            const std::string name = fmt::format("`{}`", step_variable(chart_, step));
            steps.push_back(exprs_.leaf(Op::Variable, leaves_.steps[step.index]));
            names += (names.empty() ? "" : ", ") + name;
            claim(steps.back(), "enabled", name + " is never active");
        }
        const Id<Expr> enabled = exprs_.conjunction(steps);
        if (steps.size() > 1) claim(enabled, "enabled", names + " are never active together");

        std::vector<Id<Expr>> terms = {transition.condition}, read;
        if (chart_.exprs[transition.condition].op == Op::And) {
            const auto operands = chart_.exprs.operands(transition.condition);
            terms.assign(operands.begin(), operands.end());
        }
        std::vector<std::string> texts;
        for (const Id<Expr> term : terms) {
            const std::optional<Id<Expr>> found = bound_of(term);
            if (!found) continue;
            read.push_back(*found);
            texts.push_back(fmt::format("`{}`", term_text(chart_, term)));
            claim(*found, "cleared", texts.back() + " is never true");
        }
        if (steps.empty()) return;
        const std::string active = names + (steps.size() > 1 ? " are active" : " is active");
        for (std::size_t k = 0; k < read.size(); ++k)
            claim(exprs_.conjunction(enabled, read[k]), "cleared", texts[k] + " is never true while " + active);
        if (read.size() < 2) return;
        for (std::size_t i = 0; read.size() > 2 && read.size() < 8 && i < read.size(); ++i)
            for (std::size_t j = i + 1; j < read.size(); ++j)
                claim(exprs_.conjunction(enabled, exprs_.conjunction(read[i], read[j])), "cleared",
                      texts[i] + ", " + texts[j] + " are never true together while " + active);
        claim(exprs_.conjunction(enabled, exprs_.conjunction(read)), "cleared",
              fmt::format("{}", fmt::join(texts, ", ")) + " are never true together while " + active);
    }

    std::vector<DeadTransition> made = {};

private:
    void claim(Id<Expr> never, const char* state, const std::string& why) {
        const std::string& name = chart_.transitions[transition_].name;
        made.push_back({transition_, never, fmt::format("`{}` is never {}: {}", name, state, why)});
    }

    /// Returns a term of the model that is true in every state in which the condition `term` is true, or nothing if no
    /// such term is known.
    std::optional<Id<Expr>> bound_of(Id<Expr> term) {
        if (chart_.exprs[term].op != Op::Timed) return copy_of(term);
        // A condition `t1/v` is true only if the output of its timer is true. A condition `v/t2` can also be true while
        // the output of its timer is false.
        const auto index = static_cast<std::uint32_t>(chart_.exprs[term].value);
        const auto& end = leaves_.ends[index];
        if (!end || chart_.time_conditions[{index}].fall_ms != 0) return {};
        return exprs_.leaf(Op::Variable, *end);
    }

    /// Returns a copy of the term for the model, or nothing if the term contains an edge, a time condition or an
    /// output. For an output, a copy would be wrong, because conditions read the value of the output's equation, not
    /// the value written to the plant.
    std::optional<Id<Expr>> copy_of(Id<Expr> term) {
        bool known = true;
        const auto leaf = [&](const Expr& node) {
            const auto index = static_cast<std::uint32_t>(node.value);
            if (node.op == Op::Step) return exprs_.leaf(Op::Variable, leaves_.steps[index]);
            const auto found = node.op == Op::Variable ? leaves_.variables.find(chart_.variables[{index}].name)
                                                       : leaves_.variables.end();
            known = known && found != leaves_.variables.end();
            return known ? exprs_.leaf(Op::Variable, found->second) : exprs_.constant(false);
        };
        const auto edge = [&](Op, Id<Expr> now) {
            known = false;
            return now;
        };
        const Id<Expr> copy = TermCopier(chart_.exprs, exprs_, leaf, edge)(term);
        return known && !is_true(exprs_, copy) ? std::optional(copy) : std::nullopt;
    }

    const Chart& chart_;
    const ConditionLeaves& leaves_;
    Exprs& exprs_;
    Id<Chart::Transition> transition_ = {};
};

}  // namespace

std::vector<DeadTransition> dead_transitions(const Chart& chart, const ConditionLeaves& leaves, Id<Chart::Step> step,
                                             Exprs& exprs) {
    Candidates candidates(chart, leaves, exprs);
    const Chart::Step& entered = chart.steps[step];
    const Id<Chart::Step> macro = entered.entry ? chart.partial_charts[entered.chart].owner : step;
    for (const Id<Chart::Transition> id : chart.transitions.ids())
        if (std::ranges::any_of(chart.transitions[id].to, [&](auto to) { return to == step || to == macro; }))
            candidates.add(id);
    return std::move(candidates.made);
}

}  // namespace grafverif
