// SPDX-License-Identifier: MIT
#include "run/reader.hpp"

#include <algorithm>
#include <utility>

namespace grafverif {

namespace {

bool is_edge(Op op) { return op == Op::Rise || op == Op::Fall; }

}  // namespace

Memory memory(const Chart& chart) {
    Memory result;
    bool edges = false;
    for (std::uint32_t index = 0; index < chart.exprs.size() && !edges; ++index)
        edges = is_edge(chart.exprs[Id<Expr>{index}].op);
    if (!edges && chart.time_conditions.empty()) return result;
    const ReadTerms read = read_terms(chart);
    result.time_conditions = read.time_conditions;
    if (!edges) return result;
    result.places.resize(chart.exprs.size());
    for (std::uint32_t index = 0; index < chart.exprs.size(); ++index) {
        const Expr& node = chart.exprs[Id<Expr>{index}];
        if (read.terms[index] && is_edge(node.op)) result.edges.push_back(chart.exprs.operands(node)[0]);
    }
    std::ranges::sort(result.edges);
    const auto repeated = std::ranges::unique(result.edges);
    result.edges.erase(repeated.begin(), repeated.end());
    for (std::uint32_t place = 0; place < result.edges.size(); ++place)
        result.places[result.edges[place].index] = place;
    return result;
}

std::optional<std::int64_t> Reader::value(Id<Expr> term) {
    // `value` is called recursively: a term can read an output whose actions have conditions. The old value of
    // `undefined_` belongs to the enclosing term.
    const bool outer = std::exchange(undefined_, false);
    const auto result = evaluate(chart_.exprs, term, [this](const Expr& leaf) { return leaf_value(leaf); });
    const bool is_undefined = std::exchange(undefined_, outer);
    return is_undefined ? std::nullopt : result;
}

std::optional<std::int64_t> Reader::output(Id<Chart::Variable> output) {
    if (known_.empty()) index_actions();
    Known& known = known_[output.index];
    if (known != Known::No)
        return known == Known::Undefined ? std::nullopt : std::optional(std::int64_t{known == Known::True});
    const std::optional<std::int64_t> result = look_up(output);
    known = !result ? Known::Undefined : *result != 0 ? Known::True : Known::False;
    return result;
}

bool Reader::is_stored(Id<Chart::Variable> variable) {
    if (known_.empty()) index_actions();
    return stored_[variable.index];
}

std::int64_t Reader::leaf_value(const Expr& leaf) {
    const auto index = static_cast<std::size_t>(leaf.value);
    if (is_edge(leaf.op)) return edge_value(leaf);
    if (leaf.op == Op::Step) return state_.situation[index];
    if (leaf.op == Op::Timed) return time_value(index);
    return variable_value({static_cast<std::uint32_t>(index)});
}

std::int64_t Reader::variable_value(Id<Chart::Variable> variable) {
    const Chart::VariableKind kind = chart_.variables[variable].kind;
    if (kind == Chart::VariableKind::Input) return inputs_[variable.index];
    if (kind == Chart::VariableKind::Internal || is_stored(variable)) return state_.values[variable.index];
    const std::optional<std::int64_t> set = output(variable);
    undefined_ = undefined_ || !set;
    return set.value_or(0);
}

/// Returns the value of a rising or falling edge: true in the first evolution after the change of its operand.
std::int64_t Reader::edge_value(const Expr& edge) {
    if (memory_ == nullptr) return 0;
    const Id<Expr> operand = chart_.exprs.operands(edge)[0];
    const std::optional<std::int64_t> now = value(operand);
    undefined_ = undefined_ || !now;
    const bool before = state_.previous[memory_->places[operand.index]];
    return edge.op == Op::Rise ? !before && now.value_or(0) != 0 : before && now.value_or(1) == 0;
}

/// Returns the value of the time condition `t1/v/t2`. The stored timing refers to the value of v after the last
/// evolution, and v may have changed since then. Without t2, the condition becomes false immediately when v becomes
/// false. Without t1, the condition becomes true immediately when v becomes true.
std::int64_t Reader::time_value(std::size_t index) {
    const Chart::TimeCondition& timed = chart_.time_conditions[{static_cast<std::uint32_t>(index)}];
    const bool over = timed_[index];
    if (timed.rise_ms > 0 && timed.fall_ms > 0) return over;
    if (over == (timed.fall_ms > 0)) return over;
    const std::optional<std::int64_t> now = value(timed.watched);
    undefined_ = undefined_ || !now;
    return now.value_or(0);
}

std::optional<std::int64_t> Reader::look_up(Id<Chart::Variable> output) {
    if (!chart_.variables[output].type.boolean) return state_.values[output.index];
    for (const Id<Chart::ContinuousAction> id : actions_[output.index]) {
        const Chart::ContinuousAction& action = chart_.continuous[id];
        if (!state_.situation[action.step.index]) continue;
        const std::optional<std::int64_t> condition = value(action.condition);
        if (!condition) return condition;
        if (*condition != 0 && in_time(id)) return 1;
    }
    return 0;
}

/// For an action whose step is active: true if its delay has elapsed and its time limit has not elapsed.
bool Reader::in_time(Id<Chart::ContinuousAction> id) const {
    const Chart::ContinuousAction& action = chart_.continuous[id];
    std::size_t place = first_time_[id.index];
    if (action.delay_ms > 0 && !timed_[place++]) return false;
    return action.limit_ms == 0 || !timed_[place];
}

void Reader::index_actions() {
    known_.assign(chart_.variables.size(), Known::No);
    stored_.assign(chart_.variables.size(), false);
    actions_.resize(chart_.variables.size());
    for (const Chart::StoredAction& action : chart_.stored) stored_[action.target.index] = true;
    std::size_t place = chart_.time_conditions.size();
    for (const Id<Chart::ContinuousAction> id : chart_.continuous.ids()) {
        const Chart::ContinuousAction& action = chart_.continuous[id];
        actions_[action.output.index].push_back(id);
        first_time_.push_back(place);
        place += (action.delay_ms > 0 ? 1U : 0U) + (action.limit_ms > 0 ? 1U : 0U);
    }
}

}  // namespace grafverif
