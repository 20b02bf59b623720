// SPDX-License-Identifier: MIT
#include "check/timed/fixpoints.hpp"

#include <algorithm>

namespace grafverif::timed {

namespace {

/// One sweep over `open`: states that `decided(state)` leave it and join `set`. With `beside`, each thread sweeps a part.
template <class Decided>
void sweep_once(std::vector<std::uint32_t>& open, StateSet& set, bool beside, const Limits& limits,
                const Decided& decided) {
    const std::size_t parts = beside ? limits.parts(open.size()) : 1;
    std::vector<std::size_t> ends(parts);  // of what stays of each part
    const auto sweep_part = [&](std::size_t part) {
        std::size_t kept = open.size() * part / parts;
        const std::size_t end = open.size() * (part + 1) / parts;
        for (std::size_t i = kept; i != end; ++i) {
            if (i % Limits::look_every == 0 && limits.stopped()) throw Limits::Stop{};
            const std::uint32_t state = open[i];
            if (!decided(state)) open[kept++] = state;
            else if (parts == 1) set.add(state);
            else set.add_beside(state);
        }
        ends[part] = kept;
    };
    limits.share(parts, sweep_part);
    std::size_t kept = ends[0];
    for (std::size_t part = 1; part != parts; ++part)
        for (std::size_t i = open.size() * part / parts; i != ends[part]; ++i) open[kept++] = open[i];
    open.resize(kept);
}

/// Sweeps over `open`, alternating in direction, until a sweep decides less than one state in `stall` (none, for 0).
/// `decided(state)` tells whether the state joins. False: stopped.
template <class Decided>
bool sweep(std::vector<std::uint32_t>& open, StateSet& set, std::size_t stall, bool beside, const Limits& limits,
           const Decided& decided) {
    std::ranges::reverse(open);
    for (std::size_t before = open.size() + 1; !open.empty();) {
        if (limits.stopped()) return false;
        before = open.size();
        sweep_once(open, set, beside, limits, decided);
        const std::size_t found = before - open.size();
        if (found == 0 || (stall != 0 && found < before / stall)) break;
        std::ranges::reverse(open);
    }
    if (!std::ranges::is_sorted(open)) std::ranges::reverse(open);
    return true;
}

/// The states looked at that are not in `set`; those of which nothing is known join it.
std::vector<std::uint32_t> undecided(const Graph& graph, StateSet& set) {
    std::size_t count = 0;
    for (std::uint32_t state = 0; state < graph.states(); ++state) {
        if (graph.open(state)) set.add(state);
        if (!set.has(state)) ++count;
    }
    std::vector<std::uint32_t> open;
    open.reserve(count);
    for (std::uint32_t state = 0; state < graph.states(); ++state)
        if (!set.has(state)) open.push_back(state);
    return open;
}

}  // namespace

std::optional<std::vector<std::uint32_t>> out_of_reach(Graph& graph, StateSet& goal, Transitions by,
                                                       const Limits& limits) {
    std::vector<std::uint32_t> open = undecided(graph, goal);
    const auto target_leads = [&](std::uint32_t state) {  // without looking at all successors
        const StateKind kind = graph.kind(state);
        const bool has_one = kind == StateKind::Urgent || (kind == StateKind::Acts && by != Transitions::UrgentActions);
        return has_one && goal.has(graph.target(state));
    };
    if (!sweep(open, goal, 0, true, limits, target_leads)) return {};
    std::vector<std::uint32_t> successors;  // of urgent edges; their sweep is of one thread
    const auto leads = [&](std::uint32_t state) {
        bool found = false;
        const auto look = [&](std::uint32_t next) { found = found || goal.has(next); };
        if (by == Transitions::All) graph.each(state, look);
        if (by == Transitions::Actions) graph.each_action(state, look);
        if (by != Transitions::UrgentActions || graph.kind(state) != StateKind::Urgent) return found;
        graph.urgent_successors(state, successors);
        std::ranges::for_each(successors, look);
        return found;
    };
    if (!sweep(open, goal, 0, graph.linked && by != Transitions::UrgentActions, limits, leads)) return {};
    return open;
}

std::optional<bool> unavoidable(Graph& graph, StateSet& met, const std::vector<std::uint32_t>& roots,
                                const Limits& limits) {
    const auto all_lead = [&](std::uint32_t state) {
        if (graph.kind(state) == StateKind::Stuck) return false;
        bool all = true;
        graph.each(state, [&](std::uint32_t next) { all = all && met.has(next); });
        return all;
    };
    std::vector<std::uint32_t> open = undecided(graph, met);
    if (graph.linked && !sweep(open, met, 16, true, limits, all_lead)) return {};
    open = {};

    // What is left: depth first from the roots. A state is left for good when all its successors are in `met`.
    constexpr std::uint32_t leaving = 1U << 31U;
    StateSet on_path(graph.states());
    Column<std::uint32_t> stack;
    std::uint32_t steps = 0;
    for (const std::uint32_t root : roots) {
        stack.push_back(root);
        while (!stack.empty()) {
            const std::uint32_t top = stack.back();
            stack.pop_back();
            if ((top & leaving) != 0) {
                on_path.remove(top & ~leaving);
                met.add(top & ~leaving);
                continue;
            }
            if (met.has(top)) continue;
            if (++steps % 4096 == 0 && limits.stopped()) return {};
            if (graph.kind(top) == StateKind::Stuck) return false;
            on_path.add(top);
            stack.push_back(top | leaving);
            bool cycle = false;
            graph.each(top, [&](std::uint32_t next) {
                cycle = cycle || on_path.has(next);
                if (!met.has(next)) stack.push_back(next);
            });
            if (cycle) return false;
        }
    }
    return true;
}

std::optional<std::uint32_t> first_deadlock(const Graph& graph, const std::function<bool(std::uint32_t)>& judged,
                                            const Limits& limits) {
    StateSet alive(graph.states());
    const auto goes_on = [&](std::uint32_t state) {
        return !graph.open(state) && !alive.has(state) && graph.kind(state) == StateKind::Passes &&
               graph.target(state) != state;
    };
    for (std::uint32_t state = 0; state < graph.looked_at; ++state) {
        limits.poll();
        std::uint32_t end = state;
        while (goes_on(end)) end = graph.target(end);
        const bool dead = !graph.open(end) && !alive.has(end) &&
                          (graph.kind(end) == StateKind::Stuck || graph.kind(end) == StateKind::Passes);
        if (dead && judged(state)) return state;
        if (dead) continue;
        for (std::uint32_t now = state; now != end; now = graph.target(now)) alive.add(now);
    }
    return {};
}

}  // namespace grafverif::timed
