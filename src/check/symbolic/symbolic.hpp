// SPDX-License-Identifier: MIT
// Symbolic engine: explores a TransitionSystem by computing sets of states. A binary decision diagram represents each
// set as a Boolean function (Burch, Clarke, McMillan, Dill, Hwang 1992: "Symbolic model checking: 10^20 states and
// beyond"). The engine translates the property patterns of untimed models to CTL formulas and decides these formulas.
//
// The semantics is defined in ir/transition_system.hpp. `always`, `never`, `exactly one of` and `reachable` concern the
// reachable states. `inevitable p` means AF p, `p leads to q` means AG (p -> AF q), and `always possible p` means AG EF
// p. Runs are infinite. If the system has justice conditions, only runs in which each justice condition holds
// infinitely often are considered. A state in which p and q hold satisfies `p leads to q`.
//
// A run for a property about single states has the minimum number of steps. An infinite counterexample begins with a
// shortest path to a state from which the property fails. The further parts of the counterexample are short, but not
// always shortest paths.
//
// CTL is defined only for systems in which each state has a successor. A step that assigns a variable a value outside
// its range does not lead to a state. Therefore, the engine searches for reachable states without successors and for
// steps with values outside the range. If the engine finds a state or a step of this kind, all verdicts are unknown
// (obstacle `faulty`).
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/verdict.hpp"
#include "ir/flat_system.hpp"

namespace grafverif {

struct SymbolicProgress {
    std::size_t depth = 0;  ///< number of steps from the initial states that the search has completed
    std::uint64_t bytes = 0;
    double seconds = 0;
};

struct SymbolicOptions {
    std::vector<std::string> properties = {};            ///< names of the properties to check; an empty list selects
                                                         ///< all
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< memory limit of decision diagrams, in bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;  ///< cancellation flag; if set, the check ends with the results so far
    std::function<void(const SymbolicProgress&)> progress = {};  ///< called after every step of the search
    bool witnesses = true;                                       ///< if true, the result contains a run for each
                                                                 ///< `reachable` property that holds

    /// If true, the steps are partitioned into event clusters (event_clusters.hpp), and the reachable states are
    /// computed by saturation.
    bool by_kind = true;
    /// Number of steps of decision-diagram operations after which the breadth-first search ends and saturation begins.
    std::uint64_t one_by_one = 200'000;
    /// Counter to which the check periodically adds the number of steps of decision-diagram operations; may be null.
    std::atomic<std::uint64_t>* worked = nullptr;
};

struct SymbolicResult {
    std::vector<Verdict> verdicts = {};               ///< verdicts in the order of the properties
    std::vector<std::optional<SystemRun>> runs = {};  ///< counterexample of each violated property, or witness of
                                                      ///< `reachable`
    std::optional<SystemFault> fault = {};
    /// Exact number of reachable states, in decimal; empty if the search did not find all reachable states.
    std::string states = {};
    /// Depth (number of steps from the initial states) up to which the breadth-first search is complete. If
    /// SymbolicOptions::by_kind is false, the complete search is breadth-first.
    std::size_t depth = 0;
    std::uint64_t bytes = 0;  ///< peak memory in bytes
    double seconds = 0;
};

/// Checks the properties of `system`. Requires verify(system).empty().
SymbolicResult check_symbolic(const TransitionSystem& system, const SymbolicOptions& options = {});

}  // namespace grafverif
