// SPDX-License-Identifier: MIT
// TestSequence: inputs to apply to a controller and the expected outputs, step by step (JESA13 section 6). A
// TestSequence is self-contained: a tester does not need the chart.
//
// A sequence starts at power-on. In each step the tester lets `wait_ms` pass with the inputs of the previous step; then
// it applies `inputs` for `cycles` scans of the controller and compares the outputs of the controller with `outputs`
// after each scan. A scan reads the inputs, executes the chart in `mode` and writes the outputs. A step with a positive
// `wait_ms` changes no input.
//
// Without stability search, `cycles` is 1 if a second scan with the same inputs would lead to
// another state. `cycles` is also 1 if the user requested one cycle per step; otherwise, `cycles`
// is 2, and the second scan shows that the controller stays in its state.
//
// Without stability search the first scan after power-on clears no transition: it activates the initial steps.
// `activation` represents the first scan after power-on, which has the inputs of step 1 and does
// not count as a test step.
//
// Invariants (see verify): there is at least one sequence, and each sequence has at least one step. The numbers of
// values match the inputs and outputs, and values are in their ranges; `cycles` is positive. A step with a positive
// `wait_ms` changes no input and is not the first step of its sequence. `lower_bound` is at most the number of steps;
// the two numbers are equal if the number of steps is proved minimal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/type.hpp"
#include "grafverif/support/table.hpp"

namespace grafverif {

enum class TestCover {
    Transitions,  ///< every transition of the Mealy machine, for each input combination of the transition
    Evolutions,   ///< every evolution of the location automaton, each with one input combination
    Locations,    ///< every location of the location automaton
};

struct TestSequence {
    struct Variable {
        std::string name = {};
        Type type = {};
        bool operator==(const Variable&) const = default;
    };
    struct Situation {
        /// Situation after the step, such as `{2,5}`; several situations if equivalent states are merged: `{1} or {3}`.
        std::string text = {};
        bool operator==(const Situation&) const = default;
    };
    struct Step {
        std::vector<std::int64_t> inputs = {};   ///< value of each input; Booleans are 0 and 1
        std::vector<std::int64_t> outputs = {};  ///< value of each output that is expected in every scan of the step
        std::uint32_t cycles = 1;
        std::int64_t wait_ms = 0;
        Id<Situation> situation = {};
        bool operator==(const Step&) const = default;
    };
    /// A sequence that starts at power-on.
    struct Sequence {
        std::optional<Step> activation = {};
        std::vector<Step> steps = {};
        bool operator==(const Sequence&) const = default;
    };

    std::string chart = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    TestCover cover = TestCover::Transitions;
    bool one_cycle_each = false;  ///< true if each step is applied for one cycle (option `--hold one`)
    std::vector<Variable> inputs = {}, outputs = {};
    Table<Situation> situations = {};
    std::vector<Sequence> sequences = {};
    std::uint64_t covered = 0;      ///< number of covered transitions, evolutions or locations, depending on `cover`
    std::uint64_t to_cover = 0;     ///< number of reachable transitions, evolutions or locations
    std::uint64_t lower_bound = 0;  ///< lower bound of the total number of steps that the coverage `cover` requires
    bool proven_least = false;

    bool operator==(const TestSequence&) const = default;
};

/// Returns the number of steps of all sequences, without activations.
std::size_t step_count(const TestSequence& test);

/// Returns `transitions`, `evolutions` or `locations`.
std::string_view word(TestCover cover);

std::vector<std::string> verify(const TestSequence& test);

}  // namespace grafverif
