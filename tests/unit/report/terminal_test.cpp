// SPDX-License-Identifier: MIT
#include "report/terminal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "report/table.hpp"
#include "report/trace_text.hpp"
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
    print_report(report, {.verbose = verbose}, out);
    return out.str();
}

/// This test finishes within its time limit only if the work is linear in the number of properties.
TEST(Terminal, ReportsOfVeryManyPropertiesArePrinted) {
    constexpr std::size_t many = 100'000;
    Report report{"wide", {}};
    for (std::size_t k = 0; k < many; ++k) {
        PropertyResult& answer = report.answers.emplace_back();
        answer.verdict.property = "reachable.X" + std::to_string(k);
        answer.verdict.reason = "stopped";
        answer.verdict.notes = {"note " + std::to_string(k)};
        answer.verdict.scope.searched = {"part " + std::to_string(k)};
    }
    std::ostringstream out;
    print_report(report, {.failures_only = true}, out);
    EXPECT_NE(out.str().find("note: note 99999"), std::string::npos);
    for (PropertyResult& answer : report.answers) answer.verdict.notes.clear(), answer.verdict.scope = {};
    std::ostringstream shared;
    print_report(report, {.failures_only = true}, shared);
    EXPECT_NE(shared.str().find("\nreachable: unknown\n    why: stopped\n"), std::string::npos)
        << shared.str().substr(0, 1000);
    report.answers.front().verdict.notes = {"another"};
    std::ostringstream named;
    print_report(report, {.failures_only = true}, named);
    EXPECT_NE(named.str().find("reachable.X1, reachable.X2, reachable.X3"), std::string::npos);
}

TEST(Terminal, FoldsRowsThatAreRepeatedInEqualTime) {
    ChartRun run;
    for (const char* name : {"0", "1"}) run.steps.add({{"", name}, "", ""});
    shorten_names(run.steps);
    const auto add = [&run](const char* what, std::int64_t ms, std::uint32_t step) {
        run.moments.push_back({.move = run.moments.size(), .after = {ms, {{step}}, {}}});
        run.rows.push_back({ChartRun::Kind::Controller, "lamp", what, {}, false, run.rows.size()});
    };
    add("power on", 0, 0);
    for (std::int64_t k = 0; k < 5; ++k) {
        add("on", 1000 * k + 500, 1);
        add("off", 1000 * k + 1000, 0);
    }
    add("on", 7000, 1);
    EXPECT_EQ(table(run),
              "   time  event           inputs  cleared  situation  outputs\n"
              "    0 s  lamp: power on  none             0          none\n"
              "  0.5 s  lamp: on                         1\n"
              "    1 s  lamp: off                        0\n"
              "         repeated 4 times, every 1 s, until 5 s\n"
              "    7 s  lamp: on                         1          none\n");
    run.timed = false;  // steps of a model are not durations
    EXPECT_EQ(table(run).find("repeated"), std::string::npos);
}

TEST(Terminal, PrintsATraceAsATableWithItsLoopMarked) {
    EXPECT_EQ(table(sample_run()),
              "   time  event                       inputs     cleared     situation  outputs\n"
              "    0 s  press: power on             LEVEL = 2              0, 2       none\n"
              "         Start                       START\n"
              "         press: COUNT 0 -> -1                   t1; t2, t3  1, 2       GO\n"
              "+-- repeated forever from here:\n"
              "| 1.5 s  1.5 s pass\n"
              "|        Slide: going_out, X 0 -> 4  LEVEL = 3              1, 2       GO\n");
    ChartRun finite = sample_run();
    finite.loop_from.reset();
    EXPECT_EQ(table(finite).substr(table(finite).rfind("  1.5 s")),
              "  1.5 s  Slide: going_out, X 0 -> 4  LEVEL = 3              1, 2       GO\n")
        << "a delay is visible only in the time of the next row";
}

TEST(Terminal, PrintsACauseOfSeveralEventsOfOneInstantOnce) {
    ChartRun run = sample_run();
    const Id<ChartRun::Signal> go{1}, level{2}, idle{3};
    run.causes = {{.signal = go, .value = 1, .first = 1, .last = 1},
                  {.signal = idle, .value = 0, .first = 1, .last = 4},
                  {.signal = go, .value = 1, .first = 2, .last = 2},
                  {.signal = level, .value = 2, .first = 2, .last = 2}};
    EXPECT_EQ(causes_text(run), "at 0 s: GO, LEVEL = 2; from 0 s on: !IDLE");
    run.causes.clear();
    for (std::int64_t k = 0; k < 20; ++k)
        run.causes.push_back({.signal = level, .value = k / 2, .first = 1, .last = 1});
    EXPECT_EQ(causes_text(run),
              "at 0 s: LEVEL = 0, LEVEL = 1, LEVEL = 2, LEVEL = 3, LEVEL = 4, LEVEL = 5, LEVEL = 6, LEVEL = 7; and 2 "
              "more");
}

TEST(Terminal, FitsAHundredColumnsForAllNames) {
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
    // Line breaks do not change the text.
    const std::string whole = table(run);
    EXPECT_EQ(std::count(whole.begin(), whole.end(), 'n') >= 300, true);
}

TEST(Terminal, PrintsSharedAssumptionsOnce) {
    Report report = sample_report();
    report.answers.resize(3);
    const std::string output = text(report);
    EXPECT_TRUE(output.starts_with(
        "station, checked with: timed engine; stability-search, phased grain; time unit 0.5 s, cycle "
        "time taken as zero; 12 states\n"
        "\nP2 \"a <dangerous> & \"quoted\" text\": violated\ncounterexample:\n"))
        << output;
    EXPECT_EQ(output.find("12 states\n"), output.rfind("12 states\n")) << output;
    EXPECT_EQ(output.find("P1 \"all"), std::string::npos) << "a property that holds is only in the table";
    EXPECT_TRUE(
        output.ends_with("\n"
                         "P3: unknown\n"
                         "    why: 12 states are not enough\n"
                         "\n"
                         "property  verdict   description\n"
                         "P1        holds     all is well\n"
                         "P2        violated  a <dangerous> & \"quoted\" text\n"
                         "P3        unknown\n"
                         "station: 1 holds, 1 violated, 1 unknown; 1 unexpected\n"))
        << output;
}

TEST(Terminal, PrintsTheSeparateAssumptionsOfEachGroup) {
    Report report{"station", {"timed", "every-cycle", "atomic", 1000}, {}, {}};
    const SearchScope alone{{"left"}, {"right"}, "has no say"};
    const auto answer = [](const char* name, const char* states, const SearchScope& scope) {
        return PropertyResult{
            {.property = name, .outcome = Outcome::Holds, .states = states, .scope = scope}, "", {}, {}, ""};
    };
    report.answers = {answer("A", "7", alone), answer("S.X1", "9", {}), answer("S.X2", "9", {}),
                      answer("B", "7", alone), answer("T.X1", "9", {}), answer("T.X2", "7", alone)};
    const std::string output = text(report);
    EXPECT_TRUE(output.starts_with(
        "station, checked with: timed engine; every-cycle, atomic grain; time unit 1 s, cycle time taken as zero\n"
        "    A, B, T.X2: 7 states; sub-loop `left` alone; omitted: `right`, which has no say\n"
        "    S, T.X1: 9 states\n"))
        << output;
}

TEST(Terminal, UndecidedPropertiesHaveNoImplications) {
    Report report{"tanks", {.engine = "symbolic", .mode = "every-cycle", .untimed = "no plant"}, {}, {}};
    report.answers = {
        {{.property = "A", .outcome = Outcome::Holds, .states = "9"}, "", {}, "valid for every plant", ""},
        {{.property = "B", .reason = "it is about time"}, "", {}, "", ""}};
    EXPECT_TRUE(
        text(report).starts_with("tanks, checked with: symbolic, untimed: no plant; every-cycle; 9 states\n"
                                 "    A: valid for every plant\n"
                                 "\n"
                                 "B: unknown\n"
                                 "    why: it is about time\n"))
        << text(report);
}

TEST(Terminal, PrintsReachedStepsInOneLineAndTheOthersSeparately) {
    Report report{"line", {"timed", "every-cycle", "atomic", 1000}, {}, {}};
    for (const char* step : {"0", "1", "2"})
        report.answers.push_back({{.property = std::string("S.X") + step,
                                   .pattern = Pattern::Reachable,
                                   .outcome = *step == '1' ? Outcome::Violated : Outcome::Holds,
                                   .states = "3"},
                                  "all are of use",
                                  {},
                                  "",
                                  "a.grafcet:7"});
    EXPECT_TRUE(
        text(report).ends_with("; 3 states\n"
                               "\n"
                               "a.grafcet:7: S.X1 \"all are of use\": violated\n"
                               "\n"
                               "property          verdict   location     description\n"
                               "S (2 of 3 steps)  holds     a.grafcet:7  all are of use\n"
                               "S.X1              violated  a.grafcet:7  all are of use\n"
                               "line: 2 hold, 1 violated; 1 unexpected\n"))
        << text(report);
    report.answers[1].verdict.outcome = Outcome::Holds;
    EXPECT_NE(text(report).find("S (3 steps)  holds"), std::string::npos) << text(report);
}

TEST(Terminal, PrintsNotesOfHoldingPropertiesWithTheAssumptions) {
    Report report = sample_report();
    const std::string output = text(report);
    EXPECT_NE(output.find("    note (P5): time never passes\n\nP2 "), std::string::npos) << output;
    EXPECT_NE(output.find("P5                          holds, vacuously\n"), std::string::npos) << output;
    EXPECT_NE(output.find("P4: violated, as expected\ncounterexample:\n"), std::string::npos) << output;
    EXPECT_NE(output.find("no_timelock (not declared)  unknown\n"), std::string::npos) << output;
    report.answers[1].verdict.notes = {"of this one"};
    EXPECT_NE(text(report).find("violated\n    note: of this one\ncounterexample:"), std::string::npos) << text(report);
    for (PropertyResult& answer : report.answers) answer.verdict.notes = {"of all"};
    EXPECT_NE(text(report).find("    note: of all\n"), std::string::npos) << text(report);
    EXPECT_EQ(text(report).find("of all"), text(report).rfind("of all")) << text(report);
}

TEST(Terminal, PrintsOnlyFailuresOnRequest) {
    std::ostringstream out;
    Report report = sample_report();
    print_report(report, {.failures_only = true}, out);
    EXPECT_NE(out.str().find("\nP2 \"a <dangerous>"), std::string::npos) << out.str();
    EXPECT_TRUE(out.str().ends_with("\nP3: unknown\n    why: 12 states are not enough\n")) << out.str();
    for (const char* other : {"P1", "P4", "P5", "no_timelock", "property", "station:"})
        EXPECT_EQ(out.str().find(other), std::string::npos) << other << " in\n" << out.str();
    report.answers.resize(1);
    std::ostringstream none;
    print_report(report, {.failures_only = true}, none);
    EXPECT_EQ(none.str(), "") << "a property that holds is not a failure";
}

TEST(Terminal, FitsTheClosingTableIntoTheTerminalAsFarAsItsTextGoes) {
    Report report = sample_report();
    report.answers.resize(1);
    report.answers[0].text = "字字字字字字字字字字字字";
    report.answers[0].place = "a.grafcet:7";
    const auto last_rows = [&](std::size_t columns) {
        std::ostringstream out;
        print_report(report, {.columns = columns}, out);
        return out.str().substr(out.str().find("\n\n") + 2);
    };
    EXPECT_EQ(last_rows(0),
              "property  verdict  location     description\n"
              "P1        holds    a.grafcet:7  字字字字字字字字字字字字\nstation: 1 holds\n");
    EXPECT_EQ(last_rows(52),
              "property  verdict  location     description\n"
              "P1        holds    a.grafcet:7  字字字字字字字字字…\nstation: 1 holds\n");
    EXPECT_EQ(last_rows(51), "property  verdict  location\nP1        holds    a.grafcet:7\nstation: 1 holds\n")
        << "a location is never truncated";
}

TEST(Terminal, PaintsVerdicts) {
    std::ostringstream out;
    print_report(sample_report(), {.colour = Colour::Ansi}, out);
    for (const char* painted :
         {"P1                          \033[1;32mholds\033[0m", "P3                          \033[1;33munknown\033[0m",
          "P2                          \033[1;31mviolated\033[0m", "P3: \033[1;33munknown\033[0m\n"})
        EXPECT_NE(out.str().find(painted), std::string::npos) << painted << " in\n" << out.str();
}

TEST(Terminal, PrintsTheSharedReasonOfUnknownVerdictsOnce) {
    Report report = sample_report();
    for (const char* name : {"Q1", "Q2"})
        report.answers.push_back({{.property = name,
                                   .outcome = Outcome::Unknown,
                                   .obstacle = UnknownReason::Bound,
                                   .reason = "state limit reached: 7 states"},
                                  "",
                                  {},
                                  "",
                                  ""});
    const std::string output = text(report);
    const std::string once =
        "\n"
        "Q1, Q2: unknown\n"
        "    why: state limit reached: 7 states\n";
    EXPECT_NE(output.find(once), std::string::npos) << output;
    EXPECT_EQ(output.find("state limit reached"), output.rfind("state limit reached")) << output;
    EXPECT_NE(output.find("\nP3: unknown\n    why: 12 states are not enough\n"), std::string::npos)
        << "a reason of a single property is printed with this property";
}

TEST(Terminal, PrintsTheStateProfile) {
    Report report = sample_report();
    StateProfile profile{.states = 40, .sampled = 30, .most_combinations = 12, .inside_cycles = 10};
    profile.parts = {{"PLC", StateProfile::Kind::Controller, 12, {30, 5}, {}, "a.grafcet:3"},
                     {"Lamp", StateProfile::Kind::Instance, 9, {30, 30}, {}, ""}};
    profile.clocks = {{"Start", "t", 12, 13, {30, 10}, {}, ""}};
    profile.finest = StateProfile::Finest{1010, 10, 100, {30, 12}, {}, "a.grafcet:7"};
    report.profile = profile;
    const std::string output = text(report);
    EXPECT_NE(output.find("state space factors of the first 30 of 40 states (x N: without this element, the number of "
                          "states would be divided by N):\n"
                          "    x 6.0     controller PLC, 12 or more combinations of its variables (a.grafcet:3)\n"
                          "    x 3.0     the clock t of Start alone, 13 values, greatest constant in comparisons: 12\n"
                          "    33 % of these states are within a cycle; with grain atomic, each cycle is one step, "
                          "and at most 20 of these states remain\n"
                          "    with the duration 1.01 s (a.grafcet:7), the time unit is 0.01 s; without this duration, "
                          "it is 0.1 s (x 2.5: with this unit, the number of states would be divided by 2.5)\n"),
              std::string::npos)
        << output;
}

TEST(Terminal, ShowsWitnessesOnlyOnRequest) {
    Report report = sample_report();
    report.answers = {{{.property = "R", .pattern = Pattern::Reachable, .outcome = Outcome::Holds}, "", sample_run()}};
    EXPECT_EQ(text(report).find("witness"), std::string::npos);
    EXPECT_NE(text(report, true).find("witness:\n"), std::string::npos);
}

TEST(Terminal, ShowsModelErrorsFirst) {
    Report report = sample_report();
    report.error_traces = {{"out-of-range", "`X` would leave its range 0..20", sample_run()}};
    EXPECT_TRUE(text(report).starts_with("model error: `X` would leave its range 0..20 [out-of-range]\n"))
        << text(report);
    EXPECT_NE(text(report).find("1 model error"), std::string::npos);
}

TEST(Terminal, WrapsBetweenCharactersAndCountsTheirColumns) {
    using Lines = std::vector<std::string>;
    EXPECT_EQ(wrapped("Förderer läuft", 8), (Lines{"Förderer", "läuft"}));
    EXPECT_EQ(wrapped("ÄÖÜäöü", 4), (Lines{"ÄÖÜä", "öü"}));
    EXPECT_EQ(wrapped("字字字", 5), (Lines{"字字", "字"}));
    EXPECT_EQ(wrapped("字字", 1), (Lines{"字", "字"})) << "each line has at least one character";
    EXPECT_EQ(wrapped("e\xCC\x81tage", 3), (Lines{"e\xCC\x81ta", "ge"}));
    EXPECT_EQ(wrapped("\xFF\xFF\xFF", 2), (Lines{"\xFF\xFF", "\xFF"}));
    ChartRun run = sample_run();
    for (ChartRun::Signal& signal : run.signals) signal.name = "Ü" + signal.name;
    ChartRun plain = sample_run();
    for (ChartRun::Signal& signal : plain.signals) signal.name = "U" + signal.name;
    std::string output = table(run);
    for (std::size_t at = 0; (at = output.find("Ü")) != std::string::npos;) output.replace(at, 2, "U");
    EXPECT_EQ(output, table(plain));
}

TEST(Terminal, WritesTimesInSeconds) {
    EXPECT_EQ(seconds_text(0), "0 s");
    EXPECT_EQ(seconds_text(250), "0.25 s");
    EXPECT_EQ(seconds_text(12'005), "12.005 s");
    EXPECT_EQ(seconds_text(60'000), "60 s");
}

TEST(Tally, CountsUnexpectedVerdicts) {
    const Tally count = tally(sample_report());
    EXPECT_EQ(count, (Tally{.holds = 2, .violated = 2, .unknown = 1, .undeclared_unknown = 1, .unexpected = 1}));
}

}  // namespace
}  // namespace grafverif
