// SPDX-License-Identifier: MIT
#include "grafverif/ir/test_sequence.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "syntax/print/test_csv.hpp"

namespace grafverif {
namespace {

/// Returns a sequence with a button, a lamp, and two steps; the second step waits.
TestSequence lamp() {
    TestSequence test;
    test.chart = "lamp";
    test.mode = ExecutionMode::EveryCycle;
    test.inputs = {{"BUTTON", {}}};
    test.outputs = {{"LAMP", {}}, {"SPEED", integer_type(0, 3)}};
    const auto rest = test.situations.add({"{0}"});
    const auto lit = test.situations.add({"{1,2}"});
    TestSequence::Sequence sequence;
    sequence.activation = TestSequence::Step{{1}, {0, 0}, 1, 0, rest};
    sequence.steps = {{{1}, {1, 2}, 2, 0, lit}, {{1}, {0, 0}, 1, 3000, rest}};
    test.sequences = {sequence};
    test.covered = test.to_cover = test.lower_bound = 2;
    test.proven_least = true;
    return test;
}

TEST(TestSequence, IsWellFormedAsMade) {
    EXPECT_EQ(verify(lamp()), std::vector<std::string>{});
    EXPECT_EQ(step_count(lamp()), 2u);
}

TEST(TestSequence, IsATableOfStepsAsCsv) {
    std::ostringstream out;
    print_test_csv(out, lamp());
    EXPECT_EQ(out.str(),
              "sequence,step,wait,cycles,BUTTON,LAMP,SPEED,situation\n"
              "1,0,,1,1,0,0,{0}\n"
              "1,1,,2,1,1,2,\"{1,2}\"\n"
              "1,2,3s,1,1,0,0,{0}\n");
}

TEST(TestSequence, AStepThatWaitsChangesNoInput) {
    TestSequence test = lamp();
    test.sequences[0].steps[1].inputs = {0};
    EXPECT_EQ(verify(test), std::vector<std::string>{"a test step both waits and changes an input"});
}

TEST(TestSequence, ALengthIsProvenLeastByItsBoundOnly) {
    TestSequence test = lamp();
    test.lower_bound = 1;
    EXPECT_EQ(verify(test),
              std::vector<std::string>{"the length is declared minimal but differs from its lower bound"});
    test.lower_bound = 3;
    test.proven_least = false;
    EXPECT_EQ(verify(test), std::vector<std::string>{"the lower bound exceeds the length"});
}

TEST(TestSequence, ValuesStayInTheRangesOfTheirVariables) {
    TestSequence test = lamp();
    test.sequences[0].steps[0].outputs = {1, 4};
    EXPECT_EQ(verify(test), std::vector<std::string>{"a value of `SPEED` is outside its range"});
}

}  // namespace
}  // namespace grafverif
