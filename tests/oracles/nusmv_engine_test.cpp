// SPDX-License-Identifier: MIT
// Compares NuSMV as an engine with the embedded engines on random systems and on the controllers of random loops. The
// verdicts and numbers of states must be equal, and the counterexamples read from the output of
// NuSMV must be runs of the system.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <sstream>
#include <utility>

#include "app/system/process.hpp"
#include "check/external/nusmv.hpp"
#include "check/symbolic/symbolic.hpp"
#include "emit/nusmv/nusmv.hpp"
#include "grafverif/grafverif.hpp"
#include "run/project.hpp"
#include "run/replay.hpp"
#include "support/explicit_search.hpp"
#include "support/nusmv_specs.hpp"
#include "support/random_loop.hpp"
#include "support/random_system.hpp"
#include "support/read_loop.hpp"
#include "support/test_size.hpp"
#include "support/untimed_loop.hpp"

namespace grafverif {
namespace {

/// Time limit of NuSMV and of the embedded engine, because each can take minutes for some small models.
constexpr std::chrono::seconds time_limit(2);

/// The results of NuSMV, with its model and its output for failure messages.
struct Requested {
    NusmvResult result = {};
    std::string conversation = {};
};

Requested asked_nusmv(const TransitionSystem& system, const std::string& program) {
    const app::TemporaryFolder folder;
    const std::string model = (folder.path() / "model.smv").string(), commands = (folder.path() / "commands").string();
    const SystemSpelling spelling = nusmv::spelling(system);
    std::vector<std::size_t> all;
    for (const Id<Property> id : system.properties.ids()) all.push_back(id.index);
    std::ostringstream text;
    nusmv::emit(system, text);
    std::ofstream(model) << text.str();
    std::ofstream(commands) << nusmv_commands(model, spelling, all);
    const ProgramResult program_result = app::run_program({program, "-source", commands}, "",
                                                          {.deadline = std::chrono::steady_clock::now() + time_limit});
    if (program_result.end != ProgramResult::End::Exited) return {};
    return {read_nusmv(system, spelling, all, program_result), text.str() + program_result.out + program_result.err};
}

struct Agreement {
    std::size_t verdicts = 0, runs = 0, given_up = 0;
};

/// Compares the results of NuSMV with those of the symbolic engine: the number of states, the verdicts, and the runs.
/// Runs without a loop have the minimum length in both results.
void expect_agreement(const TransitionSystem& system, const std::string& program, Agreement& agreement) {
    const SymbolicResult own = check_symbolic(system, {.deadline = std::chrono::steady_clock::now() + time_limit});
    if (own.fault) return;
    if (own.states.empty()) {
        ++agreement.given_up;
        return;
    }
    const auto [theirs, conversation] = asked_nusmv(system, program);
    if (conversation.empty()) {
        ++agreement.given_up;
        return;
    }
    ASSERT_TRUE(theirs.total) << conversation;
    ASSERT_EQ(theirs.states, own.states);
    ASSERT_EQ(theirs.verdicts.size(), own.verdicts.size());
    const bool just = !system.modules[system.main].justice.empty();
    for (std::size_t i = 0; i < own.verdicts.size(); ++i) {
        SCOPED_TRACE(own.verdicts[i].property);
        if (own.verdicts[i].outcome == Outcome::Unknown) continue;
        ASSERT_EQ(theirs.verdicts[i].outcome, own.verdicts[i].outcome) << conversation;
        ++agreement.verdicts;
        if (!own.runs[i] || own.verdicts[i].pattern == Pattern::AlwaysPossible) continue;
        ASSERT_TRUE(theirs.runs[i]);
        const bool about_states = !own.runs[i]->loop;
        if (about_states) {
            EXPECT_EQ(theirs.runs[i]->states.size(), own.runs[i]->states.size()) << "both runs have the minimum length";
        } else if (!just) {
            EXPECT_TRUE(theirs.runs[i]->loop);
        }
        ++agreement.runs;
    }
}

/// Calls `expect` with random systems that have additional properties, until a call fails fatally.
template <class Expect>
void for_random_systems(const Expect& expect) {
    for (int seed = 1; seed <= test_size(40); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        TransitionSystem system = random_system(random);
        ask_more(system, random);
        ASSERT_NO_FATAL_FAILURE(expect(system));
    }
}

TEST(NusmvEngine, AgreesWithTheSymbolicEngineOnRandomSystems) {
    const auto program = app::find_program("NuSMV");
    if (!program) GTEST_SKIP() << "NuSMV is not on the PATH";
    Agreement agreement;
    ASSERT_NO_FATAL_FAILURE(for_random_systems(
        [&](const TransitionSystem& system) { expect_agreement(system, program->string(), agreement); }));
    std::cout << agreement.verdicts << " verdicts, " << agreement.runs << " runs\n";
}

std::vector<const Chart*> charts_of(const Model& model) {
    std::vector<const Chart*> charts;
    for (const ClosedLoop::Controller& controller : model.loops[{0}].controllers)
        charts.push_back(&model.charts[controller.chart]);
    return charts;
}

TEST(NusmvEngine, CounterexamplesReplayOnTheRules) {
    const auto program = app::find_program("NuSMV");
    if (!program) GTEST_SKIP() << "NuSMV is not on the PATH";
    std::size_t replayed = 0;
    for (int seed = 1; seed <= test_size(4); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = random_loop(random);
        const std::vector<const Chart*> charts = charts_of(model);
        for (const TransitionSystem& system : untimed_models(model)) {
            if (!explored(system, 300, 256)) continue;  // NuSMV may take minutes for larger models
            SCOPED_TRACE(system.scope);
            for (const auto& run : asked_nusmv(system, program->string()).result.runs) {
                if (!run) continue;
                const auto found = disagreement(project(system, *run), charts);
                EXPECT_FALSE(found) << "step " << found->move << ", " << found->where << ": " << found->what;
                ++replayed;
            }
        }
    }
    std::cout << replayed << " runs replayed\n";
}

/// Checks every exported model of a sample, including a model with fairness.
TEST(NusmvEngine, AgreesWithTheSymbolicEngineOnTheSamples) {
    const auto program = app::find_program("NuSMV");
    if (!program) GTEST_SKIP() << "NuSMV is not on the PATH";
    Agreement agreement;
    for (const auto& [sample, fairness] : {std::pair("blinker/blinker.grafcet", false),
                                           {"tanks/tanks.grafcet", false},
                                           {"assembly_station/assembly_station.grafcet", false},
                                           {"assembly_station/assembly_station.grafcet", true}})
        for (const TransitionSystem& system : untimed_models(read_sample(sample).model, fairness)) {
            SCOPED_TRACE(std::string(sample) + ": " + system.scope);
            ASSERT_NO_FATAL_FAILURE(expect_agreement(system, program->string(), agreement));
        }
    std::cout << agreement.verdicts << " verdicts, " << agreement.runs << " runs, " << agreement.given_up
              << " models not decided\n";
    EXPECT_GT(agreement.verdicts, 200u);
}

/// Returns the results that `NuSMV FILE` prints when a user runs it, with their formulas. Several specifications may
/// have the same formula.
std::vector<std::pair<SpecTerm, bool>> printed_verdicts(const std::string& out) {
    std::vector<std::pair<SpecTerm, bool>> found;
    std::istringstream lines(out);
    for (std::string line; std::getline(lines, line);)
        for (const std::string_view before : {"-- specification ", "-- invariant "})
            for (const std::string_view after : {" is true", " is false"})
                if (line.starts_with(before) && line.ends_with(after)) {
                    const std::size_t length = line.size() - before.size() - after.size();
                    const auto formula = read_spec(std::string_view(line).substr(before.size(), length));
                    EXPECT_TRUE(formula) << line;
                    if (formula) found.emplace_back(*formula, after == " is true");
                }
    return found;
}

/// Checks that the verdicts of `NuSMV FILE` equal those of the embedded engine. The name of a
/// specification in the text determines the property to which the verdict belongs.
void expect_same_as_a_user_sees(const TransitionSystem& system, const std::string& program, Agreement& agreement) {
    const SymbolicResult own = check_symbolic(system, {.deadline = std::chrono::steady_clock::now() + time_limit});
    if (own.fault || own.states.empty()) return;
    const app::TemporaryFolder folder;
    const std::string model = (folder.path() / "model.smv").string();
    std::ostringstream text;
    nusmv::emit(system, text);
    std::ofstream(model) << text.str();
    const ProgramResult program_result =
        app::run_program({program, model}, "", {.deadline = std::chrono::steady_clock::now() + time_limit});
    if (program_result.end != ProgramResult::End::Exited) {
        ++agreement.given_up;
        return;
    }
    const NusmvModel read = read_nusmv(text.str());
    ASSERT_EQ(read.error_text, "");
    const auto printed = printed_verdicts(program_result.out);
    const std::vector<std::string> names = nusmv::spelling(system).properties;
    for (const Id<Property> id : system.properties.ids()) {
        const auto& specs = read.modules.front().specifications;
        const auto spec = std::ranges::find(specs, names[id.index], &NusmvModel::Specification::name);
        ASSERT_NE(spec, specs.end());
        const auto formula = read_spec(spec->formula);
        ASSERT_TRUE(formula) << spec->formula;
        const auto verdict = std::ranges::find(printed, *formula, &std::pair<SpecTerm, bool>::first);
        ASSERT_NE(verdict, printed.end()) << spec->formula << "\n" << program_result.out << program_result.err;
        if (own.verdicts[id.index].outcome == Outcome::Unknown) continue;
        ASSERT_EQ(verdict_of_spec(*spec, system.properties[id], verdict->second),
                  own.verdicts[id.index].outcome == Outcome::Holds)
            << spec->name << "\n"
            << text.str() << program_result.out;
        ++agreement.verdicts;
    }
}

TEST(NusmvAsAUserRunsIt, AgreesWithTheSymbolicEngineOnRandomSystemsAndLoops) {
    const auto program = app::find_program("NuSMV");
    if (!program) GTEST_SKIP() << "NuSMV is not on the PATH";
    Agreement agreement;
    ASSERT_NO_FATAL_FAILURE(for_random_systems(
        [&](const TransitionSystem& system) { expect_same_as_a_user_sees(system, program->string(), agreement); }));
    for (int seed = 1; seed <= test_size(3); ++seed) {
        SCOPED_TRACE("loop of seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        for (TransitionSystem& system : untimed_models(random_loop(random), chance(random, 50))) {
            if (!explored(system, 300, 256)) continue;  // NuSMV may take minutes for larger models
            ask_more(system, random);
            ASSERT_NO_FATAL_FAILURE(expect_same_as_a_user_sees(system, program->string(), agreement));
        }
    }
    std::cout << agreement.verdicts << " verdicts, " << agreement.given_up << " models not decided\n";
    EXPECT_GT(agreement.verdicts, 200u);
}

TEST(NusmvAsAUserRunsIt, AgreesWithTheSymbolicEngineOnTheSamples) {
    const auto program = app::find_program("NuSMV");
    if (!program) GTEST_SKIP() << "NuSMV is not on the PATH";
    Agreement agreement;
    for (const auto& [sample, fairness] : {std::pair("blinker/blinker.grafcet", true),
                                           {"tanks/tanks.grafcet", false},
                                           {"assembly_station/assembly_station.grafcet", true}})
        for (const TransitionSystem& system : untimed_models(read_sample(sample).model, fairness)) {
            SCOPED_TRACE(std::string(sample) + ": " + system.scope);
            ASSERT_NO_FATAL_FAILURE(expect_same_as_a_user_sees(system, program->string(), agreement));
        }
    std::cout << agreement.verdicts << " verdicts, " << agreement.given_up << " models not decided\n";
    EXPECT_GT(agreement.verdicts, 50u);
}

/// Returns a loop whose lamp is on for two seconds, with the property `sentence`, which requires an observer. Some of
/// the tested properties are false.
std::string watched_lamp(const std::string& sentence) {
    return "grafcet light {\n    input BUTTON;\n    output LAMP;\n    initial step 0;\n    step 1 { LAMP; }\n    step "
           "2;\n"
           "    transition t0: 0 -> 1 when BUTTON;\n    transition t1: 1 -> 2 when 2s/X1;\n"
           "    transition t2: 2 -> 0 when 1s/X2 && !BUTTON;\n}\n"
           "closed_loop stairs {\n    controller light;\n    environment Button = push_button(OUT = BUTTON, GAP = "
           "3s);\n"
           "    property S: " +
           sentence + ";\n}\n";
}

TEST(NusmvEngine, AgreesWithTheTimedEngineOnSentencesInDiscreteTime) {
    const auto program = app::find_program("NuSMV");
    if (!program) GTEST_SKIP() << "NuSMV is not on the PATH";
    std::size_t compared = 0, violated = 0;
    for (const char* sentence : {"LAMP leads to !LAMP within 2s",
                                 "LAMP leads to !LAMP within 1s",
                                 "LAMP holds for 2s",
                                 "LAMP holds for 3s",
                                 "LAMP holds at most 2s",
                                 "LAMP holds at most 1s",
                                 "X2 at most 2s since BUTTON",
                                 "LAMP at most 1s since X0",
                                 "X0 at least every 4s",
                                 "BUTTON precedes LAMP",
                                 "X2 precedes LAMP",
                                 "BUTTON precedes LAMP before X2",
                                 "X1 precedes X2 after X0",
                                 "BUTTON precedes X0 after X2",
                                 "X1 precedes X2 between X0 and X2",
                                 "X2 precedes LAMP after X0 until X2",
                                 "never LAMP before BUTTON",
                                 "never LAMP after X2",
                                 "never LAMP between X2 and X1 at stable",
                                 "never X0 after X1 until X2",
                                 "always X0 before BUTTON",
                                 "always !X2 after LAMP",
                                 "inevitable BUTTON before LAMP",
                                 "inevitable LAMP after BUTTON",
                                 "inevitable LAMP between X1 and X2",
                                 "inevitable X2 after X0 until X1",
                                 "X1 leads to LAMP before X2",
                                 "X1 leads to X0 after BUTTON",
                                 "X1 leads to LAMP between X0 and X2",
                                 "X0 leads to BUTTON after X0 until LAMP",
                                 "LAMP leads to !LAMP within 2s after BUTTON",
                                 "LAMP leads to !LAMP within 1s after X1 until X0",
                                 "X1 leads to X0 within 3s between X1 and X2",
                                 "X1 leads to X0 within 2s before BUTTON",
                                 "X0 at least every 2s between X1 and X0",
                                 "X2 at least every 3s after X1 until X0",
                                 "LAMP holds at most 1s after BUTTON",
                                 "LAMP holds at most 2s before X2",
                                 "BUTTON at most 1 time before X2",
                                 "X2 at most 2 times after BUTTON",
                                 "LAMP at most 1 time between X0 and X2",
                                 "BUTTON at most 2 times after X1 until X0"}) {
        SCOPED_TRACE(sentence);
        const Model model = read_loop(watched_lamp(sentence)).model;
        Diagnostics diagnostics;
        const auto own = check(model, Id<ClosedLoop>{0}, {.grain = Grain::Atomic}, {.properties = {"S"}}, diagnostics);
        ASSERT_TRUE(own);
        const auto system = transition_system_of(
            model, Id<ClosedLoop>{0},
            {.grain = Grain::Atomic, .untimed = {.plant = PlantApproach::Automata, .time = TimeModel::Discrete}},
            diagnostics);
        ASSERT_TRUE(system);
        const auto [theirs, conversation] = asked_nusmv(*system, program->string());
        if (conversation.empty()) continue;  // NuSMV did not finish within its time limit
        const auto here =
            std::ranges::find(own->answers, "S", [](const PropertyResult& one) { return one.verdict.property; });
        const auto there = std::ranges::find(theirs.verdicts, "S", &Verdict::property);
        ASSERT_NE(here, own->answers.end());
        ASSERT_NE(there, theirs.verdicts.end());
        ASSERT_EQ(there->outcome, here->verdict.outcome) << conversation;
        ++compared;
        if (there->outcome == Outcome::Violated) ++violated;
    }
    std::cout << compared << " sentences compared, " << violated << " of them violated\n";
    EXPECT_GT(compared, 15U);
    EXPECT_GT(violated, 3U);
}

TEST(NusmvEngine, ProgramWithoutOutputGivesNoVerdict) {
    Random random(3);
    TransitionSystem system = random_system(random);
    ask_more(system, random);
    const SystemSpelling spelling = nusmv::spelling(system);
    const NusmvResult result = read_nusmv(
        system, spelling, {0, 1}, {ProgramResult::End::Exited, 1, "", "file model.smv: line 3: syntax error\n"});
    ASSERT_EQ(result.verdicts.size(), 2u);
    EXPECT_EQ(result.verdicts[0].outcome, Outcome::Unknown);
    EXPECT_EQ(result.verdicts[0].obstacle, UnknownReason::Failed);
    EXPECT_NE(result.verdicts[0].reason.find("syntax error"), std::string::npos) << result.verdicts[0].reason;
}

TEST(NusmvEngine, AModelThatGetsStuckGivesNoVerdict) {
    Random random(3);
    TransitionSystem system = random_system(random);
    ask_more(system, random);
    const std::string out =
        "grafverif: fsm\nThe transition relation is not total.\ngrafverif: states\nreachable states: 4 (2^2) out of 8\n"
        "grafverif: 0\n-- invariant x  is true\ngrafverif: end\n";
    const NusmvResult result =
        read_nusmv(system, nusmv::spelling(system), {0}, {ProgramResult::End::Exited, 0, out, ""});
    EXPECT_EQ(result.verdicts[0].outcome, Outcome::Unknown);
    EXPECT_EQ(result.verdicts[0].obstacle, UnknownReason::Faulty);
}

}  // namespace
}  // namespace grafverif
