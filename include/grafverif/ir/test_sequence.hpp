// SPDX-License-Identifier: MIT
// TestSequence: inputs to apply to a controller and the outputs to expect, step by step (JESA13 section 6). It is
// self-contained: names, values and numbers of cycles are all that a tester needs.
//
// A sequence starts at power-on. In each step the tester lets `wait_ms` pass, the inputs of the step before being
// held; then it applies `inputs` for `cycles` scans of the controller and compares `outputs` in each of them. A scan
// reads the inputs, executes the chart as `mode` says and writes the outputs. A step that waits changes no input.
//
// `cycles` is 1 where one scan more would go on to another state (without stability search), or where the tester asked
// for one cycle each; else 2, of which the second shows that the controller stays.
//
// Without stability search the first scan after power-on clears no transition: it activates the initial steps. It is
// given as `activation`, one scan, with the inputs of step 1; it is no test step and is not counted as one.
//
// Invariants (see verify): at least one sequence, none of them empty; as many values as inputs and outputs, in their
// ranges; cycles are positive; no step that waits changes an input or is a first one; the lower bound is none above
// the length, and equals it where the length is proven least.
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
    Transitions,  ///< every transition of the Mealy machine: every combination of inputs in every state
    Evolutions,   ///< every evolution of the location automaton, each under one combination of inputs
    Locations,    ///< every location
};

struct TestSequence {
    struct Variable {
        std::string name = {};
        Type type = {};
        bool operator==(const Variable&) const = default;
    };
    struct Situation {
        std::string text = {};  ///< `{2,5}`, after the step; where several are alike `{1} or {3}`
        bool operator==(const Situation&) const = default;
    };
    struct Step {
        std::vector<std::int64_t> inputs = {};   ///< per input; Booleans 0 and 1
        std::vector<std::int64_t> outputs = {};  ///< per output: expected in every scan of the step
        std::uint32_t cycles = 1;
        std::int64_t wait_ms = 0;
        Id<Situation> situation = {};
        bool operator==(const Step&) const = default;
    };
    /// One sequence from power-on.
    struct Sequence {
        std::optional<Step> activation = {};
        std::vector<Step> steps = {};
        bool operator==(const Sequence&) const = default;
    };

    std::string chart = {};
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    TestCover cover = TestCover::Transitions;
    bool one_cycle_each = false;  ///< `--hold one`
    std::vector<Variable> inputs = {}, outputs = {};
    Table<Situation> situations = {};
    std::vector<Sequence> sequences = {};
    std::uint64_t covered = 0;      ///< transitions, evolutions or locations, as `cover` says
    std::uint64_t to_cover = 0;     ///< how many of them there are that can be reached
    std::uint64_t lower_bound = 0;  ///< no sequences that cover as much have fewer steps in all
    bool proven_least = false;

    bool operator==(const TestSequence&) const = default;
};

/// The steps of all sequences; activations are none.
std::size_t step_count(const TestSequence& test);

/// `transitions`, `evolutions`, `locations`.
std::string_view word(TestCover cover);

std::vector<std::string> verify(const TestSequence& test);

}  // namespace grafverif
