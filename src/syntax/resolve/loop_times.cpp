// SPDX-License-Identifier: MIT
// Resolves time conditions in properties. A property creates no timer. Therefore a time condition in a property, such
// as `3s/X2`, must also occur in a transition or a delayed action of a chart of the loop. The time
// condition reads the timer of this chart, which also appears in traces.
#include <algorithm>
#include <string>
#include <vector>

#include "ir/time_condition.hpp"
#include "support/messages.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/chart.hpp"
#include "syntax/resolve/loop_scope.hpp"

namespace grafverif {

namespace {

using Controller = ClosedLoop::Controller;

struct Times {
    std::int64_t rise_ms = 0, fall_ms = 0;
    bool operator==(const Times&) const = default;
};

std::string text_of(const Times& times) { return '`' + time_text(times.rise_ms, "...", times.fall_ms) + '`'; }

/// True if the leaf of the chart of `controller` denotes `symbol`.
bool is(const LoopScope& scope, Id<Controller> controller, const Expr& leaf, const ClosedLoop::Symbol& symbol) {
    const auto index = static_cast<std::uint32_t>(leaf.value);
    const Chart& chart = scope.chart(controller);
    if (const auto* step = std::get_if<ClosedLoop::StepSymbol>(&symbol))
        return leaf.op == Op::Step && step->controller == controller && step->step.index == index;
    if (leaf.op != Op::Variable) return false;
    if (const auto* internal = std::get_if<ClosedLoop::InternalSymbol>(&symbol))
        return internal->controller == controller && internal->variable.index == index;
    const auto* shared = std::get_if<ClosedLoop::SharedSymbol>(&symbol);
    return shared != nullptr && chart.variables[{index}].kind != Chart::VariableKind::Internal &&
           scope.loop.shared[shared->shared].name == chart.variables[{index}].name;
}

/// True if the term `of_controller` of a chart is equal to the term `own` of the loop.
bool same(const LoopScope& scope, Id<Controller> controller, Id<Expr> of_controller, Id<Expr> own) {
    const Exprs& of_chart = scope.chart(controller).exprs;
    const Expr &left = of_chart[of_controller], &right = scope.loop.exprs[own];
    if (is_leaf(right.op))
        return is(scope, controller, left, scope.loop.symbols[{static_cast<std::uint32_t>(right.value)}]);
    return left.op == right.op && left.value == right.value &&
           std::ranges::equal(of_chart.operands(left), scope.loop.exprs.operands(right),
                              [&](Id<Expr> one, Id<Expr> other) { return same(scope, controller, one, other); });
}

/// A timer of a chart, and its durations.
struct Timer {
    ClosedLoop::TimeSymbol symbol = {};
    Times times = {};
};

/// Returns the timers of the charts that observe the term `watched`. Timers of one chart with the same durations are
/// returned once.
std::vector<Timer> timers_over(const LoopScope& scope, Id<Expr> watched) {
    std::vector<Timer> found;
    for (const Id<Controller> controller : scope.loop.controllers.ids()) {
        const Chart& chart = scope.chart(controller);
        const auto add = [&](const ClosedLoop::TimeSymbol& symbol, Times times) {
            const auto is_same = [&](const Timer& one) {
                return one.symbol.controller == controller && one.times == times;
            };
            if (std::ranges::none_of(found, is_same)) found.push_back({symbol, times});
        };
        const std::vector<bool> read = read_terms(chart).time_conditions;
        for (const Id<Chart::TimeCondition> id : chart.time_conditions.ids()) {
            const Chart::TimeCondition& time = chart.time_conditions[id];
            if (read[id.index] && same(scope, controller, time.watched, watched))
                add({.controller = controller, .condition = id}, {time.rise_ms, time.fall_ms});
        }
        const Expr& leaf = scope.loop.exprs[watched];
        if (!is_leaf(leaf.op)) continue;
        const auto* step = std::get_if<ClosedLoop::StepSymbol>(
            &scope.loop.symbols[Id<ClosedLoop::Symbol>{static_cast<std::uint32_t>(leaf.value)}]);
        if (step == nullptr || step->controller != controller) continue;
        for (const Chart::ContinuousAction& action : chart.continuous) {
            if (action.step != step->step) continue;
            for (const auto& [counts, after] : {std::pair(action.delay_ms > 0, action.delay_ms),
                                                std::pair(action.limit_ms > 0, action.delay_ms + action.limit_ms)})
                if (counts) add({.controller = controller, .step = action.step, .rise_ms = after}, {after, 0});
        }
    }
    return found;
}

}  // namespace

std::optional<Term> time_term(LoopScope& scope, const tree::Expr& node) {
    const WrittenTime written = written_time(scope.file, node);
    if (!written.watched.valid()) return {};
    const Times times{milliseconds(scope.file, written.rise, scope.diagnostics),
                      milliseconds(scope.file, written.fall, scope.diagnostics)};
    const bool wrong = (written.rise.valid() && times.rise_ms == 0) || (written.fall.valid() && times.fall_ms == 0);
    const Id<Expr> watched = property_terms(scope).resolve(written.watched, TermKind::Boolean, "a time condition");
    if (!watched.valid() || wrong || scope.record.beyond_errors()) return Term{};
    std::vector<Timer> found;
    std::vector<std::string> others;
    for (const Timer& timer : timers_over(scope, watched)) {
        if (timer.times == times) found.push_back(timer);
        else others.push_back(text_of(timer.times));
    }
    if (found.size() > 1) {
        const auto name = [&](const Timer& timer) { return scope.loop.controllers[timer.symbol.controller].name; };
        scope.diagnostics.add(messages::ambiguous_time(node.where, name(found[0]), name(found[1])));
    } else if (found.empty()) scope.diagnostics.add(messages::unknown_time(node.where, others));
    if (found.size() != 1) return Term{};
    const Id<Expr> end = symbol_leaf(scope, found.front().symbol);
    return Term{time_condition(scope.loop.exprs, times.rise_ms, watched, times.fall_ms, end), TermKind::Boolean};
}

}  // namespace grafverif
