// SPDX-License-Identifier: MIT
// Tests the three plant approaches and the three schedules of untimed models: their common results, and cases in which
// the results differ.
#include <gtest/gtest.h>

#include <map>

#include "check/symbolic/symbolic.hpp"
#include "support/untimed_loop.hpp"

namespace grafverif {
namespace {

constexpr ScheduleOptions with(Schedule schedule) { return {.plant = PlantApproach::Automata, .schedule = schedule}; }

std::map<std::string, Outcome> verdicts(const TransitionSystem& system) {
    const SymbolicResult result = check_symbolic(system);
    EXPECT_FALSE(result.fault.has_value()) << system.scope;
    std::map<std::string, Outcome> found;
    for (const Verdict& verdict : result.verdicts) found[verdict.property] = verdict.outcome;
    return found;
}

/// Two sensors read the same push button.
const char* const button = R"(
grafcet watcher {
    input a, c;
    output LAMP;
    initial step 0;
    step 1 { LAMP; }
    transition t0: 0 -> 1 when a && !c;
}
closed_loop two_sensors {
    controller watcher;
    environment Button = push_button(OUT = pressed);
    plant A = combination_sensor(A = pressed, B = pressed, OUT = a);
    plant C = combination_sensor(A = pressed, B = pressed, OUT = c);
    property P: never X1;
}
)";

TEST(Schedules, OnlyInterleavedSeesOneSensorOfAButtonBeforeTheOther) {
    EXPECT_EQ(verdicts(untimed_text(button, with(Schedule::Interleaved)))["P"], Outcome::Violated);
    EXPECT_EQ(verdicts(untimed_text(button, with(Schedule::Interleaved), Grain::Atomic))["P"], Outcome::Violated);
    EXPECT_EQ(verdicts(untimed_text(button, with(Schedule::Synchronous)))["P"], Outcome::Holds);
    EXPECT_EQ(verdicts(untimed_text(button, with(Schedule::Sequenced)))["P"], Outcome::Holds);
    EXPECT_EQ(verdicts(untimed_text(button, {}))["P"], Outcome::Violated);
}

TEST(Schedules, ConstraintsAreAssumedOfFreeInputsAndProvedOfAPlant) {
    std::string text = button;
    text.replace(text.find("    property"), 0, "    constraint a == c;\n");
    const auto constrained = verdicts(untimed_text(text, {.plant = PlantApproach::Constraints}));
    EXPECT_EQ(constrained.at("P"), Outcome::Holds);
    EXPECT_FALSE(constrained.contains("constraint_1"));
    EXPECT_EQ(verdicts(untimed_text(text, with(Schedule::Interleaved)))["constraint_1"], Outcome::Violated);
    EXPECT_EQ(verdicts(untimed_text(text, with(Schedule::Sequenced)))["constraint_1"], Outcome::Holds);
}

TEST(Schedules, ConstraintsMayPermitOneOfVeryManyCombinationsOfInputs) {
    std::string chart = "grafcet g { input n: int -32000..32000, m: int -32000..32000; output o; input ";
    std::string drivers;
    std::string loop =
        "closed_loop l { controller g; environment N = free_integer(OUT = n, LOW = -32000, HIGH = 32000);"
        "environment M = free_integer(OUT = m, LOW = -32000, HIGH = 32000); property P: never o; constraint n == m && "
        "n % 3 == 2 && ";
    for (int k = 0; k < 40; ++k) {
        const std::string name = "a" + std::to_string(k);
        chart += (k == 0 ? "" : ", ") + name;
        loop += (k == 0 ? "" : " && ") + name;
        drivers += "environment A" + std::to_string(k) + " = free(OUT = " + name + "); ";
    }
    loop += "; " + drivers;
    chart += "; initial step 0; step 1 { o; } transition t: 0 -> 1 when a0 && n > m; }\n";
    const auto found =
        verdicts(untimed_text(chart + loop + "constraint n > 31998; }", {.plant = PlantApproach::Constraints}));
    EXPECT_EQ(found.at("P"), Outcome::Holds);
    EXPECT_THROW(untimed_text(chart + loop + "constraint n == 31999; }", {.plant = PlantApproach::Constraints}),
                 std::invalid_argument);
}

/// The cylinders and the sensor of WODES06 Fig. 3 without the other parts (III.E): L1C retracts while L2C is out.
const char* const two_cylinders = R"(
grafcet moves {
    input s0, s2, go;
    output L1CGO, L1CGI, L2CGO, L2CGI;
    initial step 0;
    step 1 { L1CGO; L2CGO; }
    step 2 { L1CGI; }
    transition t0: 0 -> 1 when s0;
    transition t1: 1 -> 2 when go;
}
closed_loop pair {
    controller moves;
    schedule sequenced;
    plant L1C = cylinder_5_2(G_OUT = L1CGO, G_IN = L1CGI, IN = V_P5, OUT = V_P7);
    plant L2C = cylinder_5_2(G_OUT = L2CGO, G_IN = L2CGI, IN = V_P9, OUT = V_P11);
    plant S0 = combination_sensor(A = V_P5, B = V_P9, OUT = s0) initially on;
    plant S2 = combination_sensor(A = V_P5, B = V_P11, OUT = s2);
    plant S3 = combination_sensor(A = V_P7, B = V_P11, OUT = go);
    property unstable "{P5, P11, P17} is seen": reachable L1C.in && L2C.out && S2.off;
    property stable "{P5, P11, P18} with s2 is seen": reachable L1C.in && L2C.out && S2.on && s2;
    property before "{P8, P11, P17} is seen": reachable L1C.moving_in && L2C.out && S2.off;
}
)";

TEST(Schedules, ThePlantSequencerHidesTheSituationThatTheSensorHasNotSeenYet) {
    std::string text = two_cylinders;
    const auto sequenced = verdicts(untimed_text(text, with(Schedule::Sequenced)));
    EXPECT_EQ(sequenced.at("unstable"), Outcome::Violated);
    EXPECT_EQ(sequenced.at("stable"), Outcome::Holds);
    EXPECT_EQ(sequenced.at("before"), Outcome::Holds);
    EXPECT_EQ(sequenced.at("plant_settles"), Outcome::Holds);
    EXPECT_EQ(sequenced.at("controllers_settle"), Outcome::Holds);
    const auto interleaved = verdicts(untimed_text(text, with(Schedule::Interleaved), Grain::Atomic));
    EXPECT_EQ(interleaved.at("unstable"), Outcome::Holds);
    EXPECT_EQ(interleaved.at("stable"), Outcome::Holds);
    EXPECT_EQ(verdicts(untimed_text(text, with(Schedule::Synchronous)))["unstable"], Outcome::Holds);
}

/// Checks the result of the paper WODES06, section III.E, on the complete machine.
TEST(PickAndPlace, ShowsTheUnstableSituationWithoutTheSequencer) {
    const SymbolicResult result =
        check_symbolic(untimed_sample("pick_and_place/pick_and_place.grafcet", with(Schedule::Synchronous)));
    EXPECT_EQ(result.states, "1466");
    for (const Verdict& verdict : result.verdicts) EXPECT_EQ(verdict.outcome, Outcome::Holds) << verdict.property;
}

/// The rows follow DESDES06 Table 1, with one row for each group of properties.
TEST(AssemblyStation, HasTheVerdictsOfTheTableInEachApproach) {
    const std::string sample = "assembly_station/assembly_station.grafcet";
    struct Column {
        ScheduleOptions options = {};
        Outcome prop3_and_4 = Outcome::Violated;
        std::string states = {};
    };
    const Column columns[] = {
        {{}, Outcome::Violated, "4096"},
        {{.plant = PlantApproach::Constraints}, Outcome::Violated, "2304"},  // 9/16 of the states, as in the table
        {{.plant = PlantApproach::Automata}, Outcome::Holds, "116"},
    };
    for (const Column& column : columns) {
        const SymbolicResult result = check_symbolic(untimed_sample(sample, column.options));
        std::size_t steps = 0;
        for (const Verdict& verdict : result.verdicts) {
            const bool differs = verdict.property == "PROP3" || verdict.property == "PROP4";
            EXPECT_EQ(verdict.outcome, differs ? column.prop3_and_4 : Outcome::Holds) << verdict.property;
            steps += verdict.property.starts_with("PROP_R_1.X") ? std::size_t{1} : std::size_t{0};
        }
        EXPECT_EQ(steps, 14U);
        EXPECT_EQ(result.states, column.states);
    }
}

TEST(Observers, FollowEveryStepOfTheModel) {
    std::string text = button;
    text.replace(text.find("    property"), 0,
                 "    observer Once {\n        initial location dark;\n        location lit;\n        location again;\n"
                 "        dark -> lit when LAMP;\n        lit -> again when !LAMP;\n    }\n"
                 "    property never_again: never Once.again;\n    property sees: reachable Once.lit;\n");
    for (const ScheduleOptions& options : {ScheduleOptions{}, with(Schedule::Interleaved)}) {
        const auto found = verdicts(untimed_text(text, options));
        EXPECT_EQ(found.at("never_again"), Outcome::Holds);
        EXPECT_EQ(found.at("sees"), Outcome::Holds);
    }
    EXPECT_EQ(verdicts(untimed_text(text, with(Schedule::Synchronous)))["sees"], Outcome::Violated);
}

TEST(Fairness, EndsMovementsAndPressesNoButton) {
    const std::string text = R"(
grafcet go {
    input start, there;
    output OUT;
    initial step 0;
    step 1 { OUT; }
    step 2;
    transition t0: 0 -> 1 when start;
    transition t1: 1 -> 2 when there;
}
closed_loop line {
    controller go;
    environment Start = push_button(OUT = start);
    plant Rod = cylinder_5_2_spring(G_OUT = OUT, IN = back, OUT = there);
    property arrives: X1 leads to X2;
    property starts: inevitable X1;
}
)";
    for (const Schedule schedule : {Schedule::Interleaved, Schedule::Synchronous, Schedule::Sequenced}) {
        ScheduleOptions options = with(schedule);
        EXPECT_EQ(verdicts(untimed_text(text, options))["arrives"], Outcome::Violated);
        options.fairness = true;
        const auto fair = verdicts(untimed_text(text, options));
        EXPECT_EQ(fair.at("arrives"), Outcome::Holds);
        EXPECT_EQ(fair.at("starts"), Outcome::Violated);
    }
}

/// Both charts have an internal variable `n`. The replay resolves each name in its own chart.
TEST(Schedules, VariablesOfSeveralControllersHaveTheNamesDeclaredInTheirCharts) {
    const std::string text = R"(
grafcet first {
    input go;
    internal n: int 0..3 = 0;
    initial step 0;
    step 1 { n := n + 1 on activation; }
    transition t0: 0 -> 1 when go && n < 3;
    transition t1: 1 -> 0 when !go;
}
grafcet second {
    input go;
    internal n: int 0..3 = 3;
    initial step 0 { n := 2 on deactivation; }
    step 1;
    transition t0: 0 -> 1 when go;
}
closed_loop pair {
    controller first;
    controller second;
    environment Go = push_button(OUT = go);
}
)";
    for (const Schedule schedule : {Schedule::Interleaved, Schedule::Synchronous, Schedule::Sequenced}) {
        const TransitionSystem system = untimed_text(text, with(schedule));
        ASSERT_EQ(system.controllers.size(), 2u);
        for (const TransitionSystem::Controller& controller : system.controllers) {
            ASSERT_EQ(controller.words.internals.size(), 1u);
            EXPECT_EQ(controller.words.internals.front().name, "n");
        }
    }
}

}  // namespace
}  // namespace grafverif
