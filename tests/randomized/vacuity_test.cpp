// SPDX-License-Identifier: MIT
// Compares the vacuity checks of all engines, for properties with observers, with a search of the graph of the loop
// without the observer. The search implements the definition of docs/reference/properties.md.
#include "check/vacuity.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <map>

#include "check/portfolio.hpp"
#include "check/symbolic/symbolic.hpp"
#include "check/timed/timed.hpp"
#include "compose/observe.hpp"
#include "schedule/network.hpp"
#include "support/naive_tadd.hpp"
#include "support/random_sentence.hpp"
#include "support/test_size.hpp"
#include "unit/compose/hand_chart.hpp"

namespace grafverif {
namespace {

using Set = std::vector<bool>;

/// Every reachable state of a loop and its successors, by the reference semantics.
struct Graph {
    std::vector<TaddState> states = {};
    std::vector<std::vector<std::size_t>> next = {};

    /// Returns the states reachable from `from` through states of `within` only. States of `from` outside `within` are
    /// excluded.
    Set reached(const Set& from, const Set& within) const {
        Set seen(states.size());
        std::vector<std::size_t> open;
        const auto add = [&](std::size_t state) {
            if (seen[state] || !within[state]) return;
            seen[state] = true;
            open.push_back(state);
        };
        for (std::size_t i = 0; i < states.size(); ++i)
            if (from[i]) add(i);
        while (!open.empty()) {
            const std::size_t state = open.back();
            open.pop_back();
            for (const std::size_t other : next[state]) add(other);
        }
        return seen;
    }
};

/// Returns the graph, or nothing if there are more than `limit` states or the model has an error.
std::optional<Graph> graph_of(const NaiveTadd& tadd, std::size_t limit) {
    Graph graph;
    std::map<TaddState, std::size_t> numbers;
    const auto number = [&](const TaddState& state) {
        const auto [place, fresh] = numbers.emplace(state, graph.states.size());
        if (fresh) graph.states.push_back(state);
        return place->second;
    };
    number(tadd.initial());
    for (std::size_t i = 0; i < graph.states.size(); ++i) {
        if (graph.states.size() > limit) return {};
        if (const Id<Network::Variable> race = tadd.network().race;
            race.valid() && graph.states[i].variables[race.index] != 0)
            return {};
        std::vector<std::size_t> next;
        for (const TaddMove& move : tadd.successors(TaddState(graph.states[i]))) {
            if (move.out_of_range) return {};
            next.push_back(number(move.next));
        }
        graph.next.push_back(std::move(next));
    }
    return graph;
}

/// True if no scope on any run has a state that the property checks.
bool is_vacuous(const NaiveTadd& tadd, const Graph& graph, const Property& property) {
    using Kind = Sentence::Kind;
    using enum Sentence::Scope;
    const Sentence& watch = property.watch;
    const std::size_t size = graph.states.size();
    const auto where = [&](const auto& test) {
        Set set(size);
        for (std::size_t i = 0; i < size; ++i)
            set[i] = (!property.at_stable || tadd.settled(graph.states[i])) && test(graph.states[i]);
        return set;
    };
    const auto holds = [&](std::size_t k) {
        return where([&](const TaddState& state) { return tadd.holds(property.operands[k], state); });
    };
    const auto both = [&](const Set& a, const Set& b) {
        Set set(size);
        for (std::size_t i = 0; i < size; ++i) set[i] = a[i] && b[i];
        return set;
    };
    const auto any = [](const Set& set) { return std::ranges::find(set, true) != set.end(); };

    Set checked = where([](const TaddState&) { return true; });
    if (watch.kind >= Kind::Response) checked = holds(watch.kind == Kind::Precedence ? 1 : 0);
    if (watch.kind == Kind::Recurrence)
        checked = where([&](const TaddState& state) { return !tadd.holds(property.operands[0], state); });
    if (watch.scope == Globally) return !any(checked);

    const Set all(size, true);
    Set starts(size), closing(size);
    if (watch.scope == Before) starts[0] = true;
    else starts = holds(property.operands.size() - (watch.scope == After ? 1 : 2));
    if (watch.scope != After) closing = holds(property.operands.size() - 1);
    Set open = closing;
    open.flip();
    const Set inside = both(graph.reached(starts, open), checked);
    if (watch.scope == After || watch.scope == AfterUntil) return !any(inside);
    const Set later = graph.reached(inside, open);
    for (std::size_t i = 0; i < size; ++i)
        for (const std::size_t next : graph.next[i])
            if (later[i] && closing[next]) return false;
    return true;
}

struct Tally {
    /// Counts of properties that hold, by kind and scope.
    std::map<std::pair<int, int>, std::size_t> vacuous = {}, checked = {};
    std::map<std::pair<std::pair<int, int>, bool>, std::size_t> untimed = {};
    std::size_t violated = 0, by_symbolic = 0, by_pdr = 0, together = 0;
};

/// The verdict on the property. `vacuous` is false if the only reason is that no time passes.
struct Found {
    Outcome outcome = Outcome::Unknown;
    bool vacuous = false;
};
Found found(const Table<Property>& properties, std::vector<Verdict> verdicts) {
    apply_probes(properties, verdicts);
    const Verdict& verdict = *std::ranges::find(verdicts, "S", &Verdict::property);
    Found result{verdict.outcome};
    for (const std::string& note : verdict.notes) {
        if (note.starts_with("vacuity ")) return {};  // the engine was stopped
        result.vacuous = result.vacuous || note.starts_with("the ") || note == "no state is quiescent";
    }
    EXPECT_TRUE(verdict.vacuous || !result.vacuous);
    return result;
}

/// Untimed models with more clocks are not checked, because decision diagrams of many independent clocks are large.
constexpr std::size_t most_clocks = 5;

std::size_t clock_count(const Network& network) {
    std::size_t count = 0;
    for (const Network::Process& process : network.processes)
        count += network.templates[process.automaton].clocks.size();
    return count;
}

void check_untimed(Model model, const Network& watched, const Property& property, bool vacuous, Tally& tally) {
    model.loops[{0}].properties = {};
    model.loops[{0}].properties.add({.name = "S", .pattern = Pattern::Watched, .watch = property.watch});
    Diagnostics diagnostics;
    const auto system = schedule_network(model, model.loops[{0}], derived(model).value(), watched,
                                         {.plant = PlantApproach::Automata, .time = TimeModel::Discrete}, diagnostics);
    if (!system) return;
    ASSERT_EQ(verify(*system), std::vector<std::string>{});
    const auto compare = [&](const char* engine, const std::vector<Verdict>& verdicts, std::size_t& count) {
        const Found here = found(system->properties, verdicts);
        if (here.outcome == Outcome::Unknown) return;
        EXPECT_EQ(here.outcome, Outcome::Holds) << engine;
        EXPECT_EQ(here.vacuous, vacuous) << engine;
        ++count;
    };
    compare("symbolic", check_symbolic(*system).verdicts, tally.by_symbolic);
    if (tally.together >= static_cast<std::size_t>(test_size(20))) return;
    // PDR does not always terminate for clocks in discrete time. The test ignores properties that PDR does not decide
    // within the time limit.
    PdrOptions pdr;
    pdr.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(1);
    compare("pdr", check_pdr(*system, pdr).verdicts, tally.by_pdr);
    compare("auto", check_together(*system).verdicts, tally.together);
}

void compare(const Model& model, const NaiveTadd& tadd, const Graph& graph, const Property& property, Tally& tally) {
    const Network watched = observed(tadd.network(), {{0}}, Vacuity::Probed);
    const TimedResult timed = check_timed(watched, {.timelock = false});
    const Found here = found(watched.properties, timed.verdicts);
    if (here.outcome == Outcome::Unknown) return;
    const bool vacuous = is_vacuous(tadd, graph, property);
    if (here.outcome == Outcome::Violated) {
        // If r holds in the first state, the scope before r is empty, and `inevitable p before r` is violated.
        const bool empty =
            property.watch.kind == Sentence::Kind::Existence && property.watch.scope == Sentence::Scope::Before;
        EXPECT_TRUE(!vacuous || empty);
        ++tally.violated;
        return;
    }
    EXPECT_EQ(here.vacuous, vacuous);
    const std::pair form{static_cast<int>(property.watch.kind), static_cast<int>(property.watch.scope)};
    ++(vacuous ? tally.vacuous : tally.checked)[form];
    // For slower engines, the test compares each form of property only once.
    std::size_t& untimed = tally.untimed[{form, vacuous}];
    if (untimed >= static_cast<std::size_t>(test_size(1))) return;
    if (timed.states >= 600 || clock_count(watched) > most_clocks) return;
    ++untimed;
    check_untimed(model, watched, property, vacuous, tally);
}

TEST(RandomizedVacuity, EveryEngineMarksVacuousProperties) {
    Tally tally;
    for (int seed = 1; seed <= test_size(60); ++seed) {
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop(random);
        Diagnostics diagnostics;
        for (const Chart& chart : model.charts) derive(chart, diagnostics);
        if (diagnostics.has_errors()) continue;
        Network network = composed(model);
        const NaiveTadd tadd(network);
        const std::optional<Graph> graph = graph_of(tadd, 600);
        if (!graph) continue;
        for (int requested = 0; requested < 40; ++requested) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", sentence " + std::to_string(requested));
            const Property property = random_sentence(network, random).property;
            network.properties = {};
            network.properties.add(property);
            compare(model, tadd, *graph, property, tally);
            if (HasFailure()) {
                std::cout << "kind " << static_cast<int>(property.watch.kind) << ", scope "
                          << static_cast<int>(property.watch.scope) << (property.at_stable ? ", at stable" : "")
                          << '\n';
                return;
            }
        }
    }
    std::map<int, std::pair<std::size_t, std::size_t>> kinds, scopes;
    std::size_t vacuous = 0, checked = 0;
    for (const auto& [of, count] : tally.vacuous)
        vacuous += count, kinds[of.first].first += count, scopes[of.second].first += count;
    for (const auto& [of, count] : tally.checked)
        checked += count, kinds[of.first].second += count, scopes[of.second].second += count;
    std::cout << vacuous << " vacuous, " << checked << " not vacuous, " << tally.violated << " violated; symbolic "
              << tally.by_symbolic << ", pdr " << tally.by_pdr << ", auto " << tally.together << '\n';
    EXPECT_EQ(kinds.size(), 10U);
    EXPECT_EQ(scopes.size(), 5U);
    for (const auto* counts : {&kinds, &scopes})
        for (const auto& [of, both] : *counts) {
            EXPECT_GT(both.first, 0U) << of;
            EXPECT_GT(both.second, 0U) << of;
        }
    EXPECT_GT(tally.by_symbolic, 0U);
    EXPECT_GT(tally.by_pdr, 0U);
    EXPECT_GT(tally.together, 0U);
}

}  // namespace
}  // namespace grafverif
