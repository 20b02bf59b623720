// SPDX-License-Identifier: MIT
// What is said to somebody who has just met the program: wrong files, wrong verbs, half a chart.
#include <gtest/gtest.h>

#include <string>

#include "app/options.hpp"
#include "app/stop_words.hpp"
#include "run_program.hpp"

namespace grafverif::app {
namespace {

const std::string pick_and_place = (root / "samples/pick_and_place/pick_and_place.grafcet").string();

constexpr const char* lone =
    "grafcet lone { input x; output L; initial step 0; step 1 { L; } transition t: 0 -> 1 when x; transition u: 1 -> 0 "
    "when !x; }\n";

bool says(const Result& result, const std::string& what) { return result.err.find(what) != std::string::npos; }

TEST(FirstUse, ImportSaysOfWhatItIsNotForWhatItIs) {
    const Folder folder;
    struct Case {
        std::string text, message;
    };
    for (const Case& c :
         {Case{"hello this is junk\n",
               "error: the file begins with no chart that is known here; read are AGRAFE GRAFCET"},
          Case{"", "error: the file begins with no chart that is known here"},
          Case{std::string("\x01\x02\x03\xFF\x00\x01", 6), "error: the file begins with no chart that is known here"},
          Case{std::string("g\0r\0a\0f\0", 8), "error: this text is UTF-16; save the file as UTF-8 text"},
          Case{"<?xml version=\"1.0\"?>\n<html/>\n", "error: `html` begins no chart that is known here"},
          Case{lone, "error: the file is in our own language, which every verb reads; `grafverif fmt` prints it"}}) {
        SCOPED_TRACE(c.text);
        const Result result = grafverif({"import", folder.write("file", c.text)});
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_TRUE(says(result, c.message)) << result.err;
        EXPECT_EQ(result.out, "");
    }
}

TEST(FirstUse, ImportWritesNothingThatAVerbWouldRefuse) {
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
    EXPECT_TRUE(says(result, "flawed.xmi:5:2: error: `x` is assigned on an event that can hold without an edge"))
        << result.err;
    EXPECT_EQ(folder.entries(), 1U);
}

TEST(FirstUse, AChartAloneIsSentToTheVerbsThatTakeIt) {
    const Folder folder;
    const std::string chart = folder.write("lone.grafcet", lone);
    for (const char* verb : {"build", "uppaal"}) {
        const Result result = grafverif({verb, chart});
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_TRUE(says(result,
                         "A chart alone is run by `grafverif plc`, checked by `grafverif check`, and written as a "
                         "model by `grafverif nusmv`"))
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
    EXPECT_TRUE(says(grafverif({"chek", "file"}), "there is no verb `chek`; did you mean `check`?"));
    EXPECT_TRUE(says(grafverif({"help", "chek"}), "there is no verb `chek`; did you mean `check`?"));
    EXPECT_TRUE(
        says(grafverif({"--timeout", "3s", "check"}), "a verb comes first, options behind it; not `--timeout`"));
}

TEST(FirstUse, SeveralLoopsAreNamedWithTheWayToChoose) {
    const Folder folder;
    const std::string loop = " { controller lone; environment X = free(OUT = x); }\n";
    const Result result = grafverif(
        {"check", folder.write("two.grafcet", lone + ("closed_loop one" + loop) + "closed_loop other" + loop)});
    EXPECT_TRUE(says(result, "error: the file has several closed loops: `one`, `other`; choose with `--loop`"))
        << result.err;
}

TEST(FirstUse, AReasonNamesWhatStoppedTheEngine) {
    Options options;
    EXPECT_EQ(with_who_stopped("stopped after 3 states", true, options),
              "stopped by Ctrl-C or another signal after 3 states");
    EXPECT_EQ(with_who_stopped("stopped after 3 states", false, options), "stopped after 3 states");
    options.timeout_ms = 1500;
    EXPECT_EQ(with_who_stopped("stopped", false, options), "stopped at the time limit of 1.5 s");
    EXPECT_EQ(with_who_stopped("verifyta was stopped at the time limit", false, options),
              "verifyta was stopped at the time limit of 1.5 s");
    EXPECT_EQ(with_who_stopped("the memory allowed is used up", true, options), "the memory allowed is used up");
}

TEST(FirstUse, TheTimeLimitIsNamedByEveryVerbThatEndsAtIt) {
    EXPECT_NE(grafverif({"check", station, "--timeout", "0"}).out.find("why: stopped at the time limit of 0 s"),
              std::string::npos);
    EXPECT_NE(
        grafverif({"analyse", station, "--timeout", "0"}).out.find("stopped at the time limit of 0 s before the end"),
        std::string::npos);
    const Result automaton = grafverif({"automaton", station, "--timeout", "0"});
    EXPECT_TRUE(says(automaton, "stopped before the end by the time limit, which `--timeout` sets")) << automaton.err;
}

TEST(FirstUse, ALoopWithAScheduleIsSentToItsUntimedModel) {
    const Result timed = grafverif({"check", pick_and_place});
    EXPECT_EQ(timed.code, ExitCode::Verdict);
    EXPECT_TRUE(
        says(timed, "note: `pick_and_place` names a `schedule`, which untimed models alone obey; `grafverif check " +
                        pick_and_place + " --untimed --plant automata` checks that one"))
        << timed.err;
    EXPECT_FALSE(says(grafverif({"check", pick_and_place, "--quiet"}), "note: "));
    EXPECT_FALSE(says(grafverif({"check", station, "--timeout", "0"}), "names a `schedule`"));
}

TEST(FirstUse, AConstraintThatIsProvedIsShown) {
    const Result result = grafverif({"check", pick_and_place, "--property", "VC_constraint_1"});
    EXPECT_NE(result.out.find("VC_constraint_1             holds    <library>/cylinder_5_2.grafcet:30  !(vc_in && "
                              "vc_out) holds of this plant\n"),
              std::string::npos)
        << result.out;
}

}  // namespace
}  // namespace grafverif::app
