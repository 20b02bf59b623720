// SPDX-License-Identifier: MIT
// Tests the public API of the library, with no other header.
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "grafverif/grafverif.hpp"

namespace {

using namespace grafverif;

const std::string samples = GRAFVERIF_SOURCE_DIR "/samples/";

constexpr const char* lamp_text = R"(grafcet lamp_chart {
    input a;
    output o;
    initial step 0;
    step 1 { o; }
    transition t0: 0 -> 1 when a;
    transition t1: 1 -> 0 when 2s/X1;
}
closed_loop lamp_loop {
    controller lamp_chart with stability_search;
    plant Lamp = lamp(ON = o);
    environment A = push_button(OUT = a);
    property lit: reachable X1 && o;
    property never_lit: never o;
}
)";

ParseResult lamp_reading() {
    ParseResult reading = read_string(lamp_text, "lamp.grafcet");
    EXPECT_TRUE(reading.model) << reading.diagnostics_text();
    return reading;
}

Outcome outcome(const Report& report, std::string_view property) {
    for (const PropertyResult& answer : report.answers)
        if (answer.verdict.property == property) return answer.verdict.outcome;
    ADD_FAILURE() << "no result for " << property;
    return Outcome::Unknown;
}

TEST(PublicApi, ReportsErrorsOfATextAsTheProgramDoes) {
    const ParseResult reading =
        read_string("grafcet g { initial step 0; transition t: 0 -> 9 when true; }\n", "wrong.grafcet");
    EXPECT_FALSE(reading.model);
    EXPECT_NE(reading.diagnostics_text().find("wrong.grafcet:1:"), std::string::npos) << reading.diagnostics_text();
    EXPECT_NE(reading.diagnostics_text().find('^'), std::string::npos);
    const ParseResult missing = read_file("/nowhere/x.grafcet");
    EXPECT_FALSE(missing.model);
    EXPECT_NE(missing.diagnostics_text().find("no such file"), std::string::npos) << missing.diagnostics_text();
}

TEST(PublicApi, PropertiesNameEveryStateOfThePlantInEveryEngine) {
    const ParseResult reading = read_string(R"(grafcet raising {
    input CARD, TOP;
    output RAISE;
    initial step 0;
    step 1 { RAISE; }
    transition t0: 0 -> 1 when CARD;
    transition t1: 1 -> 0 when TOP;
}
component gate(input OPEN; output AT_TOP; STEP = 1s) {
    variable X: int 0..3 = 0;
    variable MOVED = false;
    clock t;
    initial location resting;
    location rising invariant t <= STEP;
    urgent resting -> rising when OPEN && X < 3 do t := 0;
    timed rising -> resting when t == STEP && X < 2 do X := X + 1, MOVED := true;
    timed rising -> resting when t == STEP && X == 2 do X := 3, MOVED := true, AT_TOP := true;
}
closed_loop park {
    controller raising;
    plant Gate = gate(OPEN = RAISE, AT_TOP = TOP);
    environment Card = push_button(OUT = CARD);
    property names: always Gate.OPEN == RAISE && Gate.AT_TOP == TOP && Gate_X == Gate.X;
    property moves: always Gate.X > 0 => Gate.MOVED;
    property rests: always Gate.X == 3 implies Gate in resting;
    property rises: reachable Gate in rising && Gate.X == 2;
    property stays: never Gate.X == 3 && TOP;
})",
                                            "park.grafcet");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    Diagnostics diagnostics;
    const Id<ClosedLoop> park{0};
    ModelOptions discrete;
    discrete.untimed.plant = PlantApproach::Automata;
    discrete.untimed.time = TimeModel::Discrete;
    ModelOptions together = discrete;
    together.untimed.time = TimeModel::Abstract;
    together.untimed.schedule = Schedule::Synchronous;
    for (const auto& report : {check(*reading.model, park, {}, {}, diagnostics),
                               check_untimed(*reading.model, park, discrete, {}, diagnostics),
                               check_untimed(*reading.model, park, together, {}, diagnostics)}) {
        ASSERT_TRUE(report);
        for (const char* name : {"names", "moves", "rests", "rises"})
            EXPECT_EQ(outcome(*report, name), Outcome::Holds) << name;
        EXPECT_EQ(outcome(*report, "stays"), Outcome::Violated);
    }
    const auto alone = check_untimed(*reading.model, park, {}, {}, diagnostics);  // this check is without a plant
    ASSERT_TRUE(alone);
    EXPECT_EQ(outcome(*alone, "moves"), Outcome::Unknown);
}

constexpr const char* blinking = R"(grafcet blinker {
    input BUTTON;
    output LAMP;
    initial step 0;
    step 1 { LAMP; }
    transition t0: 0 -> 1 when BUTTON;
    transition t1: 1 -> 0 when 3s/X1 && !BUTTON;
}
closed_loop room {
    controller blinker;
    plant Lamp = lamp(ON = LAMP);
    environment Button = push_button_released(OUT = BUTTON, HOLD = 4s);
    property on: BUTTON leads to LAMP within 1s;
    property late: LAMP leads to !LAMP within 6s;
    property lit: Lamp in lit holds for 3s;
    property since: LAMP at most 1s since BUTTON;
    property cause: BUTTON precedes LAMP;
    property again: never X1 after X1 until X0;
    property often: LAMP at most 2 times;
    property once: LAMP at most 1 time between X1 and X0;
    property other: never LAMP && X0 at stable;
}
)";

TEST(PublicApi, ObserversAgreeInContinuousAndDiscreteTime) {
    const ParseResult reading = read_string(blinking, "room.grafcet");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    Diagnostics diagnostics;
    ModelOptions discrete;
    discrete.untimed.plant = PlantApproach::Automata;
    discrete.untimed.time = TimeModel::Discrete;
    const auto timed = check(*reading.model, Id<ClosedLoop>{0}, {}, {}, diagnostics);
    const auto counted = check_untimed(*reading.model, Id<ClosedLoop>{0}, discrete, {}, diagnostics);
    discrete.untimed.time = TimeModel::Abstract;
    const auto abstract = check_untimed(*reading.model, Id<ClosedLoop>{0}, discrete, {}, diagnostics);
    ASSERT_TRUE(timed && counted && abstract);
    const std::vector<std::string> violated = {"late", "since", "again", "often"};
    std::vector<std::string> order;
    for (const Property& property : reading.model->loops[{0}].properties) {
        const std::string& name = property.name;
        const bool holds = std::ranges::find(violated, name) == violated.end();
        EXPECT_EQ(outcome(*timed, name), holds ? Outcome::Holds : Outcome::Violated) << name;
        EXPECT_EQ(outcome(*counted, name), holds ? Outcome::Holds : Outcome::Violated) << name;
        if (property.watch.duration_ms > 0) EXPECT_EQ(outcome(*abstract, name), Outcome::Unknown) << name;
        else EXPECT_NE(outcome(*abstract, name), Outcome::Unknown) << name;
        order.push_back(name);
    }
    std::vector<std::string> answered;
    for (const PropertyResult& answer : timed->answers)
        if (answer.verdict.declared) answered.push_back(answer.verdict.property);
    EXPECT_EQ(answered, order);
}

TEST(PublicApi, CounterexamplesExplainTheirSentence) {
    const ParseResult reading = read_string(blinking, "room.grafcet");
    ASSERT_TRUE(reading.model);
    Diagnostics diagnostics;
    for (const auto& [property, words] : std::vector<std::pair<std::string, std::string>>{
             {"late", "`LAMP` at 1 s; deadline 7 s; `!LAMP` not true by then"},
             {"often", "`LAMP` at 1 s; `LAMP` at 5 s; `LAMP` at 9 s; more than 2 times"}}) {
        CheckOptions one;
        one.properties = {property};
        const auto report = check(*reading.model, Id<ClosedLoop>{0}, {}, one, diagnostics);
        ASSERT_TRUE(report);
        ASSERT_EQ(report->answers.size(), 2U);  // the second result is that of the search for timelocks
        ASSERT_FALSE(report->answers[0].verdict.notes.empty());
        EXPECT_EQ(report->answers[0].verdict.notes[0], words);
        EXPECT_EQ(report->answers[1].verdict.property, "no_timelock");
    }
}

/// A chart that violates a property of every form of docs/reference/properties.md.
const std::string forms = R"(grafcet chart {
    input BUTTON;
    output LAMP;
    initial step 0;
    step 1 { LAMP; }
    step 2;
    transition t0: 0 -> 1 when BUTTON;
    transition t1: 1 -> 2 when 4s/X1;
    transition t2: 2 -> 0 when 2s/X2;
}
closed_loop room {
    controller chart;
    environment Button = push_button_released(OUT = BUTTON, HOLD = 1s);
    property within: LAMP leads to !LAMP within 3s;
    property holds_for: LAMP holds for 5s;
    property holds_at_most: LAMP holds at most 3s;
    property since: LAMP at most 2s since BUTTON;
    property every: LAMP at least every 5s;
    property precedes: LAMP precedes BUTTON;
    property precedes_before: X2 precedes LAMP before X2;
    property precedes_between: X0 precedes LAMP between X1 and X2;
    property never_before: never LAMP before X2;
    property never_after: never X0 after X2;
    property never_between: never LAMP between X1 and X2;
    property never_until: never X2 after X1 until X0;
    property always_between: always BUTTON between X1 and X2;
    property inevitable_before: inevitable X2 before LAMP;
    property inevitable_after: inevitable X2 after X0;
    property inevitable_between: inevitable X0 between X1 and X2;
    property inevitable_until: inevitable X0 after X1 until X2;
    property leads_before: BUTTON leads to X2 before LAMP;
    property leads_after: X0 leads to LAMP after X0;
    property leads_between: LAMP leads to X0 between X1 and X2;
    property within_before: X1 leads to X2 within 2s before X2;
    property within_after: X1 leads to X2 within 2s after BUTTON;
    property within_between: X1 leads to X0 within 2s between X1 and X0;
    property every_between: X2 at least every 3s between X1 and X0;
    property at_most_between: X1 holds at most 3s between X1 and X0;
    property once: LAMP at most 1 time;
    property once_after: X2 at most 1 time after LAMP;
}
)";

TEST(PublicApi, ViolationsOfEveryFormAreExplainedEventByEvent) {
    const std::vector<std::pair<std::string, std::string>> expected = {
        {"within", "`LAMP` at 1 s; deadline 4 s; `!LAMP` not true by then"},
        {"holds_for", "`LAMP` from 1 s; required until 6 s; false at 5 s"},
        {"holds_at_most", "`LAMP` from 1 s; deadline 4 s; `LAMP` still true after the deadline"},
        {"since", "`BUTTON` false from 2 s on; `LAMP` allowed until 4 s; `LAMP` at 5 s"},
        {"every", "no `LAMP` from 0 s; deadline 5 s; `LAMP` not true by then"},
        {"precedes", "`BUTTON` at 1 s; `LAMP` not true before"},
        {"precedes_before", "`LAMP` at 1 s; `X2` not true before; `X2` at 5 s"},
        {"precedes_between", "`X1` at 1 s; `LAMP` at 1 s; `X0` not true before; `X2` at 5 s"},
        {"never_before", "`LAMP` at 1 s; `X2` at 5 s"},
        {"never_after", "`X2` at 5 s; `X0` at 7 s"},
        {"never_between", "`X1` at 1 s; `LAMP` at 1 s; `X2` at 5 s"},
        {"never_until", "`X1` at 1 s; `X2` at 5 s"},
        {"always_between", "`X1` at 1 s; `BUTTON` false at 2 s; `X2` at 5 s"},
        {"inevitable_before", "`LAMP` at 1 s; `X2` not true by then"},
        {"inevitable_after", "`X0` at 0 s; `X2` never true after that"},
        {"inevitable_between", "`X1` at 1 s; `X2` at 5 s; `X0` not true by then"},
        {"inevitable_until", "`X1` at 1 s; `X2` at 5 s; `X0` not true by then"},
        {"leads_before", "`BUTTON` at 1 s; `LAMP` at 1 s; `X2` not true by then"},
        {"leads_after", "`X0` at 0 s; `X0` at 0 s; `LAMP` never true after that"},
        {"leads_between", "`X1` at 1 s; `LAMP` at 1 s; `X2` at 5 s; `X0` not true by then"},
        {"within_before", "`X1` at 1 s; deadline 3 s; `X2` not true by then; `X2` at 5 s"},
        {"within_after", "`BUTTON` at 1 s; `X1` at 1 s; deadline 3 s; `X2` not true by then"},
        {"within_between", "`X1` at 1 s; `X1` at 1 s; deadline 3 s; `X0` not true by then; `X0` at 7 s"},
        {"every_between", "`X1` at 1 s; no `X2` from 1 s; deadline 4 s; `X2` not true by then; `X0` at 7 s"},
        {"at_most_between",
         "`X1` at 1 s; `X1` from 1 s; deadline 4 s; `X1` still true after the deadline; `X0` at 7 s"},
        {"once", "`LAMP` at 1 s; `LAMP` at 7 s; more than once"},
        {"once_after", "`LAMP` at 1 s; `X2` at 5 s; `X2` at 11 s; more than once"}};
    const ParseResult reading = read_string(forms, "forms.grafcet");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    Diagnostics diagnostics;
    const auto report = check(*reading.model, Id<ClosedLoop>{0}, {}, {}, diagnostics);
    ASSERT_TRUE(report);
    std::vector<std::pair<std::string, std::string>> found;
    for (const PropertyResult& answer : report->answers)
        if (answer.verdict.outcome == Outcome::Violated && !answer.verdict.notes.empty())
            found.emplace_back(answer.verdict.property, answer.verdict.notes[0]);
    EXPECT_EQ(found, expected);
}

TEST(PublicApi, IncludesComeFromTheFoldersOfTheCaller) {
    ReadOptions options;
    std::vector<std::string> requested;
    options.load = [&](const std::string& path, std::string& why) -> std::optional<std::string> {
        requested.push_back(path);
        if (path != "part.grafcet") return why = "it is not here", std::nullopt;
        return "grafcet part { initial step 0; }\n";
    };
    const ParseResult reading = read_string("include \"part.grafcet\";\n", "main.grafcet", options);
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    EXPECT_EQ(requested, std::vector<std::string>{"part.grafcet"});
    EXPECT_TRUE(find_chart(*reading.model, "part"));
    EXPECT_FALSE(find_chart(*reading.model, "other"));
    const ParseResult refused = read_string("include \"far.grafcet\";\n", "main.grafcet", options);
    EXPECT_NE(refused.diagnostics_text().find("it is not here"), std::string::npos) << refused.diagnostics_text();
}

TEST(PublicApi, DecidesALoopWithAndWithoutTime) {
    ParseResult file = lamp_reading();
    const auto loop = find_loop(*file.model, "lamp_loop");
    ASSERT_TRUE(loop);
    const auto timed = check(*file.model, *loop, {}, {}, file.diagnostics);
    ASSERT_TRUE(timed) << file.diagnostics_text();
    EXPECT_EQ(outcome(*timed, "lit"), Outcome::Holds);
    EXPECT_EQ(outcome(*timed, "never_lit"), Outcome::Violated);
    EXPECT_EQ(timed->failures, std::vector<std::string>{});
    const auto violated = std::ranges::find(timed->answers, "never_lit",
                                            [](const PropertyResult& each) { return each.verdict.property; });
    ASSERT_TRUE(violated->trace);
    EXPECT_FALSE(violated->trace->rows.empty());
    EXPECT_NE(text_of(*timed).find("never_lit: violated"), std::string::npos) << text_of(*timed);
    EXPECT_NE(json_of(*timed).find("\"lamp_loop\""), std::string::npos);

    const auto untimed = check_untimed(*file.model, *loop, {}, {}, file.diagnostics);
    ASSERT_TRUE(untimed) << file.diagnostics_text();
    EXPECT_EQ(outcome(*untimed, "lit"), Outcome::Holds);
    EXPECT_FALSE(untimed->answers.front().preservation.empty());
}

TEST(PublicApi, UnknownPropertyIsAnError) {
    ParseResult file = lamp_reading();
    const CheckOptions options{.properties = {"litt"}};
    EXPECT_FALSE(check(*file.model, {0}, {}, options, file.diagnostics));
    EXPECT_NE(file.diagnostics_text().find("litt"), std::string::npos) << file.diagnostics_text();
    EXPECT_FALSE(check_untimed(*file.model, Id<ClosedLoop>{0}, {}, options, file.diagnostics));
    EXPECT_FALSE(check_untimed(*file.model, Id<Chart>{0}, {}, options, file.diagnostics));
}

TEST(PublicApi, LimitsEndTheWorkWithTheResultsSoFar) {
    ParseResult file = read_file(samples + "testing_station/testing_station.grafcet");
    ASSERT_TRUE(file.model) << file.diagnostics_text();
    CheckOptions options;
    options.limits.states = 10;
    const auto bounded = check(*file.model, {0}, {}, options, file.diagnostics);
    ASSERT_TRUE(bounded);
    EXPECT_TRUE(std::ranges::any_of(bounded->answers, [](const PropertyResult& answer) {
        return answer.verdict.outcome == Outcome::Unknown && answer.verdict.obstacle == UnknownReason::Bound;
    })) << text_of(*bounded);

    const std::atomic<bool> stop = true;
    options.limits = {.stop = &stop};
    const auto stopped = check(*file.model, {0}, {}, options, file.diagnostics);
    ASSERT_TRUE(stopped);
    EXPECT_TRUE(std::ranges::any_of(stopped->answers, [](const PropertyResult& answer) {
        return answer.verdict.obstacle == UnknownReason::Stopped;
    })) << text_of(*stopped);
}

TEST(PublicApi, ProgressCallbackMayEndTheWork) {
    ParseResult file = read_file(samples + "tanks/tanks.grafcet");
    ASSERT_TRUE(file.model) << file.diagnostics_text();
    std::atomic<bool> stop = false;
    std::string words;
    CheckOptions options;
    options.jobs = 1;  // with several threads, the engines might end before the callback sets `stop`
    options.limits.stop = &stop;
    options.limits.progress = [&](const Progress& now) {
        words = now.words();
        stop = true;
    };
    const auto report = check_untimed(*file.model, Id<ClosedLoop>{0}, {}, options, file.diagnostics);
    ASSERT_TRUE(report);
    EXPECT_NE(words.find("steps deep"), std::string::npos) << words;
    EXPECT_TRUE(std::ranges::any_of(report->answers, [](const PropertyResult& answer) {
        return answer.verdict.obstacle == UnknownReason::Stopped;
    })) << text_of(*report);
}

TEST(PublicApi, ExportsModelsAsText) {
    ParseResult file = lamp_reading();
    const auto network = network_of(*file.model, {0}, {}, file.diagnostics);
    const auto system = transition_system_of(*file.model, Id<ClosedLoop>{0}, {}, file.diagnostics);
    const auto equations = equations_of(*file.model, {0}, file.diagnostics);
    ASSERT_TRUE(network && system && equations) << file.diagnostics_text();
    const UppaalProject uppaal = uppaal_project(*network, file.diagnostics);
    EXPECT_NE(uppaal.project.find("<nta>"), std::string::npos);
    EXPECT_NE(uppaal.queries.find("A[]"), std::string::npos) << uppaal.queries;
    EXPECT_NE(nusmv_model(*system, file.diagnostics).find("MODULE main"), std::string::npos);
    const auto block = structured_text_of(*equations, ExecutionMode::StabilitySearch, file.diagnostics);
    ASSERT_TRUE(block);
    EXPECT_NE(block->find("END_FUNCTION_BLOCK"), std::string::npos) << *block;
}

TEST(PublicApi, ChecksChartsAlone) {
    ParseResult file = lamp_reading();
    const auto report = check_untimed(*file.model, Id<Chart>{0}, {}, {}, file.diagnostics);
    ASSERT_TRUE(report) << file.diagnostics_text();
    EXPECT_EQ(outcome(*report, "reachable.X1"), Outcome::Holds);
    EXPECT_EQ(outcome(*report, "stabilises"), Outcome::Holds);
    const auto analysis = analysis_of(*file.model, {0}, {}, {}, file.diagnostics);
    ASSERT_TRUE(analysis);
    EXPECT_TRUE(analysis->open.empty());
    const auto automaton = automaton_of(*file.model, {0}, {}, file.diagnostics);
    const auto machine = mealy_of(*file.model, {0}, {}, file.diagnostics);
    const auto test = test_of(*file.model, {0}, {}, file.diagnostics);
    ASSERT_TRUE(automaton && machine && test) << file.diagnostics_text();
    EXPECT_TRUE(automaton->complete);
    EXPECT_TRUE(verify(*machine).empty());
    EXPECT_FALSE(test->sequences.empty());
}

TEST(PublicApi, OneModelServesSeveralThreads) {
    const ParseResult file = lamp_reading();
    std::vector<std::string> reports(4);
    std::vector<std::thread> threads;
    for (std::string& report : reports)
        threads.emplace_back([&] {
            Diagnostics diagnostics;
            if (const auto made = check(*file.model, {0}, {}, {}, diagnostics)) report = text_of(*made);
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_NE(reports[0], "");
    for (const std::string& report : reports) EXPECT_EQ(report, reports[0]);
}

}  // namespace
