// SPDX-License-Identifier: MIT
// Tests the fault analysis on small loops.
#include "pipeline/variants/faults.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <set>

#include "pipeline/check.hpp"
#include "pipeline/variants/fault_model.hpp"

namespace grafverif {
namespace {

/// A press that moves down while a button is pressed. P is the position; AT_TOP and AT_BOTTOM are its sensors.
const char* const press = R"(
grafcet press {
    input START, AT_TOP, AT_BOTTOM;
    output DOWN, UP, ALARM;

    initial step 0;
    step 1 { DOWN; }
    step 2 { UP; }
    step 9 { ALARM; }

    transition t0: 0 -> 1 when ↑START;
    transition t1: 1 -> 2 when AT_BOTTOM;
    transition t2: 2 -> 0 when AT_TOP;
    transition t9: 1 -> 9 when 9s/X1 && !AT_BOTTOM;
}

component ram(input DOWN, UP; output P: int 0..3 = 0) {
    clock t;

    initial location still;
    location down invariant t <= 1s;
    location up invariant t <= 1s;

    urgent still -> down when DOWN && P < 3 do t := 0;
    timed down -> still when t == 1s do P := P + 1;
    urgent still -> up when UP && P > 0 do t := 0;
    timed up -> still when t == 1s do P := P - 1;
}

component sensors(input P: int; output AT_TOP, AT_BOTTOM) {
    initial location sensors with AT_TOP := true;

    urgent sensors -> sensors when AT_TOP != (P == 0) do AT_TOP := P == 0;
    urgent sensors -> sensors when AT_BOTTOM != (P == 3) do AT_BOTTOM := P == 3;
}

component no_bottom(input P: int; output AT_TOP, AT_BOTTOM) {
    initial location stuck with AT_BOTTOM := false;

    urgent stuck -> stuck when AT_TOP != (P == 0) do AT_TOP := P == 0;
}

component bottom_on(input P: int; output AT_TOP, AT_BOTTOM) {
    initial location stuck with AT_BOTTOM := true;

    urgent stuck -> stuck when AT_TOP != (P == 0) do AT_TOP := P == 0;
}

component held(output OUT) {
    initial location held with OUT := true;
}

component frozen(output P: int 0..3 = 2) {
    initial location frozen;
}
)";

std::string loop_with(const std::string& faults, const std::string& properties) {
    return std::string(press) +
           "closed_loop station {\n"
           "    controller press;\n"
           "    environment Start = push_button(OUT = START, GAP = 1s);\n"
           "    plant Ram = ram(DOWN = DOWN, UP = UP, P = P);\n"
           "    plant Sensors = sensors(P = P, AT_TOP = AT_TOP, AT_BOTTOM = AT_BOTTOM);\n" +
           faults + properties + "}\n";
}

struct Analysed {
    ParseResult read = {};
    FaultAnalysis analysis = {};

    const FaultAnalysis::Row& row(const std::string& property) const {
        for (const FaultAnalysis::Row& each : analysis.rows)
            if (each.property == property) return each;
        ADD_FAILURE() << property;
        return analysis.rows.front();
    }
    std::string name(const FaultSet& faults) const {
        std::string text;
        for (const std::size_t fault : faults) text += (text.empty() ? "" : "+") + analysis.faults[fault].name;
        return text;
    }
    std::set<std::string> minimal(const std::string& property) const {
        std::set<std::string> names;
        for (const FaultAnalysis::Cut& cut : row(property).minimal) names.insert(name(cut.faults));
        return names;
    }
};

Analysed analysed(const std::string& text, FaultsRequest request) {
    Analysed made{read_string(text, "press.grafcet")};
    if (!made.read.model) {
        ADD_FAILURE() << made.read.diagnostics_text();
        return made;
    }
    request.jobs = 1;
    const auto found =
        analysed_faults(*made.read.model, *find_loop(*made.read.model, "station"), request, made.read.diagnostics);
    if (!found) ADD_FAILURE() << made.read.diagnostics_text();
    else made.analysis = *found;
    EXPECT_EQ(made.analysis.failures, std::vector<std::string>{});
    return made;
}

using Names = std::set<std::string>;

TEST(Faults, SingleFaultsThatViolateAPropertyAreFoundWithTheirRuns) {
    const Analysed found = analysed(loop_with("    fault blind of Sensors: no_bottom();\n"
                                              "    fault blocked of Ram: frozen();\n",
                                              "    property silent: never ALARM;\n    property inside: never P > 3;\n"),
                                    {});
    EXPECT_EQ(found.minimal("silent"), (Names{"blind", "blocked"}));
    EXPECT_EQ(found.minimal("inside"), Names{});
    for (const FaultAnalysis::Cut& cut : found.row("silent").minimal) {
        ASSERT_TRUE(cut.result.trace.has_value());
        EXPECT_GE(cut.result.trace->moments.back().after.time_ms, 9000);
    }
}

// The value after `= ` in the head of a component is its value at power-on, so that the blocked ram does not jump to 2.
TEST(Faults, OutputsKeepTheirValuesUnlessTheInitialLocationAssignsThem) {
    const Analysed found = analysed(loop_with("    fault blocked of Ram: frozen();\n",
                                              "    property from_0: P >= 2 leads to X2;\n"
                                              "    property from_power_on: always P == 2 => !X0 at stable;\n"),
                                    {});
    EXPECT_EQ(found.minimal("from_power_on"), Names{});
    EXPECT_EQ(found.minimal("from_0"), Names{"blocked"});
}

// If the button is held from power-on, no edge of START occurs, and X1 is not reachable. If the button is first
// released, X1 is reachable.
TEST(Faults, ReachabilityIsCheckedWithTheFaultFromPowerOn) {
    const Analysed found =
        analysed(loop_with("    fault held of Start: held();\n", "    property works: reachable X1;\n"), {});
    EXPECT_EQ(found.minimal("works"), Names{"held"});
    EXPECT_EQ(found.row("works").minimal.front().from_power_on, FaultSet{0});
}

TEST(Faults, PropertiesOfRunsFromPowerOnAreAlsoCheckedWithFaultsFromPowerOn) {
    const Analysed found = analysed(loop_with("    fault held of Start: held();\n",
                                              "    property released: inevitable !START;\n"
                                              "    property first: !START precedes X1;\n"),
                                    {});
    EXPECT_EQ(found.minimal("released"), Names{"held"});
    EXPECT_EQ(found.row("released").minimal.front().from_power_on, FaultSet{0});
}

TEST(Faults, ACombinationIsMinimalIfNoSubsetViolatesTheProperty) {
    const std::string faults =
        "    fault blind of Sensors: no_bottom();\n    fault held of Start: held();\n"
        "    fault blocked of Ram: frozen();\n";
    const Analysed found = analysed(loop_with(faults,
                                              "    property both: never ALARM && START at stable;\n"
                                              "    property pair: never P == 3 && X9;\n"),
                                    {.order = 3});
    EXPECT_EQ(found.analysis.combinations, 7u);
    EXPECT_EQ(found.minimal("both"), (Names{"blind", "blocked"}));
    EXPECT_EQ(found.minimal("pair"), Names{"blind"});
}

TEST(Faults, TwoFaultsOfOneInstanceAreNotCombined) {
    const std::string faults =
        "    fault a of Start: held();\n    fault b of Start: held();\n"
        "    fault c of Ram: frozen();\n";
    const Analysed found = analysed(loop_with(faults, "    property p: never P > 3;\n"), {.order = 2});
    EXPECT_EQ(found.analysis.combinations, 5u);
    EXPECT_EQ(combination_count(found.read.model->loops[Id<ClosedLoop>{0}], 2), 5u);
    EXPECT_EQ(combination_count(found.read.model->loops[Id<ClosedLoop>{0}], 8), 5u);
}

// With both faults, a button that is held stops the loop in X0, after which the ram can still become blocked.
TEST(Faults, ADeadlockBelongsToTheFaultsThatHaveOccurred) {
    const std::string faults = "    fault held of Start: held();\n    fault blocked of Ram: frozen();\n";
    const Analysed found = analysed(loop_with(faults, "    property alive: no deadlock;\n"), {.order = 2});
    EXPECT_EQ(found.minimal("alive"), Names{"held"});
    EXPECT_EQ(found.row("alive").non_monotone.size(), 0u);
}

// A button that is held stops the loop in X0. The sensors can still begin to chatter, and then the loop never stops.
// However, in the run with the fault `held` alone, the sensors never chatter.
TEST(Faults, AFaultThatNeverOccursCannotEndADeadlock) {
    const std::string chatter =
        "component chatter(output AT_TOP, AT_BOTTOM) {\n    clock t;\n\n    initial location chatter;\n\n"
        "    timed chatter -> chatter when t >= 1s do t := 0;\n}\n";
    const std::string faults = "    fault held of Start: held();\n    fault chatter of Sensors: chatter();\n";
    for (const char* const pattern : {"no deadlock", "always possible X1"}) {
        const Analysed found =
            analysed(chatter + loop_with(faults, "    property p: " + std::string(pattern) + ";\n"), {.order = 2});
        const FaultAnalysis::Row& row = found.row("p");
        if (row.without_faults != Outcome::Holds) continue;  // `always possible` can be unknown
        EXPECT_TRUE(found.minimal("p").contains("held")) << pattern;
        EXPECT_FALSE(found.minimal("p").contains("held+chatter")) << pattern;
        EXPECT_TRUE(row.non_monotone.empty()) << pattern;
    }
    const ParseResult read = read_string(chatter + loop_with(faults, "    property p: no deadlock;\n"), "a.grafcet");
    ASSERT_TRUE(read.model.has_value());
    const Model& model = *read.model;
    const Id<ClosedLoop> loop = *find_loop(model, "station");
    Diagnostics diagnostics;
    const auto both = check(with_faults(model, loop, {{{0}, false}, {{1}, false}}), loop, {}, {}, diagnostics);
    ASSERT_TRUE(both.has_value());
    EXPECT_EQ(both->answers.front().verdict.outcome, Outcome::Holds);  // the model with both faults hides the deadlock
}

// Two switches turn the lamp off. The strict clock constraint of the fault `a` makes the verdict
// with this fault unknown.
TEST(Faults, MinimalityIsUnprovedIfASubsetIsUnknown) {
    const std::string text =
        "grafcet lamp {\n    input ON, A, B;\n    output LAMP;\n\n    initial step 0;\n    step 1 { LAMP; }\n\n"
        "    transition t0: 0 -> 1 when ON && !A && !B;\n    transition t1: 1 -> 0 when A || B;\n}\n"
        "component toggle(output OUT) {\n    clock t;\n\n    initial location toggle invariant t <= 1s;\n\n"
        "    timed toggle -> toggle when t == 1s do OUT := !OUT, t := 0;\n}\n"
        "component open(output OUT) {\n    clock t;\n\n    initial location open invariant t < 3s with OUT := false;\n"
        "\n    timed open -> open when t >= 1s do t := 0;\n}\n"
        "component dead(output OUT) {\n    initial location dead with OUT := false;\n}\n"
        "closed_loop station {\n    controller lamp;\n    environment On = push_button(OUT = ON, GAP = 1s);\n"
        "    environment A = toggle(OUT = A);\n    environment B = toggle(OUT = B);\n"
        "    fault a of A: open();\n    fault b of B: dead();\n    property p: X1 leads to X0 within 5s;\n}\n";
    const Analysed found = analysed(text, {.order = 2});
    const FaultAnalysis::Row& row = found.row("p");
    EXPECT_EQ(row.without_faults, Outcome::Holds);
    ASSERT_EQ(row.open.size(), 1u);
    EXPECT_EQ(found.name(row.open.front().faults), "a");
    ASSERT_EQ(found.minimal("p"), Names{"a+b"});
    EXPECT_EQ(row.minimal.front().unknown_subsets, std::vector<FaultSet>{{0}});
}

// The edge of `overflow` is enabled only after `runaway` has occurred, and has an error of the same kind.
TEST(Faults, DifferentModelErrorsOfOneKindAreReported) {
    const std::string text =
        "component still(output OUT: int 0..3 = 0) {\n    initial location still;\n}\n"
        "component runaway(output OUT: int 0..3 = 0) {\n    clock t;\n\n    initial location runaway;\n\n"
        "    timed runaway -> runaway when t >= 1s do OUT := OUT + 1, t := 0;\n}\n"
        "component meter(input X: int; output OUT: int 0..1 = 0) {\n    initial location meter;\n}\n"
        "component overflow(input X: int; output OUT: int 0..1 = 0) {\n    clock t;\n\n"
        "    initial location overflow;\n\n"
        "    timed overflow -> overflow when X == 2 && t >= 1s do OUT := OUT + 1, t := 0;\n}\n";
    const std::string faults =
        "    plant Rotor = still(OUT = R);\n    plant Meter = meter(X = R, OUT = Q);\n"
        "    fault runaway of Rotor: runaway();\n    fault overflow of Meter: overflow();\n";
    const Analysed found = analysed(text + loop_with(faults, "    property p: always R <= 3;\n"), {.order = 2});
    Names errors;
    for (const FaultAnalysis::Error& each : found.analysis.errors)
        errors.insert(found.name(each.faults) + ": " + each.trace.message.substr(0, 3));
    EXPECT_EQ(errors, (Names{"runaway: `R`", "runaway+overflow: `Q`"}));
}

TEST(Faults, AnUndeclaredTimelockWithoutFaultsIsReported) {
    const std::string bomb =
        "component bomb(output OUT) {\n    clock t;\n\n    initial location bomb invariant t <= 5s;\n}\n";
    const Analysed found =
        analysed(bomb + loop_with("    plant Bomb = bomb(OUT = W);\n    fault held of Start: held();\n",
                                  "    property p: never P > 3;\n"),
                 {});
    EXPECT_FALSE(found.row("no_timelock").declared);
    EXPECT_EQ(found.row("no_timelock").without_faults, Outcome::Violated);
}

TEST(Faults, ChecksAreCounted) {
    const std::string text = loop_with("    fault held of Start: held();\n", "    property p: never P > 3;\n");
    EXPECT_EQ(analysed(text, {.visible = false}).analysis.checks, 2u);
    EXPECT_EQ(analysed(text, {}).analysis.checks, 5u);
}

TEST(Faults, ReportsCombinationsThatRestoreAProperty) {
    const std::string faults = "    fault blocked of Ram: frozen();\n    fault bottom of Sensors: bottom_on();\n";
    const Analysed found = analysed(loop_with(faults, "    property lifts: reachable X2;\n"), {.order = 2});
    EXPECT_EQ(found.minimal("lifts"), Names{"blocked"});
    ASSERT_EQ(found.row("lifts").non_monotone.size(), 1u);
    EXPECT_EQ(found.name(found.row("lifts").non_monotone.front().holding), "blocked+bottom");
}

TEST(Faults, PropertiesThatAreViolatedWithoutFaultsAreNotAnalysed) {
    const Analysed found =
        analysed(loop_with("    fault held of Start: held();\n", "    property p expected violated: never X1;\n"), {});
    EXPECT_EQ(found.row("p").without_faults, Outcome::Violated);
    EXPECT_EQ(found.minimal("p"), Names{});
}

TEST(Faults, VisibleEffectsAreStepsAndOutputsThatOnlyTheFaultReachesOrPrevents) {
    const Analysed found = analysed(loop_with("    fault blind of Sensors: no_bottom();\n"
                                              "    fault held of Start: held();\n",
                                              "    property p: never P > 3;\n"),
                                    {});
    const FaultAnalysis::Visible& blind = found.analysis.faults[0].visible;
    EXPECT_TRUE(blind.decided);
    EXPECT_EQ(blind.newly_true, (std::vector<std::string>{"ALARM", "X9"}));
    EXPECT_EQ(blind.never_true, (std::vector<std::string>{"UP", "X2"}));
    EXPECT_EQ(blind.always_shown, Outcome::Violated);  // the button may never be pressed
    EXPECT_EQ(found.analysis.faults[1].visible.never_true, (std::vector<std::string>{"DOWN", "UP", "X1", "X2"}));
}

TEST(Faults, UnknownVerdictsAreReportedAtALimit) {
    std::atomic<bool> stop = true;
    FaultsRequest request;
    request.limits.stop = &stop;
    const Analysed found =
        analysed(loop_with("    fault held of Start: held();\n", "    property p: never P > 3;\n"), request);
    EXPECT_EQ(found.row("p").without_faults, Outcome::Unknown);
    EXPECT_FALSE(found.analysis.faults[0].visible.decided);
    EXPECT_EQ(found.analysis.checks, 1u);
}

// With two faults, the loop is expected to have more states than the limit of the small first search. Therefore, the
// analysis begins with a search of the complete loop, which reaches the memory limit. Then a small search decides `q`
// in the independent subsystem of `lamp`.
TEST(Faults, PropertiesAreDecidedBySmallSearchesIfTheSearchOfTheCompleteLoopFails) {
    std::string text =
        "component chatter(output OUT) {\n    clock t;\n\n    initial location chatter invariant t <= 4s;\n\n"
        "    timed chatter -> chatter when t >= 1s do OUT := !OUT, t := 0;\n}\n";
    for (const char* const name : {"lamp", "pump"})
        text += fmt::format(
            "grafcet {0} {{\n    input {0}_A, {0}_B;\n    output {0}_ON;\n\n    initial step 0;\n"
            "    step 1 {{ {0}_ON; }}\n\n    transition a: 0 -> 1 when {0}_A && {0}_B;\n"
            "    transition b: 1 -> 0 when !{0}_A;\n}}\n",
            name);
    text += "closed_loop station {\n    controller lamp;\n    controller pump;\n";
    for (const char* const input : {"lamp_A", "lamp_B", "pump_A", "pump_B"})
        text += fmt::format("    environment {0}_button = push_button(OUT = {0}, GAP = 1s);\n", input);
    text +=
        "    fault a of lamp_A_button: chatter();\n    fault b of lamp_B_button: chatter();\n"
        "    property p: never lamp.X0 && lamp.X1 && pump_ON;\n    property q: never lamp.X0 && lamp.X1;\n}\n";
    FaultsRequest request{.order = 2, .visible = false, .first_states = 4000};
    request.limits.memory = 6'000'000;
    const Analysed found = analysed(text, request);
    for (const char* const property : {"p", "q"}) {
        EXPECT_EQ(found.row(property).without_faults, Outcome::Holds);
        EXPECT_TRUE(found.row(property).minimal.empty());
        EXPECT_TRUE(found.row(property).open.empty()) << property;
    }
    const Id<ClosedLoop> loop = *find_loop(*found.read.model, "station");
    const auto memory_suffices = [&](const std::vector<ActiveFault>& faults) {
        Diagnostics diagnostics;
        const Model made = with_faults(*found.read.model, loop, faults);
        const auto whole =
            check(made, loop, {}, {.properties = {"q"}, .limits = request.limits, .whole = true}, diagnostics);
        return whole->answers.front().verdict.outcome == Outcome::Holds;
    };
    EXPECT_TRUE(memory_suffices({{{0}, false}}));
    EXPECT_TRUE(memory_suffices({{{1}, false}}));
    EXPECT_FALSE(memory_suffices({{{0}, false}, {{1}, false}}));
}

TEST(Faults, TheModelWithFaultsKeepsTheIdsOfTheLoop) {
    const ParseResult read = read_string(
        loop_with("    fault blind of Sensors: no_bottom();\n", "    property p: never P > 3;\n"), "press.grafcet");
    ASSERT_TRUE(read.model.has_value()) << read.diagnostics_text();
    const Id<ClosedLoop> loop = *find_loop(*read.model, "station");
    const Model made = with_faults(*read.model, loop, {{{0}, true}});
    EXPECT_EQ(verify(made), std::vector<std::string>{});
    const Component& sensors = made.components[made.loops[loop].instances[Id<ClosedLoop::Instance>{2}].component];
    EXPECT_EQ(sensors.locations[Id<Component::Location>{0}].name, "sensors");
    EXPECT_EQ(sensors.locations[Id<Component::Location>{1}].name, "blind");
    EXPECT_TRUE(made.loops[loop].faults.empty());
}

}  // namespace
}  // namespace grafverif
