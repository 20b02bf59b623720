// SPDX-License-Identifier: MIT
#include "plant/time_unit.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <ranges>
#include <variant>
#include <vector>

#include "support/messages.hpp"

namespace grafverif {

namespace {

constexpr std::int64_t many_units = 10'000;
// Maximum constant that UPPAAL can compare with a clock.
constexpr std::int64_t most_units = std::int64_t{1} << 30U;

struct Duration {
    std::int64_t milliseconds = 0;
    Span where = {};
};

void collect(const Exprs& exprs, Id<Expr> root, Span where, std::vector<Duration>& found) {
    if (exprs[root].op == Op::Duration) found.push_back({exprs[root].value, where});
    for (const Id<Expr> operand : exprs.operands(root)) collect(exprs, operand, where, found);
}

/// Collects the durations in the body of a component. The other overload of `collect` collects the default values of
/// parameters, as arguments of instances.
void collect(const Component& component, std::vector<Duration>& found) {
    const auto take = [&](Id<Expr> root, Span where) { collect(component.exprs, root, where, found); };
    for (const Component::Location& location : component.locations)
        for (const Component::ClockConstraint& bound : location.invariant) take(bound.bound, bound.origin);
    for (const Component::Edge& edge : component.edges) {
        take(edge.guard, edge.origin);
        for (const Component::ClockConstraint& bound : edge.constraint) take(bound.bound, bound.origin);
        for (const Component::Assignment& assignment : edge.assignments) take(assignment.value, assignment.origin);
    }
}

void collect(const Component& component, const ClosedLoop::Instance& instance, std::vector<Duration>& found) {
    for (const Id<Component::Parameter> parameter : component.parameters.ids()) {
        const auto* value = std::get_if<std::int64_t>(&instance.arguments[parameter.index]);
        if (value && component.parameters[parameter].value == Component::ValueKind::Duration)
            found.push_back({*value, instance.origin});
    }
}

std::vector<Duration> durations(const Model& model, const ClosedLoop& loop) {
    std::vector<Duration> found;
    std::vector<bool> seen(model.components.size());
    for (const ClosedLoop::Instance& instance : loop.instances) {
        const Component& component = model.components[instance.component];
        if (!seen[instance.component.index]) collect(component, found);
        seen[instance.component.index] = true;
        collect(component, instance, found);
    }
    const auto take = [&](std::int64_t milliseconds, Span where) {
        if (milliseconds != 0) found.push_back({milliseconds, where});
    };
    for (const ClosedLoop::Controller& controller : loop.controllers) {
        if (controller.cycle) {
            take(controller.cycle->least_ms, controller.cycle->origin);
            take(controller.cycle->most_ms, controller.cycle->origin);
        }
        const Chart& chart = model.charts[controller.chart];
        for (const Chart::TimeCondition& condition : chart.time_conditions) {
            take(condition.rise_ms, condition.origin);
            take(condition.fall_ms, condition.origin);
        }
        for (const Chart::ContinuousAction& action : chart.continuous) {
            take(action.delay_ms, action.origin);
            if (action.limit_ms != 0) take(action.delay_ms + action.limit_ms, action.origin);
        }
    }
    for (const Property& property : loop.properties) take(property.watch.duration_ms, property.origin);
    return found;
}

/// Returns the greatest common divisor of all durations; 0 if there are no durations.
std::int64_t common_divisor(const std::vector<Duration>& all) {
    std::int64_t divisor = 0;
    for (const Duration& duration : all) divisor = std::gcd(divisor, duration.milliseconds);
    return divisor;
}

/// Returns, for each distinct duration, the greatest common divisor of all other durations.
std::map<std::int64_t, std::int64_t> divisors_without(const std::vector<Duration>& all) {
    std::map<std::int64_t, std::int64_t> without;
    for (const Duration& duration : all) without.emplace(duration.milliseconds, 0);
    std::int64_t before = 0, after = 0;
    for (auto& [length, divisor] : without) {
        divisor = before;
        before = std::gcd(before, length);
    }
    for (auto& [length, divisor] : without | std::views::reverse) {
        divisor = std::gcd(divisor, after);
        after = std::gcd(after, length);
    }
    return without;
}

}  // namespace

std::optional<std::int64_t> time_unit(const Model& model, const ClosedLoop& loop, Diagnostics& diagnostics) {
    const std::vector<Duration> all = durations(model, loop);
    std::int64_t unit = common_divisor(all);
    if (unit == 0) unit = 1000;
    const std::size_t errors = diagnostics.errors();
    if (loop.time_unit_ms) {
        unit = *loop.time_unit_ms;
        for (const Duration& duration : all)
            if (duration.milliseconds % unit != 0)
                diagnostics.add(messages::no_multiple_of_time_unit(duration.where, duration.milliseconds, unit));
    }
    if (diagnostics.errors() != errors || all.empty())
        return diagnostics.errors() == errors ? std::optional(unit) : std::nullopt;

    const Duration longest = *std::ranges::max_element(all, {}, &Duration::milliseconds);
    const std::int64_t units = longest.milliseconds / unit;
    if (units > most_units) {
        diagnostics.add(messages::duration_too_long(longest.where, longest.milliseconds, unit));
        return {};
    }
    if (units > many_units) diagnostics.add(messages::many_time_units(longest.where, longest.milliseconds, unit));
    return unit;
}

std::optional<StateProfile::Finest> finest_duration(const Model& model, const ClosedLoop& loop) {
    const std::vector<Duration> all = durations(model, loop);
    const std::int64_t divisor = common_divisor(all);
    if (loop.time_unit_ms && divisor > *loop.time_unit_ms)
        return StateProfile::Finest{0, *loop.time_unit_ms, divisor, {}, loop.time_unit_origin, {}};
    std::optional<StateProfile::Finest> found;
    if (loop.time_unit_ms) return found;
    const std::map<std::int64_t, std::int64_t> divisors = divisors_without(all);
    for (const Duration& duration : all) {
        const std::int64_t without = divisors.at(duration.milliseconds);
        if (without > (found ? found->coarser_ms : divisor))
            found = StateProfile::Finest{duration.milliseconds, divisor, without, {}, duration.where, {}};
    }
    return found;
}

}  // namespace grafverif
