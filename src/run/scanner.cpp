// SPDX-License-Identifier: MIT
#include "run/scanner.hpp"

#include <fmt/format.h>

#include <utility>

namespace grafverif {

std::vector<Id<Chart::Variable>> variables_of_kind(const Chart& chart, Chart::VariableKind kind) {
    std::vector<Id<Chart::Variable>> found;
    for (const Id<Chart::Variable> id : chart.variables.ids())
        if (chart.variables[id].kind == kind) found.push_back(id);
    return found;
}

std::string situation_text(const Chart& chart, const std::vector<bool>& situation) {
    std::string text;
    for (const Id<Chart::Step> step : chart.steps.ids())
        if (situation[step.index]) text += (text.empty() ? "" : ", ") + name_of(chart, step).text();
    return "{" + text + "}";
}

std::string instability_text(const Chart& chart, const std::vector<std::vector<bool>>& endless) {
    constexpr std::size_t shown = 8;
    std::string text = "with these inputs, the situation never becomes stable: ";
    for (std::size_t k = 0; k < endless.size() && k < shown; ++k) text += situation_text(chart, endless[k]) + " -> ";
    return text + (endless.size() > shown ? "..." : situation_text(chart, endless.front())) +
           ", forever within one instant [total-instability]";
}

std::string race_text(std::string_view variable) {
    if (variable.empty()) return "contradictory forcing orders [action-race]";
    return fmt::format("two stored actions assign different values to `{}` in one evolution [action-race]", variable);
}

std::string problem_in(const Chart& chart, const Cycle& cycle) {
    if (cycle.race) return race_text(chart.variables[cycle.race->variable].name);
    if (cycle.fault && cycle.fault->kind == RunFault::Kind::OutOfRange) {
        const Chart::Variable& variable = chart.variables[cycle.fault->variable];
        return fmt::format("the value {3} of `{0}` is outside its range {1}..{2} [out-of-range]", variable.name,
                           variable.type.low, variable.type.high, cycle.fault->value);
    }
    if (cycle.fault && cycle.fault->kind == RunFault::Kind::ForcedApart) return race_text("");
    if (cycle.fault) return "a condition or a stored value is undefined [no-value]";
    if (cycle.gave_up)
        return fmt::format("no stable situation within {} evolutions [total-instability]", evolution_limit);
    return cycle.endless.empty() ? "" : instability_text(chart, cycle.endless);
}

void Scanner::wait(std::int64_t milliseconds) {
    if (state_.started) state_ = pass_time(std::move(state_), milliseconds);
}

std::string Scanner::scan(const std::vector<std::int64_t>& values) {
    std::vector<std::int64_t> inputs(chart_.variables.size());
    for (std::size_t k = 0; k < inputs_.size(); ++k) inputs[inputs_[k].index] = values[k];
    Cycle result = cycle(chart_, state_, inputs, mode_);
    state_ = std::move(result.state);
    return problem_in(chart_, result);
}

std::vector<std::int64_t> Scanner::outputs() const {
    std::vector<std::int64_t> values;
    for (const Id<Chart::Variable> id : outputs_) values.push_back(state_.outputs[id.index]);
    return values;
}

}  // namespace grafverif
