// SPDX-License-Identifier: MIT
#include "analyse/analyse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <tuple>

#include "grafverif/grafverif.hpp"
#include "report/findings.hpp"
#include "support/play.hpp"

namespace grafverif {
namespace {

Analysis analysed(std::string_view text, AnalyseOptions options = {}) {
    const Chart subject = chart(text);
    const Equations meaning = equations(text);
    Analysis result = analyse(subject, meaning, options);
    EXPECT_EQ(verify(result), std::vector<std::string>{}) << text;
    EXPECT_EQ(result.failures, std::vector<std::string>{}) << text;
    EXPECT_EQ(result.obstacle, "") << text;
    return result;
}

const Finding* find(const Analysis& analysis, std::string_view code, std::string_view subject = {}) {
    const auto found = std::ranges::find_if(analysis.findings, [&](const Finding& finding) {
        return finding.code == code && (subject.empty() || finding.subject == subject);
    });
    return found == analysis.findings.end() ? nullptr : &*found;
}

std::vector<std::string> codes(const Analysis& analysis) {
    std::vector<std::string> all;
    for (const Finding& finding : analysis.findings)
        all.push_back(finding.code + (finding.subject.empty() ? "" : " " + finding.subject));
    return all;
}

using Codes = std::vector<std::string>;

constexpr std::string_view sound = R"(
    input a, b;
    output O, P;
    initial step 0 { O; }
    step 1 { P; }
    transition t0: 0 -> 1 when a && !b;
    transition t1: 1 -> 0 when b;
)";

/// Returns the transitions cleared in the last row, evolution by evolution.
std::vector<std::vector<std::string>> cleared(const ChartRun& run) {
    std::vector<std::vector<std::string>> names;
    for (const std::vector<Id<ChartRun::Transition>>& evolution : run.rows.back().fired) {
        names.emplace_back();
        for (const Id<ChartRun::Transition> id : evolution) names.back().push_back(run.transitions[id].name);
    }
    return names;
}

TEST(Analyse, AChartWithoutFaultsHasNoFindings) {
    EXPECT_EQ(codes(analysed(sound)), Codes{});
    EXPECT_EQ(codes(analysed(sound, {.mode = ExecutionMode::EveryCycle})), Codes{});
}

TEST(Analyse, UnreachableStepIsNeverActiveAndItsTransitionsAreNeverCleared) {
    const Analysis found = analysed(R"(
        input a, b; output O, P;
        initial step 0;
        step 1 { O; }
        step 2 { P; }
        transition t0: 0 -> 1 when a;
        transition t1: 1 -> 2 when a && !a;
        transition t2: 2 -> 0 when b;
        transition t3: 1 -> 0 when b;
        transition t4: 1 -> 0 when a && X0;
    )");
    ASSERT_NE(find(found, "step-never-active", "X2"), nullptr);
    ASSERT_NE(find(found, "output-never-set", "P"), nullptr);
    const Finding* const condition = find(found, "transition-never-fired", "t1");
    ASSERT_NE(condition, nullptr);
    EXPECT_EQ(condition->message, "`t1` is never cleared; its condition is never true while it is enabled");
    const Finding* const part = find(found, "transition-never-fired", "t4");
    ASSERT_NE(part, nullptr);
    EXPECT_EQ(part->message,
              "`t4` is never cleared; its condition is never true while it is enabled, since `X0` is false");
    ASSERT_TRUE(condition->evidence.has_value()) << "the evidence is a run to a situation in which t1 is enabled";
    const Finding* const upstream = find(found, "transition-never-fired", "t2");
    ASSERT_NE(upstream, nullptr);
    EXPECT_EQ(upstream->message, "`t2` is never cleared; `X2` is never active");
}

TEST(Analyse, DistinguishesTransitionsWhoseStepsAreNeverActiveTogether) {
    const Analysis found = analysed(R"(
        input a;
        initial step 0;
        step 1;
        step 2;
        transition t0: 0 -> 1 when a;
        transition t1: 1 -> 0 when !a;
        transition t2: 0 -> 2 when a;
        transition t3: 2 -> 0 when !a;
        transition t4: 0, 1 -> 2 when a;
    )");
    const Finding* const never = find(found, "transition-never-fired", "t4");
    ASSERT_NE(never, nullptr);
    EXPECT_EQ(never->message, "`t4` is never cleared; `X0` and `X1` are never active together");
}

TEST(Analyse, BranchesThatFireTogetherAreShownByTheInputsThatDoIt) {
    const Analysis found = analysed(R"(
        input a, b;
        initial step 0;
        step 1;
        step 2;
        transition t0: 0 -> 1 when a;
        transition t1: 0 -> 2 when b;
        transition t2: 1 -> 0 when !a && !b;
        transition t3: 2 -> 0 when !a && !b;
    )");
    const Finding* const both = find(found, "branches-together", "t0");
    ASSERT_NE(both, nullptr);
    ASSERT_TRUE(both->evidence.has_value());
    EXPECT_EQ(inputs_text(*both->evidence), "a, b at 0 s");
    EXPECT_EQ(cleared(*both->evidence), (std::vector<std::vector<std::string>>{{"t0", "t1"}}));
}

TEST(Analyse, ConstraintsAndExclusionsRemoveImpossibleFindings) {
    const std::string body = R"(
        initial step 0;
        step 1;
        step 2;
        transition t0: 0 -> 1 when a;
        transition t1: 0 -> 2 when b;
        transition t2: 1 -> 0 when !a && !b;
        transition t3: 2 -> 0 when !a && !b;
    )";
    EXPECT_EQ(codes(analysed("input a, b; constraint !(a && b);" + body)), Codes{});
    AnalyseOptions options;
    options.exclusions = {{{0}, {1}, "one switch, two positions", {}}};
    EXPECT_EQ(codes(analysed("input a, b;" + body, options)), Codes{});
    EXPECT_EQ(codes(analysed("input a, b; constraint a; constraint !a;" + body)), Codes{"contradictory-constraints"});
}

TEST(Analyse, ARaceNamesBothActions) {
    const Analysis found = analysed(R"(
        input a; output O;
        initial step 0 { O := true on deactivation; }
        step 1 { O := false on activation; }
        transition t0: 0 -> 1 when a;
        transition t1: 1 -> 0 when !a;
    )");
    const Finding* const race = find(found, "action-race", "O");
    ASSERT_NE(race, nullptr);
    EXPECT_EQ(race->related.size(), 2U);
    ASSERT_TRUE(race->evidence.has_value());
    EXPECT_EQ(race->evidence->rows.back().what, "race");
}

TEST(Analyse, ARaceInTheFirstEvolutionIsFoundThere) {
    const Analysis found = analysed(R"(
        input a, b; internal n : int 0..3;
        initial step 0 { n := 1 on activation; }
        initial step 1 { n := 2 on activation; }
        transition t0: 0 -> 0 when a;
        transition t1: 1 -> 1 when b;
    )");
    ASSERT_NE(find(found, "action-race", "n"), nullptr);
}

TEST(Analyse, CounterThatLeavesItsRangeIsFoundAfterManyRounds) {
    const Analysis found = analysed(R"(
        input a; internal n : int -1..2 = 0;
        initial step 0;
        step 1 { n := n + 1 on activation; }
        transition t0: 0 -> 1 when a;
        transition t1: 1 -> 0 when !a;
        transition t2: 0 -> 0 when n == 7;
    )");
    const Finding* const range = find(found, "out-of-range", "n");
    ASSERT_NE(range, nullptr);
    ASSERT_TRUE(range->evidence.has_value());
    EXPECT_EQ(range->evidence->rows.size(), 1U + 5U) << "power-on and five evolutions: up, down, up, down, up";
    ASSERT_NE(find(found, "transition-never-fired", "t2"), nullptr);
}

TEST(Analyse, ADivisionByACounterThatReachesZeroIsFound) {
    const Analysis found = analysed(R"(
        input a; internal n : int 0..2 = 1;
        initial step 0;
        step 1 { n := n - 1 on activation; }
        step 2;
        transition t0: 0 -> 1 when a;
        transition t1: 1 -> 2 when 2 / n == 1;
    )");
    const Finding* const none = find(found, "no-value");
    ASSERT_NE(none, nullptr);
    ASSERT_TRUE(none->evidence.has_value());
    EXPECT_EQ(none->evidence->rows.size(), 2U) << "power-on with `a` true; then `n` is 0";
}

constexpr std::string_view two_orders = R"(
    input a, b;
    partial A { initial step 0; step 1 { force P := {}; } transition a0: 0 -> 1 when a; transition a1: 1 -> 0 when !a; }
    partial B { initial step 10; step 11 { force P := {INIT}; } transition b0: 10 -> 11 when b; transition b1: 11 -> 10 when !b; }
    partial P { initial step 20; step 21; transition p0: 20 -> 21 when !a; transition p1: 21 -> 20 when a; }
)";

TEST(Analyse, TwoOrdersThatExcludeEachOtherAreShownTogether) {
    const Analysis found = analysed(two_orders);
    const Finding* const twice = find(found, "forced-twice");
    ASSERT_NE(twice, nullptr);
    ASSERT_TRUE(twice->evidence.has_value());
    EXPECT_EQ(twice->evidence->rows.back().what, "contradictory forcing orders");
    EXPECT_EQ(found.notes.size(), 2U) << "the findings about dead elements apply only until these errors";
    const std::string exclusive = std::string(two_orders) + "constraint !(a && b);";
    EXPECT_EQ(find(analysed(exclusive), "forced-twice"), nullptr);
}

TEST(Analyse, OrdersInCopiesNameTheirOwnPartialChart) {
    const Analysis found = analysed(R"(
        for i in 1..2 {
            input a[i], b[i];
            partial A[i] { initial step 0; step 1 { force P[i] := {}; } transition 0 -> 1 when a[i]; transition 1 -> 0 when !a[i]; }
            partial B[i] { initial step 0; step 1 { force P[i] := {INIT}; } transition 0 -> 1 when b[i]; transition 1 -> 0 when !b[i]; }
            partial P[i] { initial step 0; step 1; transition 0 -> 1 when !a[i]; transition 1 -> 0 when a[i]; }
        }
    )");
    std::vector<std::string> subjects;
    for (const Finding& each : found.findings)
        if (each.code == "forced-twice") subjects.push_back(each.subject);
    EXPECT_EQ(subjects, (std::vector<std::string>{"P[1]", "P[2]"}));
}

TEST(Analyse, DoesNotReportARaceInAnEvolutionWithConflictingOrders) {
    const Analysis found = analysed(R"(
        internal count: int 0..5 = 3;
        initial step 0 { force G1 := {INIT}; }
        enclosing step 1 encloses G1 { force G1 := {}; }
        transition t0: 0 -> 1 when !X1;
        transition t2: 0 -> 0 when count != 0;
        partial G1 { initial enclosing step 2 encloses G2 { count := 3 on activation; } }
        partial G2 { linked step 20 { count := 1 on activation; } }
    )");
    EXPECT_NE(find(found, "forced-twice"), nullptr);
    EXPECT_EQ(find(found, "action-race"), nullptr);
}

TEST(Analyse, AChartThatIsForcedWhileItsEnclosingStepGovernsItIsFound) {
    const std::string_view body = R"(
        partial A { initial step 0; enclosing step 1 encloses P; transition a0: 0 -> 1 when a; transition a1: 1 -> 0 when !a; }
        partial B { initial step 10; step 11 { force P := {21}; } transition b0: 10 -> 11 when b; transition b1: 11 -> 10 when !b; }
        partial P { linked step 20; step 21; transition p0: 20 -> 21 when a && b; transition p1: 21 -> 20 when !a; }
    )";
    const Analysis found = analysed("input a, b;" + std::string(body));
    const Finding* const both = find(found, "forced-and-enclosed");
    ASSERT_NE(both, nullptr);
    EXPECT_EQ(both->related.size(), 1U) << "the related element is the enclosing step";
    ASSERT_TRUE(both->evidence.has_value());
    EXPECT_EQ(both->evidence->rows.size(), 2U);
    EXPECT_EQ(find(analysed("input a, b; constraint !(a && b);" + std::string(body)), "forced-and-enclosed"), nullptr);
}

TEST(Analyse, EvidenceIncludesAFirstEvolutionThatClearsNothing) {
    const Analysis found = analysed(
        "input a; initial step 0; step 1; transition t0: 0 -> 1 when a; transition t1: 1 -> 0 "
        "when a;");
    const Finding* const endless = find(found, "total-instability");
    ASSERT_TRUE(endless != nullptr && endless->evidence.has_value());
    const ChartRun& run = *endless->evidence;
    ASSERT_EQ(run.rows.size(), 4U);
    EXPECT_EQ(run.rows[1].what, "first evolution") << "`t0` is enabled and `a` is true, but `t0` is not cleared yet";
    EXPECT_EQ(run.loop_from, 2U);
}

TEST(Analyse, TotalInstabilityEndsInALoopOfSituations) {
    const Analysis found = analysed(R"(
        input a, b;
        initial step 0;
        step 1;
        step 2;
        transition t0: 0 -> 1 when b;
        transition t1: 1 -> 2 when a;
        transition t2: 2 -> 1 when true;
        transition t3: 2 -> 0 when !b;
    )");
    const Finding* const endless = find(found, "total-instability");
    ASSERT_NE(endless, nullptr);
    ASSERT_TRUE(endless->evidence.has_value());
    const ChartRun& run = *endless->evidence;
    ASSERT_TRUE(run.loop_from.has_value());
    EXPECT_EQ(run.rows.size() - *run.loop_from, 2U);
    EXPECT_EQ(verify(run), std::vector<std::string>{});
    EXPECT_EQ(endless->related.size(), 2U) << "t1 and t2, the transitions of the nearest loop";
    EXPECT_EQ(find(analysed(sound), "total-instability"), nullptr);
}

TEST(Analyse, ASourceTransitionOnALevelThatOnlyActivatesAnActiveStepIsUnstable) {
    const Analysis found = analysed(R"(
        input a, b;
        initial step 0;
        transition t0: -> 0 when a;
        transition t1: 0 -> when b;
    )");
    ASSERT_NE(find(found, "total-instability"), nullptr);
    ASSERT_NE(find(found, "step-reactivated", "X0"), nullptr);
}

TEST(Analyse, TransientStepWritesNoOutputUnderStabilitySearchOnly) {
    constexpr std::string_view text = R"(
        input a; output O;
        initial step 0;
        step 1 { O; }
        step 2;
        transition t0: 0 -> 1 when a;
        transition t1: 1 -> 2 when true;
        transition t2: 2 -> 0 when !a;
    )";
    const Analysis searching = analysed(text);
    EXPECT_NE(find(searching, "step-never-stable", "X1"), nullptr);
    EXPECT_NE(find(searching, "output-never-set", "O"), nullptr);
    EXPECT_NE(find(searching, "transition-always-fired", "t1"), nullptr);
    const Analysis cyclic = analysed(text, {.mode = ExecutionMode::EveryCycle});
    EXPECT_EQ(codes(cyclic), Codes{"transition-always-fired t1"});
}

TEST(Analyse, OutputSetAndResetInOneInstantIsNeverWritten) {
    const Analysis found = analysed(R"(
        input a; output O;
        initial step 0;
        step 1 { O := true on activation; }
        step 2;
        step 3 { O := false on activation; }
        transition t0: 0 -> 1 when a;
        transition t1: 1 -> 2 when true;
        transition t2: 2 -> 3 when a;
        transition t3: 3 -> 0 when !a;
    )");
    const Finding* const conflict = find(found, "action-conflict", "O");
    ASSERT_NE(conflict, nullptr);
    EXPECT_EQ(conflict->message,
              "`O` can be set and reset in one instant, so the plant never receives the first value");
    ASSERT_TRUE(conflict->evidence.has_value());
    EXPECT_EQ(cleared(*conflict->evidence), (std::vector<std::vector<std::string>>{{"t0"}, {"t1"}, {"t2"}}));
    EXPECT_EQ(find(found, "action-race"), nullptr);
}

TEST(Analyse, AnInputThatNothingReadsIsANote) {
    const Analysis found = analysed(
        "input a, b; initial step 0; step 1; transition t0: 0 -> 1 when a; "
        "transition t1: 1 -> 0 when !a;");
    EXPECT_EQ(codes(found), Codes{"input-never-read b"});
    EXPECT_FALSE(is_open(found.findings.front()));
}

TEST(Analyse, AnAcceptedFindingIsNotOpen) {
    const Analysis found = analysed(
        "input a, b; accept branches-together t0 \"never pressed together\"; "
        "accept total-instability \"none\"; initial step 0; step 1; step 2; "
        "transition t0: 0 -> 1 when a; transition t1: 0 -> 2 when b; "
        "transition t2: 1 -> 0 when !a && !b; transition t3: 2 -> 0 when !a && !b;");
    const Finding* const both = find(found, "branches-together", "t0");
    ASSERT_NE(both, nullptr);
    EXPECT_EQ(both->accepted, "never pressed together");
    EXPECT_FALSE(is_open(*both));
    EXPECT_TRUE(std::ranges::any_of(
        found.notes, [](const std::string& note) { return note == "no finding matches `accept total-instability`"; }));
}

// If `H` is an instance of a chart, a declaration `accept` without subject in this chart gets the subject `H.`.
TEST(Analyse, AnAcceptanceOfAnInstanceConcernsOnlyTheInstance) {
    const std::string_view text =
        "input a; partial H { initial step 0; step 1; transition 0 -> 1 when a && !a; transition 1 -> 0 when a; }"
        "partial K { initial step 0; step 1; transition 0 -> 1 when a && !a; transition 1 -> 0 when a; }";
    Chart subject = chart(text);
    subject.accepted = {
        {"transition-never-fired", "H.", "spare"}, {"step-never-active", "H.", "spare"}, {"action-race", "H.", "none"}};
    const Analysis found = analyse(subject, equations(text), {});
    for (const auto& [code, mine, other] :
         {std::tuple("transition-never-fired", "t1", "t3"), std::tuple("step-never-active", "H.X1", "K.X1")}) {
        const Finding* const of_instance = find(found, code, mine);
        const Finding* const elsewhere = find(found, code, other);
        ASSERT_TRUE(of_instance != nullptr && elsewhere != nullptr) << code;
        EXPECT_EQ(of_instance->accepted, "spare");
        EXPECT_EQ(elsewhere->accepted, std::nullopt);
    }
    EXPECT_TRUE(std::ranges::any_of(
        found.notes, [](const std::string& note) { return note == "no finding matches `accept action-race` in `H`"; }));
}

// -- time -------------------------------------------------------------------------------------------------------------

TEST(Analyse, TimedEvidenceHasTimes) {
    const Analysis found = analysed(R"(
        input a, b; output O;
        initial step 0 { O := true on activation; }
        step 1 { O := false on deactivation; }
        transition t0: 0 -> 1 when a;
        transition t1: 1 -> 0 when 5s/X1;
    )");
    const Finding* const race = find(found, "action-race", "O");
    ASSERT_NE(race, nullptr);
    EXPECT_EQ(race->timing, Finding::Timing::Confirmed);
    ASSERT_TRUE(race->evidence.has_value());
    EXPECT_EQ(race->evidence->moments.back().after.time_ms, 5000);
}

TEST(Analyse, TheLongerOfTwoTimersOnOneStepNeverEndsFirst) {
    const Analysis found = analysed(R"(
        initial step 0;
        step 1;
        transition t0: 0 -> 1 when 2s/X0;
        transition t1: 0 -> 0 when 5s/X0 && !(2s/X0);
        transition t2: 1 -> 0 when 1s/X1;
    )");
    EXPECT_NE(find(found, "transition-never-fired", "t1"), nullptr);
    EXPECT_EQ(find(found, "branches-together"), nullptr);
}

TEST(Analyse, EventsExcludedOnlyByTimesAreReportedAsUnconfirmed) {
    // Both steps become active at the same time; the 3 s timer expires before the 5 s timer.
    const Analysis found = analysed(R"(
        initial step 0;
        initial step 1;
        step 2;
        transition t0: 0 -> 0 when 3s/X0 && false;
        transition t1: 0 -> 2 when 3s/X0;
        transition t2: 0, 1 -> 2 when 5s/X1 && !(3s/X0);
        transition t3: 2 -> when 1s/X2 && false;
    )");
    const Finding* const early = find(found, "transition-never-fired", "t2");
    EXPECT_EQ(early, nullptr) << "the search considers the order of timers only for one step";
}

TEST(Analyse, TimerOfAnInputRunsIfItRisesWithoutOtherEvents) {
    const Analysis found = analysed(R"(
        input a, b; output o;
        initial step 0;
        step 1 { o; }
        step 2;
        transition t0: 0 -> 1 when !a;
        transition t1: 1 -> 2 when 3s/a;
        transition t2: 2 -> 0 when b;
    )");
    EXPECT_EQ(find(found, "step-never-active", "X2"), nullptr) << "a can be true for 3 s while step 1 is active";
    EXPECT_EQ(find(found, "transition-never-fired", "t1"), nullptr);
}

// -- parts, and counters ----------------------------------------------------------------------------------------------

/// Two partial charts that a supervisor forces. Each has a counter that is never reset while the partial chart runs.
constexpr std::string_view two_cells = R"(
    input go, halt, p1, q1, p2, q2;
    output m1, m2;
    internal k1: int 0..30000;
    internal k2: int 0..30000;
    partial supervisor {
        initial step rest { force cell1 := {INIT}; force cell2 := {INIT}; }
        step work;
        transition s0: rest -> work when go && !halt;
        transition s1: work -> rest when halt;
    }
    partial cell1 {
        initial step a1;
        step b1 { m1; k1 := k1 + 1 on activation; }
        step c1;
        transition c10: a1 -> b1 when p1 && k1 < 3;
        transition c11: b1 -> a1 when q1 && !p1;
        transition c12: a1 -> c1 when k1 > 4;
    }
    partial cell2 {
        initial step a2;
        step b2 { m2; k2 := k2 + 1 on activation; }
        transition c20: a2 -> b2 when p2;
        transition c21: b2 -> a2 when q2 && !p2;
    }
)";

Analysis bounded_analysis(std::string_view text, AnalyseOptions options) {
    const Chart subject = chart(text);
    Analysis result = analyse(subject, equations(text), options);
    EXPECT_EQ(verify(result), std::vector<std::string>{}) << text;
    EXPECT_EQ(result.failures, std::vector<std::string>{}) << text;
    return result;
}

TEST(Analyse, ACounterThatStopsAtItsThresholdIsDecidedWithoutCountingToItsEnd) {
    AnalyseOptions options;
    options.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    options.first_slice = 4'000'000;
    const Analysis found = bounded_analysis(two_cells, options);
    EXPECT_NE(find(found, "step-never-active", "cell1.Xc1"), nullptr) << "k1 is at most 3";
    EXPECT_EQ(find(found, "out-of-range", "k1"), nullptr);
    const auto open = [&](std::string_view code, std::string_view subject) {
        return std::ranges::any_of(found.open, [&](const OpenQuestion& question) {
            return question.code == code && question.subject == subject;
        });
    };
    EXPECT_FALSE(open("out-of-range", "k1")) << "k1 is never incremented beyond 3";
    for (const OpenQuestion& question : found.open) {
        EXPECT_EQ(question.code + " " + question.subject, "out-of-range k2") << "no other question depends on k2";
        EXPECT_GE(question.evolutions, 29'000) << "k2 needs this number of evolutions";
    }
}

TEST(Analyse, ResultOfOnePartDoesNotWaitForOthers) {
    AnalyseOptions options;
    options.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    options.first_slice = 4'000'000;
    std::vector<std::string> order;
    std::size_t parts = 0;
    options.found = [&](const Finding& finding) { order.push_back(finding.code); };
    options.progress = [&](const AnalyseProgress& now) { parts = std::max(parts, now.parts); };
    const Analysis found = bounded_analysis(two_cells, options);
    EXPECT_GE(parts, 4U) << "the supervisor, the supervisor with each cell, and the complete chart";
    EXPECT_GE(order.size(), 1U) << "findings are reported when they are found";
}

TEST(Analyse, RepeatedAnalysisGivesTheSameResult) {
    ParseResult oven = read_file(GRAFVERIF_SOURCE_DIR "/samples/oven_door/oven_door.grafcet");
    ASSERT_TRUE(oven.model);
    std::optional<Analysis> first;
    for (int k = 0; k < 20; ++k) {
        std::optional<Analysis> found =
            analysis_of(*oven.model, *oven.model->charts.ids().begin(), {}, {}, oven.diagnostics);
        ASSERT_TRUE(found);
        found->seconds = 0;
        if (!first) first = found;
        EXPECT_EQ(*found, *first);
    }
}

TEST(Analyse, EventsExcludedByAnAbortedRunAreNotTransferredFromParts) {
    // If only part b is considered, it reaches b1 in its second instant. In the complete chart, the race in part a
    // aborts every run in the first instant.
    const Analysis found = analysed(R"(
        input x; output o, p;
        partial a {
            initial step a0 { o := true on activation; o := false on activation; }
        }
        partial b {
            initial step b0;
            step b1 { p; }
            transition t: b0 -> b1 when x;
        }
    )");
    EXPECT_NE(find(found, "action-race", "o"), nullptr);
    EXPECT_NE(find(found, "transition-never-fired", "t"), nullptr) << "every run ends in the race";
}

TEST(Analyse, RunsOfPartsWithoutPossibleTimesAreNotRunsOfTheChart) {
    // After a rising edge of `a`, the chart is never stable, because of part g. The shortest run of the other part is
    // not possible for any choice of times: a timer would have to expire earlier.
    const Analysis found = analysed(R"(
        input a;
        output o;
        initial step 2;
        step 3 { o for 500ms; }
        transition t0: 2 -> 3 when a;
        transition t: 3 -> when !rise(1s/X100/500ms) && fall(a);
        partial g { initial step 10; transition u: 10 -> 10 when a; }
        partial h { initial step 100; transition v: 100 -> when a; }
    )");
    EXPECT_NE(find(found, "total-instability"), nullptr);
    EXPECT_NE(find(found, "transition-never-fired", "t"), nullptr);
}

// -- events that never occur again
// -------------------------------------------------------------------------------------

constexpr std::string_view press = R"(
    input a, b;
    output O;
    internal n: int 0..3 = 0;
    initial step 10;
    step 0;
    step 1 { n := n + 1 on activation; }
    step 9 { O; }
    transition t10: 10 -> 0 when a;
    transition t0: 0 -> 1 when !a && n < 2;
    transition t1: 1 -> 0 when a && !b;
    transition t9: 1 -> 9 when a && b;
)";

TEST(Analyse, EachAbsorbingRegionIsReportedWithAPathIntoIt) {
    const Analysis found = analysed(press);
    EXPECT_EQ(codes(found), (Codes{"step-never-again X0", "step-never-again X1", "comes-once X10"}));
    const Finding &stopped = found.findings[0], &counted = found.findings[1], &once = found.findings[2];
    EXPECT_EQ(stopped.level, Finding::Level::Warning);
    EXPECT_EQ(stopped.lost, (std::vector<std::string>{"X0", "X1", "t0", "t1", "t9", "n"}));
    EXPECT_EQ(stopped.message,
              "the chart can reach a situation from which `X0` and `X1` are never active again, `t0`, `t1` and `t9` "
              "are never cleared again, `n` is never changed again; `X9` stays active");
    EXPECT_EQ(cleared(*stopped.evidence), (std::vector<std::vector<std::string>>{{"t9"}}));
    EXPECT_EQ(stopped.evidence->rows.size(), 4U) << "power-on, t10, t0, t9";
    EXPECT_EQ(counted.lost, (std::vector<std::string>{"X1", "X9", "t0", "t1", "t9", "n"}));
    EXPECT_TRUE(counted.message.ends_with("; `X0` stays active")) << counted.message;
    EXPECT_EQ(once.level, Finding::Level::Note);
    EXPECT_EQ(once.lost, (std::vector<std::string>{"X10", "t10"}));
}

TEST(Analyse, CounterWithoutResetSticksWhileStepsContinue) {
    const Analysis found = analysed(R"(
        input a, b;
        internal n: int 0..3 = 0;
        initial step 0 { n := n + 1 on event rise(b) && n < 3; }
        step 1;
        transition t0: 0 -> 1 when a;
        transition t1: 1 -> 0 when !a || n == 3;
    )",
                                    {.mode = ExecutionMode::EveryCycle});
    ASSERT_EQ(codes(found), Codes{"value-sticks n"});
    EXPECT_EQ(found.findings[0].lost, std::vector<std::string>{"n"});
}

TEST(Analyse, TwoPartsThatFallOutOfStepAreARegionThatIsNeverLeft) {
    const Analysis found = analysed(R"(
        input a, b;
        initial step 0;
        step 1;
        transition t0: 0 -> 1 when rise(a);
        transition t1: 1 -> 0 when rise(a);
        partial other {
            initial step 10;
            step 11;
            transition u0: 10 -> 11 when rise(a) || (rise(b) && X0);
            transition u1: 11 -> 10 when rise(a);
        }
    )");
    ASSERT_EQ(codes(found), Codes{"region-never-left"});
    EXPECT_EQ(found.findings[0].evidence->rows.size(), 2U + 1U) << "power-on and a rising edge of `b` only";
}

TEST(Analyse, PathBackThroughARaceIsNotExcluded) {
    // The states after the race are not explored: they may lead back to step 0.
    const Analysis found = analysed(R"(
        input a, b;
        internal m: bool = false;
        initial step 0;
        step 1;
        step 2 { m := true on activation; }
        step 3 { m := false on activation; }
        transition t0: 0 -> 1 when a;
        transition t1: 1 -> 2, 3 when b;
        transition t2: 2, 3 -> 0 when m;
    )");
    EXPECT_NE(find(found, "action-race"), nullptr);
    EXPECT_EQ(find(found, "step-never-again"), nullptr);
    EXPECT_EQ(find(found, "comes-once"), nullptr);
}

TEST(Analyse, PathAbortedByAnotherPartLeadsIntoNoAbsorbingRegion) {
    // Without the counter, step 2 is never active again. With the counter, a value goes out of range before the end of
    // the instant.
    const Analysis found = analysed(R"(
        input a;
        internal n: int -2..5 = 5;
        initial step 2;
        step 3;
        step 4 { n := n + 1 on activation; }
        transition t1: 2 -> 3 when a;
        transition t2: 3 -> 4 when true;
    )");
    EXPECT_NE(find(found, "out-of-range"), nullptr);
    EXPECT_EQ(find(found, "comes-once"), nullptr);
}

TEST(Analyse, InfiniteInstantDoesNotCountAsARunOutsideARegion) {
    const Analysis found = analysed(R"(
        input a;
        initial step 0;
        initial step 1;
        step 2;
        transition t0: 0 -> 1 when true;
        transition t1: 1 -> 2 when a;
        transition t2: 2 -> 0 when X1;
    )");
    EXPECT_NE(find(found, "total-instability"), nullptr);
    EXPECT_EQ(find(found, "region-never-left"), nullptr);
}

/// There are more regions than the analysis distinguishes: each value of k is a region, and two of them have an
/// additional dead element.
TEST(Analyse, DeadElementsOfDifferentRegionsAreReportedSeparately) {
    const Analysis found = analysed(R"(
        input C: int 0..63;
        input I, J;
        internal k: int 0..63 = 0;
        initial step 0;
        step 1 { k := C on activation; }
        step 99;
        step 2;
        step 101;
        step 102;
        transition p: 0 -> 1 when I;
        transition q: 1 -> 2 when !I && !J;
        transition l: 2 -> 99 when I && J && k != 1 && k != 13;
        transition l2: 99 -> 2 when !I && !J;
        transition a: 2 -> 101 when I && !J && k != 1;
        transition a2: 101 -> 2 when !I && !J;
        transition b: 2 -> 102 when J && !I && k != 13;
        transition b2: 102 -> 2 when !I && !J;
    )");
    const auto names = [](const Finding& finding, const char* step) {
        return std::ranges::find(finding.lost, step) != finding.lost.end();
    };
    EXPECT_TRUE(std::ranges::any_of(found.findings, [&](const Finding& each) { return names(each, "X101"); }));
    for (const Finding& each : found.findings) {
        EXPECT_FALSE(names(each, "X101") && names(each, "X102")) << each.message;
        EXPECT_EQ(each.message.find("`X2`, `X101`"), std::string::npos) << each.message;
    }
}

TEST(Analyse, ValueSetByTheFirstEvolutionMayChangeAgain) {
    const Analysis found = analysed(R"(
        input x;
        internal n: int 0..2 = 0;
        initial step 0 { n := 1 on activation; }
        step 1 { n := 2 on activation; }
        step 2;
        transition t: 0 -> 1 when x && n == 1;
        transition u: 1 -> 2 when !x && n == 2;
    )");
    const Finding* once = find(found, "comes-once");
    ASSERT_NE(once, nullptr);
    EXPECT_NE(
        once->message.find("and `n` changes at most once after the first evolution: only in a start-up or final phase"),
        std::string::npos)
        << once->message;
}

TEST(Analyse, AnExhaustedSearchClaimsNothingThatNeverHappens) {
    std::atomic<bool> stop{true};
    const std::string text(sound);
    const Chart subject = chart(text);
    AnalyseOptions options;
    options.stop = &stop;
    const Analysis found = analyse(subject, equations(text), options);
    EXPECT_NE(found.obstacle, "");
    EXPECT_EQ(find(found, "step-never-active"), nullptr);
    EXPECT_EQ(found.open.size(), found.questions);
    for (const OpenQuestion& question : found.open) EXPECT_EQ(question.instants, 0U) << question.code;
}

}  // namespace
}  // namespace grafverif
