// SPDX-License-Identifier: MIT
// Tests commands that use decision diagrams, with little time or memory, and on trivial models.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

/// Writes the faulty station with the sensor V_Sen declared first. In this poor order of variables, one operation takes
/// minutes.
std::string poor_order(const Folder& folder) {
    std::ifstream sample(root / "samples/testing_station/faulty.grafcet");
    std::string text{std::istreambuf_iterator<char>(sample), {}};
    const std::size_t sensor = text.find("    plant V_Sen"), end = text.find(";\n", sensor) + 2;
    const std::string line = text.substr(sensor, end - sensor);
    text.erase(sensor, end - sensor);
    text.insert(text.find("    plant H_Act"), line);
    return folder.write("poor.grafcet", text);
}

std::string long_ring(std::size_t steps) {
    std::string text = "grafcet ring { input a; output o; initial step 0; ";
    for (std::size_t i = 1; i < steps; ++i) text += "step " + std::to_string(i) + (i % 10 == 0 ? " { o; } " : "; ");
    for (std::size_t i = 0; i < steps; ++i)
        text += "transition t" + std::to_string(i) + ": " + std::to_string(i) + " -> " +
                std::to_string((i + 1) % steps) + (i % 2 == 0 ? " when a;\n" : " when !a;\n");
    return text + "}\n";
}

TEST(Diagrams, ATimeLimitIsKeptWithinOneLongOperation) {
    const Folder folder;
    const std::string file = poor_order(folder);
    const auto start = std::chrono::steady_clock::now();
    const Result result =
        grafverif({"check", file, "--untimed", "--plant", "automata", "--schedule", "sequenced", "--timeout", "1s"});
    EXPECT_EQ(result.code, ExitCode::Unknown) << result.err;
    EXPECT_NE(result.out.find("stopped at the time limit of 1 s"), std::string::npos) << result.out;
    EXPECT_LE(std::chrono::steady_clock::now() - start, std::chrono::seconds(15))
        << "the limit allows for a busy machine";
}

TEST(Diagrams, ALongRingIsCheckedUntilTheTimeIsUp) {
    const Folder folder;
    const std::string file = folder.write("ring.grafcet", long_ring(3000));
    const Result result = grafverif({"check", file, "--untimed", "--timeout", "2s"});
    EXPECT_TRUE(result.code == ExitCode::Unknown || result.code == ExitCode::Done) << result.out << result.err;
}

TEST(Diagrams, AnAutomatonIsDrawnOrATableOrLeftToGraphviz) {
    const Folder folder;
    const auto drawn = [&](std::size_t steps) {
        return grafverif({"automaton", folder.write("ring.grafcet", long_ring(steps)), "--format", "svg"});
    };
    const Result drawing = drawn(40), table = drawn(100), neither = drawn(300);
    EXPECT_NE(drawing.out.find("<path class=\"arrow\""), std::string::npos);
    EXPECT_EQ(drawing.err, "");
    EXPECT_EQ(table.code, ExitCode::Done);
    EXPECT_EQ(table.out.find("<path class=\"arrow\""), std::string::npos);
    EXPECT_NE(table.out.find("to 7: "), std::string::npos);
    EXPECT_EQ(table.err, "note: 101 locations are too many for a drawing (limit: 60); a table is written instead\n");
    EXPECT_EQ(neither.code, ExitCode::Input);
    EXPECT_EQ(neither.out, "");
    EXPECT_NE(neither.err.find("[too-large]"), std::string::npos) << neither.err;
}

TEST(Diagrams, AChartWithoutInputsHasATest) {
    const Folder folder;
    const std::string file = folder.write("pulse.grafcet",
                                          "grafcet pulse { output TICK; initial step 1; step 2 { TICK; }\n"
                                          "transition t1: 1 -> 2 when 5s/X1; transition t2: 2 -> 1 when true; }\n");
    const Result result = grafverif({"testgen", file, "-o", folder.file("pulse.csv")});
    EXPECT_EQ(result.code, ExitCode::Done) << result.err;
    EXPECT_NE(result.err.find("covering 2 of 2 transitions"), std::string::npos) << result.err;
}

#if !defined(__SANITIZE_ADDRESS__)
TEST(Diagrams, RefusedMemoryGivesUnknownVerdicts) {
    const Folder folder;
    const std::string program = GRAFVERIF_PROGRAM, file = folder.write("ring.grafcet", long_ring(3000));
    const std::string command = "ulimit -v 81920 && exec '" + program + "' check '" + file +
                                "' --untimed --timeout 5s > '" + folder.file("out") + "' 2>&1";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status)) << folder.read("out");
    EXPECT_EQ(WEXITSTATUS(status), 3) << folder.read("out");
}
#endif

}  // namespace
}  // namespace grafverif::app
