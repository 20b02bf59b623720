// SPDX-License-Identifier: MIT
// Compares the symbolic engine with an explicit search on random systems and on the controllers of random loops. The
// faults, the verdicts and the number of states must be equal, and every run must be valid and of minimal length.
#include "check/symbolic/symbolic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "report/trace_rows.hpp"
#include "run/project.hpp"
#include "run/replay.hpp"
#include "schedule/controller.hpp"
#include "support/derived.hpp"
#include "support/explicit_search.hpp"
#include "support/random_chart.hpp"
#include "support/random_loop.hpp"
#include "support/random_system.hpp"
#include "support/test_size.hpp"
#include "support/untimed_loop.hpp"

namespace grafverif {
namespace {

using System = TransitionSystem;

/// True if a symbol of the main module is a state variable of this module or of an instance. Any other symbol may
/// depend on a choice, which the graph does not store.
bool is_state(const System& system, const System::Symbol& symbol) {
    if (const auto* member = std::get_if<System::MemberSymbol>(&symbol.kind)) {
        const Id<System::Module> module = system.instances[member->instance].module;
        return std::holds_alternative<System::StateSymbol>(system.modules[module].symbols[member->symbol].kind);
    }
    return std::holds_alternative<System::StateSymbol>(symbol.kind);
}

/// Returns the states of a graph that agree with `seen` in the state variables of the main module, and in those state
/// variables of instances that the main module names.
StateSet looking_like(const System& system, const SystemGraph& graph, const std::vector<std::int64_t>& seen) {
    const Table<System::Symbol>& symbols = system.modules[system.main].symbols;
    return where(graph, [&](const SystemState& state) {
        return std::ranges::all_of(symbols.ids(), [&](Id<System::Symbol> id) {
            return !is_state(system, symbols[id]) || value_of(system, state, symbols[id].name) == seen[id.index];
        });
    });
}

StateSet successors(const SystemGraph& graph, const StateSet& states) {
    StateSet next(states.size());
    for (std::size_t state = 0; state < states.size(); ++state)
        for (const std::size_t to : graph.successors[state]) next[to] = next[to] || states[state];
    return next;
}

StateSet both(StateSet left, const StateSet& right) {
    for (std::size_t i = 0; i < left.size(); ++i) left[i] = left[i] && right[i];
    return left;
}

bool any(const StateSet& set) { return std::ranges::find(set, true) != set.end(); }

/// Returns the possible last states of `run` in the graph. The set is empty if `run` is not a run.
StateSet ends(const System& system, const SystemGraph& graph, const SystemRun& run) {
    StateSet here(graph.states.size());
    std::fill_n(here.begin(), graph.initial, true);
    StateSet at_loop;
    for (std::size_t i = 0; i < run.states.size(); ++i) {
        here = both(i == 0 ? here : successors(graph, here), looking_like(system, graph, run.states[i]));
        if (i == run.loop) at_loop = here;
    }
    if (run.loop && !any(both(successors(graph, here), at_loop))) return StateSet(graph.states.size());
    return here;
}

void expect_shown(const System& system, const SystemGraph& graph, const Property& property, const SystemRun& run) {
    const StateSet end = ends(system, graph, run);
    ASSERT_TRUE(any(end)) << "it is not a run of the system";
    const std::vector<StateSet> sets = operand_sets(system, graph, property);
    if (property.pattern == Pattern::Inevitable || property.pattern == Pattern::LeadsTo) {
        ASSERT_TRUE(run.loop);
        return;
    }
    EXPECT_FALSE(run.loop);
    if (property.pattern == Pattern::AlwaysPossible) return;
    EXPECT_TRUE(any(both(end, sets[0]))) << "the run does not prove the verdict";
    const std::vector<std::size_t> distances = graph.distances();
    std::size_t least = graph.states.size();
    for (std::size_t state = 0; state < sets[0].size(); ++state)
        if (sets[0][state]) least = std::min(least, distances[state]);
    EXPECT_EQ(run.states.size() - 1, least) << "there is a shorter run";
}

struct Compared {
    std::size_t systems = 0, states = 0, verdicts = 0, faults = 0, violated = 0;
    std::size_t saturated = 0;  ///< cases with fewer rounds than the greatest distance of a state
};

/// The tested options: breadth-first search alone, and event clusters from the first state on.
const SymbolicOptions plain{.by_kind = false}, by_kind{.one_by_one = 0};

void compare(const System& system, std::size_t limit, Compared& compared, const SymbolicOptions& options) {
    ASSERT_EQ(verify(system), std::vector<std::string>{});
    const std::optional<SystemGraph> graph = explored(system, limit);
    if (!graph) return;
    const SymbolicResult result = check_symbolic(system, options);
    ++compared.systems;
    ASSERT_EQ(result.fault.has_value(), graph->initial == 0 || !graph->total);
    if (result.fault) {
        ++compared.faults;
        EXPECT_EQ(result.fault->kind == SystemFault::Kind::NoInitialState, graph->initial == 0);
        for (const Verdict& verdict : result.verdicts) EXPECT_EQ(verdict.obstacle, UnknownReason::Faulty);
        return;
    }
    ASSERT_EQ(result.states, std::to_string(graph->states.size()));
    if (!options.by_kind) {
        EXPECT_EQ(result.depth, std::ranges::max(graph->distances()));
    }
    if (result.depth < std::ranges::max(graph->distances())) ++compared.saturated;
    ASSERT_EQ(result.verdicts.size(), system.properties.size());
    compared.states += graph->states.size();
    for (const Id<Property> id : system.properties.ids()) {
        const Property& property = system.properties[id];
        SCOPED_TRACE(property.name);
        const Verdict& verdict = result.verdicts[id.index];
        if (verdict.obstacle == UnknownReason::Unsupported) continue;
        const bool expected = explicit_verdict(system, *graph, property);
        ASSERT_EQ(verdict.outcome, expected ? Outcome::Holds : Outcome::Violated);
        ++compared.verdicts;
        if (!expected) ++compared.violated;
        const bool shown = property.pattern == Pattern::Reachable ? expected : !expected;
        ASSERT_EQ(result.runs[id.index].has_value(), shown);
        if (shown) expect_shown(system, *graph, property, *result.runs[id.index]);
    }
}

void print(const Compared& compared) {
    std::cout << compared.systems << " systems, " << compared.states << " states, " << compared.verdicts
              << " verdicts, " << compared.violated << " of them violated, " << compared.faults << " faults, "
              << compared.saturated << " saturated\n";
}

TEST(RandomizedSymbolic, AgreesWithAnExplicitSearchOnRandomSystems) {
    Compared compared;
    for (int seed = 1; seed <= test_size(300); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        System system = random_system(random);
        ask_more(system, random);
        compare(system, 400, compared, plain);
        compare(system, 400, compared, by_kind);
        if (testing::Test::HasFailure()) return;
    }
    print(compared);
    EXPECT_GT(compared.violated, compared.verdicts / 5);
    EXPECT_GT(compared.faults, 0u);
}

/// Returns a system of three interleaved parts, scheduled by a choice: only the selected part changes. Half of the
/// systems have free inputs, which have initial values. If `leaking`, numbers leave their ranges or are divided by
/// zero.
System interleaving(Random& random, bool leaking) {
    System system = random_system(random);
    Exprs& exprs = system.exprs;
    const bool closed = chance(random, 50);
    for (System::Module& module : system.modules) {
        const bool main = &module == &system.modules[system.main];
        const Id<System::Symbol> turn =
            main ? module.symbols.add({"turn", integer_type(0, 2), System::ChoiceSymbol{}, "", {}})
                 : Id<System::Symbol>{0};
        std::vector<Id<Expr>> booleans;
        for (const Id<System::Symbol> id : module.symbols.ids()) {
            auto* state = std::get_if<System::StateSymbol>(&module.symbols[id].kind);
            if (state == nullptr) continue;
            const Type type = module.symbols[id].type;
            const Id<Expr> self = exprs.leaf(Op::Variable, id.index), chosen = exprs.leaf(Op::Variable, turn.index);
            if (type.boolean) booleans.push_back(self);
            if (!state->initial && chance(random, 70))
                state->initial = type.boolean ? exprs.constant(chance(random, 50)) : exprs.integer(type.low);
            if (!state->next && !closed) continue;
            Id<Expr> next = state->next ? *state->next : type.boolean ? exprs.negation(self) : self;
            if (leaking && !type.boolean && chance(random, 60))
                next = exprs.apply(chance(random, 70) ? Op::Plus : Op::Divide, exprs.integer(1), self);
            const Id<Expr> mine =
                main ? exprs.apply(Op::Equal, chosen, exprs.integer(random_number(random, 0, 2))) : chosen;
            state->next = exprs.conditional(mine, next, self);
        }
        if (main && chance(random, 30))
            module.invariants.push_back(exprs.disjunction(booleans.front(), exprs.negation(booleans.back())));
    }
    return system;
}

TEST(RandomizedSymbolic, EventClustersOfInterleavedSystemsAgreeWithAnExplicitSearch) {
    Compared compared;
    std::size_t vacuous = 0;
    for (int seed = 1; seed <= test_size(500); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        System system = interleaving(random, false);
        ask_more(system, random);
        compare(system, 400, compared, by_kind);
        if (testing::Test::HasFailure()) return;
        const SymbolicResult whole = check_symbolic(system, plain), apart = check_symbolic(system, by_kind);
        for (std::size_t i = 0; i < whole.verdicts.size(); ++i) {
            ASSERT_EQ(apart.verdicts[i].vacuous, whole.verdicts[i].vacuous) << whole.verdicts[i].property;
            if (whole.verdicts[i].vacuous) ++vacuous;
        }
    }
    print(compared);
    EXPECT_GT(compared.saturated, compared.systems / 10);
    EXPECT_GT(compared.faults, 0u);
    EXPECT_GT(vacuous, 0u);
}

TEST(RandomizedSymbolic, EventClustersFindTheSameModelErrors) {
    std::size_t leaks = 0, dead_ends = 0, sound = 0;
    for (int seed = 1; seed <= test_size(600); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const System system = interleaving(random, true);
        ASSERT_EQ(verify(system), std::vector<std::string>{});
        const SymbolicResult whole = check_symbolic(system, plain), apart = check_symbolic(system, by_kind);
        ASSERT_EQ(apart.fault.has_value(), whole.fault.has_value());
        ASSERT_EQ(apart.states, whole.states);
        if (!whole.fault) {
            ++sound;
            continue;
        }
        ASSERT_EQ(apart.fault->kind, whole.fault->kind);
        ASSERT_EQ(apart.fault->variable, whole.fault->variable);
        ASSERT_EQ(apart.fault->run.states.size(), whole.fault->run.states.size());
        if (whole.fault->kind == SystemFault::Kind::OutOfRange) ++leaks;
        if (whole.fault->kind == SystemFault::Kind::DeadEnd) ++dead_ends;
    }
    std::cout << leaks << " values out of range, " << dead_ends << " dead ends, " << sound << " without errors\n";
    EXPECT_GT(leaks, 0u);
    EXPECT_GT(dead_ends, 0u);
    EXPECT_GT(sound, 0u);
}

/// Checks that the interpreter can replay and print every run of the engine.
std::size_t expect_replays(const System& system, const std::vector<const Chart*>& charts) {
    std::size_t count = 0;
    const SymbolicResult result = check_symbolic(system);
    for (std::size_t i = 0; i < result.runs.size(); ++i) {
        EXPECT_EQ(system.properties[result.verdicts[i].about].name, result.verdicts[i].property);
        if (!result.runs[i]) continue;
        const ChartRun run = project(system, *result.runs[i]);
        const auto found = disagreement(run, charts);
        EXPECT_FALSE(found) << result.verdicts[i].property << ", step " << found->move << ", " << found->where << ": "
                            << found->what;
        EXPECT_EQ(verify(run), std::vector<std::string>{});
        EXPECT_EQ(verify(with_rows(run, Detail::Everything)), std::vector<std::string>{});
        EXPECT_EQ(verify(with_rows(run)), std::vector<std::string>{});
        ++count;
    }
    return count;
}

TEST(RandomizedSymbolic, AgreesWithAnExplicitSearchOnRandomControllers) {
    Compared compared;
    std::size_t replays = 0;
    for (int seed = 1; seed <= test_size(60); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop(random);
        const ClosedLoop& loop = model.loops[{0}];
        const auto equations = derived(model);
        if (!equations) continue;
        System system = schedule_controllers(model, loop, *equations);
        ask_more(system, random);
        compare(system, 600, compared, plain);
        std::vector<const Chart*> charts;
        for (const ClosedLoop::Controller& controller : loop.controllers)
            charts.push_back(&model.charts[controller.chart]);
        replays += expect_replays(system, charts);
        if (!testing::Test::HasFailure()) continue;
        for (const Chart* chart : charts) std::cout << chart_text(*chart);
        return;
    }
    print(compared);
    EXPECT_GT(replays, 50u);
}

struct Cut {
    std::size_t decided = 0, undecided = 0;
};

/// Checks that, with insufficient memory, each verdict is unknown or equals that of the complete search.
void expect_no_more_said(const System& system, const SymbolicResult& whole, Cut& cut) {
    for (const std::uint64_t part : {40u, 15u}) {
        SymbolicOptions little = by_kind;
        little.max_memory = whole.bytes / 100 * part;
        const SymbolicResult result = check_symbolic(system, little);
        ASSERT_TRUE(result.states.empty() || result.states == whole.states);
        for (std::size_t i = 0; i < whole.verdicts.size(); ++i) {
            if (result.verdicts[i].outcome != Outcome::Unknown) {
                ASSERT_EQ(result.verdicts[i].outcome, whole.verdicts[i].outcome) << whole.verdicts[i].property;
            }
            ++(result.verdicts[i].outcome == Outcome::Unknown ? cut.undecided : cut.decided);
        }
    }
}

/// Tests every model of a loop, with and without its plant. The automata of some models are interleaved.
TEST(RandomizedSymbolic, EventClustersGiveTheSameVerdictsOnRandomLoops) {
    std::size_t systems = 0, saturated = 0, runs = 0;
    Cut cut;
    for (int seed = 1; seed <= test_size(12); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop(random);
        for (const System& system : untimed_models(model)) {
            SCOPED_TRACE(system.scope);
            if (!explored(system, 150)) continue;
            const SymbolicResult whole = check_symbolic(system, plain), apart = check_symbolic(system, by_kind);
            ++systems;
            if (apart.depth < whole.depth) ++saturated;
            ASSERT_EQ(apart.fault.has_value(), whole.fault.has_value());
            ASSERT_EQ(apart.states, whole.states);
            expect_no_more_said(system, apart, cut);
            for (std::size_t i = 0; i < whole.verdicts.size(); ++i) {
                SCOPED_TRACE(whole.verdicts[i].property);
                ASSERT_EQ(apart.verdicts[i].outcome, whole.verdicts[i].outcome);
                ASSERT_EQ(apart.verdicts[i].vacuous, whole.verdicts[i].vacuous);
                ASSERT_EQ(apart.runs[i].has_value(), whole.runs[i].has_value());
                if (!whole.runs[i]) continue;
                ++runs;
                ASSERT_EQ(apart.runs[i]->loop.has_value(), whole.runs[i]->loop.has_value());
                if (!whole.runs[i]->loop) {
                    ASSERT_EQ(apart.runs[i]->states.size(), whole.runs[i]->states.size());
                }
            }
        }
    }
    std::cout << systems << " systems, " << saturated << " saturated, " << runs << " runs; with less memory "
              << cut.decided << " verdicts, " << cut.undecided << " unknown\n";
    EXPECT_GT(saturated, systems / 4);
    EXPECT_GT(cut.decided, 0u);
    EXPECT_GT(cut.undecided, 0u);
}

}  // namespace
}  // namespace grafverif
