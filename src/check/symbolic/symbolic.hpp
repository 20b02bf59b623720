// SPDX-License-Identifier: MIT
// Symbolic engine: represents a TransitionSystem by sets of states, each of which is a Boolean function (Burch, Clarke,
// McMillan, Dill, Hwang 1992: "Symbolic model checking: 10^20 states and beyond"). The engine decides the property
// patterns of untimed models as CTL formulas.
//
// The semantics is defined in ir/transition_system.hpp. `always`, `never`, `exactly one of` and `reachable` concern the
// reachable states. `inevitable p` means AF p, `p leads to q` means AG (p -> AF q), and `always possible p` means AG EF
// p. Runs are infinite. If the system has justice conditions, only runs that satisfy each of them infinitely often are
// considered. A state with p and q satisfies `p leads to q`.
//
// Runs for properties about single states have the minimum number of steps of the system. A lasso consists of a
// shortest path to a state from which the property fails, and of short (not necessarily shortest) paths after this
// state.
//
// CTL is defined only for total systems, and a step that leaves the range of a variable does not lead to a state.
// Therefore, the engine searches the reached states for both faults. If it finds a fault, it does not decide any
// property (`faulty`).
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
    std::size_t depth = 0;  ///< number of steps from the initial states so far
    std::uint64_t bytes = 0;
    double seconds = 0;
};

struct SymbolicOptions {
    std::vector<std::string> properties = {};            ///< names of the properties to check; all if empty
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< memory limit of decision diagrams, in bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;                     ///< cancellation flag: return the results so far
    std::function<void(const SymbolicProgress&)> progress = {};  ///< called after every step of the search
    bool witnesses = true;                                       ///< return a run for each `reachable` that holds
    /// True: steps that change few bits form separate clusters, and reachable states are computed by saturation.
    bool by_kind = true;
    /// Number of operation steps after which the breadth-first search ends and saturation begins.
    std::uint64_t one_by_one = 200'000;
    /// Counter to which the number of operation steps is periodically added.
    std::atomic<std::uint64_t>* worked = nullptr;
};

struct SymbolicResult {
    std::vector<Verdict> verdicts = {};               ///< verdicts in the order of the properties
    std::vector<std::optional<SystemRun>> runs = {};  ///< counterexample of each verdict, or witness of `reachable`
    std::optional<SystemFault> fault = {};
    std::string states = {};  ///< exact number of reachable states, in decimal; empty if not all were reached
    /// Number of steps from the initial states that the breadth-first search completed. Without `by_kind`, all states
    /// are searched breadth first.
    std::size_t depth = 0;
    std::uint64_t bytes = 0;  ///< peak memory in bytes
    double seconds = 0;
};

/// Checks the properties of `system`. Requires verify(system).empty().
SymbolicResult check_symbolic(const TransitionSystem& system, const SymbolicOptions& options = {});

}  // namespace grafverif
