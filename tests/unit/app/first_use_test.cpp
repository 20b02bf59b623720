// SPDX-License-Identifier: MIT
// Tests the messages for new users: wrong files, wrong commands, incomplete charts.
#include <gtest/gtest.h>

#include <string>

#include "app/options.hpp"
#include "app/stop_text.hpp"
#include "run_program.hpp"

namespace grafverif::app {
namespace {

const std::string pick_and_place = (root / "samples/pick_and_place/pick_and_place.grafcet").string();

constexpr const char* lone =
    "grafcet lone { input x; output L; initial step 0; step 1 { L; } transition t: 0 -> 1 when x; transition u: 1 -> 0 "
    "when !x; }\n";

bool says(const Result& result, const std::string& what) { return result.err.find(what) != std::string::npos; }

TEST(FirstUse, ImportRejectsUnknownFormatsWithHint) {
    const Folder folder;
    struct Case {
        std::string text, message;
    };
    for (const Case& c :
         {Case{"hello this is junk\n", "error: unknown file format; supported formats are AGRAFE GRAFCET"},
          Case{"", "error: unknown file format; supported"},
          Case{std::string("\x01\x02\x03\xFF\x00\x01", 6), "error: unknown file format; supported"},
          Case{std::string("g\0r\0a\0f\0", 8), "error: unknown file format; supported"},
          Case{"<?xml version=\"1.0\"?>\n<html/>\n", "error: unknown file format, starting with `html`"},
          Case{
              lone,
              "error: the file is in grafverif's own language and needs no import; pass it to any command directly"}}) {
        SCOPED_TRACE(c.text);
        const Result result = grafverif({"import", folder.write("file", c.text)});
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_TRUE(says(result, c.message)) << result.err;
        EXPECT_EQ(result.out, "");
    }
}

TEST(FirstUse, ImportWritesOnlyChartsThatCommandsAccept) {
    const Folder folder;
    const std::string file = folder.write(
        "flawed.xmi",
        R"(<g:Grafcet xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns:g="http://www.example.org/grafcet" xmlns:t="http://www.example.org/terms" name="flawed">
<variableDeclarationContainer><variableDeclarations name="a"><sort xsi:type="t:Bool"/></variableDeclarations>
<variableDeclarations name="x" variableDeclarationType="internal"><sort xsi:type="t:Integer"/></variableDeclarations></variableDeclarationContainer>
<partialGrafcets xsi:type="g:PartialGrafcet" name="G1"><steps xsi:type="g:Step" id="1" initial="true"/>
<actionTypes xsi:type="g:StoredAction" storedActionType="event">
<term xsi:type="t:And"><subterm xsi:type="t:Variable" variableDeclaration="//@variableDeclarationContainer/@variableDeclarations.0"/><subterm xsi:type="t:Not"><subterm xsi:type="t:Variable" variableDeclaration="//@variableDeclarationContainer/@variableDeclarations.0"/></subterm></term>
<variable variableDeclaration="//@variableDeclarationContainer/@variableDeclarations.1"/><value xsi:type="t:IntegerConstant" value="1"/></actionTypes>
<actionLinks step="//@partialGrafcets.0/@steps.0" actionType="//@partialGrafcets.0/@actionTypes.0"/></partialGrafcets></g:Grafcet>
)");
    const Result result = grafverif({"import", file, "-o", folder.file("out.grafcet")});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_TRUE(says(result, "flawed.xmi:5:2: error: `x` is assigned on an event that can be true without an edge"))
        << result.err;
    EXPECT_EQ(folder.entries(), 1U);
}

TEST(FirstUse, ChartWithoutLoopGetsAHintToSuitableCommands) {
    const Folder folder;
    const std::string chart = folder.write("lone.grafcet", lone);
    for (const char* verb : {"build", "uppaal"}) {
        const Result result = grafverif({verb, chart});
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_TRUE(
            says(result,
                 "or use a command for charts: `plc` runs a chart, `check` checks a chart, `nusmv` writes a model of a "
                 "chart"))
            << result.err;
    }
    EXPECT_EQ(grafverif({"simulate", chart}, "quit\n").code, ExitCode::Done);
    EXPECT_EQ(grafverif({"plc", chart}, "1\n").out, "1\n");
    EXPECT_EQ(grafverif({"check", chart}).code, ExitCode::Done);
    EXPECT_EQ(grafverif({"nusmv", chart}).code, ExitCode::Done);
}

TEST(FirstUse, HelpComesInEveryOrderOfWords) {
    const std::string help = grafverif({"check", "--help"}).out;
    EXPECT_TRUE(help.starts_with("Usage: grafverif check FILE"));
    EXPECT_EQ(grafverif({"help", "check"}).out, help);
    EXPECT_EQ(grafverif({"--help", "check"}).out, help);
    EXPECT_EQ(grafverif({"help"}).out, grafverif({"--help"}).out);
    EXPECT_TRUE(says(grafverif({"chek", "file"}), "unknown command `chek`; did you mean `check`?"));
    EXPECT_TRUE(says(grafverif({"help", "chek"}), "unknown command `chek`; did you mean `check`?"));
    EXPECT_TRUE(says(grafverif({"--timeout", "3s", "check"}),
                     "expected a command before `--timeout`; write options after the command"));
}

TEST(FirstUse, MisspeltOptionOrNameGetsASuggestion) {
    EXPECT_TRUE(says(grafverif({"check", station, "--proprty", "P14"}),
                     "unknown option `--proprty`; did you mean `--property`?"));
    EXPECT_TRUE(
        says(grafverif({"check", station, "--colour", "never"}), "unknown option `--colour`; did you mean `--color`?"));
    EXPECT_TRUE(says(grafverif({"check", station, "--frobnicate"}), "unknown option `--frobnicate`; see"));
    EXPECT_TRUE(says(grafverif({"check", station, "--property", "P41"}), "no property `P41`; did you mean `P14`?"));
    EXPECT_TRUE(says(grafverif({"check", station, "--property", "cup"}),
                     "no property `cup`; choose one of `P14`, `P15`, `no_deadlock`, `no_timelock`"));
    EXPECT_TRUE(
        says(grafverif({"check", station, "--loop", "staton"}), "no closed loop `staton`; did you mean `station`?"));
    EXPECT_TRUE(
        says(grafverif({"equations", station, "--chart", "testing_staton"}), "did you mean `testing_station`?"));
    EXPECT_TRUE(says(grafverif({"draw", station, "--situation", "W22"}), "no step `W22`;"));
}

TEST(FirstUse, InvalidNumberIsRejectedWithASuggestion) {
    for (const auto& [arguments, advice] : {
             std::pair(std::vector<std::string>{"check", station, "--timeout", "5"},
                       "`--timeout 5` has no unit; write `5s`"),
             std::pair(std::vector<std::string>{"check", station, "--timeout", "0"},
                       "`--timeout 0` has no unit; write `0s`"),
             std::pair(std::vector<std::string>{"draw", station, "--max-memory", "500"},
                       "`--max-memory 500` has no unit; write `500M`"),
             std::pair(std::vector<std::string>{"check", station, "--max-memory", "1X"},
                       "invalid value `1X` of `--max-memory`; use a whole number with one of the units `M`, `K`, `G`"),
             std::pair(
                 std::vector<std::string>{"check", station, "--timeout", "s"},
                 "invalid value `s` of `--timeout`; use a whole number with one of the units `s`, `ms`, `min`, `h`"),
             std::pair(std::vector<std::string>{"check", station, "--max-states", "5k"},
                       "invalid value `5k` of `--max-states`; use a whole number"),
             std::pair(std::vector<std::string>{"check", station, "--timeout", "99999999999999999999s"},
                       "value `99999999999999999999s` of `--timeout` is too large; reduce it"),
             std::pair(std::vector<std::string>{"check", station, "--max-memory", "99999999999999999G"},
                       "value `99999999999999999G` of `--max-memory` is too large; reduce it"),
         }) {
        const Result result = grafverif(arguments);
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_TRUE(says(result, advice)) << result.err;
    }
}

TEST(FirstUse, ACommandMustBeASeparateArgument) {
    const Folder folder;
    const std::string ran = folder.file("ran");
    for (const auto& [verb, option] : {std::pair("check", "--engine-command"), std::pair("test", "--against")}) {
        const Result result = grafverif({verb, station, option + ("=touch " + ran)});
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_TRUE(says(result, "is ambiguous, because a file may have this name; write `" + std::string(option)))
            << result.err;
        EXPECT_FALSE(fs::exists(ran));
    }
    EXPECT_TRUE(says(grafverif({"check", "--", "--engine-command=touch " + ran}), "no such file"));
}

TEST(FirstUse, OptionWithoutEffectIsRejected) {
    const Folder folder;
    const std::string file = folder.write("one.grafcet", "grafcet c { input x; output o; initial step 0 { o; } }\n");
    struct Case {
        std::vector<std::string> arguments = {};
        std::string error_text = {};
    };
    for (const Case& each : std::vector<Case>{
             {{"check", file, "--from", "3"}, "`--from` requires `--trace-svg`; add it"},
             {{"check", file, "--max-steps", "3"}, "`--max-steps` applies only to `--engine bmc`"},
             {{"check", file, "--engine-command", ""}, "the value of `--engine-command` is empty"},
             {{"check", file, "--chart", "c", "--loop", "l"},
              "`--chart` and `--loop` are mutually exclusive; remove one"},
             {{"check", file, "--properties", "p.yaml", "--untimed"}, "`--properties` checks a PLC program"},
             {{"check", file, "--properties", "p.yaml", "--list"}, "`--properties` checks a PLC program"},
             {{"simulate", file, "--chart", "c", "--grain", "atomic"},
              "`--chart` and `--grain` are mutually exclusive; remove one"},
             {{"simulate", file, "--steps", "3"}, "`--steps` requires `--random`; add it"},
             {{"simulate", file, "--junit", "r.xml"}, "`--junit` requires `--script`; add it"},
             {{"simulate", file, "--script", "s", "--random", "1"},
              "`--script` and `--random` are mutually exclusive; remove one"},
             {{"test", file, "--against", "x", "--sequence", "s", "--cover", "locations"},
              "`--sequence` and `--cover` are mutually exclusive; remove one"},
             {{"mutate", file, "--seed", "3"}, "`--seed` requires `--limit`; add it"},
             {{"mutate", file, "--limit", "0"}, "invalid value of `--limit`; use a number of at least 1"},
             {{"supervise", file, "--marked", ""}, "the value of `--marked` is empty"},
             {{"watch", "chekc", file}, "unknown command `chekc`; did you mean `check`?"},
             {{"manual", "chekc"}, "unknown command `chekc`; did you mean `check`?"},
         }) {
        const Result result = grafverif(each.arguments);
        EXPECT_EQ(result.code, ExitCode::Input) << each.error_text;
        EXPECT_NE(result.err.find("grafverif: error: " + each.error_text), std::string::npos) << result.err;
    }
}

/// The complete loop has too many states. The undeclared property is proved without it, as if it were declared.
TEST(FirstUse, UndeclaredTimelockOfAStationIsProvedIfItIsSelected) {
    const std::string lift = (root / "bench/stations/independent/goods_lift.grafcet").string();
    const Result result = grafverif({"check", lift, "--property", "no_timelock", "--max-states", "200000"});
    EXPECT_EQ(result.code, ExitCode::Done) << result.out << result.err;
    EXPECT_NE(result.out.find("\nno_timelock (not declared)  holds"), std::string::npos) << result.out;
}

TEST(FirstUse, StepOfAPropertyIsSelectedByTheNameOfItsVerdict) {
    const Result one = grafverif({"check", pick_and_place, "--property", "all_steps.X11", "--format", "json"});
    EXPECT_EQ(one.code, ExitCode::Done) << one.err;
    EXPECT_NE(one.out.find("\"all_steps.X11\""), std::string::npos);
    EXPECT_EQ(one.out.find("all_steps.X1\""), std::string::npos);
    EXPECT_TRUE(says(grafverif({"check", pick_and_place, "--property", "all_steps.X71"}),
                     "no property `all_steps.X71`; did you mean `all_steps.X1`?"));
    EXPECT_EQ(grafverif({"check", station, "--property", "no_timelock"}).code, ExitCode::Done);
    const Result undeclared =
        grafverif({"check", (root / "samples/blinker/blinker.grafcet").string(), "--property", "no_timelock"});
    EXPECT_EQ(undeclared.code, ExitCode::Done) << undeclared.err;
    EXPECT_TRUE(undeclared.out.ends_with("blinker_loop: 1 holds\n")) << undeclared.out;
}

TEST(FirstUse, AFolderIsNotWrittenToStandardOutput) {
    const Result result = grafverif({"build", station, "-o", "-"});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_TRUE(says(result, "`build` writes a folder, which `-` is not")) << result.err;
}

TEST(FirstUse, ColoursAreUsedOnTerminalsByDefault) {
    struct Case {
        bool terminal;
        std::string no_color, clicolor_force, term;
        bool coloured;
    };
    for (const Case& c :
         {Case{true, "", "", "xterm", true}, Case{false, "", "", "xterm", false}, Case{true, "", "", "dumb", false},
          Case{true, "", "", "", false}, Case{true, "1", "", "xterm", false}, Case{true, "1", "1", "xterm", false},
          Case{false, "", "1", "dumb", true}, Case{false, "", "0", "xterm", false}, Case{true, "", "0", "xterm", true}})
        EXPECT_EQ(has_colours(c.terminal, c.no_color, c.clicolor_force, c.term), c.coloured);
    std::istringstream in;
    for (const char* choice : {"auto", "always", "never"}) {
        for (const bool coloured : {false, true}) {
            std::ostringstream out, err;
            const std::vector<std::string> check = {"check", station, "--color", choice};
            run(check, {in, out, err, false, {.terminal = true, .colours = coloured, .columns = 60}});
            EXPECT_EQ(out.str().find("\033[1;32mholds\033[0m") != std::string::npos,
                      *choice == 'a' && (choice[1] == 'l' || coloured))
                << choice;
            EXPECT_EQ(out.str().find("says"), std::string::npos) << "the table has no space for descriptions";
        }
    }
}

TEST(FirstUse, SeveralLoopsAreListedWithTheSelectingOption) {
    const Folder folder;
    const std::string loop = " { controller lone; environment X = free(OUT = x); }\n";
    const Result result = grafverif(
        {"check", folder.write("two.grafcet", lone + ("closed_loop one" + loop) + "closed_loop other" + loop)});
    EXPECT_TRUE(says(result, "error: the file has several closed loops: `one`, `other`; choose with `--loop`"))
        << result.err;
}

TEST(FirstUse, ReasonNamesTheCauseOfTheStop) {
    Options options;
    EXPECT_EQ(with_who_stopped("stopped after 3 states", true, options),
              "stopped by Ctrl-C or another signal after 3 states");
    EXPECT_EQ(with_who_stopped("stopped after 3 states", false, options), "stopped after 3 states");
    options.timeout_ms = 1500;
    EXPECT_EQ(with_who_stopped("stopped", false, options), "stopped at the time limit of 1.5 s");
    EXPECT_EQ(with_who_stopped("verifyta was stopped at the time limit", false, options),
              "verifyta was stopped at the time limit of 1.5 s");
    EXPECT_EQ(with_who_stopped("memory limit of 16 MiB reached", true, options), "memory limit of 16 MiB reached");
}

TEST(FirstUse, EveryCommandThatTimesOutNamesTheTimeLimit) {
    EXPECT_NE(grafverif({"check", station, "--timeout", "0s"}).out.find("why: stopped at the time limit of 0 s"),
              std::string::npos);
    EXPECT_NE(grafverif({"analyse", station, "--timeout", "0s"})
                  .out.find("stopped at the time limit of 0 s before completion"),
              std::string::npos);
    const Result automaton = grafverif({"automaton", station, "--timeout", "0s"});
    EXPECT_TRUE(says(automaton, "stopped at the time limit (`--timeout`)")) << automaton.err;
}

TEST(FirstUse, ALoopWithAScheduleIsSentToItsUntimedModel) {
    const Result timed = grafverif({"check", pick_and_place});
    EXPECT_EQ(timed.code, ExitCode::Verdict);
    EXPECT_TRUE(says(timed,
                     "note: `pick_and_place` declares a `schedule`, which applies only to untimed models; to check "
                     "the untimed model, run `grafverif check " +
                         pick_and_place + " --untimed --plant automata`"))
        << timed.err;
    EXPECT_FALSE(says(grafverif({"check", pick_and_place, "--quiet"}), "note: "));
    EXPECT_FALSE(says(grafverif({"check", station, "--timeout", "0s"}), "declares a `schedule`"));
}

TEST(FirstUse, AConstraintThatIsProvedIsShown) {
    const Result result = grafverif({"check", pick_and_place, "--property", "VC_constraint_1"});
    EXPECT_NE(result.out.find("VC_constraint_1             holds    <library>/cylinder_5_2.grafcet:33  !(vc_in && "
                              "vc_out) holds for this plant\n"),
              std::string::npos)
        << result.out;
    const Folder folder;
    const std::string report = folder.file("r.xml");
    grafverif({"check", pick_and_place, "--property", "VC_constraint_1", "--junit", report});
    const std::string instance = "plant VC =";
    const std::string text = folder.read(pick_and_place);
    const std::size_t at = text.find(instance);
    ASSERT_NE(at, std::string::npos);
    const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
    EXPECT_NE(folder.read("r.xml").find("name=\"VC_constraint_1\" file=\"" + pick_and_place + "\" line=\"" +
                                        std::to_string(line) + "\""),
              std::string::npos)
        << "the position of the instance, not of the loop";
}

}  // namespace
}  // namespace grafverif::app
