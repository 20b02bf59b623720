// SPDX-License-Identifier: MIT
#include "grafverif/ir/test_sequence.hpp"

#include "support/overloaded.hpp"

namespace grafverif {

using Step = TestSequence::Step;

namespace {

struct TestSequenceCheck {
    const TestSequence& test;
    std::vector<std::string> faults = {};

    void fault(std::string text) { faults.push_back(std::move(text)); }

    void values(const std::vector<std::int64_t>& values, const std::vector<TestSequence::Variable>& variables) {
        if (values.size() != variables.size()) return fault("a step does not have exactly one value per variable");
        for (std::size_t k = 0; k < values.size(); ++k)
            if (values[k] < variables[k].type.low || values[k] > variables[k].type.high)
                fault("a value of `" + variables[k].name + "` is outside its range");
    }

    void step(const Step& step) {
        values(step.inputs, test.inputs);
        values(step.outputs, test.outputs);
        if (step.cycles == 0) fault("a step has no cycle");
        if (step.wait_ms < 0) fault("a step waits for a negative time");
        if (!test.situations.contains(step.situation)) fault("a step has no situation");
    }

    void sequence(const TestSequence::Sequence& sequence) {
        if (sequence.steps.empty()) return fault("a sequence has no steps");
        if (sequence.activation) {
            step(*sequence.activation);
            if (sequence.activation->inputs != sequence.steps.front().inputs)
                fault("the inputs of an activation differ from the inputs of the first step");
            if (sequence.activation->cycles != 1) fault("an activation does not last exactly one scan");
        }
        if (sequence.steps.front().wait_ms != 0) fault("the first step of a sequence waits");
        const Step* before = nullptr;
        for (const Step& now : sequence.steps) {
            step(now);
            if (before != nullptr && now.wait_ms != 0 && now.inputs != before->inputs)
                fault("a test step both waits and changes an input");
            before = &now;
        }
    }
};

}  // namespace

std::size_t step_count(const TestSequence& test) {
    std::size_t count = 0;
    for (const TestSequence::Sequence& sequence : test.sequences) count += sequence.steps.size();
    return count;
}

std::string_view word(TestCover cover) {
    switch (cover) {
    case TestCover::Transitions: return "transitions";
    case TestCover::Evolutions: return "evolutions";
    case TestCover::Locations: return "locations";
    }
    unreachable();
}

std::vector<std::string> verify(const TestSequence& test) {
    TestSequenceCheck check{test};
    if (test.sequences.empty()) check.fault("the test has no sequence");
    for (const TestSequence::Sequence& sequence : test.sequences) check.sequence(sequence);
    if (test.covered > test.to_cover)
        check.fault("the number of covered elements exceeds the number of elements to cover");
    if (test.lower_bound > step_count(test)) check.fault("the lower bound exceeds the length");
    if (test.proven_least && test.lower_bound != step_count(test))
        check.fault("the length is declared minimal but differs from its lower bound");
    return std::move(check.faults);
}

}  // namespace grafverif
