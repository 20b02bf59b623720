// SPDX-License-Identifier: MIT
// Tests timers of the controller in cases that are prone to errors.
#include <gtest/gtest.h>

#include <sstream>

#include "emit/structured_text/structured_text.hpp"
#include "support/play.hpp"
#include "support/run_structured_text.hpp"

namespace grafverif {
namespace {

std::string controller(std::string_view declarations, ExecutionMode mode, std::uint32_t max_evolutions = 1000) {
    std::ostringstream out;
    structured_text::emit(equations(declarations), {mode, max_evolutions, structured_text::Form::Text}, out);
    return std::move(out).str();
}

/// The pulse in the documentation of the method: false for 5 s, then true for one cycle, then false for 5 s again.
constexpr std::string_view pulse =
    "output L; initial step 1; step 2 { L; }\n"
    "transition a: 1 -> 2 when 5s/X1; transition b: 2 -> 1 when true;";

TEST(StructuredTextTimers, StepReactivatedWithinOneCycleRestartsItsTimer) {
    const std::string text =
        "output L; internal N: int 0..9 = 0; initial step 1 { L if N > 0; }\n"
        "step 2 { N := N + 1 on activation; }\n"
        "transition a: 1 -> 2 when 5s/X1; transition b: 2 -> 1 when true;";
    SmallPlc plc({controller(text, ExecutionMode::StabilitySearch)}, "chart");
    for (const std::int64_t now : {0, 4999, 5000, 5001, 9999, 10000}) {
        plc.call(now);
        EXPECT_EQ(plc.value("N"), now / 5000) << now;
        EXPECT_EQ(plc.value("FAULT"), 0);
        EXPECT_EQ(plc.value("X_1"), 1);
    }
}

TEST(StructuredTextTimers, WithoutStabilitySearchThePulseLastsOneCycle) {
    SmallPlc plc({controller(pulse, ExecutionMode::EveryCycle)}, "chart");
    std::string seen;
    for (const std::int64_t now : {0, 4999, 5000, 5001, 10000, 10001, 10002}) {
        plc.call(now);
        seen += plc.value("L") != 0 ? '1' : '0';
    }
    EXPECT_EQ(seen, "0010010") << "the second period of 5 s starts with the activation at 5001 ms";
}

TEST(StructuredTextTimers, ATimerDoesNotEndWithinACycleThatTakesLong) {
    const std::string text = controller("output L; initial step 1; step 2 { L; } transition a: 1 -> 2 when 5s/X1;",
                                        ExecutionMode::StabilitySearch);
    EXPECT_NE(text.find("T_X1_5s_Q := T_X1_5s_Q AND X_1;"), std::string::npos)
        << "a sampled timer output can only become false within the cycle\n"
        << text;
}

TEST(StructuredTextController, StopsAtTheBoundOfEvolutionsAndKeepsItsOutputs) {
    const std::string text =
        "input a; output L; initial step 1 { L; } step 2;\n"
        "transition t: 1 -> 2 when a; transition u: 2 -> 1 when a;";
    SmallPlc plc({controller(text, ExecutionMode::StabilitySearch, 20)}, "chart");
    plc.call(0);
    EXPECT_EQ(plc.value("L"), 1);
    plc.set("a", 1);
    plc.call(1);
    EXPECT_EQ(plc.value("FAULT"), 1);
    EXPECT_EQ(plc.value("evolutions"), 20);
    plc.set("a", 0);
    plc.call(2);
    EXPECT_EQ(plc.value("FAULT"), 1) << "the block remains in the fault state";
    EXPECT_EQ(plc.value("L"), 1);
}

TEST(StructuredTextController, ComputesNewValuesFromOldOnes) {
    const std::string text =
        "input go; output A: int 0..9, B: int 0..9; internal M: int 0..9 = 1, N: int 0..9 = 2;\n"
        "initial step 1; step 2 { M := N on activation; N := M on activation; A := M on activation; }\n"
        "transition t: 1 -> 2 when go; transition u: 2 -> 1 when !go;";
    SmallPlc plc({controller(text, ExecutionMode::StabilitySearch)}, "chart");
    plc.call(0);
    for (const int swaps : {1, 2, 3}) {
        plc.set("go", 1);
        plc.call(1);
        EXPECT_EQ(plc.value("M"), swaps % 2 == 0 ? 1 : 2);
        EXPECT_EQ(plc.value("N"), swaps % 2 == 0 ? 2 : 1);
        EXPECT_EQ(plc.value("A"), swaps % 2 == 0 ? 2 : 1);
        plc.set("go", 0);
        plc.call(2);
    }
}

}  // namespace
}  // namespace grafverif
