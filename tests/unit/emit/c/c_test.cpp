// SPDX-License-Identifier: MIT
// Tests controllers in C: the complete text of a small chart, names, and rejected charts.
#include "emit/c/c.hpp"

#include <gtest/gtest.h>

#include "support/messages.hpp"
#include "support/play.hpp"

namespace grafverif {
namespace {

controller::Code code(std::string_view declarations, ExecutionMode mode) {
    return controller::code_of(equations(declarations), {mode, 1000}, Target::C);
}

constexpr std::string_view lamp =
    "input go, level: int 0..7; output L; initial step 0; step 1 { L if level < 3; }\n"
    "transition a: 0 -> 1 when go && 3s/X0; transition b: 1 -> 0 when !go;";

TEST(CCode, HeaderDeclaresInputsStateAndFunctions) {
    const std::string header = c::header_of(code(lamp, ExecutionMode::StabilitySearch));
    for (const char* part : {
             "static const uint32_t chart_MAX_EVOLUTIONS = 1000U;\n",
             "typedef struct {\n    bool go;\n    int32_t level;  /* 0 to 7 */\n} chart_inputs;\n",
             "typedef struct {\n    /* outputs */\n    bool L;\n    int16_t FAULT;",
             "    struct chart_timer T_X0_3s;\n",
             "void chart_init(chart_state *self);\n",
             "void chart_scan(chart_state *self, const chart_inputs *in, uint32_t elapsed_ms);\n",
         })
        EXPECT_NE(header.find(part), std::string::npos) << part << "\nis missing in\n" << header;
}

TEST(CCode, StatementsAreThoseOfStructuredText) {
    const std::string source = c::source_of(code(lamp, ExecutionMode::EveryCycle), "lamp.h");
    EXPECT_TRUE(source.starts_with("#include \"lamp.h\"\n\n")) << source;
    for (const char* part : {
             "    if (self->FAULT != 0) {\n        return;\n    }\n",
             "    chart_ton(&self->T_X0_3s, self->X_0, 3000U);\n    self->T_X0_3s_Q = self->T_X0_3s.q;\n",
             "        self->CF_b = self->X_1 && !in->go;\n",
             "    if (self->FAULT == 0) {\n        /* outputs */\n        self->L = self->X_1 && in->level < 3;\n    "
             "}\n",
         })
        EXPECT_NE(source.find(part), std::string::npos) << part << "\nis missing in\n" << source;
}

TEST(CCode, NegationsAndComparisonsHaveBrackets) {
    const std::string source =
        c::source_of(code("input a, b, c; output L; initial step 0 { L if !(a == b) || (!a == c) && !(b && c); }",
                          ExecutionMode::EveryCycle),
                     "");
    EXPECT_NE(source.find("!(in->a == in->b) || ((!in->a) == in->c && !(in->b && in->c))"), std::string::npos)
        << source;
}

TEST(CCode, KeywordsAndMacrosAreRenamed) {
    const controller::Code made = code(
        "input int32_t, UINT_FAST8_MAX, register, _A, a__b; output errno, ON; initial step 0 { errno; ON if "
        "register; }",
        ExecutionMode::EveryCycle);
    EXPECT_NE(made.comment.find("int32_t is int32_t_2\n"), std::string::npos) << made.comment;
    EXPECT_NE(made.comment.find("UINT_FAST8_MAX is UINT_FAST8_MAX_2\n"), std::string::npos) << made.comment;
    EXPECT_NE(made.comment.find("register is register_2\n"), std::string::npos) << made.comment;
    EXPECT_NE(made.comment.find("_A is v_A\n"), std::string::npos) << made.comment;
    EXPECT_NE(made.comment.find("a__b is a_b\n"), std::string::npos) << made.comment;
    EXPECT_NE(made.comment.find("errno is errno_2\n"), std::string::npos) << made.comment;
    const std::string header = c::header_of(made);
    EXPECT_NE(header.find("    bool ON;\n"), std::string::npos) << header;
}

TEST(CCode, ChartWithoutInputsHasAStructWithOneMember) {
    const controller::Code made = code("output L; initial step 0 { L; }", ExecutionMode::EveryCycle);
    EXPECT_NE(c::header_of(made).find("bool unused;"), std::string::npos);
    EXPECT_NE(c::source_of(made, "").find("    (void)in;\n    (void)elapsed_ms;\n"), std::string::npos);
}

void expect_rejected(const std::string& value, const std::string& reason) {
    Diagnostics diagnostics;
    const Equations found = equations(
        "input level: int -32768..7; output L; internal N: int 0..7 = 1; initial step 0 { L; }\n"
        "step 1 { N := " +
        value + " on activation; } transition a: 0 -> 1 when true;");
    EXPECT_FALSE(controller::expressible(found, messages::not_in_c, diagnostics)) << value;
    ASSERT_FALSE(diagnostics.all().empty());
    EXPECT_EQ(diagnostics.all()[0].code, "not-in-c");
    EXPECT_TRUE(diagnostics.all()[0].message.starts_with(reason + " cannot be translated"))
        << diagnostics.all()[0].message;
}

TEST(CCode, UndefinedOperationsAreRejected) {
    expect_rejected("N / level", "a division by a variable");
    expect_rejected("level * 32768 * 2 / -1", "a value that may need more than 32 bits");
    expect_rejected("level * 32768 * 2 % -1", "a remainder of a division by -1");
}

}  // namespace
}  // namespace grafverif
