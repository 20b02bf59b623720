// SPDX-License-Identifier: MIT
// Tests `mutate`: mutants of a chart, and the properties that detect them.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

const std::string gate =
    "grafcet gate {\n    input up, down, top;\n    output RAISE, LOWER;\n\n    initial step 0;\n    step 1 { RAISE; }\n"
    "    step 2 { LOWER if down && !up; }\n\n    transition t0: 0 -> 1 when up && !top;\n"
    "    transition t1: 1 -> 2 when top;\n    transition t2: 2 -> 0 when 2s/X2;\n}\n\n"
    "closed_loop house {\n    controller gate;\n    environment U = free(OUT = up);\n    environment D = free(OUT = "
    "down);\n"
    "    environment T = free(OUT = top);\n    property apart: never RAISE && LOWER;\n"
    "    property moves: reachable RAISE;\n}\n";

nlohmann::json mutated(const std::string& text, std::vector<std::string> options = {}) {
    const Folder folder;
    options.insert(options.begin(), {"mutate", folder.write("gate.grafcet", text), "--format", "json"});
    const Result result = grafverif(options);
    EXPECT_NE(result.code, ExitCode::Failure) << result.err;
    EXPECT_NE(result.code, ExitCode::Input) << result.err;
    return nlohmann::json::parse(result.out, nullptr, false);
}

TEST(Mutate, CreatesAndChecksEachKindOfMutant) {
    const auto json = mutated(gate);
    std::set<std::string> kinds, results;
    for (const auto& mutant : json["mutants"]) {
        kinds.insert(mutant["kind"]);
        results.insert(mutant["fate"]);
        EXPECT_NE(mutant["before"], mutant["after"]) << mutant;
        EXPECT_NE(mutant["fate"], "refused") << mutant;
        const bool differs = mutant["fate"] == "unnoticed";
        EXPECT_EQ(mutant["noticed_by"].empty(), mutant["fate"] != "noticed") << mutant;
        EXPECT_TRUE(!differs || mutant["scans"] > 0) << mutant;
    }
    for (const char* kind :
         {"term-dropped", "term-negated", "and-or", "wrong-successor", "duration", "action-missing", "output-swapped"})
        EXPECT_TRUE(kinds.contains(kind)) << kind;
    EXPECT_TRUE(results.contains("noticed") && results.contains("unnoticed")) << json["counts"];
    EXPECT_EQ(json["specification"]["of"],
              json["counts"]["noticed"].get<int>() + json["counts"]["unnoticed"].get<int>());
    EXPECT_EQ(json["properties"].size(), 3U) << json["properties"];  // the third property is no_timelock
}

// A mutant of a chart changes its instances, so that the properties of loops with instances are checked.
TEST(Mutate, PropertiesOfLoopsWithInstancesAreChecked) {
    const std::string chart =
        "grafcet g(input IN; output OUT) { initial step 0; step 1 { OUT; } transition 0 -> 1 when IN; "
        "transition 1 -> 0 when !IN; }\n";
    const std::string rest = "environment e = free(OUT = A); property p: reachable B; }\n";
    for (const std::string& loop :
         {"closed_loop l { controller c = g(IN = A, OUT = B); " + rest,
          "grafcet plc { input A; output B; partial c = g(IN = A, OUT = B); }\nclosed_loop l { controller plc; " +
              rest}) {
        const auto json = mutated(chart + loop, {"--chart", "g"});
        EXPECT_EQ(json["properties"].size(), 2U) << json["properties"];  // the second property is no_timelock
        EXPECT_GT(json["counts"]["noticed"].get<int>(), 0) << json["counts"];
    }
}

TEST(Mutate, IncludedChartIsMutatedInItsFile) {
    const Folder folder;
    const std::size_t loop = gate.find("closed_loop");
    (void)folder.write("chart.grafcet", gate.substr(0, loop));
    const std::string main = folder.write("loop.grafcet", "include \"chart.grafcet\";\n\n" + gate.substr(loop));
    const Result made = grafverif({"mutate", main, "--format", "json", "--survivors", folder.file("left")});
    EXPECT_EQ(made.code, ExitCode::Verdict) << made.err;
    const auto json = nlohmann::json::parse(made.out, nullptr, false);
    const auto alone = mutated(gate);
    EXPECT_GT(json["possible"], 0);
    EXPECT_EQ(json["counts"], alone["counts"]);
    EXPECT_EQ(json["properties"], alone["properties"]);
    for (const auto& mutant : json["mutants"])
        EXPECT_TRUE(std::string(mutant["file"]).ends_with("chart.grafcet")) << mutant;
    EXPECT_EQ(folder.read("left/original.grafcet"), gate.substr(0, loop));
    const Result text = grafverif({"mutate", main, "--limit", "1"});
    EXPECT_NE(text.out.find("chart.grafcet: 1 mutants"), std::string::npos) << text.out;
}

TEST(Mutate, ScoresOfARunThatWasStoppedAreThoseSoFar) {
    const Folder folder;
    const std::string file = folder.write("gate.grafcet", gate);
    const Result stopped = grafverif({"mutate", file, "--timeout", "0s"});
    EXPECT_NE(stopped.out.find("not checked: stopped early\n"), std::string::npos) << stopped.out;
    EXPECT_NE(stopped.out.find("the specification detects 0 of 0 mutants so far\n"), std::string::npos) << stopped.out;
    const Result whole = grafverif({"mutate", file, "--limit", "2"});
    EXPECT_EQ(whole.out.find("so far"), std::string::npos) << whole.out;
}

TEST(Mutate, TimePerMutantBeyondTheRangeOfTheClockIsUnlimited) {
    const auto expected = mutated(gate, {"--limit", "3"})["counts"];
    for (const char* time : {"106751991167h", "2562047788016h", "18446744073709551615ms"})
        EXPECT_EQ(mutated(gate, {"--limit", "3", "--mutant-timeout", time})["counts"], expected) << time;
}

TEST(Mutate, AMissingActionIsNoticedByThePropertyThatNamesIt) {
    const auto json = mutated(gate);
    for (const auto& mutant : json["mutants"])
        if (mutant["kind"] == "action-missing" && mutant["subject"] == "step 1") {
            EXPECT_EQ(mutant["fate"], "noticed");
            EXPECT_EQ(mutant["noticed_by"], nlohmann::json::array({"moves"}));
            EXPECT_EQ(mutant["before"], "step 1 { RAISE; }");
            EXPECT_EQ(mutant["after"], "step 1;");
            return;
        }
    FAIL();
}

TEST(Mutate, MutantWithoutVisibleEffectIsEquivalent) {
    const std::string idle =
        "grafcet c {\n    input a;\n    output L;\n\n    initial step 0;\n    step 1;\n    step 2;\n\n"
        "    transition t0: 0 -> 1 when a;\n    transition t1: 1 -> 2 when a;\n}\n";
    const auto json = mutated(idle, {"--jobs", "2"});
    for (const auto& mutant : json["mutants"]) {
        const bool circles = mutant["after"] == "transition t1: 1 -> 0 when a;";
        EXPECT_EQ(mutant["fate"], circles ? "unnoticed" : "equivalent") << mutant;
    }
    EXPECT_EQ(json["counts"]["equivalent"], 3) << json["counts"];
    EXPECT_EQ(json["properties"].size(), 0U);
}

TEST(Mutate, SampleDependsOnTheSeedAndARunContinuesFromItsStateFile) {
    const Folder folder;
    const std::string file = folder.write("gate.grafcet", gate), state = folder.file("state");
    const std::vector<std::string> arguments = {"mutate", file, "--limit", "3", "--seed", "5", "--format", "json"};
    std::vector<std::string> kept = arguments;
    kept.insert(kept.end(), {"--state", state});
    const Result first = grafverif(kept), alone = grafverif(arguments);
    EXPECT_EQ(first.out, alone.out);
    EXPECT_EQ(nlohmann::json::parse(first.out)["mutants"].size(), 3U);
    const std::string known = folder.read("state");
    EXPECT_EQ(std::count(known.begin(), known.end(), '{'), 3) << known;
    EXPECT_EQ(grafverif(kept).out, first.out);
    const std::string later = folder.read("state");
    EXPECT_EQ(std::count(later.begin(), later.end(), '{'), 3) << later;
}

TEST(Mutate, AStateFileIsAFileOfItsRunsAndNoOther) {
    const Folder folder;
    const std::string file = folder.write("gate.grafcet", gate), notes = folder.write("notes", "precious\n");
    const auto error_of = [&](const std::vector<std::string>& options) {
        std::vector<std::string> arguments = {"mutate", file, "--limit", "1"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Result result = grafverif(arguments);
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_EQ(result.out, "") << "rejected before the first mutant is checked";
        return result.err;
    };
    const auto has = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    EXPECT_TRUE(has(error_of({"--state", file}), "[output-is-input]"));
    EXPECT_TRUE(has(error_of({"--state", notes}), "`" + notes + "` exists and is not a state file"));
    EXPECT_TRUE(has(error_of({"--state", notes, "-o", notes}), "[output-twice]"));
    EXPECT_TRUE(has(error_of({"--state", "/dev/full"}), "the path is a device, not a file"));
    EXPECT_TRUE(has(error_of({"--state", folder.file("")}), "the path is a folder"));
    EXPECT_TRUE(has(error_of({"--state", folder.file("no/state")}), "[missing-folder]"));
    EXPECT_EQ(folder.read("gate.grafcet"), gate);
    EXPECT_EQ(folder.read("notes"), "precious\n");
}

TEST(Mutate, IncompleteLineOfTheStateFileIsCheckedAgain) {
    const Folder folder;
    const std::string file = folder.write("gate.grafcet", gate), state = folder.file("state");
    const std::vector<std::string> arguments = {"mutate", file, "--limit", "2", "--state", state};
    const Result first = grafverif(arguments);
    const std::string known = folder.read("state");
    folder.write("state", known.substr(0, known.size() - 20) + "\n\n{\"k");
    EXPECT_EQ(grafverif(arguments).out, first.out);
    EXPECT_NE(folder.read("state").find(known.substr(known.rfind('{'))), std::string::npos);
}

TEST(Mutate, StateFileIsUsedForTheSameQueryOnly) {
    const Folder folder;
    const std::string part = "component quiet(output OUT) {\n    initial location there;\n}\n";
    folder.write("part.grafcet", part);
    std::string text = "include \"part.grafcet\";\n\n" + gate;
    text.replace(text.find("T = free("), 9, "T = quiet(");
    const std::string file = folder.write("gate.grafcet", text), state = folder.file("state");
    const auto lines = [&] {
        const std::string known = folder.read("state");
        return std::count(known.begin(), known.end(), '{');
    };
    std::vector<std::string> arguments = {"mutate", file, "--limit", "2", "--state", state};
    const Result first = grafverif(arguments);
    ASSERT_NE(first.code, ExitCode::Input) << first.err;
    EXPECT_EQ(lines(), 2);
    folder.write("part.grafcet", part + "// another file\n");
    grafverif(arguments);
    EXPECT_EQ(lines(), 4) << "a result depends on the included files";
    arguments.insert(arguments.end(), {"--mode", "every-cycle"});
    grafverif(arguments);
    EXPECT_EQ(lines(), 6) << "a result depends on the options";
    arguments.insert(arguments.end(), {"--mutant-timeout", "30s"});
    grafverif(arguments);
    EXPECT_EQ(lines(), 6) << "a verdict does not depend on the time limit";
}

TEST(Mutate, MutantsThatTimedOutAreCheckedAgainWithMoreTime) {
    const Folder folder;
    const std::string file = folder.write("gate.grafcet", gate), state = folder.file("state");
    const auto counts = [&](const std::string& each) {
        const Result result =
            grafverif({"mutate", file, "--limit", "2", "--state", state, "--mutant-timeout", each, "--format", "json"});
        return nlohmann::json::parse(result.out)["counts"];
    };
    EXPECT_EQ(counts("0ms")["unknown"], 2);
    EXPECT_EQ(counts("60s")["unknown"], 0);
    EXPECT_EQ(counts("0ms")["unknown"], 0) << "decided mutants remain decided";
}

TEST(Mutate, SurvivorsAreWrittenAsTextAndDrawing) {
    const Folder folder;
    const Result result = grafverif({"mutate", folder.write("gate.grafcet", gate), "--survivors", folder.file("left")});
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
    EXPECT_NE(result.out.find("survived:\n"), std::string::npos) << result.out;
    EXPECT_EQ(folder.read("left/original.grafcet"), gate);
    std::size_t texts = 0;
    for (const auto& entry : fs::directory_iterator(folder.file("left"))) {
        if (entry.path().extension() != ".grafcet") continue;
        ++texts;
        const std::string name = entry.path().stem().string();
        const auto marks = [&](const std::string& ending) {
            const std::string drawn = folder.read("left/" + name + ending);
            EXPECT_NE(drawn.find("<svg"), std::string::npos) << name << ending;
            return drawn.find(" changed\" color=") != std::string::npos;
        };
        if (name == "original") EXPECT_FALSE(marks(".svg"));
        else EXPECT_TRUE(marks(".before.svg") || marks(".svg")) << name;
        if (name.ends_with("action-missing")) {
            EXPECT_TRUE(marks(".before.svg") && !marks(".svg"));
        }
        if (name.ends_with("wrong-successor")) {
            EXPECT_TRUE(marks(".before.svg") && marks(".svg"));
        }
        EXPECT_EQ(grafverif({"fmt", "--check", entry.path().string()}).code, ExitCode::Done) << entry.path();
    }
    EXPECT_GT(texts, 1U);
}

}  // namespace
}  // namespace grafverif::app
