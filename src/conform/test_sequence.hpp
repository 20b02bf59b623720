// SPDX-License-Identifier: MIT
// Converts a MealyMachine to a TestSequence: a transition tour (Naito, Tsunoyama, Nagaoka 1981; JESA13 section 6). For
// a cover of transitions or evolutions, the length of the tour is minimal.
//
// The transitions or evolutions to cover are arcs of a graph whose nodes are the states. A shortest tour that traverses
// each of these arcs at least once solves a directed rural postman problem. Every state is reachable from the initial
// state by arcs that the tour must cover. Therefore, a minimum-cost flow that balances incoming and outgoing arcs of
// each state determines the minimal number of repeated arcs (Edmonds and Johnson 1973). An Eulerian circuit of the
// balanced graph traverses all arcs. The flow gives a lower bound of the length, and the circuit attains this bound.
//
// A test step of two cycles also traverses a second, stable transition, which stays in the reached state. A stable
// transition needs no separate step if the tour arrives in its state with the inputs of this transition. If the graph
// is strongly connected, the test has one sequence. Otherwise, the test may have several sequences, each starting at
// power-on. The total length of the sequences is minimal, and among all solutions of this length, the number of
// sequences is minimal.
//
// For a cover of locations, the tour repeatedly goes to the nearest unvisited state. The resulting tour is short, but
// it is proved to be minimal only if it repeats no step.
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
    std::size_t max_input_bits = 20;        ///< for TestCover::Transitions: maximum number of bits of all inputs
    std::uint64_t max_pairs = 100'000'000;  ///< for TestCover::Transitions: maximum number of pairs of a state and an
                                            ///< input combination
};

/// Returns the sequences for `machine`. If there are too many input combinations, or no transition, evolution or
/// location to cover, reports an error and returns nullopt. Requires verify(machine).empty().
std::optional<TestSequence> test_sequence(const MealyMachine& machine, const TestOptions& options, Span chart,
                                          Diagnostics& diagnostics);

}  // namespace grafverif
