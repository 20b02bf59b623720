// SPDX-License-Identifier: MIT
// Tests explanations of violated properties in reports.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "grafverif/grafverif.hpp"
#include "pipeline/why.hpp"

namespace grafverif {
namespace {

/// Returns the report on a closed loop of the chart `c`, whose input `a` is bound to a push button.
Report report_of(const std::string& chart, const std::string& properties, Grain grain = Grain::Phased) {
    ParseResult reading = read_string(
        chart + " closed_loop requested { controller c; environment A = push_button(OUT = a); " + properties + " }\n",
        "c");
    EXPECT_TRUE(reading.model) << reading.diagnostics_text();
    if (!reading.model) return {};
    const auto report = check(*reading.model, {0}, {{}, grain}, {}, reading.diagnostics);
    EXPECT_TRUE(report) << reading.diagnostics_text();
    return report.value_or(Report{});
}

/// Returns the report on the untimed model of the loop of report_of; by default, the inputs of the model are free.
Report untimed_report_of(const std::string& chart, const std::string& properties,
                         PlantApproach plant = PlantApproach::None) {
    ParseResult reading = read_string(
        chart + " closed_loop requested { controller c; environment A = push_button(OUT = a); " + properties + " }\n",
        "c");
    EXPECT_TRUE(reading.model) << reading.diagnostics_text();
    if (!reading.model) return {};
    ModelOptions how;
    how.untimed.plant = plant;
    const auto report = check_untimed(*reading.model, Id<ClosedLoop>{0}, how, {}, reading.diagnostics);
    EXPECT_TRUE(report) << reading.diagnostics_text();
    return report.value_or(Report{});
}

const PropertyResult& answer(const Report& report, std::string_view property) {
    const auto found = std::ranges::find(
        report.answers, property, [](const PropertyResult& each) -> std::string_view { return each.verdict.property; });
    EXPECT_NE(found, report.answers.end()) << property;
    return *found;
}

std::string notes(const Report& report, std::string_view property) {
    std::string text;
    for (const std::string& note : answer(report, property).verdict.notes) text += note + '\n';
    return text;
}

constexpr const char* lamps = R"(grafcet c {
    input a;
    output green, red;
    initial step 0 { green; }
    step 1 { red; }
    transition t0: 0 -> 1 when a;
    transition t1: 1 -> 0 when !a;
})";

TEST(Explain, ViolationsBeforeTheFirstOutputsAreDistinguished) {
    const Report report = report_of(
        lamps,
        "property one: exactly one of {green, red}; property lit: always green or red;"
        "property never_red: always green; property later: never red; property settled: always green at stable;");
    const std::string trap = "violated at power-on, before the first outputs are written";
    const std::string cure = trap + "; holds in every quiescent state: append `at stable` to check only those\n";
    EXPECT_EQ(notes(report, "one"), cure);
    EXPECT_EQ(notes(report, "lit"), cure);
    EXPECT_EQ(notes(report, "never_red"), trap + "; also violated with `at stable`\n");
    EXPECT_EQ(notes(report, "later"), "");
    EXPECT_EQ(notes(report, "settled"), "");
    const Report cured = report_of(lamps, "property one: exactly one of {green, red} at stable;");
    EXPECT_EQ(answer(cured, "one").verdict.outcome, Outcome::Holds);
}

TEST(Explain, UnstableChartIsExplainedByItsSituations) {
    const Report report = report_of(R"(grafcet c {
    input a;
    output green;
    initial step 0 { green; }
    step 1;
    step 2;
    transition t0: 0 -> 1 when a;
    transition t1: 1 -> 2 when a;
    transition t2: 2 -> 1 when a;
})",
                                    "");
    EXPECT_EQ(answer(report, "no_timelock").verdict.outcome, Outcome::Violated);
    EXPECT_EQ(notes(report, "no_timelock"),
              "with these inputs, `c` never becomes stable: its situation cycles 1 -> 2 -> 1, forever within one "
              "instant; make a transition of the cycle wait for an input change\n");
}

/// A belt that must arrive within 2 s, but cannot arrive while its motor runs.
constexpr const char* stuck_belts = R"(component belt(input GO; output AT) {
    clock t;
    initial location still;
    location moving invariant t <= 2s;
    urgent still -> moving when GO do t := 0;
    timed moving -> still when !GO && t >= 1s do AT := true;
}
grafcet c {
    input a, AT, BT;
    output M;
    initial step 0;
    step 1 { M; }
    step 2;
    transition t0: 0 -> 1 when a;
    transition t1: 1 -> 2 when AT && 1s/X1;
}
closed_loop requested {
    controller c;
    plant Belt = belt(GO = M, AT = AT);
    plant Other = belt(GO = M, AT = BT);
    environment A = push_button(OUT = a);
    property steps: reachable all steps;
    property time: no timelock;
})";

const std::string blocked_belts =
    "`Belt` blocks time: location `moving`, invariant `t <= 2s`, no edge enabled (to `still` when `!M && t >= 1s`); "
    "`Other` blocks time: location `moving`, invariant `t <= 2s`, no edge enabled (to `still` when `!M && t >= 1s`); "
    "add an edge that can leave the location when the invariant blocks time, or relax the invariant\n";

TEST(Explain, TimelockNamesEveryInstanceAndInvariantThatBlockTime) {
    ParseResult reading = read_string(stuck_belts, "c");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    const auto report = check(*reading.model, {0}, {}, {}, reading.diagnostics);
    ASSERT_TRUE(report) << reading.diagnostics_text();
    EXPECT_EQ(notes(*report, "time"), blocked_belts);
    EXPECT_NE(json_of(*report).find("invariant `t <= 2s`"), std::string::npos);
    // The input abstraction and the complete search report the same explanation.
    const auto whole = check(*reading.model, {0}, {}, {.whole = true}, reading.diagnostics);
    ASSERT_TRUE(whole);
    EXPECT_EQ(notes(*whole, "time"), blocked_belts);
}

TEST(Explain, TraceToATimelockContainsNoMovesThatCouldBeOmitted) {
    std::string text = stuck_belts;
    text.replace(text.find("input a,"), 8, "input b, a,");
    text.replace(text.find("environment A"), 0, "environment B = free(OUT = b); ");
    ParseResult reading = read_string(text, "c");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    const auto report = check(*reading.model, {0}, {}, {.whole = true}, reading.diagnostics);
    ASSERT_TRUE(report) << reading.diagnostics_text();
    EXPECT_EQ(notes(*report, "time"), blocked_belts);
    // The input `b` can always change, but no change of `b` ends the timelock.
    const ChartRun& run = answer(*report, "time").trace.value();
    EXPECT_FALSE(run.loop);
    for (const ChartRun::Row& row : run.rows) EXPECT_NE(row.component, "B");
    EXPECT_EQ(std::ranges::count(run.rows, std::string("A"), &ChartRun::Row::component), 1) << "A is pressed at 1 s";
}

TEST(Explain, TimelockInDiscreteTimeNamesTheBlockingInvariants) {
    ParseResult reading = read_string(stuck_belts, "c");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    ModelOptions how;
    how.untimed.plant = PlantApproach::Automata;
    how.untimed.time = TimeModel::Discrete;
    const auto report = check_untimed(*reading.model, Id<ClosedLoop>{0}, how, {}, reading.diagnostics);
    ASSERT_TRUE(report) << reading.diagnostics_text();
    EXPECT_EQ(answer(*report, "time").verdict.outcome, Outcome::Violated);
    const std::string found = notes(*report, "time");
    EXPECT_NE(found.find(blocked_belts), std::string::npos) << found;
}

TEST(Explain, InstancesThatNeverLetTimePassAreNamed) {
    ParseResult reading = read_string(R"(component flicker(input IN; output OUT) {
    initial location off;
    location on with OUT := true;
    urgent off -> on when IN do OUT := true;
    urgent on -> off when IN do OUT := false;
}
grafcet c { input a, b; output M; initial step 0; step 1 { M; } transition t0: 0 -> 1 when a;
            transition t1: 1 -> 0 when !a; }
closed_loop requested {
    controller c;
    environment A = push_button(OUT = a);
    plant Flicker = flicker(IN = M, OUT = b);
    property time: no timelock;
})",
                                      "c");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    const auto report = check(*reading.model, {0}, {}, {}, reading.diagnostics);
    ASSERT_TRUE(report) << reading.diagnostics_text();
    EXPECT_EQ(answer(*report, "time").verdict.outcome, Outcome::Violated);
    EXPECT_NE(notes(*report, "time").find("`Flicker` repeat forever within one instant"), std::string::npos)
        << notes(*report, "time");
}

TEST(Explain, UnreachableStepNamesTheTransitionAndTheTermThatIsNeverTrue) {
    const std::string chart = R"(grafcet c {
    input a;
    output green;
    initial step 0;
    step 1 { green; }
    step 2;
    step 3;
    step 4;
    step 5;
    transition t0: 0 -> 1 when a;
    transition t1: 1 -> 2 when a && X0;
    transition t2: 2 -> 3 when a;
    transition t3: 0, 1 -> 4 when a;
    transition t4: 1 -> 5 when a && green && !a;
    transition t5: 1 -> 0 when !a;
})";
    const std::string properties = "property all: reachable all steps; property r: reachable X3;";
    for (const Report& report :
         {report_of(chart, properties), report_of(chart, properties, Grain::Atomic),
          untimed_report_of(chart, properties), untimed_report_of(chart, properties, PlantApproach::Automata)}) {
        EXPECT_EQ(notes(report, "all.X1"), "");
        EXPECT_EQ(notes(report, "all.X2"), "`t1` is never cleared: `X0` is never true while `X1` is active\n");
        EXPECT_EQ(notes(report, "all.X3"), "`t2` is never enabled: `X2` is never active\n");
        EXPECT_EQ(notes(report, "r"), notes(report, "all.X3"));
        EXPECT_EQ(notes(report, "all.X4"), "`t3` is never enabled: `X0`, `X1` are never active together\n");
        EXPECT_EQ(notes(report, "all.X5"),
                  "`t4` is never cleared: `a`, `!a` are never true together while `X1` is active\n");
    }
}

TEST(Explain, PropertiesLeftOpenByAModelErrorNameItsPlaceInTheChart) {
    const Report report = report_of(R"(grafcet c {
    input a;
    output green;
    internal N: int 0..1 = 0;
    initial step 0 { green; }
    step 1 { N := N + 1 on activation; }
    transition t0: 0 -> 1 when a;
    transition t1: 1 -> 0 when !a;
})",
                                    "property small: always N < 4;");
    ASSERT_EQ(report.error_traces.size(), 1U);
    EXPECT_EQ(answer(report, "small").verdict.reason, "model error: " + report.error_traces[0].message);
    EXPECT_EQ(report.error_traces[0].message, "`N` would leave its range 0..1, in an evolution of `c`");
}

TEST(Explain, CausesOfAViolationAreMarkedWithTheShortestChange) {
    const Report report = report_of(lamps, "property dark: never red && X1;");
    const std::string text = text_of(report);
    const std::string end =
        " *      c                    t0       1          red\n"
        "    * causes: at 1 s: red, X1\n"
        "    without A (a) at 1 s the property holds along the run\n";
    EXPECT_NE(text.find(end), std::string::npos) << text;
    const ChartRun& run = answer(report, "dark").trace.value();
    EXPECT_EQ(verify(run), std::vector<std::string>{});
    ASSERT_EQ(run.causes.size(), 2U);
    EXPECT_EQ(run.causes[0].first, run.moments.size() - 1);
    ASSERT_EQ(run.left_out.size(), 1U);
    EXPECT_EQ(run.instances[run.moments[run.left_out[0]].instance].name, "A");
    const std::string json = json_of(report);
    EXPECT_NE(json.find(R"("words": "red")"), std::string::npos) << json;
    EXPECT_NE(json.find(R"("left_out": [)"), std::string::npos) << json;
}

TEST(Explain, MissingResponseIsACauseFromItsPremiseOn) {
    const Report report = report_of(lamps, "property comes: X0 && green leads to red;");
    const std::string text = text_of(report);
    EXPECT_NE(text.find("* causes: at 0 s: X0, green; from 0 s on: !red\n"), std::string::npos) << text;
}

TEST(Explain, DeadTransitionsAfterThePointOfNoReturnAreNamed) {
    const char* trap = R"(grafcet c {
    input a;
    output green;
    internal armed: bool = false;
    initial step 0 { green; }
    step 1;
    step 2 { armed := true on activation; }
    step 3;
    transition go: 0 -> 1 when a;
    transition back: 1 -> 0 when !a && !armed;
    transition on: 1 -> 2 when !a && armed;
    transition trap: 0 -> 3 when 3s/X0;
    transition wait: 3 -> 3 when a && armed;
})";
    const Report report =
        report_of(trap, "property again: always possible X1; property other: always possible X0 || X3;");
    EXPECT_EQ(answer(report, "again").verdict.outcome, Outcome::Violated);
    // `trap` is about to be cleared at the end of the run, and step 0 is still active.
    EXPECT_EQ(notes(report, "again"),
              "after this trace, these transitions are never cleared again: go, back (X1 stays false), on (X1 stays "
              "false), wait (armed stays false)\n");
    EXPECT_EQ(notes(report, "other").find("never cleared"), std::string::npos);
    const std::string atomic = notes(report_of(trap, "property again: always possible X1;", Grain::Atomic), "again");
    EXPECT_EQ(atomic,
              "after this trace, these transitions are never cleared again: go (X0 stays false), back (X1 stays "
              "false), on (X1 stays false), trap (X0 stays false), wait (armed stays false)\n");
    const std::string untimed = notes(untimed_report_of(trap, "property again: always possible X1;"), "again");
    EXPECT_EQ(untimed,
              "after the last state of the trace, the condition can never become true\n"
              "after this trace, these transitions are never cleared again: go, back (X1 stays false), on (X1 stays "
              "false), wait (armed stays false)\n");
}

TEST(Explain, FreeInputChangesOfTheShortestChangeAreNamedOneByOne) {
    const char* chart = R"(grafcet c {
    input a, b;
    output green, red;
    initial step 0 { green; }
    step 1 { red; }
    step 2;
    transition t0: 0 -> 1 when a && b;
    transition t1: 1 -> 0 when !a;
    transition t2: 1 -> 2 when 3s/X1;
})";
    const Report report = untimed_report_of(
        chart, "environment B = free(OUT = b); property dark: never red && X1; property short: never X2;");
    const std::string text = text_of(report);
    EXPECT_NE(text.find("* causes: at 2: red, X1\n"), std::string::npos) << text;
    const ChartRun& run = answer(report, "dark").trace.value();
    EXPECT_EQ(verify(run), std::vector<std::string>{});
    ASSERT_EQ(run.counterfactual_values.size(), 1U);
    EXPECT_EQ(run.counterfactual_values[0].moment, 0U);
    EXPECT_NE(
        text.find(
            "    without b at 0 the property holds along the run, and after its end as long as nothing changes\n"),
        std::string::npos)
        << text;
    EXPECT_NE(json_of(report).find(R"("left_out_values": [)"), std::string::npos);
    // The omitted change is the expiry of a timer.
    const ChartRun& late = answer(report, "short").trace.value();
    ASSERT_EQ(late.counterfactual_values.size(), 1U);
    EXPECT_TRUE(late.counterfactual_values[0].timer.valid());
    EXPECT_NE(text.find("    without 3s/X1 at 1 the property holds"), std::string::npos) << text;
}

TEST(Explain, ShortestChangeKeepsTheOrderOfTimersOfOneStep) {
    const Report report = untimed_report_of(R"(grafcet c {
    input a;
    output red;
    initial step 0;
    step 1 { red if 5s/X1 && 3s/X1; }
    transition t0: 0 -> 1 when a;
    transition t1: 1 -> 0 when !a;
})",
                                            "property dark: never red;");
    const ChartRun& run = answer(report, "dark").trace.value();
    ASSERT_EQ(run.counterfactual_values.size(), 1U);
    const ChartRun::Counterfactual& left_out = run.counterfactual_values[0];
    EXPECT_TRUE(!left_out.timer.valid() || run.timers[left_out.timer].rise_ms == 5000) << text_of(report);
}

TEST(Explain, TimerExpiryIsACauseInTheNotationOfConditions) {
    const char* chart = R"(grafcet c {
    input a;
    output green, red;
    initial step 0 { green; }
    step 1 { red; }
    transition t0: 0 -> 1 when a;
    transition t1: 1 -> 0 when 3s/X1 && 2s/(a || X0);
})";
    const char* properties =
        "property short: never 3s/X1; property lit: always green || 3s/X1; property longer: never 2s/(a || X0) && X1;";
    const Report timed = report_of(chart, properties);
    EXPECT_NE(json_of(timed).find(R"("words": "!3s/X1")"), std::string::npos);
    for (const Report& report :
         {timed, untimed_report_of(chart, properties), untimed_report_of(chart, properties, PlantApproach::Automata)}) {
        const ChartRun& run = answer(report, "short").trace.value();
        EXPECT_EQ(verify(run), std::vector<std::string>{});
        EXPECT_TRUE(run.causes_exact);
        ASSERT_EQ(run.causes.size(), 2U);
        const auto time = std::ranges::find_if(run.causes, [](const auto& cause) { return cause.timer.valid(); });
        ASSERT_NE(time, run.causes.end());
        EXPECT_EQ(time->value, 1);
        EXPECT_EQ(run.timers[time->timer].rise_ms, 3000);
        EXPECT_NE(text_of(report).find("3s/X1"), std::string::npos);
        EXPECT_NE(json_of(report).find(R"("words": "3s/X1")"), std::string::npos);
        // The time condition on `a || X0` has no name, so the causes are not exact.
        EXPECT_FALSE(answer(report, "longer").trace.value().causes_exact);
    }
}

TEST(Explain, FreeMovesOfInterleavedPlantAutomataAreThoseOfTheLoop) {
    const Report report = untimed_report_of(lamps, "property dark: never red && X1; property comes: X0 leads to red;",
                                            PlantApproach::Automata);
    const std::string text = text_of(report);
    const ChartRun& run = answer(report, "dark").trace.value();
    EXPECT_EQ(verify(run), std::vector<std::string>{});
    EXPECT_EQ(run.causes.size(), 2U);
    ASSERT_EQ(run.left_out.size(), 1U);
    EXPECT_EQ(run.instances[run.moments[run.left_out[0]].instance].name, "A");
    EXPECT_NE(text.find("the property holds along the run\n"), std::string::npos) << text;
    const ChartRun& never = answer(report, "comes").trace.value();
    ASSERT_FALSE(never.causes.empty());
    EXPECT_EQ(never.causes.back().last, never.moments.size() - 1);
    EXPECT_TRUE(never.left_out.empty());
}

TEST(Explain, ChangeWithoutWhichAChartBecomesStableIsNamed) {
    ParseResult reading = read_string(R"(grafcet c {
    input a, b;
    initial step 0;
    step 1;
    transition t0: 0 -> 1 when a;
    transition t1: 1 -> 0 when a && b;
})",
                                      "c");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    CheckOptions options;
    options.properties = {"stabilises"};
    const auto report = check_untimed(*reading.model, Id<Chart>{0}, {}, options, reading.diagnostics);
    ASSERT_TRUE(report) << reading.diagnostics_text();
    const ChartRun& run = report->answers.at(0).trace.value();
    EXPECT_EQ(verify(run), std::vector<std::string>{});
    EXPECT_EQ(run.counterfactual_values.size(), 1U);
    EXPECT_NE(text_of(*report).find("the property holds along the run\n"), std::string::npos) << text_of(*report);
}

/// Returns the elements that the property needs.
std::string needing(const ProofExplanation& why, const std::string& property) {
    std::string text;
    for (const ProofExplanation::ModelElement& element : why.things)
        if (std::ranges::find(element.needed_by, property) != element.needed_by.end())
            text += fmt::format("{} {}{}; ", word(element.kind), element.name,
                                element.of.empty() ? "" : " of " + element.of);
    return text;
}

TEST(Explain, ProofWithoutAssumptionsHasAnEmptyCore) {
    ParseResult reading =
        read_string(std::string(lamps) +
                        " closed_loop requested { controller c; environment A = push_button(OUT = a);"
                        "property apart: never X0 && X1; property idle: always X0 && X1 => red && green;"
                        "property on: reachable red; }",
                    "c");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    const auto report = check(*reading.model, {0}, {}, {}, reading.diagnostics);
    const ProofExplanation why = why_it_holds(*reading.model, {0}, {}, {}, report.value());
    ASSERT_EQ(why.grounds.size(), 3U);
    EXPECT_EQ(why.grounds[0], (ProofExplanation::ProofCore{.property = "apart", .about_states = true}));
    EXPECT_EQ(why.grounds[1], (ProofExplanation::ProofCore{.property = "idle", .about_states = true, .vacuous = true}));
    EXPECT_EQ(why.grounds[2], (ProofExplanation::ProofCore{.property = "on"}));
    EXPECT_EQ(why.unneeded_parts, std::vector<std::string>{"A"});
    EXPECT_EQ(why.ended, "");
    EXPECT_EQ(needing(why, "apart"), "");
    EXPECT_EQ(needing(why, "on"), "transition t0; step 1; term a of t0; term !a of t1; edge idle -> idle of A; ");
    EXPECT_TRUE(std::ranges::all_of(
        why.things, [](const ProofExplanation::ModelElement& element) { return element.open.empty(); }));
}

/// Returns the explanations for a chart with a button and a lift, whose door is monitored.
ProofExplanation why_of_lift(const std::string& chart, const std::string& properties, ParseResult& reading) {
    reading = read_string(chart + R"(
component lift(input UP; output TOP; TRAVEL = 2s) {
    clock t;
    initial location down;
    location rising invariant t <= TRAVEL;
    location up;
    urgent down -> rising when UP do t := 0;
    timed rising -> up when t == TRAVEL do TOP := true;
    urgent up -> down when !UP do TOP := false;
}
closed_loop requested { controller c; environment A = push_button(OUT = a); plant Lift = lift(UP = up, TOP = top); )" +
                              properties + " }",
                          "c");
    EXPECT_TRUE(reading.model) << reading.diagnostics_text();
    if (!reading.model) return {};
    const auto report = check(*reading.model, {0}, {}, {}, reading.diagnostics);
    return why_it_holds(*reading.model, {0}, {}, {}, report.value());
}

constexpr const char* lifted = R"(grafcet c {
    input a, top;
    output up, bell;
    internal called, rung;
    initial step 0;
    step 1 { up; called := true on activation; }
    step 2 { bell if top || top && called; rung := true on event rise(a) && top; called := false on deactivation; }
    transition t0: 0 -> 1 when a && !top;
    transition t1: 1 -> 2 when top;
    transition t2: 2 -> 0 when !a && !top;
})";

TEST(Explain, UncoveredStepsTermsGuardsAndEdgesAreListed) {
    ParseResult reading;
    const ProofExplanation why = why_of_lift(lifted,
                                             "property served: reachable X2; property calls: reachable called;"
                                             "property calm: never Lift.rising && X0 at stable;",
                                             reading);
    ASSERT_EQ(why.grounds.size(), 4U);
    std::string all;
    for (const ProofExplanation::ModelElement& element : why.things)
        all +=
            fmt::format("{} {} {}{}; ", word(element.kind), element.name, element.nth > 1 ? "again " : "", element.of);
    EXPECT_EQ(all,
              "transition t0 ; transition t1 ; transition t2 ; step 1 ; step 2 ; "
              "term a t0; term !top t0; term top t1; term !a t2; term !top t2; "
              "term top bell in step 2; term top && called bell in step 2; term top again bell in step 2; "
              "term called bell in step 2; term top rung in step 2; "
              "guard down -> rising Lift; guard up -> down Lift; "
              "edge idle -> idle A; edge down -> rising Lift; edge rising -> up Lift; edge up -> down Lift; ");
    EXPECT_EQ(needing(why, "served"),
              "transition t0; transition t1; step 1; edge idle -> idle of A; edge down -> rising of Lift; "
              "edge rising -> up of Lift; ");
    EXPECT_EQ(needing(why, "calls"), "transition t0; step 1; edge idle -> idle of A; ");
    EXPECT_EQ(needing(why, "calm"), "guard down -> rising of Lift; guard up -> down of Lift; ");
}

TEST(Explain, AblationOfOneInstanceKeepsTheRangesOfOthers) {
    ParseResult reading = read_string(std::string(lamps) + R"(
component level(output X: int 0..MOST; MOST) {
    clock t;
    initial location here;
    timed here -> here when X < 3 && t >= 1s do X := X + 1, t := 0;
}
closed_loop requested {
    controller c; environment A = push_button(OUT = a);
    plant Low = level(X = low, MOST = 2); plant High = level(X = high, MOST = 4);
    property full: reachable low == 3; property filled: never low == 4;
})",
                                      "c");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    const auto report = check(*reading.model, {0}, {}, {}, reading.diagnostics);
    const ProofExplanation why = why_it_holds(*reading.model, {0}, {}, {}, report.value());
    ASSERT_EQ(why.grounds.size(), 2U);
    // Without the edge `here -> here`, the chart never becomes stable.
    EXPECT_EQ(needing(why, "full"), "term a of t0; edge here -> here of Low; ");
    EXPECT_EQ(needing(why, "filled"), "guard here -> here of Low; ");
}

TEST(Explain, VariantsOfALargeLoopAreDecidedByAbstractions) {
    ParseResult reading = read_string(R"(grafcet panel {
    input A, B, C, D, E;
    output OUT;
    initial step 0;
    step 1 { OUT; }
    transition t0: 0 -> 1 when A && (B || C);
    transition t1: 1 -> 0 when D && !E;
}
closed_loop large {
    controller panel;
    environment Pa = push_button(OUT = A, GAP = 7s); environment Pb = push_button(OUT = B, GAP = 11s);
    environment Pc = push_button(OUT = C, GAP = 13s); environment Pd = push_button(OUT = D, GAP = 17s);
    environment Pe = push_button(OUT = E, GAP = 19s);
    property first: never OUT before A;
})",
                                      "c");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    CheckOptions options;
    options.properties = {"first"};
    const auto report = check(*reading.model, {0}, {}, options, reading.diagnostics);
    const ProofExplanation why = why_it_holds(*reading.model, {0}, {}, options, report.value());
    ASSERT_EQ(why.grounds.size(), 1U);
    EXPECT_EQ(needing(why, "first"), "term A of t0; ");
    for (const ProofExplanation::ModelElement& element : why.things)
        EXPECT_TRUE(element.open.empty()) << word(element.kind) << ' ' << element.name;
}

TEST(Explain, UntriedElementsAreOmittedAtTheTimeLimit) {
    ParseResult reading = read_string(std::string(lamps) +
                                          " closed_loop requested { controller c; environment A = push_button(OUT = a);"
                                          "property apart: never X0 && X1; }",
                                      "c");
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    const auto report = check(*reading.model, {0}, {}, {}, reading.diagnostics);
    CheckOptions options;
    options.limits.deadline = std::chrono::steady_clock::now();
    const ProofExplanation why = why_it_holds(*reading.model, {0}, {}, options, report.value());
    ASSERT_EQ(why.grounds.size(), 1U);
    EXPECT_EQ(why.grounds[0].open, (std::vector<std::string>{"A"}));
    EXPECT_FALSE(why.things.empty());
    for (const ProofExplanation::ModelElement& element : why.things) {
        // The removal of an edge that is not forced adds no behaviour, so that no search is needed.
        if (element.kind == ProofExplanation::Kind::Edge)
            EXPECT_EQ(element.open, std::vector<std::string>{}) << element.name;
        else EXPECT_EQ(element.open, std::vector<std::string>{"apart"}) << element.name;
    }
    EXPECT_TRUE(why.unneeded_parts.empty());
    EXPECT_EQ(why.searches, 0U);
    EXPECT_EQ(why.ended, "time limit reached");
}

}  // namespace
}  // namespace grafverif
