// SPDX-License-Identifier: MIT
// Tests `analyse` on PLC programs: the operands, and the options that do not apply.
#include <gtest/gtest.h>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

const std::string chart_program =
    "PROGRAM p VAR_INPUT a : BOOL; END_VAR VAR_OUTPUT q : BOOL; END_VAR\n"
    "INITIAL_STEP One: END_STEP\nSTEP Two: q(N); END_STEP\n"
    "TRANSITION FROM One TO Two := a; END_TRANSITION\n"
    "TRANSITION FROM Two TO One := a AND NOT q; END_TRANSITION\nEND_PROGRAM\n";

TEST(AnalyseProgramFile, IsAnalysedAsAProgramUnlessItsChartIsImported) {
    const Folder folder;
    const std::string file = folder.write("p.st", chart_program);
    const Result program = grafverif({"analyse", file});
    EXPECT_EQ(program.code, ExitCode::Verdict) << program.err;
    EXPECT_NE(program.out.find("p.st:5:31: warning: this transition is never cleared: `a AND NOT q` is never true"),
              std::string::npos)
        << program.out;
    const Result chart = grafverif({"analyse", file, "--imported-charts"});
    EXPECT_EQ(chart.out.find("this transition is never cleared"), std::string::npos) << chart.out;
    EXPECT_NE(chart.out.find("inputs change only in stable situations"), std::string::npos) << chart.out;
}

TEST(AnalyseProgramFile, CanBeDeclaredInAGrafcetFile) {
    const Folder folder;
    folder.write("p.st", chart_program);
    const std::string file = folder.write("loop.grafcet",
                                          "program pump = \"p.st\";\ngrafcet g { input a; output q; "
                                          "initial step 1 { q if a; } }\n");
    const Result result = grafverif({"analyse", file, "--chart", "pump", "--format", "json"});
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
    EXPECT_NE(result.out.find("\"chart\": \"pump\""), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("\"transition-never-fired\""), std::string::npos) << result.out;
}

TEST(AnalyseProgramFile, AssumesAnyTimeIfALoopHasAnotherCycleThanTheTask) {
    const Folder folder;
    folder.write("p.st",
                 "PROGRAM p VAR_INPUT a : BOOL; END_VAR VAR_OUTPUT q : BOOL; END_VAR\nq := a;\nEND_PROGRAM\n"
                 "CONFIGURATION c\nTASK t(INTERVAL := T#10ms, PRIORITY := 1);\nPROGRAM i WITH t : p;\n"
                 "END_CONFIGURATION\n");
    const auto note = [&](const std::string& cycle) {
        const std::string file =
            folder.write("loop.grafcet", "program pump = \"p.st\";\nclosed_loop l { controller pump " + cycle +
                                             "; environment a = free(OUT = a); "
                                             "property never_on: never q; }\n");
        return grafverif({"analyse", file, "--chart", "pump"}).out;
    };
    EXPECT_NE(note("every 10ms").find("a scan starts every 10 ms"), std::string::npos);
    EXPECT_NE(note("every 20ms").find("any time can pass between two scans"), std::string::npos);
    EXPECT_NE(note("every 10ms..20ms").find("any time can pass between two scans"), std::string::npos);
}

TEST(AnalyseProgramFile, NotesTheColdStartOfRetainedVariables) {
    const Folder folder;
    const auto output = [&](const std::string& qualifier) {
        return grafverif({"analyse", folder.write("p.st",
                                                  "PROGRAM p VAR_INPUT a : BOOL; END_VAR VAR_OUTPUT q : BOOL; END_VAR\n"
                                                  "VAR " +
                                                      qualifier +
                                                      " r : BOOL; END_VAR\nIF r THEN q := a; END_IF\n"
                                                      "END_PROGRAM\n")})
            .out;
    };
    const std::string text = "note: power-on is a cold start: retained variables have their initial values\n";
    EXPECT_NE(output("RETAIN").find(text), std::string::npos);
    EXPECT_EQ(output("").find(text), std::string::npos);
}

TEST(AnalyseProgramFile, MentionsTheImportedChartsOfSeveralPrograms) {
    const Folder folder;
    std::string other = chart_program;
    other.replace(other.find("PROGRAM p"), 9, "PROGRAM r");
    const std::string file = folder.write("p.st", chart_program + other);
    const Result result = grafverif({"analyse", file});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_NE(result.err.find("note: `--imported-charts` analyses the Sequential Function Charts of the file\n"),
              std::string::npos)
        << result.err;
    EXPECT_NE(grafverif({"analyse", file, "--imported-charts", "--all"}).code, ExitCode::Input);
    for (const std::vector<std::string>& options : {std::vector<std::string>{"--all"}, {"--chart", "p"}}) {
        std::vector<std::string> arguments = {"analyse", folder.write("one.st", chart_program)};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Result rejected = grafverif(arguments);
        EXPECT_EQ(rejected.code, ExitCode::Input);
        EXPECT_NE(rejected.err.find("`--chart` and `--all` select charts; remove them, or pass `--imported-charts`"),
                  std::string::npos)
            << rejected.err;
    }
}

TEST(AnalyseProgramFile, RejectsOptionsOfCharts) {
    const Folder folder;
    const Result result = grafverif({"analyse", folder.write("p.st", chart_program), "--mode", "every-cycle"});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find("`--exclusions` and `--mode` apply to charts; remove them [only-for-charts]"),
              std::string::npos)
        << result.err;
}

}  // namespace
}  // namespace grafverif::app
