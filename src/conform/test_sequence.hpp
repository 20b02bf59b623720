// SPDX-License-Identifier: MIT
// Converts a MealyMachine to a TestSequence: a transition tour (Naito, Tsunoyama, Nagaoka 1981; JESA13 section 6) of
// minimal length.
//
// The elements to cover are arcs of a graph whose nodes are the states; a tour that traverses each of them at least
// once is a directed rural postman tour. The arcs to cover reach every state. Therefore a minimum-cost flow that
// balances incoming and outgoing arcs of each state has the minimal number of repeated arcs (Edmonds and Johnson 1973).
// An Eulerian circuit traverses all arcs. The flow proves that the length is minimal, and the tour attains it.
//
// A step of two cycles also traverses the stable transition to the same state. Such transitions need no separate step
// if the tour arrives with their inputs. If the graph is strongly connected, there is one sequence. Otherwise there are
// several, each from power-on, with minimal total length and then with the minimal number of sequences.
//
// A cover of locations repeatedly goes to the nearest state that was not visited. The result is short, but proved
// minimal only if no step is repeated.
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
    std::size_t max_input_bits = 20;        ///< for TestCover::Transitions: limit of 2^20 combinations
    std::uint64_t max_pairs = 100'000'000;  ///< for TestCover::Transitions: limit for pairs of states and combinations
};

/// Returns the sequences for `machine`, or nothing after an error: there are too many input combinations, or nothing to
/// cover. Requires verify(machine).empty().
std::optional<TestSequence> test_sequence(const MealyMachine& machine, const TestOptions& options, Span chart,
                                          Diagnostics& diagnostics);

}  // namespace grafverif
