// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <tuple>

#include "derive/derivation.hpp"
#include "support/messages.hpp"
#include "support/messages_notation.hpp"

namespace grafverif {

namespace {

using Partial = Chart::PartialChart;

class HierarchyBuilder {
public:
    HierarchyBuilder(const Chart& chart, Diagnostics& diagnostics) : chart_(chart), diagnostics_(diagnostics) {}

    std::optional<Hierarchy> build() {
        const std::size_t errors = diagnostics_.errors();
        check_ownership();
        if (diagnostics_.errors() != errors) return {};
        find_root_charts();
        find_stand_ins();
        find_orders();
        sort_root_charts();
        if (diagnostics_.errors() != errors) return {};
        find_initial();
        check_orders();
        if (diagnostics_.errors() != errors) return {};
        return std::move(result_);
    }

private:
    const Partial& partial(Id<Partial> id) const { return chart_.partial_charts[id]; }

    /// Returns the chart that contains the macro-step or enclosing step of `inner`, or an invalid id if `inner` has no
    /// owner.
    Id<Partial> outer(Id<Partial> inner) const {
        const Id<Chart::Step> owner = partial(inner).owner;
        return owner.valid() ? chart_.steps[owner].chart : Id<Partial>{};
    }

    /// Checks that no chart contains itself. Each chart has at most one owner (macro-step or enclosing step).
    /// Therefore, a cycle exists if and only if the path from some chart to the charts of its successive owners reaches
    /// a chart twice.
    void check_ownership() {
        std::vector<std::uint32_t> trail(chart_.partial_charts.size(), Id<Partial>::none);
        for (const Id<Partial> start : chart_.partial_charts.ids())
            for (Id<Partial> at = start; at.valid(); at = outer(at)) {
                if (trail[at.index] == start.index) {
                    diagnostics_.add(messages::enclosing_cycle(partial(at).origin, partial(at).name));
                    return;
                }
                if (trail[at.index] != Id<Partial>::none) break;
                trail[at.index] = start.index;
            }
    }

    void find_root_charts() {
        result_.root_chart.resize(chart_.partial_charts.size());
        for (const Id<Partial> start : chart_.partial_charts.ids()) {
            Id<Partial> root_chart = start;
            while (!result_.root_chart[root_chart.index].valid() &&
                   partial(root_chart).kind == Chart::PartialKind::Expansion)
                root_chart = outer(root_chart);
            if (result_.root_chart[root_chart.index].valid()) root_chart = result_.root_chart[root_chart.index];
            for (Id<Partial> at = start; at != root_chart && !result_.root_chart[at.index].valid(); at = outer(at))
                result_.root_chart[at.index] = root_chart;
            result_.root_chart[root_chart.index] = root_chart;
        }
        result_.region.resize(chart_.partial_charts.size());
        for (const Id<Chart::Step> step : chart_.steps.ids())
            for (Id<Partial> at = chart_.steps[step].chart; at.valid(); at = outer(at)) {
                result_.region[at.index].push_back(step);
                if (partial(at).kind != Chart::PartialKind::Expansion) break;
            }
    }

    void find_stand_ins() {
        // For each macro-step: the entry and the exit step of its expansion.
        std::vector<Id<Chart::Step>> entry(chart_.steps.size()), exit(chart_.steps.size());
        for (const Id<Chart::Step> id : chart_.steps.ids()) {
            const Chart::Step& step = chart_.steps[id];
            if (partial(step.chart).kind != Chart::PartialKind::Expansion) continue;
            if (step.entry) entry[partial(step.chart).owner.index] = id;
            if (step.exit) exit[partial(step.chart).owner.index] = id;
        }
        for (const Id<Chart::Step> id : chart_.steps.ids()) {
            Id<Chart::Step> entered = id, left = id;
            while (entry[entered.index].valid()) entered = entry[entered.index];
            while (exit[left.index].valid()) left = exit[left.index];
            result_.entered.push_back(entered);
            result_.left.push_back(left);
        }
    }

    void find_orders() {
        result_.orders.resize(chart_.partial_charts.size());
        for (const Id<Chart::ForcingOrder> id : chart_.forcing.ids()) {
            const Chart::ForcingOrder& order = chart_.forcing[id];
            std::vector<Id<Chart::Step>> named = order.situation;
            if (order.to == Chart::ForcedTo::Initial)
                for (const Id<Chart::Step> step : result_.region[order.forced.index])
                    if (chart_.steps[step].initial) named.push_back(step);
            std::vector<Id<Chart::Step>> active;
            for (const Id<Chart::Step> step : named) active.push_back(result_.entered[step.index]);
            std::ranges::sort(active);
            const auto repeated = std::ranges::unique(active);
            active.erase(repeated.begin(), repeated.end());
            result_.forced.push_back(std::move(active));
            for (const Id<Partial> inner : chart_.partial_charts.ids())
                if (is_within(inner, order.forced)) result_.orders[inner.index].push_back(id);
        }
    }

    bool is_within(Id<Partial> inner, Id<Partial> region) const {
        while (inner != region && partial(inner).kind == Chart::PartialKind::Expansion) inner = outer(inner);
        return inner == region;
    }

    /// Sorts the root charts by Kahn's algorithm. Charts that the algorithm cannot sort are on a cycle, or depend on a
    /// chart that is on a cycle.
    void sort_root_charts() {
        std::vector<std::vector<Id<Partial>>> below(chart_.partial_charts.size());
        std::vector<std::size_t> waits(chart_.partial_charts.size());
        const auto depend = [&](Id<Partial> lower, Id<Chart::Step> step) {
            const Id<Partial> upper = result_.root_chart[chart_.steps[step].chart.index];
            below[upper.index].push_back(result_.root_chart[lower.index]);
            ++waits[result_.root_chart[lower.index].index];
        };
        for (const Id<Partial> id : chart_.partial_charts.ids())
            if (partial(id).kind == Chart::PartialKind::Enclosed) depend(id, partial(id).owner);
        for (const Chart::ForcingOrder& order : chart_.forcing) depend(order.forced, order.step);
        for (const Id<Partial> id : chart_.partial_charts.ids())
            if (result_.root_chart[id.index] == id && waits[id.index] == 0) result_.order.push_back(id);
        for (std::size_t k = 0; k < result_.order.size(); ++k)
            for (const Id<Partial> lower : below[result_.order[k].index])
                if (--waits[lower.index] == 0) result_.order.push_back(lower);
        for (const Chart::ForcingOrder& order : chart_.forcing) {
            const bool blocked = waits[result_.root_chart[order.forced.index].index] > 0 &&
                                 waits[result_.root_chart[chart_.steps[order.step].chart.index].index] > 0;
            if (!blocked) continue;
            diagnostics_.add(messages::forcing_cycle(order.origin, partial(order.forced).name));
            return;
        }
    }

    /// Determines the initial situation (IEC 60848, rule 1). First, the steps that are declared as initial are active.
    /// Then, in topological order of the charts, the forcing orders of active steps are applied, and the charts whose
    /// enclosing step is inactive are deactivated.
    void find_initial() {
        std::vector<bool>& initial = result_.initial;
        initial.resize(chart_.steps.size());
        for (const Id<Chart::Step> step : chart_.steps.ids())
            if (chart_.steps[step].initial) initial[result_.entered[step.index].index] = true;
        // For each root chart: forcing orders for this chart or its expansions.
        std::vector<std::vector<Id<Chart::ForcingOrder>>> orders(chart_.partial_charts.size());
        for (const Id<Chart::ForcingOrder> id : chart_.forcing.ids())
            orders[result_.root_chart[chart_.forcing[id].forced.index].index].push_back(id);
        for (const Id<Partial> root_chart : result_.order) {
            for (const Id<Chart::ForcingOrder> order : orders[root_chart.index]) force_initial(order);
            const bool enclosed = partial(root_chart).kind == Chart::PartialKind::Enclosed;
            if (enclosed && !initial[partial(root_chart).owner.index])
                for (const Id<Chart::Step> step : result_.region[root_chart.index]) initial[step.index] = false;
            find_initial_macros(root_chart);
        }
    }

    void force_initial(Id<Chart::ForcingOrder> id) {
        const Chart::ForcingOrder& order = chart_.forcing[id];
        if (order.to == Chart::ForcedTo::Current || !result_.initial[order.step.index]) return;
        for (const Id<Chart::Step> step : result_.region[order.forced.index]) result_.initial[step.index] = false;
        for (const Id<Chart::Step> step : result_.forced[id.index]) result_.initial[step.index] = true;
    }

    void find_initial_macros(Id<Partial> root_chart) {
        for (const Id<Chart::Step> step : result_.region[root_chart.index])
            if (chart_.steps[step].kind == Chart::StepKind::Macro) result_.initial[step.index] = false;
        for (const Id<Chart::Step> step : result_.region[root_chart.index]) {
            if (!result_.initial[step.index] || chart_.steps[step].kind == Chart::StepKind::Macro) continue;
            for (Id<Partial> at = chart_.steps[step].chart; at != root_chart; at = outer(at))
                result_.initial[partial(at).owner.index] = true;
        }
    }

    /// Checks each pair of forcing orders that concern the same partial chart.
    void check_orders() {
        for (const Id<Partial> id : chart_.partial_charts.ids()) {
            const std::vector<Id<Chart::ForcingOrder>>& orders = result_.orders[id.index];
            for (std::size_t k = 0; k < orders.size(); ++k)
                for (std::size_t i = 0; i < k; ++i) check_pair(id, orders[i], orders[k]);
        }
    }

    /// Checks two forcing orders that concern `forced`. A conflict is reported only once: for the partial chart that
    /// one of the orders names and that belongs to the region of the other order.
    void check_pair(Id<Partial> forced, Id<Chart::ForcingOrder> one, Id<Chart::ForcingOrder> other) {
        const Chart::ForcingOrder& first = chart_.forcing[one];
        const Chart::ForcingOrder& second = chart_.forcing[other];
        if (first.forced != forced && second.forced != forced) return;
        const bool together =
            first.step == second.step || (result_.initial[first.step.index] && result_.initial[second.step.index]);
        if (!conflict(chart_, result_, one, other)) return;
        if (!together) return check_parallel(first, second);
        if (first.forced == second.forced) {
            diagnostics_.add(messages::forced_twice(second.origin, partial(forced).name, first.origin));
            return;
        }
        // True if `second` names the expansion, and `first` names the chart that contains the expansion.
        const bool own = second.forced == forced;
        const Chart::ForcingOrder& inner = own ? second : first;
        const Chart::ForcingOrder& whole = own ? first : second;
        diagnostics_.add(
            messages::forced_beside(inner.origin, partial(forced).name, partial(whole.forced).name, whole.origin));
    }

    /// Checks two forcing orders of partial charts that evolve in parallel. A conflict is reported only once for each
    /// pair of partial charts.
    void check_parallel(const Chart::ForcingOrder& first, const Chart::ForcingOrder& second) {
        if (first.forced != second.forced || !in_parallel(first.step, second.step)) return;
        const auto key = std::minmax(chart_.steps[first.step].chart.index, chart_.steps[second.step].chart.index);
        if (parallel_.emplace(first.forced.index, key.first, key.second).second)
            diagnostics_.add(messages::forced_differently(second.origin, partial(first.forced).name, first.origin));
    }

    /// True if the two steps may be active simultaneously. The result is false if the steps, or the macro-steps or
    /// enclosing steps that contain them, are different steps of one partial chart, because such steps may exclude each
    /// other.
    bool in_parallel(Id<Chart::Step> one, Id<Chart::Step> other) const {
        for (Id<Chart::Step> above = one; above.valid(); above = partial(chart_.steps[above].chart).owner)
            for (Id<Chart::Step> beyond = other; beyond.valid(); beyond = partial(chart_.steps[beyond].chart).owner)
                if (chart_.steps[above].chart == chart_.steps[beyond].chart) return above == beyond;
        return true;
    }

    const Chart& chart_;
    Diagnostics& diagnostics_;
    Hierarchy result_ = {};
    std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> parallel_ =
        {};  ///< each element contains the forced chart and the two charts that force it
};

}  // namespace

std::optional<Hierarchy> hierarchy(const Chart& chart, Diagnostics& diagnostics) {
    return HierarchyBuilder(chart, diagnostics).build();
}

bool conflict(const Chart& chart, const Hierarchy& hierarchy, Id<Chart::ForcingOrder> one,
              Id<Chart::ForcingOrder> other) {
    const Chart::ForcingOrder& first = chart.forcing[one];
    const Chart::ForcingOrder& second = chart.forcing[other];
    if (first.forced != second.forced) return true;
    const bool held = first.to == Chart::ForcedTo::Current;
    if (held || second.to == Chart::ForcedTo::Current) return first.to != second.to;
    return hierarchy.forced[one.index] != hierarchy.forced[other.index];
}

}  // namespace grafverif
