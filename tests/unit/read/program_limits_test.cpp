// SPDX-License-Identifier: MIT
// Tests PLC programs that are too large or too deep: the result is an error with its position, and the effort is
// limited.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "program_values.hpp"

namespace grafverif {
namespace {

std::string repeated(std::size_t times, const std::string& text) {
    std::string all;
    for (std::size_t k = 0; k < times; ++k) all += text;
    return all;
}

TEST(ProgramLimits, ArraysOfManyDimensionsAreRejected) {
    const auto codes = [](std::size_t dimensions) {
        return ReadProgram("PROGRAM p\nVAR a : " + repeated(dimensions, "ARRAY[0..0] OF ") +
                           "BOOL; END_VAR\nEND_PROGRAM\n")
            .codes();
    };
    EXPECT_EQ(codes(199), "");
    EXPECT_EQ(codes(201), "2:5 not-in-program\n");
    EXPECT_EQ(codes(100'000), "2:5 not-in-program\n");
    EXPECT_EQ(
        ReadProgram("PROGRAM p\nVAR a : ARRAY[0..0" + repeated(100'000, ",0..0") + "] OF BOOL; END_VAR\nEND_PROGRAM\n")
            .codes(),
        "2:5 not-in-program\n");
}

TEST(ProgramLimits, ArraysWithEqualBoundsHaveOneType) {
    std::string others;
    for (int k = 0; k < 30'000; ++k) others += fmt::format("c{0} : ARRAY[{0}..{0}] OF BOOL;\n", k);
    EXPECT_EQ(values("PROGRAM p VAR_OUTPUT n : INT; END_VAR VAR a : ARRAY[1..2] OF INT; b : ARRAY[1..2] OF INT;\n" +
                         others + "END_VAR b[2] := 3; a := b; n := a[2]; END_PROGRAM",
                     "n", {{}}),
              "3");
}

TEST(ProgramLimits, DeepCallsAreRejected) {
    const auto codes = [](std::size_t functions) {
        std::string text = "FUNCTION f0 : INT VAR_INPUT x : INT; END_VAR f0 := x + 1; END_FUNCTION\n";
        for (std::size_t k = 1; k < functions; ++k)
            text +=
                fmt::format("FUNCTION f{} : INT VAR_INPUT x : INT; END_VAR f{} := f{}(x); END_FUNCTION\n", k, k, k - 1);
        return ReadProgram(text +
                           fmt::format("PROGRAM p VAR n : INT; END_VAR n := n + f{}(n); END_PROGRAM\n", functions - 1))
            .codes();
    };
    EXPECT_EQ(codes(1000), "");
    EXPECT_EQ(codes(1001), "2:52 program-too-large\n");
    EXPECT_EQ(codes(30'000), "29001:60 program-too-large\n");
}

TEST(ProgramLimits, ManyTransitionsToOneStepAreRejected) {
    const auto codes = [](std::size_t transitions) {
        return ReadProgram("PROGRAM p VAR q : BOOL; END_VAR INITIAL_STEP S: END_STEP STEP T: END_STEP\n" +
                           repeated(transitions, "TRANSITION FROM S TO T := q; END_TRANSITION\n") +
                           "TRANSITION FROM T TO S := q; END_TRANSITION END_PROGRAM\n")
            .codes();
    };
    EXPECT_EQ(codes(20), "");
    EXPECT_NE(codes(2000).find("program-too-large"), std::string::npos);
}

}  // namespace
}  // namespace grafverif
