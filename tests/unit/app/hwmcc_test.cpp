// SPDX-License-Identifier: MIT
// Tests circuits on the command line: `aiger`, the PDR engine, ABC and other programs that read circuits. Stand-ins for
// these programs give wrong results, crash, print too much or never end.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/system/process.hpp"
#include "support/read_aiger.hpp"
#include "support/read_btor2.hpp"
#include "unit/app/run_program.hpp"

namespace grafverif::app {
namespace {

const std::string tanks = (root / "samples/tanks/tanks.grafcet").string();
const std::string station = (root / "samples/testing_station/testing_station.grafcet").string();
const std::string faulty = (root / "samples/testing_station/faulty.grafcet").string();

std::string lamp(const std::string& properties) {
    return "grafcet lamp { input A; output L, M; initial step 0; step 1 { L; } step 2 { M; }\n"
           "transition t0: 0 -> 1 when A; transition t1: 1 -> 2 when !A; transition t2: 2 -> 0 when A; }\n"
           "closed_loop room { controller lamp; environment a = push_button(OUT = A);\n" +
           properties + " }\n";
}

/// True if the final table states that the property holds.
bool holds(const std::string& out, const std::string& property) {
    const std::size_t row = out.find("\n" + property + " ");
    return row != std::string::npos &&
           out.substr(row, out.find('\n', row + 1) - row).find("  holds") != std::string::npos;
}

TEST(Aiger, IsWrittenInBothFormsWithAMapToTheChart) {
    const Folder folder;
    for (const std::string form : {"aag", "aig"}) {
        const std::string out = folder.file("tanks." + form);
        const Result result = grafverif({"aiger", tanks, "--plant", "automata", "-o", out});
        ASSERT_EQ(result.code, ExitCode::Done) << result.err;
        EXPECT_EQ(folder.read("tanks." + form).substr(0, 4), form + " ");
        const AigerFile file = read_aiger(folder.read("tanks." + form));
        EXPECT_EQ(file.error_text, "");
        EXPECT_EQ(file.justice.size(), 1u) << "back_to_rest";
        EXPECT_GE(file.bads.size(), 4u);
        const auto map = nlohmann::json::parse(folder.read("tanks." + form + ".json"));
        EXPECT_EQ(map["questions"][0]["property"], "back_to_rest");
        EXPECT_EQ(map["questions"][1]["symbol"], "b0");
        EXPECT_EQ(map["controllers"][0]["steps"][0]["name"], "1");
        const auto& first = map["controllers"][0]["steps"][0]["bits"];
        ASSERT_EQ(first.size(), 1u);
        EXPECT_TRUE(aiger_value(aiger_run(file, {std::vector<bool>(file.inputs.size())})[0], first[0]))
            << "the first step is initially active";
    }
    EXPECT_TRUE(grafverif({"aiger", tanks}).out.starts_with("aag "));
    EXPECT_TRUE(grafverif({"aiger", tanks, "--format", "aig"}).out.starts_with("aig "));
}

TEST(Aiger, InexpressiblePropertiesAreNamed) {
    const Folder folder;
    const std::string file =
        folder.write("lamp.grafcet", lamp("property again: always possible X1; property lit: reachable L;"));
    const Result result = grafverif({"aiger", file});
    EXPECT_EQ(result.code, ExitCode::Done);
    EXPECT_NE(result.err.find("property `again` is omitted from the AIGER model"), std::string::npos) << result.err;
    EXPECT_NE(result.out.find("\nb0 lit\n"), std::string::npos) << result.out;
}

TEST(Btor2, ContainsPropertiesOfStatesAndNamesTheOthers) {
    const Result result = grafverif({"btor2", tanks, "--plant", "automata"});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    EXPECT_NE(result.err.find("property `back_to_rest` is omitted from the BTOR2 model"), std::string::npos);
    EXPECT_EQ(result.out.rfind("; property back_to_rest is omitted: ", 0), 0U) << result.out.substr(0, 100);
    const Btor2File file(result.out);
    EXPECT_EQ(file.error_text(), "");
    ASSERT_GE(file.bads().size(), 4u);
    EXPECT_EQ(file.bads()[0], "no_overflow");
}

TEST(Pdr, ProvesShowsRunsAndOmitsPropertiesOfRuns) {
    const Folder folder;
    const std::string file = folder.write(
        "lamp.grafcet", lamp("property one: never L && M; property lit: reachable M; property dark: never M;\n"
                             "property back: X1 leads to X0;"));
    const Result result = grafverif({"check", file, "--engine", "pdr"});
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
    EXPECT_TRUE(holds(result.out, "one")) << result.out;
    EXPECT_NE(result.out.find("checked by a second solver"), std::string::npos) << result.out;
    EXPECT_TRUE(holds(result.out, "lit")) << result.out;
    EXPECT_NE(result.out.find("dark: violated"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("counterexample:"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("why: this engine decides only properties of states, not of runs"), std::string::npos)
        << result.out;
}

TEST(Bmc, ShowsShortestRunsAndTheSearchedLength) {
    const Folder folder;
    const std::string file = folder.write(
        "lamp.grafcet", lamp("property one: never L && M; property lit: reachable M; property dark: never M;\n"
                             "property both: reachable L && M; property back: X1 leads to X0;"));
    const Result far = grafverif({"check", file, "--engine", "bmc", "--max-steps", "20"});
    EXPECT_EQ(far.code, ExitCode::Verdict) << far.err;
    EXPECT_NE(far.out.find("one: unknown"), std::string::npos) << far.out;
    EXPECT_NE(far.out.find("no run of up to 20 steps violates the property"), std::string::npos) << far.out;
    EXPECT_NE(far.out.find("no run of up to 20 steps satisfies the property"), std::string::npos) << far.out;
    EXPECT_TRUE(holds(far.out, "lit")) << far.out;
    EXPECT_NE(far.out.find("dark: violated"), std::string::npos) << far.out;
    EXPECT_NE(far.out.find("note (lit, dark): no shorter trace exists"), std::string::npos) << far.out;
    EXPECT_NE(far.out.find("counterexample:"), std::string::npos) << far.out;
    EXPECT_NE(far.out.find("why: this engine decides only properties of states, not of runs"), std::string::npos)
        << far.out;

    const Result near = grafverif({"check", file, "--engine", "bmc", "--max-steps", "1", "--property", "dark"});
    EXPECT_EQ(near.code, ExitCode::Unknown) << near.err;
    EXPECT_NE(near.out.find("no run of up to 1 step violates the property"), std::string::npos) << near.out;
}

TEST(Auto, NamesTheSymbolicEngineThatDecidesAloneAndUsesTheTimedOneForTimedModels) {
    const Folder folder;
    const std::string file = folder.write(
        "lamp.grafcet", lamp("property one: never L && M; property dark: never M; property back: X1 leads to X0;"));
    const Result result = grafverif({"check", file, "--untimed", "--engine", "auto"});
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
    EXPECT_EQ(result.out, grafverif({"check", file, "--untimed", "--engine", "symbolic"}).out);
    EXPECT_EQ(result.out, grafverif({"check", file, "--untimed"}).out);
    EXPECT_NE(result.out.find("checked with: symbolic, untimed: no plant"), std::string::npos) << result.out;
    EXPECT_TRUE(holds(result.out, "one")) << result.out;
    EXPECT_NE(result.out.find("dark: violated"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("back: "), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find("unknown"), std::string::npos) << result.out;
    EXPECT_EQ(grafverif({"check", file, "--engine", "auto"}).out, grafverif({"check", file}).out);
}

TEST(Auto, IsTheDefaultAndDecidesByLocalizationFirstAndTheRestByEngines) {
    const std::string line = (root / "samples/transfer_line/transfer_line.grafcet").string();
    const std::vector<std::string> command = {"check",   line,     "--untimed", "--plant", "automata",
                                              "--grain", "atomic", "--format",  "json"};
    std::vector<std::string> one_thread = command;
    one_thread.insert(one_thread.end(), {"--jobs", "1"});
    const Result ran = grafverif(command);
    EXPECT_EQ(ran.code, ExitCode::Unknown) << "an untimed model cannot decide `no timelock`";
    const auto properties = nlohmann::json::parse(ran.out)["properties"];
    const std::vector<std::string> names = {"held[1]", "released[1]", "held[2]",     "released[2]",
                                            "held[3]", "released[3]", "no_timelock", "no_out_of_range"};
    ASSERT_EQ(properties.size(), names.size());
    for (std::size_t k = 0; k < names.size(); ++k) {
        SCOPED_TRACE(names[k]);
        EXPECT_EQ(properties[k]["name"], names[k]);
        EXPECT_EQ(properties[k]["verdict"], k == 6 ? "unknown" : "holds");
        EXPECT_EQ(properties[k].contains("cells"), k < 6);
        if (k < 6) {
            EXPECT_EQ(properties[k]["notes"], nlohmann::json{"decided by localization (cells)"});
        }
    }
    const nlohmann::json in_sequence = nlohmann::json::parse(grafverif(one_thread).out);
    for (const auto& [key, property] : in_sequence["properties"].items())
        EXPECT_EQ(property["verdict"], properties[std::stoul(key)]["verdict"]) << property["name"];
    std::vector<std::string> whole = command;
    whole.insert(whole.end(),
                 {"--monolithic", "--property", "no_out_of_range", "--property", "held[2]", "--timeout", "300ms"});
    EXPECT_EQ(grafverif(whole).out.find("decided by localization (cells)"), std::string::npos);
}

TEST(Pdr, TimeAndMemoryEndInUnknown) {
    for (const std::string engine : {"pdr", "bmc", "auto"}) {
        const Result late = grafverif({"check", tanks, "--untimed", "--engine", engine, "--timeout", "0ms"});
        EXPECT_EQ(late.code, ExitCode::Unknown);
        EXPECT_NE(late.out.find("stopped at the time limit of 0 s"), std::string::npos) << late.out;
        const Result small = grafverif({"check", engine == "auto" ? faulty : station, "--engine", engine, "--plant",
                                        "automata", "--time", "discrete", "--max-memory", "1M", "--property", "P15"});
        EXPECT_EQ(small.code, ExitCode::Unknown) << small.err;
        EXPECT_NE(small.out.find("memory limit of 1 MiB reached"), std::string::npos) << small.out;
    }
}

TEST(Pdr, DecidesStabilityOfAChartAloneAndNamesTheEngine) {
    const Folder folder;
    const std::string file = folder.write("flutter.grafcet",
                                          "grafcet flutter { input A; output L; initial step 0; step 1 { L; }\n"
                                          "transition t0: 0 -> 1 when A; transition t1: 1 -> 0 when A; }\n");
    for (const std::string engine : {"pdr", "abc"}) {
        if (engine == "abc" && !find_program("berkeley-abc")) GTEST_SKIP() << "berkeley-abc is not installed";
        const Result result = grafverif({"check", file, "--engine", engine});
        EXPECT_EQ(result.code, ExitCode::Verdict) << result.out << result.err;
        EXPECT_TRUE(holds(result.out, "reachable (2 steps)")) << result.out;
        EXPECT_NE(result.out.find("(not declared): violated"), std::string::npos) << result.out;
        EXPECT_NE(result.out.find("note: decided by the exploration of `analyse`, not by " + engine), std::string::npos)
            << result.out;
        const Result alone = grafverif({"check", file, "--engine", engine, "--property", "stabilises"});
        EXPECT_EQ(alone.code, ExitCode::Verdict) << alone.err;
        EXPECT_EQ(alone.out.find("reachable"), std::string::npos) << alone.out;
    }
    EXPECT_EQ(grafverif({"check", file}).out.find("not by"), std::string::npos)
        << "the default engine includes the exploration";
}

TEST(Abc, ProvesWithAnInvariantThatIsCheckedAndShowsRuns) {
    if (!find_program("berkeley-abc")) GTEST_SKIP() << "berkeley-abc is not installed";
    const Folder folder;
    const std::string file = folder.write(
        "lamp.grafcet", lamp("property one: never L && M; property lit: reachable M; property dark: never M;"));
    for (const std::vector<std::string>& plant : {std::vector<std::string>{}, {"--plant", "automata"}}) {
        std::vector<std::string> arguments = {"check", file, "--engine", "abc"};
        arguments.insert(arguments.end(), plant.begin(), plant.end());
        const Result result = grafverif(arguments);
        EXPECT_EQ(result.code, ExitCode::Verdict) << result.out << result.err;
        EXPECT_TRUE(holds(result.out, "one")) << result.out;
        EXPECT_NE(result.out.find("checked by a solver"), std::string::npos) << result.out;
        EXPECT_TRUE(holds(result.out, "lit")) << result.out;
        EXPECT_NE(result.out.find("dark: violated"), std::string::npos) << result.out;
        EXPECT_NE(result.out.find("counterexample:"), std::string::npos) << result.out;
    }
}

/// The behaviour of a stand-in, and the expected message.
struct Lie {
    const char* property;
    std::string script, why;
};

std::string verdict_on(const Folder& folder, const Lie& lie, const std::vector<std::string>& engine) {
    const std::string file = folder.write("lamp.grafcet", lamp("property P: " + std::string(lie.property) + ";"));
    std::vector<std::string> arguments = {"check", file};
    arguments.insert(arguments.end(), engine.begin(), engine.end());
    const Result result = grafverif(arguments);
    EXPECT_EQ(result.code, ExitCode::Unknown) << result.out << result.err;
    EXPECT_NE(result.out.find("P: unknown"), std::string::npos) << result.out;
    return result.out;
}

TEST(Abc, WrongResultOfTheProgramIsRejected) {
    const std::string names = "printf '.i 1\\n.o 1\\n.ilb l0\\n.ob inv\\n";
    for (const Lie& lie : {
             Lie{"never L", "case \"$2\" in *pdr*) " + names + ".e\\n' > invariant.pla;; esac",
                 "engine-disagrees: the invariant for `P` is invalid: the invariant does not exclude the bad states"},
             {"never L && M", "case \"$2\" in *pdr*) " + names + "1 1\\n.e\\n' > invariant.pla;; esac",
              "engine-disagrees: the invariant for `P` is invalid: "},
             {"never L && M", "case \"$2\" in *pdr*) " + names + "0 1\\n.e\\n' > invariant.pla;; esac",
              "engine-disagrees: the invariant for `P` is invalid: the invariant excludes an initial state"},
             {"never L && M", "case \"$2\" in *pdr*) " + names + "1 1\\n' > invariant.pla;; esac",
              "engine-disagrees: the program printed no invariant for its verdict"},
             {"never L && M", "case \"$2\" in *pdr*) printf '.ilb l9999999\\n.e\\n' > invariant.pla;; esac",
              "engine-disagrees: the program printed no invariant for its verdict"},
             {"never L && M", "printf '1\\nb0\\n' > witness",
              "engine-disagrees: the program printed no trace for its verdict"},
             {"never L && M", "printf '1\\nb0\\n11\\n0# DONE\\n' > witness",
              "engine-disagrees: the program printed no trace for its verdict"},
             {"never L", "echo 'Property proved.'", "the program printed no verdict"},
             {"never L", "exec yes", "the output of the program is too large"},
             {"never L", "kill -SEGV $$", "the program was terminated by signal 11"},
         }) {
        SCOPED_TRACE(lie.script);
        const Folder folder;
        fs::permissions(folder.write("berkeley-abc", "#!/bin/sh\n" + lie.script + "\n"), fs::perms::owner_all);
        const Path path(folder.file("") + ":/usr/bin:/bin");
        const std::string out = verdict_on(folder, lie, {"--engine", "abc"});
        EXPECT_NE(out.find("why: " + lie.why), std::string::npos) << out;
    }
}

TEST(EngineCommand, ResultsAreValidatedOrUnknown) {
    for (const Lie& lie : {
             Lie{"never L && M", "echo 0; echo b0; echo . ; true",
                 "unchecked: the program reports that no run reaches the target state"},
             {"never L", "echo 2 ; true", "the program printed no verdict"},
             {"never L", "echo 1; true", "engine-disagrees: the program printed no trace for its verdict"},
             {"never L", "exit 1; true", "the program printed no verdict"},
             {"never L", "kill -SEGV $$; true", "the program was terminated by signal 11"},
         }) {
        SCOPED_TRACE(lie.script);
        const Folder folder;
        const std::string out = verdict_on(folder, lie, {"--engine-command", lie.script});
        EXPECT_NE(out.find("why: " + lie.why), std::string::npos) << out;
    }
}

TEST(EngineCommand, ProgramThatNeverEndsIsTerminated) {
    const Folder folder;
    const std::string file = folder.write("lamp.grafcet", lamp("property P: never L;"));
    const Result result = grafverif({"check", file, "--engine-command", "sleep 1000; true", "--timeout", "300ms"});
    EXPECT_EQ(result.code, ExitCode::Unknown);
    EXPECT_NE(result.out.find("why: stopped at the time limit of 0.3 s"), std::string::npos) << result.out;
}

TEST(EngineCommand, ShareOfOneQueryIsDistinguishedFromTheTimeLimit) {
    const Folder folder;
    const std::string file = folder.write("lamp.grafcet", lamp("property P: never L; property Q: never M;"));
    const Result result = grafverif({"check", file, "--engine-command", "sleep 1000; true", "--timeout", "600ms"});
    EXPECT_EQ(result.code, ExitCode::Unknown);
    const std::size_t first = result.out.find("why: the share of the time limit for this property is used up");
    EXPECT_NE(first, std::string::npos) << result.out;
    EXPECT_NE(result.out.find("why: stopped at the time limit of 0.6 s", first), std::string::npos) << result.out;
}

TEST(EngineCommand, MissingProgramGivesNoVerdict) {
    const Folder folder;
    const std::string out = verdict_on(folder, {"never L", "", ""}, {"--engine-command", "no-such-checker"});
    EXPECT_NE(out.find("why: the program printed no verdict and exited with status 127"), std::string::npos) << out;
}

TEST(EngineCommand, ShowsTheRunOfTheProgram) {
    if (!find_program("berkeley-abc")) GTEST_SKIP() << "berkeley-abc is not installed";
    const Folder folder;
    const std::string file = folder.write("lamp.grafcet", lamp("property P: never L;"));
    const std::string checker = folder.write("checker",
                                             "#!/bin/sh\nberkeley-abc -q \"read_aiger $1; bmc3 -F 9; write_cex -a "
                                             "out\" >/dev/null\necho 1; echo b0; sed 's/# DONE//' out; echo .\n");
    fs::permissions(checker, fs::perms::owner_all);
    const Result result = grafverif({"check", file, "--engine-command", checker});
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.out;
    EXPECT_NE(result.out.find("P: violated"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("counterexample:"), std::string::npos) << result.out;
    const Result both = grafverif({"check", file, "--engine", "abc", "--engine-command", checker});
    EXPECT_EQ(both.code, ExitCode::Input);
    EXPECT_NE(both.err.find("are mutually exclusive"), std::string::npos) << both.err;
}

}  // namespace
}  // namespace grafverif::app
