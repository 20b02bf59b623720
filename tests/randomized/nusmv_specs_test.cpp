// SPDX-License-Identifier: MIT
// Randomized test of the specifications in a NuSMV text. A model checker's verdicts on the specifications must equal
// the engine's verdicts on the properties of the same name. The test covers each approach and schedule, one and several
// initial states, and models with and without fairness.
#include "support/nusmv_specs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <sstream>

#include "check/symbolic/symbolic.hpp"
#include "emit/nusmv/nusmv.hpp"
#include "support/random_loop.hpp"
#include "support/random_system.hpp"
#include "support/read_loop.hpp"
#include "support/test_size.hpp"
#include "support/untimed_loop.hpp"

namespace grafverif {
namespace {

using System = TransitionSystem;

struct Compared {
    std::size_t systems = 0, verdicts = 0, several_starts = 0, nothing_fair = 0;
};

/// The source of the verdicts of grafverif: the engine that users run, or the explicit search that is its reference in
/// other tests. The engine is slow on some small models.
enum class Ours { Engine, ExplicitSearch };

void expect_agreement(const System& system, Compared& compared, Ours of = Ours::Engine) {
    const auto graph = explored(system, 300, 64);
    if (!graph || graph->initial == 0 || !graph->total) return;
    std::ostringstream out;
    nusmv::emit(system, out);
    const NusmvModel text = read_nusmv(out.str());
    ASSERT_EQ(text.error_text, "") << out.str();
    const std::vector<NusmvModel::Specification>& specs = text.modules.front().specifications;
    const std::vector<std::string> names = nusmv::spelling(system).properties;
    const SymbolicResult own = of == Ours::Engine ? check_symbolic(system) : SymbolicResult();
    if (own.fault) return;
    ++compared.systems;
    if (graph->initial > 1) ++compared.several_starts;
    const StateSet all(graph->states.size(), true);
    const StateSet fair = fairly_staying(*graph, all, justice_sets(system, *graph));
    if (std::ranges::find(fair, true) == fair.end()) ++compared.nothing_fair;
    for (const Id<Property> id : system.properties.ids()) {
        const Property& property = system.properties[id];
        if (property.pattern == Pattern::RawCtl || property.pattern == Pattern::RawLtl) continue;
        const auto spec = std::ranges::find(specs, names[id.index], &NusmvModel::Specification::name);
        ASSERT_NE(spec, specs.end()) << property.name;
        const bool holds = verdict_of_spec(*spec, property, spec_is_true(system, *graph, *spec));
        if (of == Ours::Engine && own.verdicts[id.index].outcome == Outcome::Unknown) continue;
        const bool we_say = of == Ours::Engine ? own.verdicts[id.index].outcome == Outcome::Holds
                                               : explicit_verdict(system, *graph, property);
        ASSERT_EQ(holds, we_say) << property.name << "\n" << out.str();
        ++compared.verdicts;
    }
    ASSERT_FALSE(testing::Test::HasFailure()) << out.str();
}

TEST(RandomizedNusmvSpecs, ToolsDecideRandomSystemsAsOurEngineDoes) {
    const int cases = test_size(300);
    Compared compared;
    for (int seed = 1; seed <= cases; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        System system = random_system(random);
        ask_more(system, random);
        ask_more(system, random);
        ASSERT_NO_FATAL_FAILURE(expect_agreement(system, compared));
    }
    std::cout << "seeds 1 to " << cases << ": " << compared.systems << " systems, " << compared.verdicts
              << " verdicts\n";
    EXPECT_GT(compared.several_starts, 20u);
    EXPECT_GT(compared.nothing_fair, 0u) << "some systems must have no fair run";
}

TEST(RandomizedNusmvSpecs, ToolsDecideRandomLoopsAsOurEngineDoesInEveryApproachAndSchedule) {
    const int cases = test_size(5);
    Compared compared;
    for (int seed = 1; seed <= cases; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop(random);
        for (System& system : untimed_models(model, chance(random, 50))) {
            SCOPED_TRACE(system.scope);
            ask_more(system, random);
            ASSERT_NO_FATAL_FAILURE(expect_agreement(system, compared, Ours::ExplicitSearch));
        }
    }
    std::cout << "seeds 1 to " << cases << ": " << compared.systems << " models, " << compared.verdicts
              << " verdicts\n";
    EXPECT_GT(compared.systems, 0u);
}

TEST(RandomizedNusmvSpecs, ToolsDecideASmallLoopAsOurEngineDoesInEveryApproachAndSchedule) {
    const Model model =
        read_loop(
            "grafcet lamp { input PRESS; output LIGHT; initial step 0; step 1 { LIGHT; }\n"
            "transition t0: 0 -> 1 when PRESS; transition t1: 1 -> 0 when !PRESS; }\n"
            "closed_loop room { controller lamp; environment a = push_button(OUT = PRESS);\n"
            "property shown: reachable LIGHT; property pressed: reachable PRESS at stable; property both: reachable X0 "
            "&& X1;\n"
            "property quick: inevitable X1; property back: X1 leads to X0; property again: always possible X1; }\n")
            .model;
    Random random(7);
    Compared compared;
    for (const bool fairness : {false, true})
        for (System& system : untimed_models(model, fairness)) {
            SCOPED_TRACE(system.scope);
            ask_more(system, random);
            ASSERT_NO_FATAL_FAILURE(expect_agreement(system, compared));
        }
    std::cout << compared.systems << " models, " << compared.verdicts << " verdicts\n";
    EXPECT_EQ(compared.systems, 16u)
        << "with and without fairness: two models without plant automata and six with plant automata";
}

/// A system with a single free input.
struct OneInput {
    System system = {};
    Id<Expr> input = {};

    OneInput() {
        system.name = "one";
        system.main = system.modules.add({"main", {}, {}, {}});
        const auto symbol = system.modules[system.main].symbols.add({"a", {}, System::StateSymbol{}, "", {}});
        input = system.exprs.leaf(Op::Variable, symbol.index);
        system.settled = system.exprs.constant(true);
        for (const Pattern pattern :
             {Pattern::Reachable, Pattern::Inevitable, Pattern::AlwaysPossible, Pattern::LeadsTo}) {
            Property property{
                .name = "P" + std::to_string(system.properties.size()), .pattern = pattern, .operands = {input}};
            if (pattern == Pattern::LeadsTo) property.operands.push_back(system.exprs.negation(input));
            system.properties.add(property);
        }
    }
};

TEST(RandomizedNusmvSpecs, StateReachedFromOnlyOneInitialStateIsReachable) {
    OneInput one;
    auto& symbol = one.system.modules[one.system.main].symbols[{0}];
    symbol.kind = System::StateSymbol{{}, one.input};  // the symbol keeps its initial value
    Compared compared;
    expect_agreement(one.system, compared);
    EXPECT_EQ(compared.several_starts, 1u);
}

TEST(RandomizedNusmvSpecs, ReachableIsDecidedEvenIfNoRunIsFair) {
    for (const bool reached : {false, true}) {
        OneInput one;
        one.system.modules[one.system.main].justice = {one.system.exprs.constant(false)};
        if (!reached) one.system.modules[one.system.main].invariants = {one.system.exprs.negation(one.input)};
        Compared compared;
        expect_agreement(one.system, compared);
        EXPECT_EQ(compared.nothing_fair, 1u);
    }
}

TEST(RandomizedNusmvSpecs, FormulasAreReadWithThePrecedencesOfNusmv) {
    struct Case {
        const char *text, *bracketed;
    };
    for (const Case& one : {Case{"AG x -> y", "(AG x) -> y"},
                            {"! a & b | c", "((!a) & b) | c"},
                            {"!a = b", "(!a) = b"},
                            {"a -> b -> c", "a -> (b -> c)"},
                            {"a <-> b -> c", "(a <-> b) -> c"},
                            {"!EF a & b", "(!(EF a)) & b"},
                            {"x + 1 * 2 = 3 & y", "((x + (1 * 2)) = 3) & y"},
                            {"AG EF a", "AG (EF a)"},
                            {"a ? b : c | d", "a ? b : (c | d)"}})
        EXPECT_EQ(read_spec(one.text), read_spec(one.bracketed)) << one.text;
    for (const char* wrong : {"", "a &", "(a", "a b", "AG", "a; INVAR FALSE"}) EXPECT_FALSE(read_spec(wrong)) << wrong;
}

}  // namespace
}  // namespace grafverif
