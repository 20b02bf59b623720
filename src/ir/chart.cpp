// SPDX-License-Identifier: MIT
#include "grafverif/ir/chart.hpp"

#include <string_view>
#include <unordered_set>

#include "ir/program/program.hpp"
#include "ir/sorts.hpp"

namespace grafverif {

bool ProgramReference::operator==(const ProgramReference& other) const {
    return shared == other.shared || (shared && other.shared && *shared == *other.shared);
}

StepName name_of(const Chart& chart, Id<Chart::Step> step) {
    const Chart::Step& named = chart.steps[step];
    return {named.chart.valid() ? chart.partial_charts[named.chart].name : "", named.name};
}

std::string step_variable(const Chart& chart, Id<Chart::Step> step) { return name_of(chart, step).variable(); }

ReadTerms read_terms(const Chart& chart) {
    ReadTerms read{std::vector<bool>(chart.exprs.size()), std::vector<bool>(chart.time_conditions.size())};
    for (const Chart::Transition& transition : chart.transitions) read.terms[transition.condition.index] = true;
    for (const Chart::ContinuousAction& action : chart.continuous) read.terms[action.condition.index] = true;
    for (const Chart::StoredAction& action : chart.stored) {
        read.terms[action.value.index] = true;
        if (action.event.valid()) read.terms[action.event.index] = true;
    }
    // The loop visits the terms in reverse order: operands precede the terms that contain them, and the observed term
    // of a time condition precedes the time condition.
    for (auto index = static_cast<std::uint32_t>(chart.exprs.size()); index-- > 0;) {
        if (!read.terms[index]) continue;
        const Expr& node = chart.exprs[Id<Expr>{index}];
        for (const Id<Expr> operand : chart.exprs.operands(node)) read.terms[operand.index] = true;
        if (node.op != Op::Timed) continue;
        read.time_conditions[static_cast<std::size_t>(node.value)] = true;
        read.terms[chart.time_conditions[{static_cast<std::uint32_t>(node.value)}].watched.index] = true;
    }
    return read;
}

namespace {

/// Collects descriptions of the violated invariants of a chart.
struct ChartFaults {
    Sorts sorts;
    std::vector<std::string> found = {};
    void condition(Id<Expr> condition, const std::string& owner) {
        sorts.check(condition, Sort::Boolean, "the condition of " + owner, found);
    }
    void check(bool holds, std::string fault) {
        if (!holds) found.push_back(std::move(fault));
    }
};

bool leaf_in_table(const Chart& chart, const Expr& leaf) {
    const auto index = static_cast<std::uint32_t>(leaf.value);
    switch (leaf.op) {
    case Op::Variable: return index < chart.variables.size();
    case Op::Step: return index < chart.steps.size();
    case Op::Timed: return index < chart.time_conditions.size();
    default: return !is_leaf(leaf.op) && leaf.op != Op::Duration;
    }
}

/// Returns the sort of a leaf or of an edge operator (Rise, Fall). Returns None if the leaf refers to an undeclared
/// element, or if it is a duration, because durations occur only in time conditions.
Sort leaf_sort(const Chart& chart, const Expr& leaf) {
    if (leaf.op == Op::Rise || leaf.op == Op::Fall) return Sort::Boolean;
    if (!leaf_in_table(chart, leaf)) return Sort::None;
    if (leaf.op != Op::Variable) return Sort::Boolean;
    return sort_of(chart.variables[Id<Chart::Variable>{static_cast<std::uint32_t>(leaf.value)}].type);
}

void check_names(const Chart& chart, ChartFaults& faults) {
    std::unordered_set<std::string_view> variables, transitions, partials;
    std::unordered_set<std::string> steps;
    for (const auto& variable : chart.variables)
        faults.check(variables.insert(variable.name).second, "two variables are named " + variable.name);
    for (const auto& transition : chart.transitions)
        faults.check(transitions.insert(transition.name).second, "two transitions are named " + transition.name);
    for (const auto& partial : chart.partial_charts)
        faults.check(partials.insert(partial.name).second, "two partial charts are named " + partial.name);
    for (const auto& step : chart.steps) {
        if (!chart.partial_charts.contains(step.chart)) continue;
        faults.check(steps.insert(std::to_string(step.chart.index) + '.' + step.name).second,
                     "two steps of one partial chart are named " + step.name);
    }
}

void check_variables(const Chart& chart, ChartFaults& faults) {
    for (const auto& variable : chart.variables) {
        const Type& type = variable.type;
        faults.check(type.low <= type.high, "the range of " + variable.name + " is empty");
        faults.check(!type.boolean || (type.low == 0 && type.high == 1),
                     "the Boolean " + variable.name + " has a range");
        faults.check(type.low <= variable.initial && variable.initial <= type.high,
                     "the initial value of " + variable.name + " is out of range");
    }
}

void check_partial_charts(const Chart& chart, ChartFaults& faults) {
    std::vector<int> entries(chart.partial_charts.size()), exits(chart.partial_charts.size());
    for (const auto& step : chart.steps) {
        faults.check(chart.partial_charts.contains(step.chart),
                     "step " + step.name + " does not belong to a partial chart");
        if (!chart.partial_charts.contains(step.chart)) continue;
        entries[step.chart.index] += step.entry ? 1 : 0;
        exits[step.chart.index] += step.exit ? 1 : 0;
    }
    std::vector<int> expansions(chart.steps.size());
    for (const auto id : chart.partial_charts.ids()) {
        const auto& partial = chart.partial_charts[id];
        const bool owned = partial.owner.valid();
        faults.check(!owned || chart.steps.contains(partial.owner), "the owner of " + partial.name + " is not a step");
        const bool is_expansion = partial.kind == Chart::PartialKind::Expansion;
        faults.check(owned == (partial.kind != Chart::PartialKind::Plain),
                     "the owner of " + partial.name + " does not match the type of the partial chart");
        if (chart.steps.contains(partial.owner)) {
            const Chart::StepKind wanted = is_expansion ? Chart::StepKind::Macro : Chart::StepKind::Enclosing;
            faults.check(chart.steps[partial.owner].kind == wanted,
                         "the owner of " + partial.name + " is a step of the wrong type");
            if (is_expansion) ++expansions[partial.owner.index];
        }
        if (!is_expansion) continue;
        faults.check(entries[id.index] == 1 && exits[id.index] == 1,
                     "expansion " + partial.name + " does not have exactly one entry step and one exit step");
    }
    for (const auto id : chart.steps.ids())
        faults.check((chart.steps[id].kind == Chart::StepKind::Macro) == (expansions[id.index] == 1),
                     "step " + chart.steps[id].name + " has a number of expansions that does not match its type");
}

bool is_input(const Chart& chart, const Expr& leaf) {
    const Id<Chart::Variable> variable{static_cast<std::uint32_t>(leaf.value)};
    return leaf.op == Op::Variable && chart.variables.contains(variable) &&
           chart.variables[variable].kind == Chart::VariableKind::Input;
}

void check_transitions(const Chart& chart, ChartFaults& faults) {
    for (const auto& transition : chart.transitions) {
        const auto check_side = [&](const std::vector<Id<Chart::Step>>& side) {
            for (const auto step : side) {
                faults.check(chart.steps.contains(step),
                             "transition " + transition.name + " links a step that does not exist");
                if (chart.steps.contains(step))
                    faults.check(chart.steps[step].chart == transition.chart,
                                 "transition " + transition.name +
                                     " has a preceding or succeeding step in another partial chart");
            }
        };
        check_side(transition.from);
        check_side(transition.to);
        faults.check(!transition.from.empty() || !transition.to.empty(),
                     "transition " + transition.name + " has neither a preceding nor a succeeding step");
        faults.condition(transition.condition, "transition " + transition.name);
    }
    for (const auto& time : chart.time_conditions) {
        faults.condition(time.watched, "a time condition");
        faults.check(time.rise_ms >= 0 && time.fall_ms >= 0 && time.rise_ms + time.fall_ms > 0,
                     "both durations of a time condition are zero, or one of them is negative");
    }
    for (const auto& constraint : chart.constraints) {
        faults.condition(constraint.condition, "a constraint");
        if (chart.exprs.contains(constraint.condition))
            for (const Id<Expr> leaf : leaves(chart.exprs, constraint.condition))
                faults.check(is_input(chart, chart.exprs[leaf]), "a constraint reads something other than an input");
    }
}

void check_actions(const Chart& chart, ChartFaults& faults) {
    for (const auto& action : chart.continuous) {
        faults.check(chart.steps.contains(action.step), "a continuous action refers to a step that does not exist");
        faults.check(chart.variables.contains(action.output),
                     "a continuous action refers to an output that does not exist");
        if (chart.variables.contains(action.output))
            faults.check(chart.variables[action.output].type.boolean,
                         "the output of a continuous action is an integer");
        faults.condition(action.condition, "a continuous action");
    }
    for (const auto& action : chart.stored) {
        const bool clearing = action.on == Chart::StoredOn::Clearing;
        faults.check(clearing ? chart.transitions.contains(action.transition) : chart.steps.contains(action.step),
                     "a stored action refers to a step or transition that does not exist");
        faults.check((action.on == Chart::StoredOn::Event) == action.event.valid(),
                     "a stored action has an unexpected event, or its event is missing");
        if (action.event.valid()) faults.condition(action.event, "an event");
        const bool known = chart.variables.contains(action.target) && chart.exprs.contains(action.value);
        faults.check(known, "a stored action refers to a target or value that does not exist");
        if (!known) continue;
        faults.sorts.check(action.value, sort_of(chart.variables[action.target].type), "the value of a stored action",
                           faults.found);
    }
    for (const auto& order : chart.forcing) {
        faults.check(chart.steps.contains(order.step), "a forcing order refers to a step that does not exist");
        faults.check(chart.partial_charts.contains(order.forced),
                     "a forcing order forces a partial chart that does not exist");
        for (const auto step : order.situation)
            faults.check(chart.steps.contains(step) && chart.steps[step].chart == order.forced,
                         "a forcing order names a step outside the forced partial chart");
    }
}

}  // namespace

std::vector<std::string> verify(const Chart& chart) {
    ChartFaults faults{Sorts(chart.exprs, [&chart](const Expr& leaf) { return leaf_sort(chart, leaf); })};
    for (std::uint32_t index = 0; index < chart.exprs.size(); ++index)
        faults.check(!is_leaf(chart.exprs[Id<Expr>{index}].op) || leaf_in_table(chart, chart.exprs[Id<Expr>{index}]),
                     "a leaf of an expression refers to an undeclared element");
    if (!faults.found.empty()) return faults.found;
    check_names(chart, faults);
    check_variables(chart, faults);
    check_partial_charts(chart, faults);
    check_transitions(chart, faults);
    check_actions(chart, faults);
    return faults.found;
}

}  // namespace grafverif
