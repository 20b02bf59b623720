// SPDX-License-Identifier: MIT
// Equations -> LocationAutomaton: JESA13 Algorithms 3 to 5, for both execution modes.
//
// Conditions are decision diagrams over the inputs. In a location every variable of the chart is a constant, so a firing
// condition becomes a function of the inputs; the sets of simultaneously firable transitions (JESA13 (11) to (13)) are
// the satisfiable cells that these functions cut the inputs into, and no input is ever looked at by itself.
//
// With stability search JESA13's Algorithm 6 is replaced by one that ends: from a stable location each cell is followed
// through the situations it crosses, shrinking to the inputs that take the same path, until it is stable. Inputs that come
// to a situation of their own path again never stabilise: total instability.
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
    std::uint64_t locations = 0;  ///< found
    std::uint64_t done = 0;       ///< of them, whose evolutions are known
    std::uint64_t evolutions = 0;
};

struct AutomatonOptions {
    ExecutionMode mode = ExecutionMode::StabilitySearch;
    std::uint64_t max_locations = 20'000'000;
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< bytes of decision diagrams
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;  ///< set by somebody else
    bool partial = false;  ///< where a limit, the deadline or `stop` ends the search: what was found, not `complete`
    std::function<void(const ConformProgress&)> progress = {};  ///< called now and then
};

/// The automaton of the chart, or nothing after adding at least one error to `diagnostics`: no inputs, no outputs, a
/// constraint that excludes every input, an initial situation that never stabilises, two actions that store different
/// values at once, a value that does not exist or is out of its range, a limit. Requires verify(equations).empty().
std::optional<LocationAutomaton> location_automaton(const Equations& equations, const AutomatonOptions& options,
                                                    Diagnostics& diagnostics);

}  // namespace grafverif
