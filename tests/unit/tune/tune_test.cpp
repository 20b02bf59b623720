// SPDX-License-Identifier: MIT
// Tests tuning by the public data types: verdicts at all points, number of checks, limits.
#include "pipeline/variants/tune.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <iterator>

#include "report/charts/tuning.hpp"

namespace grafverif {
namespace {

constexpr auto of_time = NamedConstant::Kind::Duration;
constexpr auto of_number = NamedConstant::Kind::Integer;

const std::string chart =
    "grafcet press {\n    input START, DONE;\n    output DOWN;\n\n    initial step 0;\n    step 1 { DOWN; }\n\n"
    "    transition t0: 0 -> 1 when START;\n    transition t1: 1 -> 0 when 5s/X1;\n}\n";
const std::string ram =
    "component ram(input G; output OUT; LOW = 1s, HIGH = 3s) {\n    clock t;\n\n    initial location up;\n"
    "    location moving invariant t <= HIGH;\n    location down with OUT := true;\n\n"
    "    urgent up -> moving when G do t := 0;\n    timed moving -> down when t >= LOW do OUT := true;\n"
    "    urgent down -> up when !G do OUT := false;\n}\n";

std::string loop(const std::string& properties, const std::string& constants = "LOW = 1s, HIGH = 3s") {
    return chart + ram + "closed_loop station {\n    controller press;\n    constant " + constants +
           ";\n    environment Start = push_button(OUT = START, GAP = 1s);\n"
           "    plant Ram = ram(G = DOWN, OUT = DONE, LOW = LOW, HIGH = HIGH);\n" +
           properties + "}\n";
}

struct Loop {
    explicit Loop(const std::string& text) : read(read_string(text, "station.grafcet")) {
        EXPECT_TRUE(read.model.has_value()) << read.diagnostics_text();
    }
    std::optional<Tuning> tuned(std::vector<TunedConstant> constants, TuneRequest request = {.jobs = 1}) {
        request.constants = std::move(constants);
        return grafverif::tuned(*read.model, *find_loop(*read.model, "station"), *read.sources.ids().begin(),
                                read.sources, request, read.diagnostics);
    }
    ParseResult read;
};

/// Returns a character per point: `+` holds, `-` violated, `?` unknown.
std::string map_of(const Tuning& tuning, const std::string& property) {
    const auto row = std::ranges::find(tuning.rows, property, &Tuning::Row::property);
    std::string text;
    for (const PointVerdict& each : row->verdicts)
        text += each.outcome == Outcome::Holds ? '+' : each.outcome == Outcome::Violated ? '-' : '?';
    return text;
}

// The constants of an instance of a chart change the chart. Runs at a point are replayed with the chart of this point.
TEST(Tune, ReplaysRunsWithTheChartsOfThePoint) {
    Loop station(
        "grafcet g(input IN; output OUT; T = 1s, N = 2) {\n    internal C: int 0..N;\n    initial step 0;\n"
        "    step 1 { OUT; }\n    transition 0 -> 1 when IN && C < N do C := C + 1;\n"
        "    transition 1 -> 0 when T/X1;\n}\n"
        "closed_loop station {\n    constant SLOW = 1s, K = 2;\n"
        "    controller c = g(IN = X, OUT = Y, T = SLOW, N = K);\n"
        "    environment b = push_button(OUT = X, GAP = 1s);\n    property back: c.X1 leads to c.X0 within 2s;\n"
        "    property few: always c.C <= 2;\n}\n");
    const auto tuning =
        station.tuned({{"SLOW", of_time, 1000, 3000, 1000, 1000}, {"K", of_number, 1, 3, 1, 2}}, {.jobs = 1});
    ASSERT_TRUE(tuning);
    EXPECT_EQ(tuning->failures, std::vector<std::string>{});
    EXPECT_EQ(map_of(*tuning, "back"), "++++++---");
    EXPECT_EQ(map_of(*tuning, "few"), "++-++-++-");
}

TEST(Tune, FindsTheLimitOfAnUpperBoundByFewChecks) {
    Loop station(
        loop("    property in_time: always Ram.moving => X1 || X0;\n"
             "    property soon: DOWN leads to DONE within 6s;\n    property dark: never DONE && X0;\n"));
    const auto tuning = station.tuned({{"HIGH", of_time, 1000, 20000, 1000, 3000}});
    ASSERT_TRUE(tuning.has_value());
    EXPECT_EQ(map_of(*tuning, "soon"), "++++++" + std::string(14, '-'));
    EXPECT_EQ(map_of(*tuning, "no_timelock"), std::string(20, '+'));
    EXPECT_LE(tuning->checks, 8U);
    EXPECT_EQ(tuning->points, 20U);
}

TEST(Tune, AProofForMoreBehaviourDoesNotHideATimelock) {
    // If LOW exceeds HIGH, time stops in `moving`: `down` is no longer inevitable.
    Loop station(loop("    property down: X1 leads to DONE;\n    property moves: no deadlock;\n"));
    const auto tuning =
        station.tuned({{"LOW", of_time, 1000, 4000, 1000, 1000}, {"HIGH", of_time, 1000, 4000, 1000, 3000}});
    ASSERT_TRUE(tuning.has_value());
    EXPECT_EQ(map_of(*tuning, "no_timelock"), "++++-+++--++---+");
    EXPECT_EQ(map_of(*tuning, "down"), "++++-+++--++---+");
    EXPECT_EQ(map_of(*tuning, "moves"), "++++-+++--++---+");
}

TEST(Tune, NumbersInPropertiesAndRangesAreCheckedAtEachValue) {
    Loop station(loop("    property few: never N > 3;\n    property long_: never X1 && 1 > N;\n",
                      "LOW = 1s, HIGH = 3s, N: int 0..9 = 2"));
    const auto tuning = station.tuned({{"N", of_number, 0, 9, 1, 2}});
    ASSERT_TRUE(tuning.has_value());
    EXPECT_EQ(map_of(*tuning, "few"), "++++------");
    EXPECT_EQ(map_of(*tuning, "long_"), "-+++++++++");
    EXPECT_EQ(map_of(*tuning, "no_timelock"), "++++++++++");
}

/// Returns the text of samples/testing_station, in which two durations are constants.
std::string testing_station() {
    std::ifstream in(std::string(GRAFVERIF_SOURCE_DIR) + "/samples/testing_station/testing_station.grafcet");
    std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    for (const auto& [from, to] :
         {std::pair{"DURATION = 4s", "DURATION = TEST_TIME"},
          {"GAP = 1s", "GAP = PRESS"},
          {"with stability_search;", "with stability_search;\n    constant TEST_TIME = 4s, PRESS = 1s;"}}) {
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        text.replace(at, std::string_view(from).size(), to);
    }
    return text;
}

TEST(Tune, TheTestingStationNeedsFewChecks) {
    Loop station(testing_station());
    const auto tuning =
        station.tuned({{"TEST_TIME", of_time, 1000, 20000, 1000, 4000}, {"PRESS", of_time, 1000, 20000, 1000, 1000}});
    ASSERT_TRUE(tuning.has_value());
    EXPECT_LE(tuning->checks, 80U);
    for (const char* const property : {"P14", "P15", "no_deadlock", "no_timelock"})
        EXPECT_EQ(map_of(*tuning, property), std::string(400, '+')) << property;
}

TEST(Tune, TheLastOpenPointOfABoxIsChecked) {
    Loop station(loop("    property soon: DOWN leads to DONE within 6s;\n"));
    const auto tuning = station.tuned({{"HIGH", of_time, 6000, 8000, 1000, 3000}});
    ASSERT_TRUE(tuning.has_value());
    EXPECT_EQ(map_of(*tuning, "soon"), "+--");
}

TEST(Tune, EveryPointIsCheckedOnRequest) {
    Loop station(loop("    property soon: DOWN leads to DONE within 6s;\n"));
    const auto tuning = station.tuned({{"HIGH", of_time, 1000, 9000, 1000, 3000}}, {.jobs = 1, .every_point = true});
    ASSERT_TRUE(tuning.has_value());
    EXPECT_EQ(tuning->checks, tuning->points);
    EXPECT_EQ(tuning->transferred, 0U);
    EXPECT_EQ(map_of(*tuning, "soon"), "++++++---");
}

TEST(Tune, PointsWithDifferentTimeUnitsAreCompared) {
    Loop station(loop("    property soon: DOWN leads to DONE within 6s;\n"));
    const auto tuning = station.tuned({{"HIGH", of_time, 5600, 6600, 200, 3000}});
    ASSERT_TRUE(tuning.has_value());
    EXPECT_EQ(map_of(*tuning, "soon"), "+++---");
    EXPECT_EQ(tuning->settings.time_unit_ms, 200);
    EXPECT_EQ(tuning->rows[0].current.outcome, Outcome::Holds);  // the current value is not on the grid
}

TEST(Tune, UnreadPointsAreUnknownAfterAStop) {
    Loop station(loop("    property soon: DOWN leads to DONE within 6s;\n"));
    const std::atomic<bool> stop = true;
    const auto tuning =
        station.tuned({{"HIGH", of_time, 1000, 9000, 1000, 3000}}, {.limits = {.stop = &stop}, .jobs = 1});
    ASSERT_TRUE(tuning.has_value());
    EXPECT_EQ(map_of(*tuning, "soon"), "?????????");
}

TEST(Tune, WarningsOfPointsAreReportedOnce) {
    Loop station(loop("    property soon: DOWN leads to DONE within 6s;\n"));
    const auto tuning =
        station.tuned({{"HIGH", of_time, 20001, 20003, 1, 3000}}, {.limits = {.states = 100}, .jobs = 1});
    ASSERT_TRUE(tuning.has_value());
    const std::string text = station.read.diagnostics_text();
    EXPECT_NE(text.find("for `HIGH = 20001ms`: "), std::string::npos) << text;
    EXPECT_NE(text.find("[many-time-units]"), std::string::npos) << text;
    EXPECT_EQ(text.find("for `HIGH = 20002ms`"), std::string::npos) << text;
}

TEST(Tune, AModelThatIsRejectedForSomeValuesIsAnError) {
    Loop station(loop("", "LOW = 1s, HIGH = 3s, N: int 0..9 = 2"));
    EXPECT_FALSE(station.tuned({{"N", of_number, 8, 12, 1, 2}}).has_value());
    EXPECT_NE(station.read.diagnostics_text().find("for `N = 10`: "), std::string::npos)
        << station.read.diagnostics_text();
}

/// Returns a result with two constants and the verdicts of `map`.
Tuning drawn(const std::string& map) {
    Tuning tuning{.model = "m", .constants = {{"A", of_number, 1, 3, 1, 2}, {"B", of_time, 1000, 4000, 1000, 2000}}};
    tuning.points = 12;
    tuning.reasons = {"not checked", "inexact"};
    Tuning::Row row{.property = "p"};
    for (const char each : map)
        row.verdicts.push_back({each == '+'   ? Outcome::Holds
                                : each == '-' ? Outcome::Violated
                                              : Outcome::Unknown,
                                each == '!' ? 1U : 0U});
    row.current = row.verdicts[5];
    tuning.rows.push_back(row);
    return tuning;
}

TEST(Tune, BoxesCoverEachPointOnce) {
    for (const std::string map : {"++++++++++++", "+-+-+-+-+-+-", "++--++--++++", "?+!++++-+++-", "+++++--++--+"}) {
        const Tuning tuning = drawn(map);
        std::string covered(12, ' ');
        for (const GridBox& box : boxes_of(tuning, tuning.rows[0]))
            for (std::size_t a = box.first[0]; a <= box.last[0]; ++a)
                for (std::size_t b = box.first[1]; b <= box.last[1]; ++b) {
                    char& cell = covered[tuning.point({a, b})];
                    EXPECT_EQ(cell, ' ');
                    cell = map[tuning.point(box.first)];
                }
        EXPECT_EQ(covered, map);
    }
    EXPECT_EQ(boxes_of(drawn("++--++--++--"), drawn("++--++--++--").rows[0]).size(), 2U);
}

TEST(Tune, MarginsAreTheNearestOtherVerdicts) {
    const Tuning tuning = drawn("+-++-+++++-+");
    const auto margins = margins_of(tuning, tuning.rows[0]);
    ASSERT_EQ(margins.size(), 2U);
    EXPECT_EQ(margins[0].constant, 0U);
    EXPECT_EQ(std::pair(margins[0].value, margins[0].distance), std::pair(std::int64_t{1}, std::int64_t{1}));
    EXPECT_FALSE(margins[0].up);
    EXPECT_EQ(margins[1].constant, 1U);
    EXPECT_EQ(std::pair(margins[1].value, margins[1].distance), std::pair(std::int64_t{1000}, std::int64_t{1000}));
    Tuning elsewhere = tuning;
    elsewhere.constants[0].current = 9;
    // B has no margins, because the current value of A is not on the grid.
    EXPECT_EQ(margins_of(elsewhere, elsewhere.rows[0]).size(), 1U);
}

}  // namespace
}  // namespace grafverif
