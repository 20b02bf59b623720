// SPDX-License-Identifier: MIT
// Converts a LocationAutomaton to a MealyMachine (JESA13 section 6) symbolically. Each state has one transition per
// next state and output, labelled with a set of inputs.
//
// A chart with timers becomes a machine whose states include the elapsed times of all timers, so that its outputs are
// exact. Time passes only in `wait` transitions, each until the next timer event, from states that are stable under the
// current inputs. Cycles of the controller take no time.
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

/// Returns the machine of the automaton, or nothing if a limit was reached, which is an error. Requires
/// verify(automaton).empty().
std::optional<MealyMachine> mealy_machine(const LocationAutomaton& automaton, const MealyOptions& options,
                                          Diagnostics& diagnostics);

/// Returns the minimal equivalent machine. Equivalent states are merged (Moore 1956) and named after all their
/// situations. The result is empty after an error at `origin`: a limit was reached.
std::optional<MealyMachine> minimised(const MealyMachine& machine, const MealyOptions& options, Span origin,
                                      Diagnostics& diagnostics);

}  // namespace grafverif
