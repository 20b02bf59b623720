// SPDX-License-Identifier: MIT
// Tests that every model of one loop has the same initial state. A command that reads a chart without its loop must
// execute the chart in the mode of the loop.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

using Words = std::vector<std::string>;

Words operator+(Words left, const Words& right) {
    left.insert(left.end(), right.begin(), right.end());
    return left;
}

/// Returns the options of each model of a loop. The options of the sequenced model are last.
const std::vector<Words>& models() {
    static const std::vector<Words> all = [] {
        std::vector<Words> made{{"--grain", "atomic"},
                                {"--grain", "phased"},
                                {"--untimed"},
                                {"--untimed", "--plant", "constraints"},
                                {"--untimed", "--schedule", "synchronous"}};
        for (const char* grain : {"atomic", "phased"})
            for (const Words& untimed : {Words{}, {"--fairness"}, {"--time", "discrete"}})
                made.push_back(Words{"--untimed", "--plant", "automata", "--grain", grain} + untimed);
        made.push_back({"--untimed", "--schedule", "sequenced"});
        return made;
    }();
    return all;
}

std::string word_list(const Words& words) {
    std::string text;
    for (const std::string& word : words) text += word + " ";
    return text;
}

nlohmann::json verdicts(const Result& result) {
    nlohmann::json found;
    const nlohmann::json report = nlohmann::json::parse(result.out);
    for (const nlohmann::json& property : report["properties"])
        found[std::string(property["name"])] = property["verdict"];
    return found;
}

TEST(PowerOnState, EveryModelHasTheStateInWhichOutputsAreStillFalse) {
    const Folder folder;
    const std::string file = folder.write("g.grafcet", R"(
        grafcet g {
            input a; output o;
            initial step 0 { o; }
            step 1;
            transition t0: 0 -> 1 when a;
            transition t1: 1 -> 0 when !a;
        }
        closed_loop w {
            controller g;
            environment A = push_button(OUT = a);
            property p: never X0 && !o;
            property q: !o leads to X1;
            property s: reachable X0 && !o;
        })");
    for (const char* mode : {"every-cycle", "stability-search"})
        for (const Words& model : models()) {
            SCOPED_TRACE(mode + (" " + word_list(model)));
            const Result result = grafverif(Words{"check", file, "--mode", mode, "--format", "json"} + model);
            EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
            // The sequenced model contains no state before the controllers have completed their first cycle.
            if (model == models().back()) continue;
            const nlohmann::json found = verdicts(result);
            EXPECT_EQ(found["p"], "violated");
            EXPECT_EQ(found["q"], "violated");
            EXPECT_EQ(found["s"], "holds");
        }
}

TEST(PowerOnState, EveryModelHasTheValuesBeforeTheActionsOfTheInitialSteps) {
    const Folder folder;
    const std::string file = folder.write("g.grafcet", R"(
        grafcet g {
            input a; internal n: int 0..2 = 0;
            initial step 0 { n := 1 on activation; }
            step 1 { n := 2 on activation; }
            transition t0: 0 -> 1 when a;
        }
        closed_loop w {
            controller g;
            environment A = push_button(OUT = a);
            property p: never n == 0;
            property s: reachable n == 0;
        })");
    for (const char* mode : {"every-cycle", "stability-search"})
        for (const Words& model : models()) {
            if (model == models().back()) continue;
            const nlohmann::json found =
                verdicts(grafverif(Words{"check", file, "--mode", mode, "--format", "json"} + model));
            EXPECT_EQ(found["p"], "violated") << mode << " " << word_list(model);
            EXPECT_EQ(found["s"], "holds") << mode << " " << word_list(model);
        }
}

TEST(PowerOnState, NoTimeIsOverBeforeTheFirstEvolution) {
    const Folder folder;
    for (const char* action :
         {"o1 for 3s", "o1 after 3s", "o1 if !(3s/X0)", "o1 if X0/3s", "o1 if 1s/X0/3s", "o1 if 1s/a"}) {
        const std::string file = folder.write(
            "g.grafcet",
            std::string("grafcet g { input a; output o1; initial step 0 { ") + action +
                "; } step 1; transition t0: 0 -> 1 when a; }\n"
                "closed_loop w { controller g; plant L = lamp(ON = o1); environment A = push_button(OUT = a);\n"
                "property never_settled: never X0 at stable; property dark: never o1; property lit: always o1; }\n");
        for (const char* mode : {"every-cycle", "stability-search"})
            for (const Words& model : models()) {
                const Result result = grafverif(Words{"check", file, "--mode", mode, "--verbose"} + model);
                EXPECT_TRUE(result.code == ExitCode::Verdict || result.code == ExitCode::Done)
                    << action << " " << mode << " " << word_list(model) << result.err;
            }
    }
}

TEST(Untimely, RunThatNoClockProducesIsMarked) {
    const Folder folder;
    const auto file = [&](const char* condition) {
        return folder.write(
            "g.grafcet",
            std::string("grafcet g { input a; initial step 0; step 1; transition t0: 0 -> 1 when ") + condition +
                "; }\nclosed_loop w { controller g; environment A = push_button(OUT = a); property p: never X1; }\n");
    };
    const std::string note = "note: no plant permits this run: 5s/X0 has expired in the run, but 3s/X0 has not";
    for (const Words& model :
         {Words{"--untimed"}, {"--untimed", "--plant", "automata"}, {"--untimed", "--schedule", "synchronous"}}) {
        const Result early = grafverif(Words{"check", file("5s/X0 && !(3s/X0)")} + model);
        EXPECT_EQ(early.code, ExitCode::Verdict) << early.err;
        EXPECT_NE(early.out.find(note), std::string::npos) << early.out;
        const Result late = grafverif(Words{"check", file("5s/X0 && 3s/X0")} + model);
        EXPECT_EQ(late.out.find("no plant permits"), std::string::npos) << late.out;
    }
    EXPECT_EQ(grafverif({"check", file("5s/X0 && !(3s/X0)"), "--time", "discrete", "--untimed"}).code, ExitCode::Done);
}

/// Tests each command with arguments for which the output depends on the mode; FILE is a placeholder.
TEST(Mode, OfAChartWithoutItsLoopIsThatOfTheLoopInEveryCommand) {
    const std::string text =
        "grafcet c { input a; output L; initial step 0; step 1 { L; } step 2;\n"
        "transition t: 0 -> 1 when a; transition u: 1 -> 2 when a; transition v: 2 -> 0 when !a; }\n";
    const Folder folder;
    const std::string lone = folder.write("c.grafcet", text);
    const std::string file = folder.write("loop.grafcet", text +
                                                              "closed_loop l { controller c with every_cycle; "
                                                              "environment A = push_button(OUT = a); }\n");
    const std::string sequence = folder.write("s.csv", grafverif({"testgen", file, "--mode", "every-cycle"}).out);
    const std::vector<Words> verbs{
        {"automaton"},
        {"mealy"},
        {"testgen"},
        {"st"},
        {"plc"},
        {"analyse"},
        {"nusmv", "--chart", "c"},
        {"check", "--chart", "c"},
        {"test", "--against", std::string(GRAFVERIF_PROGRAM) + " plc " + lone + " --mode every-cycle"}};
    for (const Words& verb : verbs) {
        SCOPED_TRACE(word_list(verb));
        const auto out = [&](const Words& options) {
            Words words = verb;
            words.insert(words.begin() + 1, file);
            return grafverif(words + options, "0\n1\n1\n0\n").out;
        };
        const std::string by_loop = out({});
        EXPECT_NE(by_loop, "");
        EXPECT_TRUE(by_loop == out({"--mode", "every-cycle"}) || verb.front() == "test") << by_loop;
        EXPECT_NE(by_loop, out({"--mode", "stability-search"}));
    }
}

TEST(CheckOfAChart, ReportsTotalInstabilityAsAnalyseDoes) {
    const Folder folder;
    const auto chart = [&](const std::string& also) {
        return folder.write(
            "c.grafcet",
            "grafcet c { input a; initial step 0; step 1; transition t: 0 -> 1 when a; transition u: 1 -> 0 when a; " +
                also + "}\n");
    };
    const Result result = grafverif({"check", chart(""), "--format", "json"});
    EXPECT_EQ(result.code, ExitCode::Verdict);
    const nlohmann::json found = nlohmann::json::parse(result.out)["properties"].back();
    EXPECT_EQ(found["name"], "stabilises");
    EXPECT_EQ(found["verdict"], "violated");
    EXPECT_NE(std::string(found["notes"][0]).find("the situations repeat in a cycle of length 2"), std::string::npos);
    EXPECT_TRUE(found["trace"]["loop_from"].is_number());
    EXPECT_NE(grafverif({"analyse", chart("")}).out.find("[total-instability]"), std::string::npos);

    EXPECT_EQ(grafverif({"check", chart("accept total-instability \"it blinks\"; ")}).code, ExitCode::Done);
    EXPECT_EQ(grafverif({"check", chart(""), "--mode", "every-cycle"}).code, ExitCode::Done);
    EXPECT_EQ(grafverif({"check", chart(""), "--property", "stabilises"}).code, ExitCode::Verdict);
    const std::string calm = folder.write(
        "d.grafcet",
        "grafcet d { input a; initial step 0; step 1; transition t: 0 -> 1 when a; transition u: 1 -> 0 when !a; }\n");
    EXPECT_NE(grafverif({"check", calm}).out.find("stabilises (not declared)  holds    "), std::string::npos);
}

}  // namespace
}  // namespace grafverif::app
