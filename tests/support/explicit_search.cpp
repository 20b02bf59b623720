// SPDX-License-Identifier: MIT
#include "support/explicit_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace grafverif {

namespace {

using System = TransitionSystem;

StateSet intersection(StateSet left, const StateSet& right) {
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = left[i] && right[i];
    return left;
}

StateSet complement(StateSet set) {
    set.flip();
    return set;
}

bool is_empty(const StateSet& set) { return std::ranges::find(set, true) == set.end(); }

/// Returns the states of `within` from which a path in `within` reaches `goal`, by one backward search.
StateSet leading_to(const SystemGraph& graph, const StateSet& within, const StateSet& goal) {
    std::vector<std::vector<std::size_t>> predecessors(graph.states.size());
    for (std::size_t from = 0; from < graph.states.size(); ++from)
        for (const std::size_t to : graph.successors[from]) predecessors[to].push_back(from);
    StateSet found(graph.states.size());
    std::vector<std::size_t> open;
    const auto meet = [&](std::size_t state) {
        if (!within[state] || found[state]) return;
        found[state] = true;
        open.push_back(state);
    };
    for (std::size_t state = 0; state < goal.size(); ++state)
        if (goal[state]) meet(state);
    while (!open.empty()) {
        const std::size_t state = open.back();
        open.pop_back();
        for (const std::size_t from : predecessors[state]) meet(from);
    }
    return found;
}

/// Returns the strongly connected component of `state` in `within`: the states that reach `state` and are reached from
/// it.
StateSet component_of(const SystemGraph& graph, const StateSet& within, std::size_t state) {
    StateSet one(graph.states.size()), forward(graph.states.size());
    one[state] = true;
    const StateSet backward = leading_to(graph, within, one);
    std::vector<std::size_t> open{state};
    for (forward[state] = true; !open.empty();) {
        const std::size_t from = open.back();
        open.pop_back();
        for (const std::size_t to : graph.successors[from]) {
            if (!within[to] || forward[to]) continue;
            forward[to] = true;
            open.push_back(to);
        }
    }
    return intersection(forward, backward);
}

}  // namespace

std::vector<std::size_t> SystemGraph::distances() const {
    std::vector<std::size_t> result(states.size(), std::numeric_limits<std::size_t>::max()), open;
    for (std::size_t state = 0; state < initial; ++state) {
        result[state] = 0;
        open.push_back(state);
    }
    for (std::size_t i = 0; i < open.size(); ++i)
        for (const std::size_t next : successors[open[i]]) {
            if (result[next] != std::numeric_limits<std::size_t>::max()) continue;
            result[next] = result[open[i]] + 1;
            open.push_back(next);
        }
    return result;
}

std::optional<SystemGraph> explored(const System& system, std::size_t limit, std::size_t most_paths) {
    SystemGraph graph;
    std::map<SystemState, std::size_t> known;
    const auto number = [&](const SystemState& state) {
        const auto [at, added] = known.emplace(state, graph.states.size());
        if (added) graph.states.push_back(state);
        return at->second;
    };
    const auto first = first_states(system, most_paths);
    if (!first) return {};
    for (const SystemState& state : *first) number(state);
    graph.initial = graph.states.size();
    for (std::size_t at = 0; at < graph.states.size(); ++at) {
        if (graph.states.size() > limit) return {};
        const auto next = successors(system, SystemState(graph.states[at]), most_paths);
        if (!next) return {};
        std::set<std::size_t> numbers;
        for (const SystemState& state : *next) numbers.insert(number(state));
        graph.total = graph.total && !numbers.empty();
        graph.successors.emplace_back(numbers.begin(), numbers.end());
    }
    return graph;
}

StateSet where(const SystemGraph& graph, const std::function<bool(const SystemState&)>& holds) {
    StateSet result;
    for (const SystemState& state : graph.states) result.push_back(holds(state));
    return result;
}

std::vector<StateSet> operand_sets(const System& system, const SystemGraph& graph, const Property& property) {
    const auto set_of = [&](Id<Expr> term) {
        return where(graph, [&](const SystemState& state) { return value_of(system, state, term) != 0; });
    };
    std::vector<StateSet> sets;
    for (const Id<Expr> operand : property.operands) sets.push_back(set_of(operand));
    if (property.pattern == Pattern::Always) sets.front().flip();
    if (property.pattern == Pattern::ExactlyOneOf) {
        StateSet broken(graph.states.size());
        for (std::size_t state = 0; state < broken.size(); ++state)
            broken[state] = std::ranges::count_if(sets, [&](const StateSet& set) { return set[state]; }) != 1;
        sets = {broken};
    }
    if (property.at_stable)
        for (StateSet& set : sets) set = intersection(set, set_of(system.settled));
    return sets;
}

std::vector<StateSet> justice_sets(const System& system, const SystemGraph& graph) {
    std::vector<StateSet> sets;
    for (const Id<Expr> term : system.modules[system.main].justice)
        sets.push_back(where(graph, [&](const SystemState& state) { return value_of(system, state, term) != 0; }));
    return sets;
}

StateSet fairly_staying(const SystemGraph& graph, const StateSet& within, const std::vector<StateSet>& justice) {
    StateSet visited(graph.states.size()), good(graph.states.size());
    for (std::size_t state = 0; state < graph.states.size(); ++state) {
        if (!within[state] || visited[state]) continue;
        const StateSet component = component_of(graph, within, state);
        const bool cyclic = std::ranges::count(component, true) > 1 ||
                            std::ranges::find(graph.successors[state], state) != graph.successors[state].end();
        const bool fair = std::ranges::none_of(
            justice, [&](const StateSet& each) { return is_empty(intersection(each, component)); });
        for (std::size_t i = 0; i < component.size(); ++i) {
            visited[i] = visited[i] || component[i];
            good[i] = good[i] || (component[i] && cyclic && fair);
        }
    }
    return leading_to(graph, within, good);
}

bool explicit_verdict(const System& system, const SystemGraph& graph, const Property& property) {
    const std::vector<StateSet> sets = operand_sets(system, graph, property);
    const std::vector<StateSet> justice = justice_sets(system, graph);
    const StateSet all(graph.states.size(), true);
    switch (property.pattern) {
    case Pattern::Always:
    case Pattern::Never:
    case Pattern::ExactlyOneOf: return is_empty(sets[0]);
    case Pattern::Reachable: return !is_empty(sets[0]);
    case Pattern::Inevitable: {
        StateSet bad = fairly_staying(graph, complement(sets[0]), justice);
        bad.resize(graph.initial);
        return is_empty(bad);
    }
    case Pattern::LeadsTo: return is_empty(intersection(sets[0], fairly_staying(graph, complement(sets[1]), justice)));
    case Pattern::AlwaysPossible: {
        const StateSet fair = fairly_staying(graph, all, justice);
        const StateSet dead = complement(leading_to(graph, all, intersection(sets[0], fair)));
        return is_empty(intersection(fair, dead));
    }
    case Pattern::NoDeadlock:
    case Pattern::NoTimelock:
    case Pattern::ReachableAllSteps:
    case Pattern::Watched:
    case Pattern::RawUppaal:
    case Pattern::RawCtl:
    case Pattern::RawLtl: break;
    }
    ADD_FAILURE() << "the explicit search does not support this pattern";
    return false;
}

}  // namespace grafverif
