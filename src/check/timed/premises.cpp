// SPDX-License-Identifier: MIT
// Decides two premises by the cycles of the graph. First, no run has infinitely many moves in one instant if the graph
// has no cycle of edges. Second, time can diverge if a cycle of edges and delays contains a delay. The strongly
// connected components of the graph decide both premises. In most subsystems, some state does not change when time
// passes; such a state decides the second premise without a computation of components.
#include "check/timed/premises.hpp"

#include <optional>
#include <vector>

#include "check/timed/components.hpp"

namespace grafverif::timed {

namespace {

/// Returns the strongly connected components of the graph whose transitions are the edges and, if `delays` is true,
/// also the delays. In this graph, a state with a model error has no successors.
auto components_of(Graph& graph, bool delays, const Limits& limits) {
    Components components(graph.states(), limits, [&graph, delays](std::uint32_t state, const auto& take) {
        if (graph.open(state)) return;
        if (delays) graph.each(state, take);
        else graph.each_action(state, take);
    });
    for (std::uint32_t state = 0; state < graph.states(); ++state) components.visit(state);
    return components;
}

/// Returns a run in which time diverges, or nullopt if no such run exists. The function prefers a run that finally
/// stays in one state.
std::optional<Run> divergent(Graph& graph, const Limits& limits) {
    const auto along = [&](std::uint32_t state, const std::vector<std::uint32_t>& cycle) {
        std::vector<std::uint32_t> path = graph.path_to(state);
        const std::size_t loop = path.size() - 1;
        path.insert(path.end(), cycle.begin(), cycle.end());
        return graph.run_along(path, loop);
    };
    for (std::uint32_t state = 0; state < graph.states(); ++state)
        if (graph.passes(state) && graph.target(state) == state) return along(state, {state});
    auto components = components_of(graph, true, limits);
    for (std::uint32_t state = 0; state < graph.states(); ++state)
        if (graph.passes(state) && components.of(graph.target(state)) == components.of(state))
            return along(state, components.cycle(state, graph.target(state)));
    return {};
}

}  // namespace

Premises premises_of(Graph& graph, std::uint32_t quiescent, const Limits& limits) {
    Premises premises;
    premises.diverges = divergent(graph, limits);
    premises.rests = !components_of(graph, false, limits).any_cycle();
    premises.settles = true;
    for (std::uint32_t state = 0; state < graph.states() && premises.settles; ++state) {
        limits.poll();
        premises.settles = !graph.passes(state) || graph.holds(quiescent, state) == End::Yes;
    }
    return premises;
}

}  // namespace grafverif::timed
