// SPDX-License-Identifier: MIT
#include "compare/wording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "support/overloaded.hpp"
#include "syntax/print/chart.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif::comparing {

namespace {

/// Returns `G1.X2` for `G1.2`.
std::string step_variable_of(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    return dot == std::string::npos ? "X" + name : name.substr(0, dot + 1) + "X" + name.substr(dot + 1);
}

}  // namespace

std::string Wording::term(Id<Expr> term) const {
    return expr_text(chart_.exprs, term, chart_spelling, [this](std::ostream& out, const Expr& leaf) {
        const auto index = static_cast<std::uint32_t>(leaf.value);
        if (leaf.op == Op::Variable) out << chart_.variables[Id<Chart::Variable>{index}].name;
        else if (leaf.op == Op::Step) out << step_variable_of(naming_({index}));
        else
            out << time_text(chart_, chart_.time_conditions[Id<Chart::TimeCondition>{index}],
                             [this](Id<Expr> watched) { return this->term(watched); });
    });
}

std::string Wording::variable(const Chart::Variable& variable) const {
    std::string text = variable.name;
    if (!variable.type.boolean) text += fmt::format(": int {}..{}", variable.type.low, variable.type.high);
    if (variable.initial == 0) return text;
    return text + (variable.type.boolean ? " = true" : fmt::format(" = {}", variable.initial));
}

std::string Wording::head(Id<Chart::Step> id) const {
    const Chart::Step& step = chart_.steps[id];
    std::string text;
    for (const auto& [is, word] : {std::pair(step.initial, "initial "), std::pair(step.activation_link, "linked "),
                                   std::pair(step.entry, "entry "), std::pair(step.exit, "exit ")})
        if (is) text += word;
    switch (step.kind) {
    case Chart::StepKind::Ordinary: break;
    case Chart::StepKind::Macro: text += "macro "; break;
    case Chart::StepKind::Enclosing: text += "enclosing "; break;
    }
    text += "step " + naming_(id);
    if (step.kind == Chart::StepKind::Ordinary) return text;
    std::string owned;
    for (const Chart::PartialChart& partial : chart_.partial_charts)
        if (partial.owner == id) owned += (owned.empty() ? "" : ", ") + partial.name;
    return text + (step.kind == Chart::StepKind::Macro ? " expands " : " encloses ") + owned;
}

std::string Wording::names(const std::vector<Id<Chart::Step>>& steps) const {
    std::vector<std::string> each;
    for (const Id<Chart::Step> step : steps) each.push_back(naming_(step));
    std::ranges::sort(each);
    std::string text;
    for (const std::string& name : each) text += (text.empty() ? "" : ", ") + name;
    return text;
}

std::vector<std::string> Wording::actions(Id<Chart::Step> step) const {
    std::vector<std::string> found;
    for (const Chart::ContinuousAction& action : chart_.continuous) {
        if (action.step != step) continue;
        std::string text = chart_.variables[action.output].name;
        if (!is_true(chart_.exprs, action.condition)) text += " if " + term(action.condition);
        if (action.delay_ms > 0) text += " after " + duration_text(action.delay_ms);
        if (action.limit_ms > 0) text += " for " + duration_text(action.limit_ms);
        found.push_back(std::move(text));
    }
    for (const Chart::StoredAction& action : chart_.stored) {
        if (action.step != step || action.on == Chart::StoredOn::Clearing) continue;
        std::string text = chart_.variables[action.target].name + " := " + term(action.value);
        if (action.on == Chart::StoredOn::Activation) text += " on activation";
        if (action.on == Chart::StoredOn::Deactivation) text += " on deactivation";
        if (action.on == Chart::StoredOn::Event) text += " on event " + term(action.event);
        found.push_back(std::move(text));
    }
    for (const Chart::ForcingOrder& order : chart_.forcing) {
        if (order.step != step) continue;
        const std::string to = order.to == Chart::ForcedTo::Empty     ? ""
                               : order.to == Chart::ForcedTo::Current ? "*"
                               : order.to == Chart::ForcedTo::Initial ? "INIT"
                                                                      : names(order.situation);
        found.push_back("force " + chart_.partial_charts[order.forced].name + " := {" + to + "}");
    }
    return found;
}

std::string Wording::endpoints(Id<Chart::Transition> transition) const {
    const std::string from = names(chart_.transitions[transition].from), to = names(chart_.transitions[transition].to);
    return from + (from.empty() ? "->" : " ->") + (to.empty() ? "" : " ") + to;
}

std::string Wording::guard(Id<Chart::Transition> transition) const {
    std::string text = "when " + term(chart_.transitions[transition].condition);
    bool first = true;
    for (const Chart::StoredAction& action : chart_.stored)
        if (action.on == Chart::StoredOn::Clearing && action.transition == transition) {
            text += (first ? " do " : ", ") + chart_.variables[action.target].name + " := " + term(action.value);
            first = false;
        }
    return text;
}

}  // namespace grafverif::comparing
