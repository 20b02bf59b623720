// SPDX-License-Identifier: MIT
// Tests the structure of the networks that compose builds: the automata of CEP13, Fig. 33a and 33b, with corrections,
// the procedures, and the flags.
#include <gtest/gtest.h>

#include "hand_chart.hpp"
#include "support/naive_tadd.hpp"
#include "support/print_network.hpp"

namespace grafverif {
namespace {

/// Returns a chart with the transitions 1 -> 2 when a and 2 -> 1 when 5s/X2, in which step 2 sets OUT.
HandChart small_chart() {
    HandChart hand("small");
    const auto a = hand.input("a");
    const auto out = hand.output("OUT");
    const auto one = hand.step("1", true), two = hand.step("2");
    hand.transition(one, two, hand.leaf(a));
    hand.transition(two, one, hand.after(5000, two));
    hand.while_active(two, out);
    return hand;
}

/// Returns the part of `text` from the line that begins with `from` up to the line that begins with `to`.
std::string between(const std::string& text, const std::string& from, const std::string& to) {
    const std::size_t begin = text.find("\n" + from);
    const std::size_t end = text.find("\n" + to, begin + 1);
    return begin == std::string::npos ? "" : text.substr(begin + 1, end - begin);
}

TEST(Cycle, ThePhasedCycleIsThatOfFigure33a) {
    const Network network = composed(lone_controller(small_chart().chart));
    EXPECT_EQ(
        between(network_text(network), "template plc_cycle", "template timer"),
        "template plc_cycle\n"
        "    initial location W\n"
        "    location P0\n"
        "    location P1\n"
        "    location P2\n"
        "    procedure fire\n"
        "        CF_t0 := X_1 && a\n"
        "        CF_t1 := X_2 && T_X2_5s_Q\n"
        "    procedure evolve\n"
        "        T_X2_5s_P := (CF_t0 && !X_2) || (X_2 && CF_t1 && !CF_t0)\n"
        "        stable := !(CF_t0 || CF_t1)\n"
        "        X_1 := CF_t1 || (X_1 && !CF_t0)\n"
        "        X_2 := CF_t0 || (X_2 && !CF_t1)\n"
        "        CF_t0 := false\n"
        "        CF_t1 := false\n"
        "    procedure write\n"
        "        OUT := X_2\n"
        "    urgent W -> P0 when (!stable || EVOL_PL || EVOL_TI) && !T_X2_5s_P do EVOL_PL := false, EVOL_TI := false\n"
        "    urgent P0 -> P1 do fire()\n"
        "    urgent P1 -> P2 do evolve()\n"
        "    urgent P2 -> W when stable do write()\n"
        "    urgent P2 -> W when !stable\n"
        "\n");
}

/// Returns the PLC of the small chart with the task cycle 1s..2s.
std::string with_task_cycle(const ComposeOptions& options) {
    Model model = lone_controller(small_chart().chart);
    model.loops[{0}].controllers[{0}].cycle = TaskCycle{1000, 2000, {}};
    return network_text(composed(model, options));
}

TEST(Cycle, WithATaskCycleTimeBeginsAScanThatHoldsItsInputs) {
    const std::string text = with_task_cycle({});
    EXPECT_EQ(text.find("EVOL_"), std::string::npos) << text;
    EXPECT_EQ(between(text, "template plc_cycle", "template timer"),
              "template plc_cycle\n"
              "    clock clk\n"
              "    initial location init\n"
              "    location W invariant clk <= 2\n"
              "    location P0\n"
              "    location P1\n"
              "    location P2\n"
              "    procedure fire\n"
              "        CF_t0 := X_1 && a_sample\n"
              "        CF_t1 := X_2 && T_X2_5s_Q\n"
              "    procedure evolve\n"
              "        T_X2_5s_P := (CF_t0 && !X_2) || (X_2 && CF_t1 && !CF_t0)\n"
              "        stable := !(CF_t0 || CF_t1)\n"
              "        X_1 := CF_t1 || (X_1 && !CF_t0)\n"
              "        X_2 := CF_t0 || (X_2 && !CF_t1)\n"
              "        CF_t0 := false\n"
              "        CF_t1 := false\n"
              "    procedure write\n"
              "        OUT := X_2\n"
              "        a_sample := false\n"
              "    procedure start\n"
              "        a_sample := a\n"
              "    urgent init -> W do start(), clk := 0\n"
              "    timed W -> P0 when stable && !T_X2_5s_P && clk >= 1 do a_sample := a, stable := false\n"
              "    urgent W -> P0 when !stable && !T_X2_5s_P\n"
              "    urgent P0 -> P1 do fire()\n"
              "    urgent P1 -> P2 do evolve()\n"
              "    urgent P2 -> W when stable do write(), clk := 0\n"
              "    urgent P2 -> W when !stable do clk := 0\n"
              "\n");
    EXPECT_NE(text.find("    timed run -> done when !P && stable && t == D do Q := true\n"), std::string::npos) << text;
}

TEST(Cycle, AScanOfTheModeEveryCycleIsOneEvolution) {
    const std::string text = with_task_cycle({.mode = ExecutionMode::EveryCycle});
    EXPECT_NE(text.find("    urgent init -> W do start(), write(), clk := 0\n"), std::string::npos) << text;
    EXPECT_NE(text.find("    timed W -> P0 when !T_X2_5s_P && clk >= 1\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("urgent W -> P0"), std::string::npos) << text;
    EXPECT_NE(text.find("    timed run -> done when !P && t == D do Q := true\n"), std::string::npos) << text;
}

TEST(Cycle, AScanOfTheAtomicGrainIsOneEdgePerEvolution) {
    const std::string text = with_task_cycle({.grain = Grain::Atomic});
    EXPECT_NE(
        text.find("    timed W -> W when stable && !T_X2_5s_P && clk >= 1 do a_sample := a, fire(), evolve(), write(), "
                  "clk := 0\n"),
        std::string::npos)
        << text;
    EXPECT_NE(text.find("    urgent W -> W when !stable && !T_X2_5s_P do fire(), evolve(), write(), clk := 0\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("        a_sample := stable ? false : a_sample\n"), std::string::npos) << text;
}

TEST(Cycle, TheAtomicCycleIsOneEdgeThatKeepsOutputsUntilStable) {
    const Network network = composed(lone_controller(small_chart().chart), {.grain = Grain::Atomic});
    const std::string text = between(network_text(network), "template plc_cycle", "template timer");
    EXPECT_NE(text.find("    urgent W -> W when (!stable || EVOL_PL || EVOL_TI) && !T_X2_5s_P do EVOL_PL := false, "
                        "EVOL_TI := false, fire(), evolve(), write()\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("        OUT := stable ? X_2 : OUT\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("CF_t0 := false"), std::string::npos)
        << "firing conditions are scratch variables and are not reset";
}

TEST(Cycle, TheTimerIsThatOfFigure33bWithCorrections) {
    const Network network = composed(lone_controller(small_chart().chart));
    EXPECT_EQ(between(network_text(network), "template timer", "controller PLC"),
              "template timer\n"
              "    constant D: int -32768..32767\n"
              "    read X: bool\n"
              "    written P: bool\n"
              "    written Q: bool\n"
              "    written EVOL_TI: bool\n"
              "    clock t\n"
              "    initial location idle\n"
              "    location run invariant t <= D\n"
              "    location done\n"
              "    urgent idle -> run when P && X do P := false, t := 0\n"
              "    urgent idle -> idle when P && !X do P := false\n"
              "    timed run -> done when !P && t == D do Q := true, EVOL_TI := true\n"
              "    urgent run -> run when P && X do P := false, t := 0\n"
              "    urgent run -> idle when P && !X do P := false\n"
              "    urgent done -> run when P && X do Q := false, EVOL_TI := true, P := false, t := 0\n"
              "    urgent done -> idle when P && !X do Q := false, EVOL_TI := true, P := false\n"
              "\n");
}

TEST(Cycle, OutputsAreWrittenOnEveryPathBackAndBeforeTheFirstCycle) {
    const Network network = composed(lone_controller(small_chart().chart), {.mode = ExecutionMode::EveryCycle});
    const std::string text = between(network_text(network), "template plc_cycle", "template timer");
    EXPECT_NE(text.find("    initial location init\n"), std::string::npos) << text;
    EXPECT_NE(text.find("    urgent init -> W do start(), write()\n"), std::string::npos) << text;
    EXPECT_NE(text.find("    urgent P2 -> W do write()\n"), std::string::npos) << text;
}

TEST(Cycle, ActionsOfInitialStepsRunBeforeTheFirstCycle) {
    HandChart hand = small_chart();
    const auto lock = hand.output("LOCK");
    hand.on_activation({0}, lock, hand.always());
    const Network network = composed(lone_controller(hand.chart));
    const std::string text = network_text(network);
    EXPECT_NE(text.find("    urgent init -> W do start()\n"), std::string::npos) << text;
    EXPECT_NE(text.find("    procedure start\n        LOCK_image := true\n"), std::string::npos) << text;
    EXPECT_NE(text.find("        LOCK := LOCK_image\n"), std::string::npos)
        << "written with the other outputs: " << text;
}

TEST(Cycle, StoredValuesReadTheValuesBeforeTheCycle) {
    HandChart hand = small_chart();
    const auto c = hand.variable("C", Chart::VariableKind::Internal, integer_type(0, 3), 1);
    const auto d = hand.variable("D", Chart::VariableKind::Internal, integer_type(0, 3), 2);
    hand.on_activation({1}, c, hand.leaf(d));
    hand.on_activation({1}, d, hand.leaf(c));
    const Network network = composed(lone_controller(hand.chart));
    NaiveTadd tadd(network);
    TaddState state = tadd.initial();
    state.variables[tadd.variable_id("a").index] = 1;
    for (int edges = 0; edges < 40 && !tadd.successors(state).front().delay(); ++edges)
        state = tadd.successors(state).front().next;
    EXPECT_EQ(tadd.variable(state, "C"), 2) << network_text(network);
    EXPECT_EQ(tadd.variable(state, "D"), 1);
    EXPECT_TRUE(network.variables[tadd.variable_id("C_old")].scratch);
}

TEST(Cycle, LateInputsAreSampledInThePhasedGrainOnly) {
    HandChart hand = small_chart();
    const auto b = hand.input("b"), lamp = hand.input("lamp");
    const auto out2 = hand.output("OUT2");
    const auto memory = hand.variable("memory", Chart::VariableKind::Internal);
    hand.while_active({1}, out2, hand.leaf(b));        // write() reads this variable
    hand.on_activation({1}, memory, hand.leaf(lamp));  // evolve() reads this variable
    const std::string text = network_text(composed(lone_controller(hand.chart)));
    EXPECT_NE(text.find("        b_sample := b\n        lamp_sample := lamp\n"), std::string::npos) << text;
    EXPECT_NE(text.find("        OUT2 := X_2 && b_sample\n        b_sample := false\n"), std::string::npos) << text;
    EXPECT_NE(text.find("        lamp_sample := false\n    procedure write\n"), std::string::npos) << text;
    EXPECT_NE(text.find("    urgent P2 -> W when !stable do b_sample := false\n"), std::string::npos) << text;
    const std::string atomic = network_text(composed(lone_controller(hand.chart), {.grain = Grain::Atomic}));
    EXPECT_EQ(atomic.find("_sample"), std::string::npos) << atomic;
}

TEST(Cycle, StoredActionReadsTheInputThatTheTransitionRead) {
    // The plant may move between the phases. The stored value is therefore that of fire(), not that of evolve().
    HandChart hand = small_chart();
    const auto memory = hand.variable("memory", Chart::VariableKind::Internal);
    hand.on_activation({1}, memory, hand.leaf({0}));
    const Network network = composed(lone_controller(hand.chart));
    NaiveTadd tadd(network);
    TaddState state = tadd.initial();
    while (!tadd.settled(state)) state = tadd.successors(state).front().next;
    state.variables[tadd.variable_id("a").index] = 1;
    state.variables[tadd.variable_id("EVOL_PL").index] = 1;
    while (tadd.location(state, "PLC") != "P1") state = tadd.successors(state).front().next;
    state.variables[tadd.variable_id("a").index] = 0;
    state = tadd.successors(state).front().next;
    EXPECT_EQ(tadd.variable(state, "X_2"), 1);
    EXPECT_EQ(tadd.variable(state, "memory"), 1);
}

TEST(Cycle, ARaceIsFlaggedAndRequested) {
    HandChart hand = small_chart();
    const auto c = hand.variable("C", Chart::VariableKind::Internal, integer_type(0, 3));
    hand.on_activation({1}, c, hand.chart.exprs.integer(1));
    EXPECT_TRUE(composed(lone_controller(hand.chart)).properties.empty()) << "one action cannot cause a race";
    hand.on_activation({1}, c, hand.chart.exprs.integer(2));
    const Network network = composed(lone_controller(hand.chart));
    ASSERT_EQ(network.properties.size(), 1U);
    EXPECT_EQ(network.properties[{0}].name, "no_race");
    EXPECT_EQ(network.properties[{0}].pattern, Pattern::Never);
    NaiveTadd tadd(network);
    TaddState state = tadd.initial();
    state.variables[tadd.variable_id("a").index] = 1;
    bool raced = false;
    for (int edges = 0; edges < 20; ++edges) {
        state = tadd.successors(state).front().next;
        raced = raced || tadd.holds(network.properties[{0}].operands[0], state);
    }
    EXPECT_TRUE(raced);
}

}  // namespace
}  // namespace grafverif
