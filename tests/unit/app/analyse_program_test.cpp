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
    EXPECT_NE(chart.out.find("inputs change only between stable situations"), std::string::npos) << chart.out;
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
