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
