// SPDX-License-Identifier: MIT
// Converts a LocationAutomaton to a MealyMachine (JESA13 section 6) symbolically. For each pair of a next state and an
// OutputWord (one value per output), a state has at most one transition, which is labelled with a set of inputs.
//
// A chart with timers becomes a machine whose states include the elapsed times of all timers, so that the outputs of
// the machine are exact at all times. Time passes only in `wait` transitions. A `wait` transition leads from a state
// that is stable under the current inputs to the next timer event. Cycles of the controller take no time.
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
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< memory limit of decision diagrams in bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;  ///< cancellation flag, which another thread may set
};

/// Returns the machine of the automaton. If a limit is reached, reports an error and returns nullopt. Requires
/// verify(automaton).empty().
std::optional<MealyMachine> mealy_machine(const LocationAutomaton& automaton, const MealyOptions& options,
                                          Diagnostics& diagnostics);

/// Returns the minimal equivalent machine. Equivalent states are merged (Moore 1956); the name of a merged state lists
/// the situations of all these states. If a limit is reached, reports an error at `origin` and returns nullopt.
std::optional<MealyMachine> minimised(const MealyMachine& machine, const MealyOptions& options, Span origin,
                                      Diagnostics& diagnostics);

}  // namespace grafverif
