// SPDX-License-Identifier: MIT
#include "report/terminal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "traces.hpp"

namespace grafverif {
namespace {

std::string table(const ChartRun& run) {
    std::ostringstream out;
    print_trace(run, out);
    return out.str();
}

std::string text(const Report& report, bool verbose = false) {
    std::ostringstream out;
    print_report(report, {verbose, Colour::Plain}, out);
    return out.str();
}

TEST(Terminal, TellsATraceAsATableWithItsLoopMarked) {
    EXPECT_EQ(table(sample_run()),
              "   time  what happened               inputs     cleared     situation  outputs\n"
              "    0 s  press: power on             LEVEL = 2              0, 2       none\n"
              "         Start                       START\n"
              "         press: COUNT 0 -> -1                   t1; t2, t3  1, 2       GO\n"
              "+-- from here on, for ever:\n"
              "| 1.5 s  1.5 s pass\n"
              "|        Slide: going_out, X 0 -> 4  LEVEL = 3              1, 2       GO\n");
    ChartRun finite = sample_run();
    finite.loop_from.reset();
    EXPECT_EQ(table(finite).substr(table(finite).rfind("  1.5 s")),
              "  1.5 s  Slide: going_out, X 0 -> 4  LEVEL = 3              1, 2       GO\n")
        << "a delay is told by the time of what comes next";
}

TEST(Terminal, FitsAHundredColumnsWhateverTheNames) {
    ChartRun run = sample_run();
    run.rows[1].component = std::string(300, 'n');
    run.transitions[{0}].name = "a_transition";
    run.rows[2].fired = {std::vector<Id<ChartRun::Transition>>(40, {0})};
    run.rows[2].what =
        "words " + std::string(70, 'w') + " and more of them, many more than there is room for in one line";
    run.signals[{0}].name = std::string(120, 'i');
    std::istringstream lines(table(run));
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 100u) << line;
    EXPECT_GT(count, 20);
    // Nothing is lost by wrapping.
    const std::string whole = table(run);
    EXPECT_EQ(std::count(whole.begin(), whole.end(), 'n') >= 300, true);
}

TEST(Terminal, SaysUnderEachVerdictWhatItRestsOn) {
    const std::string told = text(sample_report());
    EXPECT_TRUE(
        told.starts_with("P1 \"all is well\": holds\n"
                         "    timed engine; stability-search, phased grain; time unit 0.5 s, cycle time taken as zero; "
                         "12 states\n"))
        << told;
    for (const char* line :
         {"P2 \"a <dangerous> & \"quoted\" text\": violated\n", "P3: unknown\n", "    why: 12 states are not enough\n",
          "no_timelock (not declared): unknown\n", "P4: violated, as expected\n", "P5: holds, vacuously\n",
          "    note: time never passes\n", "station: 2 hold, 2 violated, 2 unknown; 1 against expectation\n"})
        EXPECT_NE(told.find(line), std::string::npos) << line << "in\n" << told;
}

TEST(Terminal, SaysOnceWhatKeepsItFromSeveralVerdicts) {
    Report report = sample_report();
    for (const char* name : {"Q1", "Q2"})
        report.answers.push_back({{.property = name,
                                   .outcome = Outcome::Unknown,
                                   .obstacle = Obstacle::Bound,
                                   .reason = "the bound is reached: 7 states"},
                                  "",
                                  {}});
    const std::string told = text(report);
    const std::string once = "why unknown (Q1, Q2): the bound is reached: 7 states\n";
    EXPECT_NE(told.find(once), std::string::npos) << told;
    EXPECT_EQ(told.find("the bound is reached"), told.rfind("the bound is reached")) << told;
    EXPECT_NE(told.find("P3: unknown"), std::string::npos);
    EXPECT_NE(told.find("    why: 12 states are not enough\n"), std::string::npos)
        << "a reason of its own stays where it is";
}

TEST(Terminal, TellsWhatMultiplies) {
    Report report = sample_report();
    StateProfile profile{.states = 40, .sampled = 30, .most_combinations = 12, .inside_cycles = 10};
    profile.parts = {{"PLC", StateProfile::Kind::Controller, 12, {30, 5}, {}, "a.grafcet:3"},
                     {"Lamp", StateProfile::Kind::Instance, 9, {30, 30}, {}, ""}};
    profile.clocks = {{"Start", "t", 12, 13, {30, 10}, {}, ""}};
    profile.finest = StateProfile::Finest{1010, 10, 100, {}, "a.grafcet:7"};
    report.profile = profile;
    const std::string told = text(report);
    EXPECT_NE(
        told.find("what multiplies in the first 30 of 40 states (x N: N times fewer were left if it alone did not "
                  "count):\n"
                  "    x 6.0     controller PLC, 12 or more combinations of its own (a.grafcet:3)\n"
                  "    x 3.0     the clock t of Start alone, 13 values, compared with 12 at most\n"
                  "    33 % of these states lie inside a cycle; `--grain atomic` makes each cycle one step\n"
                  "    the duration 1.01 s (a.grafcet:7) makes the time unit 0.01 s; without it, it is 0.1 s\n"),
        std::string::npos)
        << told;
}

TEST(Terminal, ShowsWitnessesOnlyWhereAskedFor) {
    Report report = sample_report();
    report.answers = {{{.property = "R", .pattern = Pattern::Reachable, .outcome = Outcome::Holds}, "", sample_run()}};
    EXPECT_EQ(text(report).find("witness"), std::string::npos);
    EXPECT_NE(text(report, true).find("witness:\n"), std::string::npos);
}

TEST(Terminal, ShowsThePlaceWhereAModelBreaksOffFirst) {
    Report report = sample_report();
    report.breakdowns = {{"out-of-range", "`X` would leave its range 0..20", sample_run()}};
    EXPECT_TRUE(text(report).starts_with("the model breaks off: `X` would leave its range 0..20 [out-of-range]\n"))
        << text(report);
    EXPECT_NE(text(report).find("1 place where the model breaks off"), std::string::npos);
}

TEST(Terminal, WritesTimesInSeconds) {
    EXPECT_EQ(seconds_text(0), "0 s");
    EXPECT_EQ(seconds_text(250), "0.25 s");
    EXPECT_EQ(seconds_text(12'005), "12.005 s");
    EXPECT_EQ(seconds_text(60'000), "60 s");
}

TEST(Tally, CountsWhatIsAgainstExpectation) {
    const Tally count = tally(sample_report());
    EXPECT_EQ(count, (Tally{.holds = 2, .violated = 2, .unknown = 1, .undeclared_unknown = 1, .unexpected = 1}));
}

}  // namespace
}  // namespace grafverif
