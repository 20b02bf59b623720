// SPDX-License-Identifier: MIT
#include "run/hierarchy.hpp"

#include <algorithm>

namespace grafverif {

Levels::Levels(const Chart& chart) : chart_(chart) {
    has_hierarchy_ = !chart.forcing.empty();
    for (const Chart::PartialChart& partial : chart.partial_charts)
        has_hierarchy_ = has_hierarchy_ || partial.owner.valid();
    if (!has_hierarchy_) return;
    entries_.resize(chart.steps.size());
    exits_.resize(chart.steps.size());
    for (const Id<Chart::Step> id : chart.steps.ids()) {
        const Chart::Step& step = chart.steps[id];
        const Chart::PartialChart& partial = chart.partial_charts[step.chart];
        if (partial.kind != Chart::PartialKind::Expansion) continue;
        if (step.entry) entries_[partial.owner.index] = id;
        if (step.exit) exits_[partial.owner.index] = id;
    }
}

Id<Chart::Step> Levels::entry(Id<Chart::Step> step) const {
    while (has_hierarchy_ && entries_[step.index].valid()) step = entries_[step.index];
    return step;
}

Id<Chart::Step> Levels::exit(Id<Chart::Step> step) const {
    while (has_hierarchy_ && exits_[step.index].valid()) step = exits_[step.index];
    return step;
}

/// True if `inner` is `region`, or the expansion of a macro-step that `region` contains directly or through other
/// expansions.
bool Levels::contains(Partial region, Partial inner) const {
    while (inner != region && chart_.partial_charts[inner].kind == Chart::PartialKind::Expansion)
        inner = chart_.steps[chart_.partial_charts[inner].owner].chart;
    return inner == region;
}

bool Levels::is_free(const Chart::Transition& transition, const std::vector<bool>& situation) const {
    if (!has_hierarchy_) return true;
    const Id<Chart::Step> owner = chart_.partial_charts[transition.chart].owner;
    if (transition.from.empty() && owner.valid() && !situation[owner.index]) return false;
    return !holder(transition.chart, situation).valid();
}

Id<Chart::Step> Levels::holder(Partial partial, const std::vector<bool>& situation) const {
    const auto found = std::ranges::find_if(chart_.forcing, [&](const Chart::ForcingOrder& order) {
        return situation[order.step.index] && contains(order.forced, partial);
    });
    return found == chart_.forcing.end() ? Id<Chart::Step>{} : found->step;
}

std::vector<bool> Levels::after(const std::vector<bool>& old, const std::vector<bool>& cleared) const {
    return has_hierarchy_ ? settled(&old, cleared) : cleared;
}

std::vector<bool> Levels::by_hand(const std::vector<bool>& old, Id<Chart::Step> step, bool active) const {
    std::vector<bool> made = old;
    made[entry(step).index] = active;
    for (const Id<Chart::PartialChart> id : chart_.partial_charts.ids())
        if (!active && chart_.partial_charts[id].kind == Chart::PartialKind::Expansion &&
            chart_.partial_charts[id].owner == step)
            clear(id, made);
    return after(old, made);
}

std::vector<bool> Levels::initial() const {
    std::vector<bool> marked(chart_.steps.size());
    for (const Id<Chart::Step> step : chart_.steps.ids())
        if (chart_.steps[step].initial) marked[entry(step).index] = true;
    return has_hierarchy_ ? settled(nullptr, marked) : marked;
}

/// Applies the rules of the hierarchy until the situation no longer changes. The activity of each level depends only on
/// the levels above it, so that each iteration determines at least one further level.
std::vector<bool> Levels::settled(const std::vector<bool>* old, const std::vector<bool>& cleared) const {
    std::vector<bool> now = cleared;
    for (std::size_t level = 0; level <= 2 * chart_.partial_charts.size() + 1; ++level) {
        std::vector<bool> next = round(old, cleared, now);
        if (next == now) break;
        now = std::move(next);
    }
    return now;
}

std::vector<bool> Levels::round(const std::vector<bool>* old, const std::vector<bool>& cleared,
                                const std::vector<bool>& now) const {
    std::vector<bool> next = cleared;
    const auto is_held = [&](Partial partial) {
        return std::ranges::any_of(chart_.forcing, [&](const Chart::ForcingOrder& order) {
            return order.to == Chart::ForcedTo::Current && contains(order.forced, partial) && old != nullptr &&
                   (*old)[order.step.index] && now[order.step.index];
        });
    };
    for (const Id<Chart::Step> id : chart_.steps.ids()) {  // activates the steps with activation links
        const Chart::Step& step = chart_.steps[id];
        const Id<Chart::Step> owner = chart_.partial_charts[step.chart].owner;
        const bool linked = step.activation_link && owner.valid() && old != nullptr;
        const Id<Chart::Step> activated = entry(id);
        if (linked && !(*old)[owner.index] && now[owner.index] && !is_held(chart_.steps[activated].chart))
            next[activated.index] = true;
    }
    for (const Chart::ForcingOrder& order : chart_.forcing)
        if (now[order.step.index] && order.to != Chart::ForcedTo::Current) clear(order.forced, next);
    for (const Chart::ForcingOrder& order : chart_.forcing) {
        if (!now[order.step.index] || order.to == Chart::ForcedTo::Current) continue;
        for (const Id<Chart::Step> step : chart_.steps.ids())
            if (is_named(order, step)) next[entry(step).index] = true;
    }
    for (const Id<Chart::PartialChart> id : chart_.partial_charts.ids()) {
        const Chart::PartialChart& partial = chart_.partial_charts[id];
        if (partial.kind == Chart::PartialKind::Enclosed && !now[partial.owner.index]) clear(id, next);
    }
    for (const Id<Chart::Step> id : chart_.steps.ids())  // a macro-step is active if a step of its expansion is active
        if (chart_.steps[id].kind == Chart::StepKind::Macro) next[id.index] = false;
    for (const Id<Chart::Step> id : chart_.steps.ids()) {
        if (!next[id.index] || chart_.steps[id].kind == Chart::StepKind::Macro) continue;
        const Chart::PartialChart* partial = &chart_.partial_charts[chart_.steps[id].chart];
        for (; partial->kind == Chart::PartialKind::Expansion;
             partial = &chart_.partial_charts[chart_.steps[partial->owner].chart])
            next[partial->owner.index] = true;
    }
    return next;
}

void Levels::clear(Partial region, std::vector<bool>& situation) const {
    for (const Id<Chart::Step> step : chart_.steps.ids())
        if (contains(region, chart_.steps[step].chart)) situation[step.index] = false;
}

bool Levels::is_named(const Chart::ForcingOrder& order, Id<Chart::Step> step) const {
    if (order.to == Chart::ForcedTo::Initial)
        return chart_.steps[step].initial && contains(order.forced, chart_.steps[step].chart);
    return std::ranges::find(order.situation, step) != order.situation.end();
}

Id<Chart::ForcingOrder> Levels::conflict(const std::vector<bool>& situation) const {
    for (const Id<Chart::ForcingOrder> one : chart_.forcing.ids())
        for (const Id<Chart::ForcingOrder> other : chart_.forcing.ids()) {
            const Chart::ForcingOrder& first = chart_.forcing[one];
            const Chart::ForcingOrder& second = chart_.forcing[other];
            if (other >= one || !situation[first.step.index] || !situation[second.step.index]) continue;
            const bool overlap = contains(first.forced, second.forced) || contains(second.forced, first.forced);
            if (overlap && !agree(first, second)) return one;
        }
    return {};
}

/// True if both forcing orders force the same chart into the same situation.
bool Levels::agree(const Chart::ForcingOrder& one, const Chart::ForcingOrder& other) const {
    if (one.forced != other.forced) return false;
    const bool first_holds = one.to == Chart::ForcedTo::Current, second_holds = other.to == Chart::ForcedTo::Current;
    if (first_holds || second_holds) return first_holds && second_holds;
    std::vector<bool> first(chart_.steps.size()), second(chart_.steps.size());
    for (const Id<Chart::Step> step : chart_.steps.ids()) {
        if (is_named(one, step)) first[entry(step).index] = true;
        if (is_named(other, step)) second[entry(step).index] = true;
    }
    return first == second;
}

}  // namespace grafverif
