// SPDX-License-Identifier: MIT
// MealyMachine -> TestSequence: a transition tour (Naito, Tsunoyama, Nagaoka 1981; JESA13 section 6) of least length.
//
// What is to be covered are arcs of a graph whose nodes are the states; a tour that crosses each of them at least once is
// a directed rural postman's. Since the arcs to cover reach every state, the least number of arcs crossed again is that
// of a minimum-cost flow which balances what enters and leaves each state (Edmonds and Johnson 1973), and an Eulerian
// circuit crosses them all: the length is proven least by the flow, and the tour reaches it.
//
// A step that lasts two cycles crosses the stable transition to the same state besides, so such transitions cost no
// step of their own where the tour arrives with their inputs. Where every state can be reached from every other there
// is one sequence; else there are several, each from power-on, of least length in all and then as few as possible.
//
// A cover of locations is a walk to the nearest state not seen yet, again and again: short, but proven least only where
// no step is wasted.
#pragma once

#include <cstdint>
#include <optional>

#include "grafverif/ir/mealy.hpp"
#include "grafverif/ir/test_sequence.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

struct TestOptions {
    TestCover cover = TestCover::Transitions;
    bool one_cycle_each = false;
    std::size_t max_input_bits = 20;        ///< of TestCover::Transitions: 2^20 combinations
    std::uint64_t max_pairs = 100'000'000;  ///< likewise: of states and combinations
};

/// The sequences for `machine`, or nothing after an error: too many combinations of inputs, nothing to cover. Requires
/// verify(machine).empty().
std::optional<TestSequence> test_sequence(const MealyMachine& machine, const TestOptions& options, Span chart,
                                          Diagnostics& diagnostics);

}  // namespace grafverif
