// SPDX-License-Identifier: MIT
// NuSMV itself, where it is installed: it takes every model we write, finds it total, counts the states that we count,
// and gives the verdicts that an explicit search of the transition system gives.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <set>
#include <sstream>

#include "grafverif/emit/nusmv.hpp"
#include "grafverif/compose/compose.hpp"
#include "grafverif/plant/plant.hpp"
#include "grafverif/schedule/controller.hpp"
#include "grafverif/schedule/network.hpp"
#include "grafverif/schedule/together.hpp"
#include "grafverif/syntax/legal_names.hpp"
#include "support/derived.hpp"
#include "support/law_size.hpp"
#include "support/random_loop.hpp"
#include "support/run_transition_system.hpp"

namespace grafverif {
namespace {

using System = TransitionSystem;

bool nusmv_is_installed() { return std::system("command -v NuSMV >/dev/null 2>&1") == 0; }

/// What NuSMV says when it reads `model` and obeys `commands`.
std::string nusmv_says(const std::string& model, const std::string& commands) {
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / ("grafverif_nusmv_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "model.smv") << model;
    std::ofstream(folder / "commands") << "read_model -i " << (folder / "model.smv").string() << "\n"
                                       << commands << "quit\n";
    const std::string command = "NuSMV -source " + (folder / "commands").string() + " 2>&1 </dev/null";
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::string text;
    for (int c = std::fgetc(pipe.get()); c != EOF; c = std::fgetc(pipe.get())) text += static_cast<char>(c);
    std::filesystem::remove_all(folder);
    return text;
}

// -- an explicit search
// -------------------------------------------------------------------------------------------------

/// Every state that can be reached, and its successors. Free variables of main take every value in every state.
struct Graph {
    std::vector<SystemState> states = {};
    std::vector<std::vector<std::size_t>> successors = {};
    std::size_t initial = 0;   ///< the first so many states
};

/// Empty: more states than `limit`, or too many ways to go on from one.
std::optional<Graph> explore(const System& system, std::size_t limit) {
    Graph graph;
    std::map<SystemState, std::size_t> known;
    const auto number = [&](const SystemState& state) {
        const auto [at, added] = known.emplace(state, graph.states.size());
        if (added) graph.states.push_back(state);
        return at->second;
    };
    const auto first = first_states(system, 64);
    if (!first) return {};
    for (const SystemState& state : *first) number(state);
    graph.initial = graph.states.size();
    for (std::size_t at = 0; at < graph.states.size(); ++at) {
        if (graph.states.size() > limit) return {};
        const auto next = successors(system, SystemState(graph.states[at]), 256);
        if (!next) return {};
        std::vector<std::size_t> numbers;
        for (const SystemState& state : *next) numbers.push_back(number(state));
        graph.successors.push_back(std::move(numbers));
    }
    return graph;
}

using States = std::vector<bool>;

States where(const Graph& graph, const std::function<bool(const SystemState&)>& holds) {
    States result;
    for (const SystemState& state : graph.states) result.push_back(holds(state));
    return result;
}

States negation(States states) {
    states.flip();
    return states;
}

/// EF: the least set with `goal` that holds each state with a successor in it.
States possibly(const Graph& graph, States goal) {
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t at = graph.states.size(); at-- > 0;) {
            if (goal[at]) continue;
            for (const std::size_t next : graph.successors[at]) goal[at] = goal[at] || goal[next];
            changed = changed || goal[at];
        }
    }
    return goal;
}

/// AF: the least set with `goal` that holds each state with all successors in it.
States inevitably(const Graph& graph, States goal) {
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t at = graph.states.size(); at-- > 0;) {
            if (goal[at]) continue;
            bool all = true;
            for (const std::size_t next : graph.successors[at]) all = all && goal[next];
            goal[at] = all;
            changed = changed || all;
        }
    }
    return goal;
}

bool initially(const Graph& graph, const States& states) {
    for (std::size_t at = 0; at < graph.initial; ++at)
        if (!states[at]) return false;
    return true;
}

bool everywhere(const States& states) { return std::ranges::find(states, false) == states.end(); }

bool verdict(const System& system, const Graph& graph, const Property& property) {
    const States settled =
        where(graph, [&](const SystemState& state) { return value_of(system, state, system.settled) != 0; });
    const auto operand = [&](std::size_t k) {
        return where(graph,
                     [&](const SystemState& state) { return value_of(system, state, property.operands[k]) != 0; });
    };
    const auto judged = [&](std::size_t k) {
        States states = operand(k);
        for (std::size_t at = 0; at < states.size() && property.at_stable; ++at) states[at] = states[at] && settled[at];
        return states;
    };
    const auto invariant = [&](States states) {
        for (std::size_t at = 0; at < states.size() && property.at_stable; ++at)
            states[at] = states[at] || !settled[at];
        return everywhere(states);
    };
    switch (property.pattern) {
    case Pattern::Always:         return invariant(operand(0));
    case Pattern::Never:          return invariant(negation(operand(0)));
    case Pattern::Reachable:      return initially(graph, possibly(graph, judged(0)));
    case Pattern::Inevitable:     return initially(graph, inevitably(graph, judged(0)));
    case Pattern::AlwaysPossible: return everywhere(possibly(graph, judged(0)));
    case Pattern::LeadsTo: {
        const States from = judged(0), to = inevitably(graph, judged(1));
        for (std::size_t at = 0; at < from.size(); ++at)
            if (from[at] && !to[at]) return false;
        return true;
    }
    case Pattern::ExactlyOneOf:
        return invariant(where(graph, [&](const SystemState& state) {
            std::int64_t count = 0;
            for (const Id<Expr> one : property.operands) count += value_of(system, state, one);
            return count == 1;
        }));
    case Pattern::NoDeadlock: case Pattern::NoTimelock: case Pattern::ReachableAllSteps: case Pattern::RawUppaal:
    case Pattern::RawCtl: case Pattern::RawLtl:
        break;
    }
    ADD_FAILURE() << "no pattern for an explicit search";
    return false;
}

// -- comparisons
// --------------------------------------------------------------------------------------------------------

std::string emitted(const System& system) {
    std::ostringstream out;
    nusmv::emit(system, out);
    return out.str();
}

/// A Boolean variable of main or of an instance: something to ask about that reads no choice.
bool holds_in_states(const System& system, Id<System::Symbol> id) {
    const System::Symbol& symbol = system.modules[system.main].symbols[id];
    if (!symbol.type.boolean) return false;
    const System::Symbol* of = &symbol;
    if (const auto* member = std::get_if<System::MemberSymbol>(&symbol.kind))
        of = &system.modules[system.instances[member->instance].module].symbols[member->symbol];
    return std::holds_alternative<System::StateSymbol>(of->kind);
}

/// A property per pattern over steps and outputs, beside those the loop has.
void ask_more(System& system, Random& random) {
    std::vector<Id<Expr>> leaves;
    for (const Id<System::Symbol> id : system.modules[system.main].symbols.ids())
        if (holds_in_states(system, id))
            leaves.push_back(system.exprs.leaf(Op::Variable, id.index));
    const auto any = [&] {
        return leaves[static_cast<std::size_t>(random_number(random, 0, static_cast<std::int64_t>(leaves.size()) - 1))];
    };
    for (const Pattern pattern : {Pattern::Always, Pattern::Never, Pattern::Reachable, Pattern::Inevitable,
                                  Pattern::LeadsTo, Pattern::AlwaysPossible, Pattern::ExactlyOneOf}) {
        Property property;
        property.name = "more_" + std::to_string(system.properties.size());
        property.pattern = pattern;
        property.operands = {any()};
        if (pattern == Pattern::LeadsTo || pattern == Pattern::ExactlyOneOf) property.operands.push_back(any());
        property.at_stable = chance(random, 50);
        system.properties.add(std::move(property));
    }
}

/// The systems of a random loop whose justice conditions matter to no property are compared in full, others not.
void compare(const System& system, std::size_t& states, std::size_t& verdicts) {
    const std::string model = emitted(system);
    const std::optional<Graph> graph = explore(system, 1500);
    const bool just = system.modules[system.main].justice.empty();
    std::vector<std::string> names;
    for (const Property& property : system.properties) names.push_back(property.name);
    std::string commands = "flatten_hierarchy\nencode_variables\nbuild_model\ncheck_fsm\n";
    if (graph) commands += "print_reachable_states\n";
    std::vector<bool> expected;
    const std::vector<std::string> legal = legal_names(Target::Nusmv, names);
    for (const Id<Property> id : system.properties.ids()) {
        const Pattern pattern = system.properties[id].pattern;
        const bool liveness = pattern == Pattern::Inevitable || pattern == Pattern::LeadsTo;
        if (!graph || (!just && liveness) || pattern == Pattern::RawCtl || pattern == Pattern::RawLtl) continue;
        commands += "check_property -P \"" + legal[id.index] + "\"\n";
        expected.push_back(verdict(system, *graph, system.properties[id]));
    }
    const std::string said = nusmv_says(model, commands);
    ASSERT_NE(said.find("The transition relation is total"), std::string::npos) << said << model;
    if (!graph) return;
    ASSERT_NE(said.find("reachable states: " + std::to_string(graph->states.size()) + " ("), std::string::npos)
        << graph->states.size() << " states expected\n" << said << model;
    std::vector<bool> found;
    std::istringstream lines(said);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("-- specification") || line.starts_with("-- invariant"))
            found.push_back(line.ends_with("true"));
    ASSERT_EQ(found, expected) << said << model;
    states += graph->states.size();
    verdicts += found.size();
}

TEST(NusmvOracle, AgreesWithAnExplicitSearchOnRandomLoops) {
    if (!nusmv_is_installed()) GTEST_SKIP() << "NuSMV is not on the PATH";
    const int cases = law_size(30);
    std::size_t states = 0, verdicts = 0;
    for (int seed = 1; seed <= cases; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop(random);
        const ClosedLoop& loop = model.loops[{0}];
        const auto equations = derived(model);
        if (!equations) continue;
        System system = schedule_controllers(model, loop, *equations);
        ask_more(system, random);
        ASSERT_NO_FATAL_FAILURE(compare(system, states, verdicts));
    }
    std::cout << "seeds 1 to " << cases << ": " << states << " states counted, " << verdicts << " verdicts compared\n";
}

/// A loop under every schedule, with clocks that count and without.
std::vector<System> with_automata(const Model& model, const ClosedLoop& loop, const std::vector<Equations>& equations) {
    Diagnostics diagnostics;
    std::vector<System> made;
    const auto plant_network = plant(model, loop, diagnostics);
    if (!plant_network) return made;
    for (const Schedule schedule : {Schedule::Synchronous, Schedule::Sequenced})
        if (auto system = schedule_together(model, loop, equations, *plant_network, {.schedule = schedule}, diagnostics))
            made.push_back(std::move(*system));
    for (const Grain grain : {Grain::Atomic, Grain::Phased}) {
        const auto network = compose(*plant_network, model, loop, equations, {grain, {}, {}}, diagnostics);
        if (!network) continue;
        for (const TimeModel time : {TimeModel::Abstract, TimeModel::Discrete})
            if (auto system = schedule_network(*network, {.time = time}, diagnostics)) made.push_back(std::move(*system));
    }
    return made;
}

TEST(NusmvOracle, AgreesWithAnExplicitSearchOnRandomLoopsWithPlantAutomata) {
    if (!nusmv_is_installed()) GTEST_SKIP() << "NuSMV is not on the PATH";
    const int cases = law_size(4);
    std::size_t states = 0, verdicts = 0;
    for (int seed = 1; seed <= cases; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop(random);
        const ClosedLoop& loop = model.loops[{0}];
        const auto equations = derived(model);
        if (!equations) continue;
        for (System& system : with_automata(model, loop, *equations)) {
            SCOPED_TRACE(system.scope);
            ASSERT_EQ(verify(system), std::vector<std::string>{});
            ask_more(system, random);
            ASSERT_NO_FATAL_FAILURE(compare(system, states, verdicts));
        }
    }
    std::cout << "seeds 1 to " << cases << ": " << states << " states counted, " << verdicts << " verdicts compared\n";
}

TEST(NusmvOracle, TakesTheGoldenModels) {
    if (!nusmv_is_installed()) GTEST_SKIP() << "NuSMV is not on the PATH";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(GRAFVERIF_SOURCE_DIR "/tests/golden")) {
        if (entry.path().extension() != ".smv") continue;
        SCOPED_TRACE(entry.path().string());
        std::ostringstream model;
        model << std::ifstream(entry.path()).rdbuf();
        const std::string said = nusmv_says(
            model.str(), "set dynamic_reorder 1\nflatten_hierarchy\nencode_variables\nbuild_model\ncheck_fsm\n");
        EXPECT_NE(said.find("The transition relation is total"), std::string::npos) << said;
    }
}

}  // namespace
}  // namespace grafverif
