// SPDX-License-Identifier: MIT
// Computes counterexamples of liveness properties. A counterexample is a short run from the initial state to a state of
// `roots`; from there on, the run stays outside of the set `met`, up to a cycle or up to a state without successors.
//
// A breadth-first traversal outside of `met` determines, for every reached state, a short path from one of the roots. A
// root is added to the traversal at its depth in the search. Then the strongly connected components of the reached
// states are computed. The run ends at the first state of the traversal that is on a cycle or has no successor. If this
// state is on a cycle, a breadth-first search in its component finds a shortest cycle.
#include "check/timed/components.hpp"
#include "check/timed/fixpoints.hpp"

namespace grafverif::timed {

namespace {

constexpr std::uint32_t none = Store::none;

/// The states reached outside of `met`, in the order of the traversal, and the predecessor of each reached state. Each
/// root is its own predecessor.
struct Traversal {
    Column<std::uint32_t> order = {};
    Column<std::uint32_t> from = {};  // predecessor of each state of the graph; none if the state was not reached

    bool has(std::uint32_t state) const { return from[state] != none; }
};

Traversal traverse(Graph& graph, const StateSet& met, const std::vector<std::uint32_t>& roots) {
    Traversal traversal;
    traversal.from.assign(graph.states(), none);
    std::size_t next_root = 0;
    std::size_t done = 0;
    const auto reach = [&](std::uint32_t state, std::uint32_t from) {
        if (traversal.has(state)) return;
        traversal.from[state] = from;
        traversal.order.push_back(state);
    };
    for (std::size_t depth = 0; depth < graph.levels.size() || done < traversal.order.size(); ++depth) {
        for (const std::size_t level = traversal.order.size(); done < level; ++done) {
            const std::uint32_t state = traversal.order[done];
            graph.each(state, [&](std::uint32_t next) {
                if (!met.has(next)) reach(next, state);
            });
        }
        const std::uint32_t end = depth + 1 < graph.levels.size() ? graph.levels[depth + 1] : none;
        for (; next_root < roots.size() && roots[next_root] < end; ++next_root)
            reach(roots[next_root], roots[next_root]);
    }
    return traversal;
}

}  // namespace

Lasso avoiding(Graph& graph, const StateSet& met, const std::vector<std::uint32_t>& roots, bool endless,
               const Limits& limits) {
    const Traversal reached = traverse(graph, met, roots);
    Components components(graph.states(), limits, [&](std::uint32_t state, const auto& take) {
        graph.each(state, [&](std::uint32_t next) {
            if (reached.has(next)) take(next);
        });
    });
    for (std::size_t i = 0; i < reached.order.size(); ++i) components.visit(reached.order[i]);
    for (std::size_t i = 0; i < reached.order.size(); ++i) {
        const std::uint32_t state = reached.order[i];
        const bool stuck = !endless && graph.kind(state) == StateKind::Stuck;
        if (!stuck && !components.has_cycle(state)) continue;
        std::vector<std::uint32_t> tail;
        std::uint32_t now = state;
        for (; reached.from[now] != now; now = reached.from[now]) tail.push_back(now);
        Lasso lasso{.path = graph.path_to(now)};
        lasso.path.insert(lasso.path.end(), tail.rbegin(), tail.rend());
        if (stuck) return lasso;
        lasso.loop = lasso.path.size() - 1;
        const std::vector<std::uint32_t> loop = components.cycle(state);
        lasso.path.insert(lasso.path.end(), loop.begin(), loop.end());
        return lasso;
    }
    return {};
}

}  // namespace grafverif::timed
