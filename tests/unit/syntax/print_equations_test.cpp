// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "support/play.hpp"
#include "syntax/print/equations.hpp"

namespace grafverif {
namespace {

template <class Printer>
std::string printed(const Equations& equations, Printer printer) {
    std::ostringstream out;
    printer(out, equations);
    return out.str();
}

// The chart of CEP13 Fig. 15.
const char* const testing_station = R"(
    input START, H_IN, H_MID, H_OUT, V_IN, V_OUT, TEST_OK, TEST_KO;
    output TEST, P, V_G_OUT, V_G_IN, H_G_OUT, H_G_IN;
    initial step 0;
    step 1 { V_G_OUT; }
    step 2 { P; }
    step 3 { P; V_G_IN; }
    step 4 { P; H_G_OUT; }
    step 5 { P; V_G_OUT; }
    step 6 { TEST; P; }
    step 10;
    step 11 { V_G_IN; }
    step 12 { H_G_IN; }
    step 20 { P; V_G_IN; }
    step 21 { P; H_G_OUT; }
    step 22;
    step 23 { H_G_IN; }
    transition T0: 0 -> 1 when START;
    transition T1: 1 -> 2 when V_OUT;
    transition T2: 2 -> 3 when 3s/X2;
    transition T3: 3 -> 4 when V_IN;
    transition T4: 4 -> 5 when H_MID;
    transition T5: 5 -> 6 when V_OUT;
    transition T6a: 6 -> 10 when TEST_OK;
    transition T6b: 6 -> 20 when TEST_KO;
    transition T10: 10 -> 11 when 5s/X10;
    transition T11: 11 -> 12 when V_IN;
    transition T12: 12 -> 0 when H_IN;
    transition T20: 20 -> 21 when V_IN;
    transition T21: 21 -> 22 when H_OUT;
    transition T22: 22 -> 23 when 5s/X22;
    transition T23: 23 -> 0 when H_IN;
)";

TEST(PrintEquations, ReproduceFigure19OfThePaper) {
    EXPECT_EQ(printed(equations(testing_station), print_equations), R"(Equations of chart

(a) Firing conditions
CF_T0 = X_0 and START
CF_T1 = X_1 and V_OUT
CF_T2 = X_2 and T_X2_3s_Q
CF_T3 = X_3 and V_IN
CF_T4 = X_4 and H_MID
CF_T5 = X_5 and V_OUT
CF_T6a = X_6 and TEST_OK
CF_T6b = X_6 and TEST_KO
CF_T10 = X_10 and T_X10_5s_Q
CF_T11 = X_11 and V_IN
CF_T12 = X_12 and H_IN
CF_T20 = X_20 and V_IN
CF_T21 = X_21 and H_OUT
CF_T22 = X_22 and T_X22_5s_Q
CF_T23 = X_23 and H_IN

(b) Step activities
X_0 = CF_T12 or CF_T23 or (X_0 and not CF_T0)
X_1 = CF_T0 or (X_1 and not CF_T1)
X_2 = CF_T1 or (X_2 and not CF_T2)
X_3 = CF_T2 or (X_3 and not CF_T3)
X_4 = CF_T3 or (X_4 and not CF_T4)
X_5 = CF_T4 or (X_5 and not CF_T5)
X_6 = CF_T5 or (X_6 and not (CF_T6a or CF_T6b))
X_10 = CF_T6a or (X_10 and not CF_T10)
X_11 = CF_T10 or (X_11 and not CF_T11)
X_12 = CF_T11 or (X_12 and not CF_T12)
X_20 = CF_T6b or (X_20 and not CF_T20)
X_21 = CF_T20 or (X_21 and not CF_T21)
X_22 = CF_T21 or (X_22 and not CF_T22)
X_23 = CF_T22 or (X_23 and not CF_T23)

(c) Output values
T_X2_3s = X_2
T_X10_5s = X_10
T_X22_5s = X_22
TEST = X_6
P = X_2 or X_3 or X_4 or X_5 or X_6 or X_20 or X_21
V_G_OUT = X_1 or X_5
V_G_IN = X_3 or X_11 or X_20
H_G_OUT = X_4 or X_21
H_G_IN = X_12 or X_23
)");
}

const char* const counter = R"(
    input a; output LOCK, O; internal N: int 0..9 = 0;
    initial step 1 { N := 1 on activation; O if N > 0; }
    step 2 { LOCK := true on activation; LOCK := false on deactivation; N := N + 1 on activation; }
    transition t0: 1 -> 2 when a;
    transition t1: 2 -> 1 when 500ms/X2;
)";

TEST(PrintEquations, HaveASectionForStoredActions) {
    EXPECT_EQ(printed(equations(counter), print_equations), R"(Equations of chart

(a) Firing conditions
CF_t0 = X_1 and a
CF_t1 = X_2 and T_X2_500ms_Q

(b) Step activities
X_1 = CF_t1 or (X_1 and not CF_t0)
X_2 = CF_t0 or (X_2 and not CF_t1)

(s) Stored actions
LOCK = (CF_t0 and not X_2) or (LOCK and not (X_2 and CF_t1 and not CF_t0))
N = CF_t1 and not X_1 ? 1 : CF_t0 and not X_2 ? N + 1 : N

(s) Stored actions, first evolution
N = 1

(s) Stored actions, races: two actions would store different values
N = CF_t1 and not X_1 and CF_t0 and not X_2 and 1 != N + 1

(c) Output values
T_X2_500ms = X_2
O = X_1 and N > 0
)");
}

TEST(PrintEquations, InLatexAreAlignedBlocksWithEscapedNames) {
    const std::string text = printed(equations(counter), print_equations_latex);
    EXPECT_NE(text.find("\\noindent (a) Firing conditions\n\\begin{align*}\n"
                        "  \\mathit{CF}_{\\mathit{t0}} &= X_{1} \\wedge \\mathit{a} \\\\\n"
                        "  \\mathit{CF}_{\\mathit{t1}} &= X_{2} \\wedge \\mathit{T\\_X2\\_500ms\\_Q}\n"
                        "\\end{align*}\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("\\neg"), std::string::npos);
}

TEST(PrintEquations, InJsonHaveOneMemberPerSection) {
    const auto json = nlohmann::json::parse(printed(equations(counter), print_equations_json));
    EXPECT_EQ(json["name"], "chart");
    EXPECT_EQ(json["firing_conditions"][1]["transition"], "t1");
    EXPECT_EQ(json["firing_conditions"][1]["equation"], "X_2 and T_X2_500ms_Q");
    EXPECT_EQ(json["steps"][0]["step"], "1");
    EXPECT_EQ(json["steps"][0]["initial"], true);
    EXPECT_EQ(json["stored"][1]["first"], "1");
    EXPECT_EQ(json["timers"][0]["rise_ms"], 500);
    EXPECT_EQ(json["timers"][0]["equation"], "X_2");
    EXPECT_EQ(json["outputs"][0]["equation"], "X_1 and N > 0");
}

}  // namespace
}  // namespace grafverif
