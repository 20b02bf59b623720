// SPDX-License-Identifier: MIT
// Converts Equations to a LocationAutomaton by JESA13 Algorithms 3 to 5, for both execution modes.
//
// Conditions are decision diagrams over the inputs. In a location, every variable of the chart is constant, so that a
// firing condition is a function of the inputs. The sets of simultaneously firable transitions (JESA13 (11) to (13))
// are the satisfiable classes of the partition of the inputs by these functions. Individual valuations of the inputs
// are never enumerated.
//
// With stability search, JESA13's Algorithm 6 is replaced by an algorithm that always terminates. Each class is
// followed from a stable location through transient situations, restricted to the inputs with the same path, until the
// situation is stable. If a path revisits one of its situations, its inputs never result in a stable situation: total
// instability.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/location_automaton.hpp"
#include "grafverif/support/diagnostic.hpp"

namespace grafverif {

struct ConformProgress {
    std::uint64_t locations = 0;  ///< number of known locations
    std::uint64_t done = 0;       ///< number of locations with known evolutions
    std::uint64_t evolutions = 0;
};

struct AutomatonOptions {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::uint64_t max_locations = 20'000'000;
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< memory limit of decision diagrams in bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;  ///< cancellation flag, which another thread may set
    /// True if the search returns an incomplete automaton when a limit, the deadline or `stop` ends the search. The
    /// member `complete` of this automaton is then false.
    bool partial = false;
    std::function<void(const ConformProgress&)> progress = {};  ///< called periodically
};

/// Returns the automaton of the chart, or nothing after at least one error. Errors are: no inputs, no outputs,
/// constraints that exclude every input, and an initial situation that never becomes stable. Further errors are two
/// actions that store different values simultaneously, a value that is undefined or out of range, and a reached limit.
/// Requires verify(equations).empty().
std::optional<LocationAutomaton> location_automaton(const Equations& equations, const AutomatonOptions& options,
                                                    Diagnostics& diagnostics);

}  // namespace grafverif
