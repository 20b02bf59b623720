// SPDX-License-Identifier: MIT
// Tests Sequential Function Charts as bodies of programs: qualifiers scan by scan, evolution, and diagnostics.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "unit/read/program_values.hpp"

namespace grafverif {
namespace {

/// Returns a chart in which step S1 is active while `a` is true. `v` is a Boolean variable, and `count` is an action
/// that increments `n`.
std::string two_steps(const std::string& first, const std::string& second) {
    return fmt::format(
        "PROGRAM p VAR_INPUT a : BOOL; END_VAR VAR v : BOOL; n : INT; END_VAR\n"
        "INITIAL_STEP S0: {} END_STEP\nSTEP S1: {} END_STEP\n"
        "TRANSITION FROM S0 TO S1 := a; END_TRANSITION\nTRANSITION FROM S1 TO S0 := NOT a; END_TRANSITION\n"
        "ACTION count: n := n + 1; END_ACTION\nEND_PROGRAM\n",
        first, second);
}

TEST(ProgramChart, QualifiersOfBooleanVariablesFollowTheStandard) {
    const auto v = [](const std::string& second, const std::vector<std::vector<std::int64_t>>& inputs,
                      const std::string& first = "") { return values(two_steps(first, second), "v", inputs); };
    const std::vector<std::vector<std::int64_t>> longer = {{0}, {1}, {1}, {1}, {0}, {0}},
                                                 shorter = {{0}, {1}, {1}, {0}, {0}};
    EXPECT_EQ(v("v(N);", longer), "0 1 1 1 0 0");
    EXPECT_EQ(v("v(P);", longer), "0 1 0 0 0 0");
    EXPECT_EQ(v("v(S);", longer), "0 1 1 1 1 1");
    EXPECT_EQ(v("v(S);", longer, "v(R);"), "0 1 1 1 0 0");
    EXPECT_EQ(v("v(S); v(R);", longer), "0 0 0 0 0 0");
    EXPECT_EQ(v("v(L, T#15ms);", longer), "0 1 1 0 0 0");
    EXPECT_EQ(v("v(D, T#15ms);", longer), "0 0 0 1 0 0");
    EXPECT_EQ(v("v(SL, T#25ms);", shorter), "0 1 1 1 0");
    EXPECT_EQ(v("v(SD, T#15ms);", shorter), "0 0 0 1 1");
    EXPECT_EQ(v("v(DS, T#15ms);", shorter), "0 0 0 0 0");
    EXPECT_EQ(v("v(DS, T#15ms);", longer), "0 0 0 1 1 1");
    EXPECT_EQ(v("v(D, T#0ms);", longer), "0 1 1 1 0 0");
}

TEST(ProgramChart, StatementsAreExecutedOnceMoreAfterTheirAction) {
    const auto n = [](const std::string& second) {
        return values(two_steps("", second), "n", {{0}, {1}, {1}, {1}, {0}, {0}});
    };
    EXPECT_EQ(n("count(N);"), "0 1 2 3 4 4");
    EXPECT_EQ(n("count(P);"), "0 1 2 2 2 2");
    EXPECT_EQ(n("count(P1);"), "0 1 1 1 1 1");
    EXPECT_EQ(n("count(P0);"), "0 0 0 0 1 1");
    EXPECT_EQ(n("count(P1); count(P0);"), "0 1 1 1 2 2");
}

TEST(ProgramChart, TheFirstExecutionClearsNoTransition) {
    EXPECT_EQ(values(two_steps("", ""), "S0.X", {{1}, {1}, {1}}), "1 0 0");
    EXPECT_EQ(values(two_steps("", "v(N);"), "S1.X", {{1}, {1}, {0}, {1}}), "0 1 0 1");
}

TEST(ProgramChart, FirstTransitionOfASelectionIsClearedUnlessThereArePriorities) {
    const auto selection = [](const std::string& first, const std::string& second) {
        return "PROGRAM p VAR_INPUT a, b : BOOL; END_VAR\nINITIAL_STEP S: END_STEP STEP S1: END_STEP STEP S2: "
               "END_STEP\n"
               "TRANSITION " +
               first +
               " FROM S TO S1 := a; END_TRANSITION\n"
               "TRANSITION " +
               second +
               " FROM S TO S2 := b; END_TRANSITION\n"
               "TRANSITION FROM S1 TO S := TRUE; END_TRANSITION TRANSITION FROM S2 TO S := TRUE; END_TRANSITION\n"
               "END_PROGRAM";
    };
    EXPECT_EQ(values(selection("", ""), "S1.X", {{1, 1}, {1, 1}}), "0 1");
    EXPECT_EQ(values(selection("(PRIORITY := 2)", "(PRIORITY := 1)"), "S2.X", {{1, 1}, {1, 1}}), "0 1");
    EXPECT_EQ(ReadProgram(selection("(PRIORITY := 1)", "(PRIORITY := 1)")).codes(), "4:1 not-in-program\n");
    EXPECT_EQ(ReadProgram(selection("(PRIORITY := 1)", "")).codes(), "4:1 not-in-program\n");
}

TEST(ProgramChart, BlocksWithChartsKeepTheirSituation) {
    EXPECT_EQ(
        values("FUNCTION_BLOCK f VAR_INPUT a : BOOL; END_VAR VAR_OUTPUT o : BOOL; END_VAR\n"
               "INITIAL_STEP S0: END_STEP STEP S1: o(N); END_STEP\n"
               "TRANSITION FROM S0 TO S1 := a; END_TRANSITION\n"
               "TRANSITION FROM S1 TO S0 := S1.T >= T#20ms; END_TRANSITION\nEND_FUNCTION_BLOCK\n"
               "PROGRAM p VAR_INPUT a, b : BOOL; END_VAR VAR k, l : f; both : INT; END_VAR\n"
               "IF b THEN k(a := a); END_IF\nl(a := a); both := 2 * BOOL_TO_INT(k.o) + BOOL_TO_INT(l.o);\nEND_PROGRAM",
               "both", {{0, 1}, {1, 1}, {0, 0}, {0, 0}, {0, 0}, {0, 1}}),
        "0 3 3 2 2 0");
}

TEST(ProgramChart, ReportsAllErrorsOfItsStructure) {
    const ReadProgram reading(
        "FUNCTION f : INT\nINITIAL_STEP S0: END_STEP\nEND_FUNCTION\n"
        "PROGRAM p VAR_INPUT a, b : BOOL; END_VAR VAR v, w : BOOL; END_VAR\n"
        "INITIAL_STEP S0: act(N); v(P1); v(L, T#1s);\n act(D);\n v(N, T#1s); END_STEP\n"
        "STEP S1: act(Q);\n v(L, T#2s); END_STEP\n"
        "STEP S1: END_STEP\n"
        "INITIAL_STEP S2: END_STEP\n"
        "TRANSITION FROM S0 TO S9 := a; END_TRANSITION\n"
        "TRANSITION FROM (S2, S2) TO S0 := a; END_TRANSITION\n"
        "ACTION act: ; END_ACTION\nACTION act: ; END_ACTION\nEND_PROGRAM\n");
    EXPECT_EQ(
        reading.codes(),
        "2:1 not-in-program\n10:6 duplicate-name\n11:1 not-in-program\n12:23 unknown-step\n13:22 not-in-program\n"
        "15:8 duplicate-name\n5:26 not-in-program\n6:2 not-in-program\n7:2 not-in-program\n8:10 not-in-program\n");
    EXPECT_EQ(ReadProgram("PROGRAM p VAR v : BOOL; END_VAR\nSTEP S0: v(N); END_STEP\nEND_PROGRAM").codes(),
              "2:1 not-in-program\n");  // the chart has no initial step
}

/// Returns a chart in PLCopen XML. `action` contains the attributes and content of an action, and `step` contains the
/// content of its step.
std::string drawn_chart(const std::string& action, const std::string& step = "") {
    return "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"><types><dataTypes/><pous><pou name=\"p\" "
           "pouType=\"program\"><interface><inputVars><variable name=\"a\"><type><BOOL/></type></variable></inputVars>"
           "<localVars><variable name=\"v\"><type><BOOL/></type></variable><variable name=\"r\"><type><INT/></type>"
           "</variable></localVars></interface><actions><action name=\"count\"><body><ST><xhtml>r := r + "
           "1;</xhtml></ST>"
           "</body></action></actions><body><SFC>\n"
           "<step localId=\"1\" name=\"S0\" initialStep=\"true\"><connectionPointIn><connection refLocalId=\"4\"/>"
           "</connectionPointIn></step>\n<step localId=\"2\" name=\"S1\"><connectionPointIn><connection "
           "refLocalId=\"3\"/></connectionPointIn>" +
           step +
           "</step>\n<transition localId=\"3\"><connectionPointIn><connection refLocalId=\"1\"/></connectionPointIn>"
           "<condition><inline><ST><xhtml>a</xhtml></ST></inline></condition></transition>\n"
           "<transition localId=\"4\"><connectionPointIn><connection refLocalId=\"2\"/></connectionPointIn>"
           "<condition negated=\"true\"><inline><ST><xhtml>a</xhtml></ST></inline></condition></transition>\n"
           "<actionBlock localId=\"5\"><connectionPointIn><connection "
           "refLocalId=\"2\"/></connectionPointIn>\n<action " +
           action + "</action></actionBlock></SFC></body></pou></pous></types></project>";
}

TEST(ProgramChart, ChartsInPlcopenXmlAreReadAsThoseInText) {
    const std::vector<std::vector<std::int64_t>> inputs = {{0}, {1}, {1}, {1}, {0}, {0}};
    EXPECT_EQ(values(drawn_chart("qualifier=\"D\" duration=\"T#15ms\"><reference name=\"v\"/>"), "v", inputs),
              "0 0 0 1 0 0");
    EXPECT_EQ(values(drawn_chart("qualifier=\"N\"><reference name=\"count\"/>"), "r", inputs), "0 1 2 3 4 4");
    EXPECT_EQ(values(drawn_chart("qualifier=\"P1\"><inline><ST><xhtml>r := 5;</xhtml></ST></inline>"), "r", inputs),
              "0 5 5 5 5 5");
    EXPECT_EQ(ReadProgram(drawn_chart("qualifier=\"N\" indicator=\"v\"><reference name=\"count\"/>")).codes(),
              "7:2 not-in-program\n");
    EXPECT_EQ(ReadProgram(drawn_chart("><inline><LD/></inline>")).codes(), "7:2 not-in-program\n");
    EXPECT_EQ(
        ReadProgram(drawn_chart("><reference name=\"v\"/>",
                                "<addData><data><attributes><attribute "
                                "guid=\"700a583f-b4d4-43e4-8c14-629c7cd3bec8\">count</attribute></attributes></data>"
                                "</addData>"))
            .codes(),
        "3:124 not-in-program\n");
}

TEST(ProgramChart, RejectsStatementsThatChangeTheChart) {
    const auto rejected = [](const std::string& statement) {
        return ReadProgram(
                   "PROGRAM p VAR v : BOOL; END_VAR\nINITIAL_STEP S0: act(N); END_STEP\n"
                   "TRANSITION FROM S0 TO S0 := v; END_TRANSITION\nACTION act:\n" +
                   statement + "\nEND_ACTION\nEND_PROGRAM")
            .codes();
    };
    EXPECT_EQ(rejected("v := S0.X AND act.Q;"), "");
    EXPECT_EQ(rejected("S0.X := TRUE;"), "5:1 not-in-program\n");
    EXPECT_EQ(rejected("RETURN;"), "5:1 not-in-program\n");
    EXPECT_EQ(rejected("act();"), "5:1 not-in-program\n");
    EXPECT_EQ(rejected("v := S0.Z;"), "5:6 unknown-variable\n");
}

/// Returns the number of the scan with the first fault of a chart, or 0 if there is no fault.
std::size_t fault(const std::string& program, const std::vector<std::vector<std::int64_t>>& inputs) {
    const ReadProgram reading(program);
    EXPECT_EQ(reading.codes(), "");
    if (!reading.text) return 0;
    ProgramRun run(reading.text->program());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        run.scan(inputs[i], 10);
        if (!run.fault()) continue;
        EXPECT_EQ(run.fault()->kind, ProgramFault::Chart);
        return i + 1;
    }
    return 0;
}

TEST(ProgramChart, ActivationOfAnActiveStepIsAFault) {
    const std::string text =
        "PROGRAM p VAR_INPUT a, b : BOOL; END_VAR\nINITIAL_STEP S0: END_STEP STEP S1: END_STEP\n"
        "STEP S2: END_STEP STEP S3: END_STEP\nTRANSITION FROM S0 TO (S1, S2) := a; END_TRANSITION\n"
        "TRANSITION FROM S1 TO S3 := a; END_TRANSITION\nTRANSITION FROM S2 TO S3 := b; END_TRANSITION\n"
        "TRANSITION FROM S3 TO S0 := NOT a; END_TRANSITION\nEND_PROGRAM";
    EXPECT_EQ(fault(text, {{0, 0}, {1, 0}, {1, 0}, {1, 0}, {1, 1}}), 5U);  // S3 is already active
    EXPECT_EQ(fault(text, {{0, 0}, {1, 0}, {1, 1}}), 3U);                  // two transitions activate S3
    EXPECT_EQ(fault(text, {{0, 0}, {1, 0}, {1, 0}, {0, 0}, {0, 1}}), 0U);
    std::string steps, all, transitions;  // 2^15 situations
    for (int i = 0; i < 15; ++i) {
        steps += fmt::format("STEP A{0}: END_STEP STEP B{0}: END_STEP\n", i);
        all += fmt::format("{}A{}", i == 0 ? "" : ", ", i);
        transitions += fmt::format("TRANSITION FROM A{0} TO B{0} := a; END_TRANSITION\n", i);
    }
    const std::string large = "PROGRAM p VAR_INPUT a : BOOL; END_VAR\nINITIAL_STEP S0: END_STEP\n" + steps +
                              "TRANSITION FROM S0 TO (" + all + ") := a; END_TRANSITION\n" + transitions +
                              "END_PROGRAM";
    EXPECT_EQ(fault(large, {{0}, {1}, {1}, {1}}), 0U);
}

TEST(ProgramChart, AnActionCanHaveDifferentDurations) {
    const auto text = [](const std::string& last) {
        return "PROGRAM p VAR_INPUT a : BOOL; END_VAR VAR v : BOOL; END_VAR\n"
               "INITIAL_STEP S0: v(L, T#15ms); END_STEP STEP S1: END_STEP STEP S2: v(L, T#25ms); END_STEP\n"
               "TRANSITION FROM S0 TO S1 := a; END_TRANSITION\nTRANSITION FROM S1 TO " +
               last + " := a; END_TRANSITION\nEND_PROGRAM";
    };
    EXPECT_EQ(values(text("S2"), "v", {{0}, {0}, {0}, {1}, {1}, {0}, {0}, {0}}), "1 1 0 0 1 1 1 0");
    EXPECT_EQ(fault(text("(S0, S2)"), {{0}, {1}, {1}}), 3U);
    EXPECT_EQ(ReadProgram("PROGRAM p VAR_INPUT a : BOOL; END_VAR VAR v : BOOL; END_VAR\n"
                          "INITIAL_STEP S0: v(SL, T#15ms);\nv(SL, T#25ms); END_STEP\nEND_PROGRAM")
                  .codes(),
              "3:1 not-in-program\n");
}

/// Returns a chart of CODESYS with the steps S0 and S1; S1 has the given attributes, and SFCReset has the use `use`.
std::string codesys_chart(const std::string& attributes, const std::string& action, const std::string& use = "true") {
    const std::string data = "<addData><data name=\"http://www.3s-software.com/plcopenxml/";
    std::string text =
        drawn_chart(action, data + "sfc/element\"><attributes>" + attributes + "</attributes></data></addData>");
    const std::string settings = data +
                                 "sfcsettings\"><SFCSettings><UseDefaults>false</UseDefaults><Flags><Reset Use=\"" +
                                 use + "\"/><Tip Use=\"false\"/></Flags></SFCSettings></data></addData>";
    return text.insert(text.find("</pou>"), settings);
}

TEST(ProgramChart, ChartsOfCodesysExecuteTheirActionsBeforeTransitions) {
    const auto attribute = [](const std::string& guid, const std::string& action) {
        return "<attribute guid=\"" + guid + "\">" + action + "</attribute>";
    };
    const std::string entry = attribute("a6b08bd8-b696-47e3-9cbf-7408b61c9ff8", "count"),
                      exit = attribute("a2621e18-7de3-4ea6-ae6d-89e9e0b7befd", "count");
    const std::vector<std::vector<std::int64_t>> inputs = {{1}, {1}, {1}, {0}, {0}};
    const std::string variable = "qualifier=\"N\"><reference name=\"v\"/>";
    EXPECT_EQ(values(codesys_chart(entry, variable), "r", inputs), "0 1 1 1 1");
    EXPECT_EQ(values(codesys_chart(entry + exit, variable), "r", inputs), "0 1 1 1 2");
    EXPECT_EQ(values(codesys_chart("", variable), "v", inputs), "0 1 1 1 0");
    EXPECT_EQ(values(codesys_chart("", "qualifier=\"P0\"><reference name=\"count\"/>"), "r", inputs), "0 0 0 0 1");
}

TEST(ProgramChart, RejectsWhatChartsOfCodesysDoNotDefine) {
    const std::string variable = "qualifier=\"N\"><reference name=\"v\"/>";
    const auto codes = [&](const std::string& attributes, const std::string& action) {
        return ReadProgram(codesys_chart(attributes, action)).codes();
    };
    EXPECT_EQ(codes("", "qualifier=\"SD\" duration=\"T#1s\"><reference name=\"v\"/>"), "7:2 not-in-program\n");
    EXPECT_EQ(codes("", "qualifier=\"D\"><reference name=\"v\"/>"), "7:2 not-in-program\n");
    EXPECT_EQ(codes("", "qualifier=\"P1\"><reference name=\"v\"/>"),
              "1:433 undocumented-reading\n7:2 not-in-program\n");
    EXPECT_NE(codes("<attribute guid=\"700a583f-b4d4-43e4-8c14-629c7cd3bec8\">none</attribute>", variable)
                  .find("unknown-action"),
              std::string::npos);
    std::string other = codesys_chart("", variable);
    other.replace(other.find("Tip Use=\"false\""), 15, "Tip Use=\"true\" ");
    EXPECT_EQ(ReadProgram(other).codes(), "1:433 not-in-program\n");
}

}  // namespace
}  // namespace grafverif
