// SPDX-License-Identifier: MIT
#include "check/timed/fixpoints.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <numeric>

namespace grafverif::timed {

namespace {

/// Performs one sweep over `open`: moves each state for which `decided(state)` is true from `open` to `set`. If
/// `parallel` is true, several threads process ranges of `open` in parallel.
template <class Decided>
void sweep_once(std::vector<std::uint32_t>& open, StateSet& set, bool parallel, const Limits& limits,
                const Decided& decided) {
    const std::size_t parts = parallel ? limits.parts(open.size()) : 1;
    std::vector<std::size_t> ends(parts);  // end of the undecided states of each part
    const auto sweep_part = [&](std::size_t part) {
        std::size_t kept = open.size() * part / parts;
        const std::size_t end = open.size() * (part + 1) / parts;
        for (std::size_t i = kept; i != end; ++i) {
            if (i % Limits::poll_interval == 0 && limits.stopped()) throw Limits::Stop{};
            const std::uint32_t state = open[i];
            if (!decided(state)) open[kept++] = state;
            else if (parts == 1) set.add(state);
            else set.add_concurrently(state);
        }
        ends[part] = kept;
    };
    limits.share(parts, sweep_part);
    std::size_t kept = ends[0];
    for (std::size_t part = 1; part != parts; ++part)
        for (std::size_t i = open.size() * part / parts; i != ends[part]; ++i) open[kept++] = open[i];
    open.resize(kept);
}

/// Sweeps over `open` in alternating directions; each sweep moves the states for which `decided(state)` is true from
/// `open` to `set`. Ends when a sweep moves fewer than 1/`stall` of the states. If `stall` is 0, ends when a sweep
/// moves no state. Returns false if the check was stopped.
template <class Decided>
bool sweep(std::vector<std::uint32_t>& open, StateSet& set, std::size_t stall, bool parallel, const Limits& limits,
           const Decided& decided) {
    std::ranges::reverse(open);
    for (std::size_t before = open.size() + 1; !open.empty();) {
        if (limits.stopped()) return false;
        before = open.size();
        sweep_once(open, set, parallel, limits, decided);
        const std::size_t found = before - open.size();
        if (found == 0 || (stall != 0 && found < before / stall)) break;
        std::ranges::reverse(open);
    }
    if (!std::ranges::is_sorted(open)) std::ranges::reverse(open);
    return true;
}

/// Adds to `set` the states with unknown successors: states that were not expanded, and states with a model error.
void join_open(const Graph& graph, StateSet& set, const Limits& limits) {
    limits.share_states(graph.states(), [&](std::size_t begin, std::size_t end) {
        for (auto state = static_cast<std::uint32_t>(begin); state != end; ++state)
            if (graph.open(state)) set.add(state);
    });
}

/// Returns the states less than `states` that are not in `set`, in increasing order.
std::vector<std::uint32_t> all_but(const StateSet& set, std::size_t states, const Limits& limits) {
    const std::size_t words = (states + 63) / 64;
    const auto bits = [&](std::size_t word) {
        const std::uint64_t all =
            word + 1 == words && states % 64 != 0 ? ~std::uint64_t{0} >> (64 - states % 64) : ~std::uint64_t{0};
        return ~set.bits(word) & all;
    };
    const std::size_t parts = limits.parts(states);
    std::vector<std::size_t> first(parts + 1);  // first index of each part in the result
    limits.share(parts, [&](std::size_t part) {
        std::size_t count = 0;
        for (std::size_t word = words * part / parts; word != words * (part + 1) / parts; ++word)
            count += static_cast<std::size_t>(std::popcount(bits(word)));
        first[part + 1] = count;
    });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::uint32_t> list(first[parts]);
    limits.share(parts, [&](std::size_t part) {
        std::size_t at = first[part];
        for (std::size_t word = words * part / parts; word != words * (part + 1) / parts; ++word)
            for (std::uint64_t rest = bits(word); rest != 0; rest &= rest - 1)
                list[at++] = static_cast<std::uint32_t>(64 * word + static_cast<std::size_t>(std::countr_zero(rest)));
    });
    return list;
}

/// Adds to `set` the states with unknown successors (see join_open). Returns all states that are not in the resulting
/// set.
std::vector<std::uint32_t> undecided(const Graph& graph, StateSet& set, const Limits& limits) {
    join_open(graph, set, limits);
    return all_but(set, graph.states(), limits);
}

constexpr std::size_t most_walkers = 4;  // maximum number of threads of a depth-first walk; each thread stores a path

/// Decides the states that the sweeps leave undecided, by a depth-first walk from the roots. When all successors of a
/// state are in `met`, the walk backtracks from the state and adds the state to `met`. Several threads walk in
/// parallel, from different roots and with different orders of successors. A thread does not enter a state from which
/// another thread has backtracked. Consider a state from which a run avoids `met`: outside of `met`, it leads to a
/// cycle or to a state without successors. No thread ever backtracks from a state of this type. Therefore some thread
/// finds the run, for any distribution of the states to threads.
class DepthFirst {
public:
    DepthFirst(Graph& graph, StateSet& met, const std::vector<std::uint32_t>& roots, const Limits& limits,
               std::size_t walkers)
        : graph_(graph), met_(met), roots_(roots), limits_(limits), walkers_(walkers) {}

    /// Returns true if no run from the roots avoids `met`.
    bool run() {
        limits_.share(walkers_, [&](std::size_t walker) { walk(walker); });
        return !avoided_;
    }

private:
    static constexpr std::uint32_t leaving = 1U << 31U;

    struct Path {
        StateSet states;
        Column<std::uint32_t> stack = {};
        std::uint32_t steps = 0;
        bool in_order = false;  // if true, visits successors in their order; if false, in reverse order
    };

    void walk(std::size_t walker) {
        Path path{.states = StateSet(graph_.states()), .in_order = walker % 2 != 0};
        const std::size_t first = roots_.size() * walker / walkers_;
        for (std::size_t i = 0; i < roots_.size(); ++i) {
            const std::uint32_t root = roots_[(first + i) % roots_.size()];
            if (!met_.has(root) && !walk_from(root, path)) return;
        }
    }

    /// Returns false if this thread or another thread has found a run that avoids `met`.
    bool walk_from(std::uint32_t root, Path& path) {
        Column<std::uint32_t>& stack = path.stack;
        stack.push_back(root);
        while (!stack.empty()) {
            const std::uint32_t top = stack.back();
            stack.pop_back();
            if ((top & leaving) != 0) {
                path.states.remove(top & ~leaving);
                walkers_ == 1 ? met_.add(top & ~leaving) : met_.add_concurrently(top & ~leaving);
                continue;
            }
            if (met_.has(top)) continue;
            if (++path.steps % 4096 == 0) {
                if (avoided_) return false;
                if (limits_.stopped()) throw Limits::Stop{};
            }
            path.states.add(top);
            stack.push_back(top | leaving);
            const std::size_t first = stack.size();
            bool avoids = graph_.kind(top) == StateKind::Stuck;
            graph_.each(top, [&](std::uint32_t next) {
                avoids = avoids || path.states.has(next);
                if (!met_.has(next)) stack.push_back(next);
            });
            if (avoids) {
                avoided_ = true;
                return false;
            }
            if (!path.in_order) continue;
            for (std::size_t low = first, high = stack.size(); low + 1 < high;) std::swap(stack[low++], stack[--high]);
        }
        return true;
    }

    Graph& graph_;
    StateSet& met_;
    const std::vector<std::uint32_t>& roots_;
    const Limits& limits_;
    std::size_t walkers_;
    std::atomic<bool> avoided_ = false;
};

}  // namespace

std::optional<std::vector<std::uint32_t>> out_of_reach(Graph& graph, StateSet& goal, Transitions by,
                                                       const Limits& limits) {
    std::vector<std::uint32_t> open = undecided(graph, goal, limits);
    const auto target_leads = [&](std::uint32_t state) {  // fast test, which reads only the stored target of the state
        const StateKind kind = graph.kind(state);
        const bool has_one = kind == StateKind::Urgent || (kind == StateKind::Acts && by != Transitions::UrgentActions);
        return has_one && goal.has(graph.target(state));
    };
    if (!sweep(open, goal, 0, true, limits, target_leads)) return {};
    std::vector<std::uint32_t> successors;  // successors by urgent edges; only a sequential sweep uses this list
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
    std::vector<std::uint32_t> open = undecided(graph, met, limits);
    if (graph.linked && !sweep(open, met, 16, true, limits, all_lead)) return {};
    open = {};
    if (!graph.linked) return DepthFirst(graph, met, roots, limits, 1).run();
    return DepthFirst(graph, met, roots, limits, std::min(limits.parts(graph.states()), most_walkers)).run();
}

std::optional<std::uint32_t> first_deadlock(const Graph& graph, const std::function<bool(std::uint32_t)>& considered,
                                            const Limits& limits) {
    StateSet alive(graph.states());
    const auto continues = [&](std::uint32_t state) {
        return !graph.open(state) && !alive.has(state) && graph.kind(state) == StateKind::Passes &&
               graph.target(state) != state;
    };
    for (std::uint32_t state = 0; state < graph.explored; ++state) {
        limits.poll();
        std::uint32_t end = state;
        while (continues(end)) end = graph.target(end);
        const bool dead = !graph.open(end) && !alive.has(end) &&
                          (graph.kind(end) == StateKind::Stuck || graph.kind(end) == StateKind::Passes);
        if (dead && considered(state)) return state;
        if (dead) continue;
        for (std::uint32_t now = state; now != end; now = graph.target(now)) alive.add(now);
    }
    return {};
}

}  // namespace grafverif::timed
