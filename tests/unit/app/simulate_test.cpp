// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "run_program.hpp"
#include "simulate/commands.hpp"

namespace grafverif::app {
namespace {

const std::string blinker = (root / "samples/blinker/blinker.grafcet").string();

/// Returns the output without the padding of columns.
std::string squeezed(const std::string& text) {
    std::string result;
    for (const char c : text)
        if (c != ' ' || (!result.empty() && result.back() != ' ' && result.back() != '\n')) result += c;
    return result;
}

TEST(Commands, AreReadLineByLine) {
    using Relation = Expectation::Relation;
    struct Case {
        const char* line;
        Command command;
    };
    for (const Case& c : std::vector<Case>{
             {"START = true", SetCommand{{{"START", 1}}}},
             {"START=false // release", SetCommand{{{"START", 0}}}},
             {"LEVEL = -3", SetCommand{{{"LEVEL", -3}}}},
             {"A = true, N = 3", SetCommand{{{"A", 1}, {"N", 3}}}},
             {"A = true,B=false", SetCommand{{{"A", 1}, {"B", 0}}}},
             {"A = true B = false", BadCommand{"the assignment is incomplete; write `NAME = VALUE`"}},
             {"A = true,", BadCommand{"the assignment is incomplete; write `NAME = VALUE`"}},
             {"wait 3s", WaitCommand{3000}},
             {"wait 250 ms", WaitCommand{250}},
             {"wait 2min # long", WaitCommand{120'000}},
             {"wait", WaitCommand{}},
             {"do Tester passed", DoCommand{"Tester", "passed"}},
             {"do Start", DoCommand{"Start", ""}},
             {"force G1.3 on", ForceCommand{"G1.3", true}},
             {"force 3 off // for trial", ForceCommand{"3", false}},
             {"force 3", BadCommand{"`force` is incomplete; write `force STEP on` or `force STEP off`"}},
             {"force 3 true", BadCommand{"`force` is incomplete; write `force STEP on` or `force STEP off`"}},
             {" 12 ", ChooseCommand{12}},
             {"back", BackCommand{}},
             {"undo", BackCommand{}},
             {"show", ShowCommand{}},
             {"expect X3", ExpectCommand{{{{"X3", Relation::Equal, 1, ""}}, "X3"}, 0}},
             {"expect not LAMP, N>=3 // both",
              ExpectCommand{{{{"LAMP", Relation::Equal, 0, ""}, {"N", Relation::AtLeast, 3, ""}}, "not LAMP, N >= 3"},
                            0}},
             {"expect LAMP = true", ExpectCommand{{{{"LAMP", Relation::Equal, 1, ""}}, "LAMP = true"}, 0}},
             {"expect within 5 s Gate in open",
              ExpectCommand{{{{"Gate", Relation::In, 1, "open"}}, "Gate in open"}, 5000}},
             {"wait until press.X3 and N != 2",
              ExpectCommand{
                  {{{"press.X3", Relation::Equal, 1, ""}, {"N", Relation::NotEqual, 2, ""}}, "press.X3 and N != 2"},
                  {}}},
             {"repeat 3 {", RepeatCommand{3}},
             {"}", EndCommand{}},
             {"repeat 0 {",
              BadCommand{"invalid `repeat`; write `repeat 3 {`, and `}` on a separate line after the repeated lines"}},
             {"expect", BadCommand{"the condition is missing; write for example `X3`, `not LAMP` or `LEVEL >= 3`"}},
             {"expect X3 X4", BadCommand{"unexpected `X4` in a condition; write for example `X3 and LEVEL >= 3`"}},
             {"expect N >=",
              BadCommand{"the comparison `N >=` has no valid value; write a whole number, `true` or `false`"}},
             {"expect not N >= 3",
              BadCommand{
                  "`not` is not allowed before the comparison `N >=`; remove `not` and use the opposite comparison"}},
             {"expect within X3",
              BadCommand{
                  "`expect within` requires a duration and a condition; write for example `expect within 3s X3`"}},
             {"q", QuitCommand{}},
             {"?", HelpCommand{}},
             {"", NoCommand{}},
             {"// nothing", NoCommand{}},
             {"wait 3", BadCommand{"`wait` requires a duration; write `3s`, `250ms` or `2min`, for example"}},
             {"wait 0s", BadCommand{"`wait` requires a duration; write `3s`, `250ms` or `2min`, for example"}},
             {"START = maybe", BadCommand{"invalid value `maybe`; write `true`, `false` or a whole number"}},
             {"START =", BadCommand{"the assignment is incomplete; write `NAME = VALUE`"}},
             {"0", BadCommand{"unknown command `0`; list the commands with `help`"}},
             {"press START", BadCommand{"unknown command `press`; list the commands with `help`"}},
         }) {
        SCOPED_TRACE(c.line);
        EXPECT_EQ(command_of(c.line), c.command);
    }
}

TEST(Simulate, FollowsAScriptAndPrintsTheSituationAsATraceDoes) {
    const Folder folder;
    const std::string script =
        folder.write("press.txt", "wait 1s\nBUTTON = true   // press\nwait 2s\nBUTTON = false\nwait 1s\n");
    const Result result = grafverif({"simulate", blinker, "--script", script});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    EXPECT_EQ(squeezed(result.out),
              "time event inputs cleared situation outputs\n"
              "0 s blinker: power on none 0 none\n"
              "1 s 1 s passes 0 none\n"
              "1 s Button BUTTON\n"
              "blinker t0 1 LAMP\n"
              "Lamp: lit 1 LAMP\n"
              "3 s blinker: 2s/X1 is true\n"
              "blinker t1 2 none\n"
              "Lamp: dark 2 none\n"
              "Button !BUTTON 2 none\n"
              "4 s blinker: 1s/X2 is true\n"
              "blinker t3 0 none\n");
}

TEST(Simulate, MarksATrialInItsRowsAndInItsTraces) {
    const Folder folder;
    const std::string script = folder.write("trial.txt", "force 1 on\nforce 0 off\nwait 2s\n");
    for (const std::vector<std::string>& of : {std::vector<std::string>{}, {"--chart", "blinker"}}) {
        std::vector<std::string> command = {
            "simulate",           blinker,       "--script",          script, "--trace-svg",
            folder.file("t.svg"), "--trace-vcd", folder.file("t.vcd")};
        command.insert(command.end(), of.begin(), of.end());
        const Result result = grafverif(command);
        EXPECT_EQ(result.code, ExitCode::Done) << result.err;
        EXPECT_NE(squeezed(result.out).find("WHAT-IF: step 0 was forced"), std::string::npos) << result.out;
        for (const char* file : {"t.svg", "t.vcd"})
            EXPECT_NE(folder.read(file).find("not a run of the model"), std::string::npos) << file;
    }
    const Result back =
        grafverif({"simulate", blinker}, "force 1 on\nforce 0 off\nback\nback\nwait 1s\nBUTTON = true\nquit\n");
    EXPECT_EQ(back.code, ExitCode::Done);
    EXPECT_NE(squeezed(back.out).rfind("t0 1 LAMP"), std::string::npos) << back.out;
}

TEST(Simulate, StopsAScriptAtItsFirstCommandThatCannotBeExecuted) {
    const Folder folder;
    struct Case {
        const char* script;
        const char* error_text;
    };
    for (const Case& c : std::vector<Case>{
             {"BUTTON = true\n", ":1: error: no move can set `BUTTON` to true now; let 1 s pass\n"},
             {"wait 1s\n\nBUTTON = false\n", ":3: error: `BUTTON` is already false\n"},
             {"LAMP = true\n", ":1: error: unknown input `LAMP`\n"},
             {"wait 500ms\n",
              ":1: error: the duration is not a multiple of the time unit 1 s; wait for a multiple of it\n"},
             {"do Nobody\n", ":1: error: unknown instance `Nobody`\n"},
             {"do Lamp lit\n", ":1: error: `Lamp` cannot move to `lit` now\n"},
             {"7\n", ":1: error: no choice is available; let time pass with `wait`\n"},
             {"wait 1s\nback\nback\n", ":3: error: there is no command to undo\n"},
             {"wait\nwait\n", ":2: error: nothing changes as time passes; write `wait` with a duration\n"},
         }) {
        SCOPED_TRACE(c.script);
        const std::string script = folder.write("script.txt", c.script);
        const Result result = grafverif({"simulate", blinker, "--script", script});
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_EQ(result.err, script + c.error_text);
    }
    EXPECT_EQ(grafverif({"simulate", blinker, "--script", folder.file("none.txt")}).code, ExitCode::Input);
}

TEST(Simulate, ScriptsExpectAndRepeat) {
    const Folder folder;
    const std::string script = folder.write("test.txt",
                                            "expect X0 and not LAMP\n"
                                            "repeat 2 {\n"
                                            "    wait 1s\n"
                                            "    BUTTON = true\n"
                                            "    expect X1, LAMP = true, Lamp in lit\n"
                                            "    wait until X2\n"
                                            "    expect not LAMP and Lamp in dark\n"
                                            "    BUTTON = false\n"
                                            "    expect within 1s X0\n"
                                            "}\n");
    const Result result = grafverif({"simulate", blinker, "--script", script, "--junit", folder.file("r.xml")});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    EXPECT_NE(folder.read("r.xml").find("tests=\"5\" failures=\"0\" errors=\"0\""), std::string::npos)
        << folder.read("r.xml");
    EXPECT_NE(squeezed(result.out).find("8 s blinker: 1s/X2 is true"), std::string::npos) << result.out;
}

TEST(Simulate, ResolvesPortsAsPropertiesDo) {
    const Folder folder;
    const auto run = [&](const std::string& text) {
        return grafverif({"simulate", blinker, "--script", folder.write("test.txt", text)});
    };
    const Result good =
        run("wait 1s\nButton.OUT = true\nexpect Button.OUT and Lamp.ON and BUTTON\nexpect Lamp.ON = 1\n");
    EXPECT_EQ(good.code, ExitCode::Done) << good.err;
    const Result unmet = run("expect not Button.OUT\nexpect Lamp.ON\n");
    EXPECT_EQ(unmet.code, ExitCode::Verdict);
    EXPECT_NE(unmet.err.find("expected `Lamp.ON`, but `LAMP` is false"), std::string::npos) << unmet.err;
    const Result wrong = run("expect Lamp.OF\n");
    EXPECT_NE(wrong.err.find("unknown variable or step `Lamp.OF`"), std::string::npos) << wrong.err;
}

TEST(Simulate, ReportsUnmetExpectationsAndContinues) {
    const Folder folder;
    const std::string script = folder.write("test.txt",
                                            "expect X1\nwait 1s\nBUTTON = true\nexpect within 1s X2\nexpect X1\nwait "
                                            "until Lamp in dark\nBUTTON = false\nwait until X1\n");
    const Result result = grafverif({"simulate", blinker, "--script", script, "--junit", folder.file("r.xml")});
    EXPECT_EQ(result.code, ExitCode::Verdict);
    EXPECT_EQ(result.err,
              script + ":1: not met: expected `X1`, but `X1` is not active\n" + script +
                  ":4: not met: expected `X2`, but `X2` is not active after 1 s\n" + script +
                  ":8: not met: expected `X1`, but `X1` is not active, and nothing changes as time passes\n");
    EXPECT_NE(folder.read("r.xml").find("tests=\"5\" failures=\"3\" errors=\"0\""), std::string::npos)
        << folder.read("r.xml");
}

TEST(Simulate, ReadsTheCompleteScriptBeforeTheFirstMove) {
    const Folder folder;
    const std::string script = folder.write("test.txt", "wait 1s\nrepeat 2 {\npress\n}\n}\nrepeat 2 {\n");
    const Result result = grafverif({"simulate", blinker, "--script", script});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(result.err, script + ":3: error: unknown command `press`; list the commands with `help`\n" + script +
                              ":5: error: this `}` does not close a `repeat`; remove it\n" + script +
                              ":6: error: `repeat` is not closed; add `}`\n");
    const Result unknown = grafverif(
        {"simulate", blinker, "--script", folder.write("u.txt", "expect NOBODY\n"), "--junit", folder.file("r.xml")});
    EXPECT_EQ(unknown.code, ExitCode::Input);
    EXPECT_NE(unknown.err.find("error: unknown variable or step `NOBODY`"), std::string::npos);
    EXPECT_NE(folder.read("r.xml").find("errors=\"1\""), std::string::npos);
}

TEST(Simulate, WaitsTheRequestedTimeForAChartAlone) {
    const Folder folder;
    const std::string script = folder.write(
        "test.txt", "BUTTON = true\nexpect within 500ms LAMP\nexpect within 1500ms X2\nexpect within 500ms X2\n");
    const Result result = grafverif({"simulate", blinker, "--chart", "blinker", "--script", script});
    EXPECT_EQ(result.code, ExitCode::Verdict);
    EXPECT_EQ(result.err, script + ":3: not met: expected `X2`, but `X2` is not active after 1.5 s\n");
    EXPECT_NE(grafverif({"simulate", blinker, "--chart", "blinker"}, "BUTTON = true\nshow\n")
                  .out.find("output     LAMP = true"),
              std::string::npos);
}

TEST(Simulate, AsksForAChoiceIfThePlantHasOne) {
    const Folder folder;
    const std::string to_the_test = "wait 1s\nSTART = true\nwait 40s\n";
    const Result stopped = grafverif({"simulate", station, "--script", folder.write("a.txt", to_the_test)});
    EXPECT_EQ(stopped.code, ExitCode::Input);
    EXPECT_NE(stopped.err.find(
                  "time cannot pass before one of these moves: `Tester: passed, TEST_OK`, `Tester: failed, TEST_KO`"),
              std::string::npos)
        << stopped.err;
    const Result failed = grafverif({"simulate", station, "--script",
                                     folder.write("b.txt", "wait 1s\nSTART = true\nwait 39s\ndo Tester failed\n")});
    EXPECT_EQ(failed.code, ExitCode::Done) << failed.err;
    EXPECT_NE(squeezed(failed.out).find("testing_station T6b 20 P, V_G_IN\n"), std::string::npos) << failed.out;
}

TEST(Simulate, CanBeUsedInteractively) {
    const Result result =
        grafverif({"simulate", blinker}, "help\nwait 1s\n1\nback\nnonsense\nBUTTON = true\nquit\nwait 1s\n");
    EXPECT_EQ(result.code, ExitCode::Done);
    const std::string out = squeezed(result.out);
    EXPECT_NE(out.find("1 Button: BUTTON\nwait any time\n> "), std::string::npos) << out;
    EXPECT_NE(out.find("> back to:\n1 s 1 s passes 0 none\n"), std::string::npos) << out;
    EXPECT_NE(out.find("! unknown command `nonsense`"), std::string::npos);
    EXPECT_NE(out.find("wait up to 2 s\n> "), std::string::npos);
    EXPECT_EQ(result.err, "");
}

TEST(Simulate, EndsWithItsInput) { EXPECT_EQ(grafverif({"simulate", blinker}, "wait 1s").code, ExitCode::Done); }

TEST(Simulate, OffersEveryEdgeToTheUserIfVerbose) {
    const Result result = grafverif({"simulate", blinker, "--verbose"}, "do PLC P0\ndo PLC P1\nq\n");
    EXPECT_NE(result.out.find("blinker: cycle begins"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("blinker: inputs sampled"), std::string::npos);
    EXPECT_NE(squeezed(result.out).find("1 PLC: P2\n> "), std::string::npos);
}

TEST(Simulate, SavesASessionAsAScriptWithExpectations) {
    const Folder folder;
    const std::string saved = folder.file("saved.txt");
    const Result typed = grafverif({"simulate", blinker},
                                   "wait 1s\n1   // by its number\nwait 5min\nundo\nwait until X2\nundo\nwait 2s\n"
                                   "expect X0\nexpect X2\nnonsense\nBUTTON = false\nundo\nsave " +
                                       saved + "\n");
    EXPECT_NE(typed.out.find("saved; replay the session with `--script "), std::string::npos) << typed.out;
    const std::string script = folder.read("saved.txt");
    EXPECT_EQ(script.substr(script.find('\n') + 1),
              "wait 1s\ndo Button idle\nexpect X1, not X0, LAMP\nwait 2s\nexpect X2, not X1, not LAMP\nexpect X2\n");
    const Result again = grafverif({"simulate", blinker, "--script", saved, "--junit", folder.file("r.xml")});
    EXPECT_EQ(again.code, ExitCode::Done) << again.err;
    EXPECT_NE(folder.read("r.xml").find("tests=\"3\" failures=\"0\""), std::string::npos);
    EXPECT_NE(grafverif({"simulate", blinker}, "save " + blinker + "\n").out.find("exists and is not a saved session"),
              std::string::npos);
    EXPECT_NE(grafverif({"simulate", blinker}, "save\n").out.find("! the file name is missing; write `save FILE`"),
              std::string::npos);
    EXPECT_EQ(grafverif({"simulate", blinker, "--script", folder.write("s.txt", "save x\n")}).code, ExitCode::Input);
}

/// The script that a session saves repeats the session.
TEST(Simulate, SavedSessionsAreRepeated) {
    for (const char* of : {"blinker", "tanks", "oven_door"})
        for (unsigned seed = 1; seed <= 6; ++seed) {
            SCOPED_TRACE(of + std::to_string(seed));
            const Folder folder;
            const std::string file = (root / "samples" / of / (std::string(of) + ".grafcet")).string();
            const std::vector<std::string> chart =
                seed % 2 == 0 ? std::vector<std::string>{} : std::vector<std::string>{"--chart", of};
            std::mt19937 random(seed);
            std::string typed;
            for (int k = 0; k < 25; ++k)
                typed += std::vector<std::string>{"1",    "2",       "3",    "wait 700ms",        "wait 1s",
                                                  "wait", "wait 3s", "undo", "wait until NOTHING"}[random() % 9] +
                         "\n";
            std::vector<std::string> words = {"simulate", file};
            words.insert(words.end(), chart.begin(), chart.end());
            grafverif(words, typed + "save " + folder.file("s.txt") + "\n");
            words.insert(words.end(), {"--script", folder.file("s.txt")});
            const Result again = grafverif(words);
            EXPECT_EQ(again.code, ExitCode::Done) << folder.read("s.txt") << again.err;
        }
}

TEST(Simulate, UndoesACommandThatMadeSeveralMovesAsOne) {
    const Result result = grafverif(
        {"simulate", blinker}, "wait 1s\nBUTTON = true\nwait until X2\nundo\nexpect X1\nundo\nexpect X0\nundo\nundo\n");
    EXPECT_EQ(result.out.find("! expected"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("! there is no command to undo"), std::string::npos) << result.out;
}

TEST(Simulate, NoticesAChartThatNeverStabilises) {
    const Folder folder;
    const std::string file = folder.write(
        "endless.grafcet",
        "grafcet endless { input GO; output A, B; initial step 0; step 1 { A; } step 2 { B; }\n"
        "transition a: 0 -> 1 when GO; transition b: 1 -> 2 when GO; transition c: 2 -> 1 when GO; }\n"
        "closed_loop one { controller endless with stability_search; environment Go = free(OUT = GO); }\n");
    const Result result = grafverif({"simulate", file, "--script", folder.write("go.txt", "GO = true\n")});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_NE(result.err.find("with these inputs, the situation never becomes stable: {1} -> {2} -> {1}, forever"),
              std::string::npos)
        << result.err;
}

TEST(Simulate, RandomWalkIsDeterminedByTheSeed) {
    const Result first = grafverif({"simulate", station, "--random", "7", "--steps", "300"});
    EXPECT_EQ(first.code, ExitCode::Done) << first.err;
    EXPECT_EQ(grafverif({"simulate", station, "--random", "7", "--steps", "300"}).out, first.out);
    EXPECT_NE(grafverif({"simulate", station, "--random", "8", "--steps", "300"}).out, first.out);
    EXPECT_EQ(grafverif({"simulate", station, "--random", "many"}).code, ExitCode::Input);
}

TEST(Simulate, WritesTheTraceItMade) {
    const Folder folder;
    grafverif({"simulate", station, "--random", "1", "--trace-vcd", folder.file("w.vcd"), "--trace-svg",
               folder.file("w.svg")});
    EXPECT_NE(folder.read("w.vcd").find("$timescale"), std::string::npos);
    EXPECT_TRUE(folder.read("w.svg").starts_with("<svg"));
}

// A chart with a time condition, an edge, a stored action, an integer input, and a constraint.
const std::string press =
    "grafcet press { input UP, DOWN, GO, N: int 0..9; output MOVE; output LOCK; internal count: int 0..5;\n"
    "constraint !(UP && DOWN);\n"
    "initial step 0 { LOCK := false on activation; }\n"
    "step 1 { MOVE; LOCK := true on activation; }\n"
    "step 2 { count := count + 1 on activation; }\n"
    "transition a: 0 -> 1 when rise(GO) && UP;\n"
    "transition b: 1 -> 2 when 2s/X1 || N > 5;\n"
    "transition c: 2 -> 0 when DOWN; }\n";

TEST(SimulateChart, RunsOnTheRulesWithItsInputsSetByHand) {
    const Folder folder;
    const std::string file = folder.write("press.grafcet", press);
    const Result result = grafverif(
        {"simulate", file, "--script",
         folder.write("a.txt", "UP = true\nGO = true\nwait 5s\nUP = false, DOWN = true, GO = false\nN = 7\n")});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    EXPECT_EQ(squeezed(result.out),
              "time event inputs cleared situation outputs\n"
              "0 s press: power on none 0 none\n"
              "inputs change UP 0 none\n"
              "inputs change GO\n"
              "press a 1 MOVE, LOCK\n"
              "2 s press: 2s/X1 is true\n"
              "press: count 0 -> 1 b 2 LOCK\n"
              "5 s 3 s pass 2 LOCK\n"
              "5 s inputs change !UP, DOWN, !GO\n"
              "press c 0 none\n"
              "inputs change N = 7 0 none\n");
}

TEST(SimulateChart, AgreesWithALoopWithFreeInputs) {
    const Folder folder;
    const std::string lone =
        "grafcet c { input A, B; output P, Q; initial step 0; step 1 { P; } step 2 { Q := true on activation; } step "
        "3;\n"
        "transition a: 0 -> 1, 3 when rise(A); transition b: 1 -> 2 when 2s/X1/1s; transition d: 2, 3 -> 0 when "
        "fall(A) || B; }\n";
    const std::string chart = folder.write("chart.grafcet", lone);
    const std::string loop =
        folder.write("loop.grafcet", lone +
                                         "closed_loop l { controller c with stability_search;\n"
                                         "environment Ea = free(OUT = A); environment Eb = free(OUT = B); }\n");
    // Returns the situation and the outputs of the last row.
    const auto end_of = [](const std::string& out) {
        const std::size_t column = out.find("situation"), last = out.rfind('\n', out.size() - 2) + 1;
        return squeezed(out.substr(last + column));
    };
    std::string script;
    std::set<std::string> seen;
    for (const char* line :
         {"A = true", "wait 1s", "A = false", "A = true", "wait 1s", "wait 1s", "A = false", "wait 1s", "A = true",
          "B = true", "wait 3s", "B = false", "A = false", "A = true", "wait 9s"}) {
        script += std::string(line) + "\n";
        for (const char* mode : {"stability-search", "every-cycle"}) {
            SCOPED_TRACE(script + mode);
            const std::string path = folder.write("s.txt", script);
            const Result alone = grafverif({"simulate", chart, "--script", path, "--mode", mode});
            const Result looped = grafverif({"simulate", loop, "--script", path, "--mode", mode});
            EXPECT_EQ(alone.code, ExitCode::Done) << alone.err;
            EXPECT_EQ(end_of(alone.out), end_of(looped.out)) << alone.out << looped.out;
            seen.insert(end_of(alone.out));
        }
    }
    EXPECT_GE(seen.size(), 4U);
}

TEST(SimulateChart, ReportsTheViolatedConstraintAndContinues) {
    const Folder folder;
    const std::string file = folder.write("press.grafcet", press);
    const Result result =
        grafverif({"simulate", file, "--script", folder.write("a.txt", "UP = true\nDOWN = true\nN = 1\nUP = false\n")});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    const std::string warning = "! these inputs violate the constraint `!(UP && DOWN)`\n";
    ASSERT_NE(result.out.find(warning), std::string::npos) << result.out;
    EXPECT_EQ(result.out.find(warning, result.out.find(warning) + 1), std::string::npos) << "printed once";
    const Result talk = grafverif({"simulate", file}, "UP = true\nquit\n");
    EXPECT_EQ(squeezed(talk.out).find("DOWN = true\n", talk.out.rfind("UP")), std::string::npos)
        << "the choice is not offered: " << talk.out;
}

TEST(SimulateChart, RejectsInvalidInputsAndUndoesTheLastCommand) {
    const Folder folder;
    const std::string file = folder.write("press.grafcet", press);
    struct Case {
        const char* script;
        const char* error_text;
    };
    for (const Case& c : std::vector<Case>{
             {"LOCK = true\n", ":1: error: unknown input `LOCK`\n"},
             {"N = 10\n", ":1: error: `N` ranges from 0 to 9 and cannot be 10\n"},
             {"UP = false\n", ":1: error: `UP` already has this value\n"},
             {"do Press\n",
              ":1: error: a chart alone has no plant, so `Press` is not available; set inputs with `NAME = VALUE`\n"},
             {"back\n", ":1: error: there is no command to undo\n"},
             {"wait\n", ":1: error: nothing changes as time passes; write `wait` with a duration\n"},
             {"UP = true\nGO = true\nback\nGO = false\n", ":4: error: `GO` already has this value\n"},
         }) {
        SCOPED_TRACE(c.script);
        const std::string script = folder.write("script.txt", c.script);
        const Result result = grafverif({"simulate", file, "--script", script});
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_EQ(result.err, script + c.error_text);
    }
}

TEST(SimulateChart, DetectsInstabilityInBothModes) {
    const Folder folder;
    const std::string file =
        folder.write("endless.grafcet",
                     "grafcet endless { input GO; output A, B; initial step 0; step 1 { A; } step 2 { B; }\n"
                     "transition a: 0 -> 1 when GO; transition b: 1 -> 2 when GO; transition c: 2 -> 1 when GO; }\n");
    for (const char* mode : {"stability-search", "every-cycle"}) {
        const Result result = grafverif(
            {"simulate", file, "--mode", mode, "--script", folder.write("go.txt", "GO = true\nGO = false\n")});
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_NE(result.err.find("go.txt:1: error: with these inputs, the situation never becomes stable: "),
                  std::string::npos)
            << mode << result.err;
    }
    const Result talk = grafverif({"simulate", file}, "GO = true\nGO = false\nback\nwait 1s\n");
    EXPECT_NE(talk.out.find("! no further event is possible; undo the last command with `back`"), std::string::npos);
    EXPECT_NE(talk.out.find("back to:"), std::string::npos);
}

TEST(SimulateChart, WalksAtRandomWithinItsConstraints) {
    const Folder folder;
    const std::string file = folder.write("press.grafcet", press);
    const Result first = grafverif({"simulate", file, "--random", "7", "--steps", "60"});
    EXPECT_EQ(first.code, ExitCode::Done) << first.err;
    EXPECT_EQ(grafverif({"simulate", file, "--random", "7", "--steps", "60"}).out, first.out);
    EXPECT_EQ(first.out.find("UP, DOWN"), std::string::npos) << first.out;
    EXPECT_NE(first.out.find("MOVE"), std::string::npos) << first.out;
}

}  // namespace
}  // namespace grafverif::app
