// SPDX-License-Identifier: MIT
// Determines the steps that can become active according to the structure of the chart, under the assumption that all
// conditions are satisfiable. Reports the steps that cannot become active.
//
// An initial step is activated at power-on. A transition activates its downstream steps if all its upstream steps can
// be active. A source transition, a forcing order, an activation link or a macro-step can also activate a step.
#include <numeric>
#include <vector>

#include "support/messages.hpp"
#include "syntax/resolve/chart_scope.hpp"

namespace grafverif {

namespace {

class Reach {
public:
    explicit Reach(const Chart& chart) : chart_(&chart), active_(chart.steps.size()), waits_(chart.transitions.size()) {
        downstream_.resize(chart.steps.size());
        links_.resize(chart.steps.size());
        for (const Id<Chart::Transition> id : chart.transitions.ids()) {
            waits_[id.index] = chart.transitions[id].from.size();
            for (const Id<Chart::Step> step : chart.transitions[id].from) downstream_[step.index].push_back(id);
        }
        for (const Id<Chart::Step> id : chart.steps.ids()) {
            const Chart::Step& step = chart.steps[id];
            const Chart::PartialChart& partial = chart.partial_charts[step.chart];
            if ((step.entry || step.activation_link) && partial.owner.valid())
                links_[partial.owner.index].push_back(id);
        }
    }

    std::vector<bool> run() {
        for (const Id<Chart::Step> id : chart_->steps.ids())
            if (chart_->steps[id].initial) activate(id);
        for (const Chart::Transition& transition : chart_->transitions)
            if (transition.from.empty())
                for (const Id<Chart::Step> step : transition.to) activate(step);
        for (const Chart::ForcingOrder& order : chart_->forcing)
            for (const Id<Chart::Step> step : order.situation) activate(step);
        while (!work_.empty()) {
            const Id<Chart::Step> step = work_.back();
            work_.pop_back();
            for (const Id<Chart::Step> linked : links_[step.index]) activate(linked);
            for (const Id<Chart::Transition> id : downstream_[step.index])
                if (--waits_[id.index] == 0)
                    for (const Id<Chart::Step> next : chart_->transitions[id].to) activate(next);
        }
        return active_;
    }

private:
    void activate(Id<Chart::Step> step) {
        if (active_[step.index]) return;
        active_[step.index] = true;
        work_.push_back(step);
    }

    const Chart* chart_;
    std::vector<bool> active_;
    std::vector<std::size_t> waits_;  ///< for each transition: number of upstream steps not yet known to be reachable
    std::vector<std::vector<Id<Chart::Transition>>> downstream_ = {};
    std::vector<std::vector<Id<Chart::Step>>> links_ = {};  ///< for each owning step: the steps that it activates
    std::vector<Id<Chart::Step>> work_ = {};
};

/// Union-find structure of inactive steps: connected steps form one group, and each group is reported once.
class Groups {
public:
    explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
    std::size_t of(std::size_t member) {
        while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
        return member;
    }
    void join(std::size_t one, std::size_t other) {
        const std::size_t a = of(one), b = of(other);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> parent_;
};

/// Returns, for each partial chart, true if none of its steps can become active. Reports the partial chart if it is
/// plain or enclosed, and if it has no owner (macro-step or enclosing step) or its owner can be active.
std::vector<bool> never_started(const Chart& chart, const std::vector<bool>& active, Diagnostics& diagnostics) {
    std::vector<bool> some(chart.partial_charts.size()), alive(some.size()), owner_active(some.size(), true);
    for (const Id<Chart::Step> id : chart.steps.ids()) {
        some[chart.steps[id].chart.index] = true;
        if (active[id.index]) alive[chart.steps[id].chart.index] = true;
    }
    std::vector<bool> reported(some.size());
    for (const Id<Chart::PartialChart> id : chart.partial_charts.ids()) {
        const Chart::PartialChart& partial = chart.partial_charts[id];
        if (!some[id.index] || alive[id.index]) continue;
        reported[id.index] = true;
        if (partial.owner.valid() && !active[partial.owner.index]) continue;
        if (partial.kind == Chart::PartialKind::Enclosed)
            diagnostics.add(messages::no_activation_link(partial.origin, partial.name));
        else if (partial.kind == Chart::PartialKind::Plain)
            diagnostics.add(
                messages::no_initial_step(partial.origin, partial.name.empty() ? chart.name : partial.name));
    }
    return reported;
}

}  // namespace

void check_reachability(const Chart& chart, Diagnostics& diagnostics) {
    const std::vector<bool> active = Reach(chart).run();
    const std::vector<bool> reported = never_started(chart, active, diagnostics);
    Groups groups(chart.steps.size());
    for (const Chart::Transition& transition : chart.transitions) {
        Id<Chart::Step> first;
        const auto join = [&](Id<Chart::Step> step) {
            if (active[step.index]) return;
            if (first.valid()) groups.join(first.index, step.index);
            else first = step;
        };
        for (const Id<Chart::Step> step : transition.from) join(step);
        for (const Id<Chart::Step> step : transition.to) join(step);
    }
    std::vector<std::size_t> sizes(chart.steps.size());
    for (std::size_t step = 0; step < sizes.size(); ++step)
        if (!active[step]) ++sizes[groups.of(step)];
    for (const Id<Chart::Step> id : chart.steps.ids()) {
        const Chart::Step& step = chart.steps[id];
        if (active[id.index] || groups.of(id.index) != id.index || reported[step.chart.index]) continue;
        diagnostics.add(messages::unreachable_step(step.origin, step.name, sizes[id.index] - 1));
    }
}

}  // namespace grafverif
