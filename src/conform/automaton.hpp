// SPDX-License-Identifier: MIT
// Converts Equations to a LocationAutomaton by JESA13 Algorithms 3 to 5, for both execution modes.
//
// Conditions are represented by decision diagrams over the inputs. In a location, every variable of the chart is
// constant, so that a firing condition is a function of the inputs. The firing conditions partition the inputs into
// classes; for all inputs of a class, the same set of transitions is simultaneously fireable (JESA13 (11) to (13)).
// Only non-empty classes are considered. Individual valuations of the inputs are never enumerated.
//
// With stability search, JESA13's Algorithm 6 is replaced by an algorithm that always terminates. From a stable
// location, the algorithm follows each class of inputs through transient situations until the situation is stable. A
// class is split if its inputs lead to different situations. If a path revisits one of its situations, the inputs of
// the path never lead to a stable situation (total instability).
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
    /// Cancellation flag, which another thread may set.
    const std::atomic<bool>* stop = nullptr;
    /// Determines the result if a limit, the deadline or `stop` ends the search. True: an incomplete automaton, whose
    /// member `complete` is false. False: an error.
    bool partial = false;
    std::function<void(const ConformProgress&)> progress = {};  ///< called periodically
};

/// Returns the automaton of the chart, or nullopt after at least one reported error. The function reports an error if
/// the chart has no inputs or no outputs, if its constraints exclude every input, or if the initial situation never
/// becomes stable. Further errors are a race of two actions, an undefined or out-of-range value, and (unless `partial`
/// is true) a limit that is reached. Requires verify(equations).empty().
std::optional<LocationAutomaton> location_automaton(const Equations& equations, const AutomatonOptions& options,
                                                    Diagnostics& diagnostics);

}  // namespace grafverif
