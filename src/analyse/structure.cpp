// SPDX-License-Identifier: MIT
#include "analyse/structure.hpp"

#include <algorithm>
#include <set>

#include "ir/reads.hpp"

namespace grafverif::analysis {

namespace {

using OrderId = Id<Chart::ForcingOrder>;

}  // namespace

std::vector<bool> variables_read(const Equations& equations) {
    std::vector<bool> marks(equations.variables.size());
    Reads reads(equations.exprs);
    const auto mark = [&](Id<Expr> root) { reads.each(root, [&](std::uint32_t variable) { marks[variable] = true; }); };
    for (const Equations::Firing& firing : equations.firings) mark(firing.condition);
    for (const Equations::StepActivity& step : equations.steps) mark(step.next);
    for (const Equations::Output& output : equations.outputs) mark(output.value);
    for (const Kept& each : remembered(equations)) mark(each.next);
    for (const Equations::Stored& stored : equations.stored)
        for (const Equations::Write& write : stored.writes) {
            mark(write.trigger);
            mark(write.value);
        }
    return marks;
}

std::vector<std::vector<OrderId>> forcing_cycles(const Chart& chart) {
    // Depth-first search from each forcing order along orders with greater ids. The search finds each cycle once,
    // starting at the order with the least id.
    std::vector<std::vector<OrderId>> found;
    const auto next_of = [&](OrderId order) {
        std::vector<OrderId> next;
        for (const OrderId other : chart.forcing.ids())
            if (chart.steps[chart.forcing[other].step].chart == chart.forcing[order].forced) next.push_back(other);
        return next;
    };
    for (const OrderId start : chart.forcing.ids()) {
        std::vector<bool> seen(chart.forcing.size());
        std::vector<std::vector<OrderId>> open{{start}};
        while (!open.empty()) {
            const std::vector<OrderId> path = std::move(open.back());
            open.pop_back();
            const std::vector<OrderId> next = next_of(path.back());
            if (std::ranges::find(next, start) != next.end()) {
                found.push_back(path);
                break;
            }
            for (const OrderId other : next) {
                if (other.index < start.index || seen[other.index]) continue;
                seen[other.index] = true;
                open.push_back(path);
                open.back().push_back(other);
            }
        }
    }
    return found;
}

std::vector<std::pair<OrderId, Id<Chart::Step>>> orders_on_enclosed(const Chart& chart) {
    std::vector<std::pair<OrderId, Id<Chart::Step>>> found;
    for (const OrderId order : chart.forcing.ids()) {
        Id<Chart::PartialChart> partial = chart.forcing[order].forced;
        std::set<std::uint32_t> seen;  // stops the traversal if the enclosures form a cycle
        while (partial.valid() && seen.insert(partial.index).second) {
            const Chart::PartialChart& here = chart.partial_charts[partial];
            if (!here.owner.valid()) break;
            if (here.kind == Chart::PartialKind::Enclosed) found.emplace_back(order, here.owner);
            partial = chart.steps[here.owner].chart;
        }
    }
    return found;
}

namespace {

/// Returns the operands of a conjunction, or the term itself.
std::vector<Id<Expr>> conjuncts(const Exprs& exprs, Id<Expr> term) {
    if (exprs[term].op != Op::And) return {term};
    const auto operands = exprs.operands(term);
    return {operands.begin(), operands.end()};
}

}  // namespace

std::string conflict_subject(const Chart& chart, const Equations& equations, const Equations::Conflict& conflict) {
    std::string subject;
    const std::vector<Id<Expr>> active = conjuncts(equations.exprs, conflict.condition);
    for (const Chart::ForcingOrder& order : chart.forcing) {
        if (order.origin.source != conflict.origin.source || order.origin.begin != conflict.origin.begin) continue;
        if (subject.empty()) subject = chart.partial_charts[order.forced].name;
        // Copies of a step contain copies of its forcing order with the same source position. The condition of each
        // copy states that its step is active.
        const std::vector<Id<Expr>> needed = conjuncts(equations.exprs, equations.steps[order.step.index].next);
        const auto is_needed = [&](Id<Expr> term) { return std::ranges::find(active, term) != active.end(); };
        if (std::ranges::all_of(needed, is_needed)) return chart.partial_charts[order.forced].name;
    }
    return subject;
}

std::vector<std::pair<Id<Chart::Transition>, Id<Chart::Transition>>> branches(const Chart& chart) {
    std::vector<std::vector<Id<Chart::Transition>>> leaving(chart.steps.size());
    for (const Id<Chart::Transition> id : chart.transitions.ids())
        for (const Id<Chart::Step> step : chart.transitions[id].from) leaving[step.index].push_back(id);
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const std::vector<Id<Chart::Transition>>& out : leaving)
        for (std::size_t k = 0; k < out.size(); ++k)
            for (std::size_t i = 0; i < k; ++i) pairs.emplace(out[i].index, out[k].index);
    std::vector<std::pair<Id<Chart::Transition>, Id<Chart::Transition>>> found;
    for (const auto& [first, second] : pairs) found.push_back({{first}, {second}});
    return found;
}

}  // namespace grafverif::analysis
