// SPDX-License-Identifier: MIT
// Tests PLC programs as controllers of closed loops: declaration, names, cycle, verdicts, faults and rejections.
#include <gtest/gtest.h>

#include <algorithm>

#include "grafverif/grafverif.hpp"

namespace {

using namespace grafverif;

constexpr const char* delay_program = R"(PROGRAM Delay
VAR_INPUT Key : BOOL; END_VAR
VAR_OUTPUT Lamp : BOOL; END_VAR
VAR Wait : TON; Count : INT; END_VAR
Wait(IN := Key, PT := T#30ms);
Lamp := Wait.Q;
IF Lamp THEN Count := Count + 1; END_IF;
END_PROGRAM
)";

constexpr const char* task = R"(CONFIGURATION Plc
TASK Fast(INTERVAL := T#10ms, PRIORITY := 1);
PROGRAM Main WITH Fast : Delay;
END_CONFIGURATION
)";

std::string loop_text(const std::string& controller, const std::string& properties) {
    return "program delay = \"delay.st\";\nclosed_loop lamp {\n    " + controller +
           "\n    environment Key = push_button(OUT = Key, GAP = 100ms);\n" + properties + "}\n";
}

ParseResult reading_of(const std::string& loop, const std::string& program) {
    ReadOptions options;
    options.load = [program](const std::string&, std::string&) { return std::optional(program); };
    return read_string(loop, "lamp.grafcet", options);
}

std::string diagnostics_of(const std::string& loop, const std::string& program) {
    ParseResult reading = reading_of(loop, program);
    if (reading.model) network_of(*reading.model, {0}, {}, reading.diagnostics);
    return reading.diagnostics_text();
}

Report report_of(const std::string& loop, const std::string& program, std::uint64_t states = 1'000'000) {
    ParseResult reading = reading_of(loop, program);
    EXPECT_TRUE(reading.model) << reading.diagnostics_text();
    if (!reading.model) return {};
    CheckOptions options;
    options.limits.states = states;
    const auto report = check(*reading.model, {0}, {}, options, reading.diagnostics);
    EXPECT_TRUE(report) << reading.diagnostics_text();
    return report.value_or(Report{});
}

Outcome outcome_of(const Report& report, std::string_view property) {
    for (const PropertyResult& answer : report.answers)
        if (answer.verdict.property == property) return answer.verdict.outcome;
    ADD_FAILURE() << property;
    return Outcome::Unknown;
}

TEST(ProgramLoop, TimerChangesInTheScanInWhichItsTimeHasElapsed) {
    // A change of Key is sampled within 10 ms, and the timer elapses in the third scan after this
    // sampling.
    const Report report = report_of(loop_text("controller delay every 10ms;", R"(
    property late: Key leads to Lamp || !Key within 40ms;
    property soon: Key leads to Lamp || !Key within 39ms;
    property early: Key holds at most 29ms before Lamp;
    property reached: reachable Lamp && Key;
)"),
                                    delay_program);
    EXPECT_EQ(outcome_of(report, "late"), Outcome::Holds);
    EXPECT_EQ(outcome_of(report, "soon"), Outcome::Violated);
    EXPECT_EQ(outcome_of(report, "early"), Outcome::Violated);
    EXPECT_EQ(outcome_of(report, "reached"), Outcome::Holds);
    EXPECT_EQ(report.failures, std::vector<std::string>());
}

TEST(ProgramLoop, IntervalOfTheTaskIsTheDefaultCycle) {
    const ParseResult reading = reading_of(loop_text("controller delay;", ""), std::string(delay_program) + task);
    ASSERT_TRUE(reading.model) << reading.diagnostics_text();
    const ClosedLoop::Controller& controller = *reading.model->loops[{0}].controllers.begin();
    ASSERT_TRUE(controller.cycle);
    EXPECT_EQ(controller.cycle->least_ms, 10);
    EXPECT_EQ(controller.cycle->most_ms, 10);
    EXPECT_EQ(controller.mode, ExecutionMode::EveryCycle);
    const ParseResult other =
        reading_of(loop_text("controller delay every 20ms;", ""), std::string(delay_program) + task);
    EXPECT_EQ(other.model->loops[{0}].controllers.begin()->cycle->least_ms, 20);
}

TEST(ProgramLoop, TimersRequireAFixedCycle) {
    for (const char* controller : {"controller delay;", "controller delay every 5ms..10ms;"})
        EXPECT_NE(diagnostics_of(loop_text(controller, ""), delay_program).find("[program-without-cycle]"),
                  std::string::npos)
            << controller;
}

TEST(ProgramLoop, PropertiesReadMembersWithoutRegardToCase) {
    const Report report = report_of(loop_text("controller delay every 10ms;", R"(
    property member: always Lamp implies Wait.Q;
    property qualified: always delay.WAIT.q => delay.wait.in;
)"),
                                    delay_program);
    EXPECT_EQ(outcome_of(report, "member"), Outcome::Violated);  // outputs are written after the variables have changed
    EXPECT_EQ(outcome_of(report, "qualified"), Outcome::Holds);
}

TEST(ProgramLoop, UnreadCounterDoesNotAddStates) {
    // Count takes 65,536 values, but no property reads it.
    const Report report = report_of(
        loop_text("controller delay every 10ms;", "    property both: never Lamp && !Lamp;\n"), delay_program, 3000);
    EXPECT_EQ(outcome_of(report, "both"), Outcome::Holds);
}

// Count changes in every scan: with cycle time zero, time does not advance, and no state is quiescent.
constexpr const char* counting_program = R"(PROGRAM Delay
VAR_INPUT Key : BOOL; END_VAR
VAR_OUTPUT Lamp : BOOL; END_VAR
VAR Motor : BOOL; Count : USINT; END_VAR
Motor := Key;
Lamp := Motor;
Count := Count + 1;
END_PROGRAM
)";

TEST(ProgramLoop, VerdictDoesNotDependOnOtherProperties) {
    for (const char* other : {"", "    property other: always Count >= 0;\n"}) {
        SCOPED_TRACE(other);
        const std::string reached = std::string("    property reached: reachable Motor;\n") + other;
        EXPECT_EQ(outcome_of(report_of(loop_text("controller delay;", reached), counting_program), "reached"),
                  Outcome::Violated);
        const std::string cyclic = loop_text("controller delay every 10ms;", reached);
        EXPECT_EQ(outcome_of(report_of(cyclic, counting_program), "reached"), Outcome::Holds);
        const std::string at_stable = loop_text(
            "controller delay every 10ms;", std::string("    property reached: reachable Motor at stable;\n") + other);
        EXPECT_EQ(outcome_of(report_of(at_stable, counting_program), "reached"), Outcome::Violated);
    }
}

TEST(ProgramLoop, UnknownNamesHaveThePositionOfTheLoop) {
    const std::string text = diagnostics_of(
        loop_text("controller delay every 10ms;", "    property p: always Lamb;\n    property q: never Wait.P;\n"),
        delay_program);
    EXPECT_NE(text.find("lamp.grafcet:5:24: error: unknown variable `Lamb`; did you mean `Lamp`?"), std::string::npos)
        << text;
    EXPECT_NE(text.find("lamp.grafcet:6:"), std::string::npos) << text;
}

TEST(ProgramLoop, VariableWithTheNameOfAStepIsAmbiguous) {
    const std::string chart = R"(FUNCTION_BLOCK Cell
VAR XFill : BOOL; END_VAR
INITIAL_STEP Fill: END_STEP
END_FUNCTION_BLOCK
PROGRAM Delay
VAR_INPUT Key : BOOL; END_VAR
VAR_OUTPUT Lamp, XDone : BOOL; END_VAR
VAR xfill, XIdle : BOOL; Tank : Cell; END_VAR
INITIAL_STEP Fill: Lamp(N); Work(N); END_STEP
TRANSITION FROM Fill TO Done := Key; END_TRANSITION
STEP Done: END_STEP
TRANSITION FROM Done TO Fill := NOT Key; END_TRANSITION
ACTION Work: Tank(); END_ACTION
END_PROGRAM
)";
    const std::string text = diagnostics_of(loop_text("controller delay every 10ms;", R"(
    property inner: never XFill;
    property written: never XDone;
    property member: never Tank.XFill;
    property qualified: never delay.XFill;
    property prefixed: never delay.Tank.XFill;
    property steps: reachable Fill.X && Done.X && Tank.Fill.X && XIdle;
)"),
                                            chart);
    std::size_t errors = 0;
    for (std::size_t at = text.find("[ambiguous-name]"); at != std::string::npos; ++errors)
        at = text.find("[ambiguous-name]", at + 1);
    EXPECT_EQ(errors, 5U) << text;
    EXPECT_NE(text.find("lamp.grafcet:7:29: error: `XDone` is a variable of the program and the step variable of "
                        "`Done`; rename the variable, or write `Done.X` for the step"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("or write `Tank.Fill.X` for the step"), std::string::npos) << text;
    EXPECT_EQ(text.find("lamp.grafcet:11:"), std::string::npos) << text;
}

TEST(ProgramLoop, InputsAndOutputsHaveElementaryTypes) {
    const std::string text = diagnostics_of(loop_text("controller delay every 10ms;", ""), R"(TYPE Range : STRUCT
    Low, High : INT;
END_STRUCT; END_TYPE
PROGRAM Delay
VAR_INPUT Key : BOOL; Limits : Range; END_VAR
VAR_OUTPUT Lamp : BOOL; Lamps : ARRAY[1..2] OF BOOL; END_VAR
VAR Inner : Range; END_VAR
Lamp := Key AND Limits.Low < Inner.High;
END_PROGRAM
)");
    EXPECT_NE(text.find("delay.st:5:23: error: the input `Limits.Low` is part of a structure, an array or an instance, "
                        "which is not supported in a closed loop; declare a variable of an elementary type for each "
                        "input [not-in-program]"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("delay.st:6:25: error: the output `Lamps[1]` is part of"), std::string::npos) << text;
    EXPECT_EQ(text.find("Inner"), std::string::npos) << text;
}

TEST(ProgramLoop, RunTimeFaultIsAModelErrorWithARun) {
    const Report report = report_of(loop_text("controller delay every 10ms;", R"(
    property never_lit: never Lamp;
    property safe: always Key || !Key;
)"),
                                    R"(PROGRAM Delay
VAR_INPUT Key : BOOL; END_VAR
VAR_OUTPUT Lamp : BOOL; END_VAR
VAR Count : INT := 3; Share : INT; END_VAR
IF Key THEN
    Lamp := TRUE;
    Share := 10 / Count;
    Count := Count - 1;
END_IF;
END_PROGRAM
)");
    ASSERT_EQ(report.error_traces.size(), 1U);
    EXPECT_EQ(report.error_traces.front().code, "no-value");
    EXPECT_EQ(report.error_traces.front().message, "the program divides by zero, in a scan of `delay`");
    EXPECT_FALSE(report.error_traces.front().trace.moments.empty());
    EXPECT_EQ(outcome_of(report, "never_lit"), Outcome::Violated);
    EXPECT_EQ(outcome_of(report, "safe"), Outcome::Unknown);
}

TEST(ProgramLoop, CommandsForChartsRejectPrograms) {
    ParseResult reading = reading_of(loop_text("controller delay every 10ms;", ""), delay_program);
    ASSERT_TRUE(reading.model);
    for (const bool untimed : {false, true}) {
        Diagnostics diagnostics;
        if (untimed) EXPECT_FALSE(transition_system_of(*reading.model, Id<ClosedLoop>{0}, {}, diagnostics));
        else EXPECT_FALSE(equations_of(*reading.model, {0}, diagnostics));
        ASSERT_TRUE(diagnostics.has_errors());
        EXPECT_EQ(diagnostics.all().front().code, "only-for-charts");
    }
    Diagnostics diagnostics;
    EXPECT_FALSE(network_of(*reading.model, {0}, {.mode = ExecutionMode::StabilitySearch}, diagnostics));
    EXPECT_EQ(diagnostics.all().front().code, "only-for-charts");
}

}  // namespace
