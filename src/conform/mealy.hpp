// SPDX-License-Identifier: MIT
// LocationAutomaton -> MealyMachine (JESA13 section 6), symbolically: one transition per next state and answer, under a
// set of inputs.
//
// A chart with timers becomes a machine that knows how long each timer has been running, so that what it answers is
// exact: time passes in `wait` transitions alone, each until the next timer ends, and from states that are stable under
// the inputs held. The cycles of the controller take no time.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>

#include "grafverif/ir/location_automaton.hpp"
#include "grafverif/ir/mealy.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

struct MealyOptions {
    std::uint64_t max_states = 20'000'000;
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< bytes of decision diagrams
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;  ///< set by somebody else
};

/// The machine of the automaton, or nothing after an error: a limit. Requires verify(automaton).empty().
std::optional<MealyMachine> mealy_machine(const LocationAutomaton& automaton, const MealyOptions& options,
                                          Diagnostics& diagnostics);

/// The least machine that gives the same answers to the same inputs from its initial state: states that nobody can tell
/// apart become one (Moore 1956), named after the situations of all of them. Nothing after an error at `origin`: a limit.
std::optional<MealyMachine> minimised(const MealyMachine& machine, const MealyOptions& options, Span origin,
                                      Diagnostics& diagnostics);

}  // namespace grafverif
