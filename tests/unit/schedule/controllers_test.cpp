// SPDX-License-Identifier: MIT
// Tests the controllers of a loop and its properties as one transition system.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "derive/derive.hpp"
#include "emit/nusmv/nusmv.hpp"
#include "read/text.hpp"
#include "schedule/controller.hpp"
#include "support/run_transition_system.hpp"

namespace grafverif {
namespace {

/// Returns the system of the only loop of `text`. Fails the test, with the rendered diagnostics, if the loop is
/// invalid.
TransitionSystem scheduled(const std::string& text, const ScheduleOptions& options = {}) {
    Diagnostics diagnostics;
    Sources sources;
    const Id<Source> file = sources.add({"loop.grafcet", text});
    const auto model = read_text(file, sources, {}, diagnostics);
    std::vector<Equations> equations;
    if (model)
        for (const ClosedLoop::Controller& controller : model->loops[{0}].controllers)
            equations.push_back(derive(model->charts[controller.chart], diagnostics).value());
    std::ostringstream rendered;
    render_text(diagnostics.all(), sources, Colour::Plain, rendered);
    EXPECT_EQ(rendered.str(), "");
    TransitionSystem system = schedule_controllers(model.value(), model->loops[{0}], equations, options);
    EXPECT_EQ(verify(system), std::vector<std::string>{});
    return system;
}

std::string emitted(const TransitionSystem& system) {
    std::ostringstream out;
    nusmv::emit(system, out);
    return out.str();
}

void expect_line(const std::string& text, const std::string& line) {
    EXPECT_NE(text.find("\n" + line + "\n"), std::string::npos) << "no line `" << line << "` in:\n" << text;
}

const std::string free_switch =
    "component toggle(output OUT) { initial location l; timed l -> l do OUT := !OUT; }\n"
    "component lamp(input IN; output N: int 0..3) { initial location off; location on; urgent off -> on when IN do N "
    ":= 3; }\n";

std::string press(const std::string& properties) {
    return free_switch +
           "grafcet press { input a; output LAMP; internal n: int 0..3 = 0; initial step 0; step 1 { LAMP; n := 1 on "
           "activation; }"
           "  partial G { initial step 5; }"
           "  transition t0: 0 -> 1 when a; transition t1: 1 -> 0 when 2s/X1; }\n"
           "closed_loop cell { controller press with stability_search;"
           "  plant lamp_1 = lamp(IN = LAMP, N = level); environment button = toggle(OUT = a);\n" +
           properties + "}\n";
}

TEST(ScheduleControllers, TranslatesPropertiesOverInputsOutputsInternalsAndSteps) {
    const std::string text =
        emitted(scheduled(press("property P1: never a && LAMP; property P2: X1 leads to n == 1 && G.X5;"
                                "property P3: always possible X0 at stable;"
                                "property P4: exactly one of {X0, X1};")));
    expect_line(text, "INVARSPEC NAME P1 := !(a & press.LAMP);");
    expect_line(text, "SPEC NAME P2 := AG (press.X_1 -> AF (press.n = 1 & press.X_G_5));");
    expect_line(text, "SPEC NAME P3 := AG EF (press.settled & press.X_0);");
    expect_line(text, "INVARSPEC NAME P4 := count(press.X_0, press.X_1) = 1;");
}

TEST(ScheduleControllers, OmitsPropertiesThatNeedThePlantWithAReason) {
    struct Case {
        const char* property;
        const char* reason;
    };
    const Case cases[] = {
        {"property P: never level == 3;", "`level` is a variable of the plant, which this model omits"},
        {"property P: never X0 && lamp_1.on;", "`lamp_1.on` is a location of the plant, which this model omits"},
        {"property P: no deadlock;",
         "the transition relation of this model is total, even if the closed loop can deadlock"},
        {"property P: no timelock;", "this model has no time"},
        {"property P: uppaal \"A[] true\";", "UPPAAL formulas require UPPAAL"},
    };
    for (const Case& one : cases) {
        SCOPED_TRACE(one.property);
        const TransitionSystem system = scheduled(press(one.property));
        EXPECT_TRUE(system.properties.empty());
        ASSERT_EQ(system.omitted.size(), 1U);
        EXPECT_EQ(system.omitted[0].reason, one.reason);
        expect_line(emitted(system), std::string("-- omitted: ") + one.reason);
    }
}

TEST(ScheduleControllers, KeepsTheOrderOfPropertiesAndOfOmittedOnes) {
    const TransitionSystem system =
        scheduled(press("property PA: always X0; property PB: no deadlock; property PC: always X0;"));
    EXPECT_EQ(system.omitted[0].before, 1U);
    const std::string text = emitted(system);
    EXPECT_LT(text.find("NAME PA :="), text.find("-- PB"));
    EXPECT_LT(text.find("-- PB"), text.find("NAME PC :="));
}

TEST(ScheduleControllers, HasAPropertyForEachStep) {
    const std::string text = emitted(scheduled(press("property all: reachable all steps;")));
    expect_line(text, "INVARSPEC NAME never_all_X0 := !press.X_0;");
    expect_line(text, "INVARSPEC NAME never_all_X1 := !press.X_1;");
    expect_line(text, "INVARSPEC NAME never_all_G_X5 := !press.X_G_5;");
}

TEST(ScheduleControllers, PassesNativeFormulasThrough) {
    const std::string text =
        emitted(scheduled(press("property C1: ctl \"AG EF press.X_0\"; property L1: ltl \"G F press.X_0\";")));
    expect_line(text, "SPEC NAME C1 := AG EF press.X_0;");
    expect_line(text, "LTLSPEC NAME L1 := G F press.X_0;");
}

TEST(ScheduleControllers, UsesTheModeOfTheLoopByDefault) {
    EXPECT_NE(emitted(scheduled(press(""))).find("next(LAMP) := (stable ? LAMP_now : LAMP);"), std::string::npos);
    const std::string cyclic = emitted(scheduled(press(""), {ExecutionMode::EveryCycle}));
    expect_line(cyclic, "  LAMP := X_1;");
}

std::string two(const std::string& properties) {
    return free_switch +
           "grafcet one { input a, b; output LAMP; initial step 0; step 1 { LAMP; } transition t0: 0 -> 1 when a; "
           "transition t1: 1 -> 0 when b; }\n"
           "grafcet two { input LAMP, b; output P; initial step 0; step 1 { P; } transition t0: 0 -> 1 when LAMP && "
           "1s/X0; transition t1: 1 -> 0 when b; }\n"
           "closed_loop pair { controller one with every_cycle; controller two with every_cycle;"
           "  environment a_1 = toggle(OUT = a); environment b_1 = toggle(OUT = b);\n" +
           properties + "}\n";
}

TEST(ScheduleControllers, WiresSeveralControllersAndGivesEachATurn) {
    const TransitionSystem system = scheduled(two("property P: never one.X1 && two.X1;"));
    const std::string text = emitted(system);
    expect_line(text, "  one : controller_one(a, b, turn_one);");
    expect_line(text, "  two : controller_two(one.LAMP, b, two_T_X0_1s_Q, turn_two);");
    expect_line(text, "JUSTICE turn_one;");
    expect_line(text, "JUSTICE turn_two;");
    expect_line(text, "INVARSPEC NAME P := !(one.X_1 & two.X_1);");
}

TEST(ScheduleControllers, LetsAControllerRunAheadOfTheOther) {
    const TransitionSystem system = scheduled(two(""));
    const auto least = [](std::string_view, Type type) { return type.low; };
    SystemState state = first_state(system, least);
    const auto step = [&](bool first, bool second) {
        set_value(system, state, "a", 1);
        set_value(system, state, "two_T_X0_1s_Q", 1);
        set_value(system, state, "turn_one", first);
        set_value(system, state, "turn_two", second);
        state = next_state(system, state, least);
    };
    step(false, true);
    EXPECT_EQ(value_of(system, state, "one.X_0"), 1) << "the controller is not selected";
    EXPECT_EQ(value_of(system, state, "two.X_0"), 1) << "LAMP was not yet written";
    step(true, true);
    EXPECT_EQ(value_of(system, state, "one.X_1"), 1);
    EXPECT_EQ(value_of(system, state, "two.X_0"), 1);
    step(false, true);
    EXPECT_EQ(value_of(system, state, "two.X_1"), 1);
}

TEST(ScheduleControllers, SystemIsQuiescentIfEachControllerIs) {
    const TransitionSystem system = scheduled(two(""));
    const auto least = [](std::string_view, Type type) { return type.low; };
    SystemState state = first_state(system, least);
    EXPECT_EQ(value_of(system, state, system.settled), 1);
    set_value(system, state, "a", 1);
    EXPECT_EQ(value_of(system, state, system.settled), 0);
}

/// DESDES06 section 6.1 writes the controller of its assembly station in this way, with X_1 for X1 and CF_t1 for CC1.
TEST(ScheduleControllers, WritesTheAssemblyStationAsThePaperDoes) {
    const std::string text = emitted(scheduled(
        "component toggle(output OUT) { initial location l; timed l -> l do OUT := !OUT; }\n"
        "grafcet assembly {\n"
        "  input p_a_s, p_s, p_g, v_c_d, v_c_u, h_c_l, h_c_r, ason; output R_P, D_V_C, L_H_C, R_H_C, ASP;\n"
        "  initial step 1; step 2; step 3; step 4; step 5 { D_V_C; } step 6 { D_V_C; ASP; } step 7 { ASP; } step 8 { "
        "ASP; L_H_C; }\n"
        "  step 9 { ASP; D_V_C; } step 10; step 11; step 12 { R_H_C; } initial step 13; step 14 { R_P; }\n"
        "  transition t1: 1 -> 2, 3 when p_a_s; transition t2: 3 -> 4 when p_s; transition t3: 4, 13 -> 5 when p_g;\n"
        "  transition t4: 5 -> 6 when v_c_d; transition t5: 6 -> 7 when ason; transition t6: 7 -> 8 when v_c_u;\n"
        "  transition t7: 8 -> 9 when h_c_l; transition t8: 9 -> 10 when v_c_d; transition t9: 10 -> 11, 12 when "
        "v_c_u;\n"
        "  transition t10: 12 -> 13 when h_c_r; transition t11: 2, 11 -> 14 when true; transition t12: 14 -> 1 when "
        "!p_a_s;\n"
        "}\n"
        "closed_loop station { controller assembly with every_cycle;"
        "  environment e1 = toggle(OUT = p_a_s); environment e2 = toggle(OUT = p_s); environment e3 = toggle(OUT = "
        "p_g);"
        "  environment e4 = toggle(OUT = v_c_d); environment e5 = toggle(OUT = v_c_u); environment e6 = toggle(OUT = "
        "h_c_l);"
        "  environment e7 = toggle(OUT = h_c_r); environment e8 = toggle(OUT = ason);"
        "  property PROP_R_1: reachable all steps; property PROP1: never L_H_C && R_H_C;"
        "  property PROP4: always !D_V_C || h_c_l && !h_c_r && !R_H_C || !h_c_l && h_c_r && !L_H_C; }\n"));
    expect_line(text, "MODULE controller_assembly(p_a_s, p_s, p_g, v_c_d, v_c_u, h_c_l, h_c_r, ason)");
    expect_line(text, "  X_1 : boolean;");
    expect_line(text, "  init(X_1) := TRUE;");
    expect_line(text, "  init(X_14) := FALSE;");
    expect_line(text, "  next(X_1) := CF_t12 | (X_1 & !CF_t1);");
    expect_line(text, "  next(X_5) := CF_t3 | (X_5 & !CF_t4);");
    expect_line(text, "  CF_t1 := X_1 & p_a_s;");
    expect_line(text, "  CF_t3 := X_4 & X_13 & p_g;");
    expect_line(text, "  CF_t12 := X_14 & !p_a_s;");
    expect_line(text, "  D_V_C := X_5 | X_6 | X_9;");
    expect_line(text, "  ASP := X_6 | X_7 | X_8 | X_9;");
    expect_line(text, "INVARSPEC NAME never_PROP_R_1_X14 := !assembly.X_14;");
    expect_line(text, "INVARSPEC NAME PROP1 := !(assembly.L_H_C & assembly.R_H_C);");
}

}  // namespace
}  // namespace grafverif
