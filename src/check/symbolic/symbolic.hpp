// SPDX-License-Identifier: MIT
// Symbolic engine: a TransitionSystem as sets of states, each a Boolean function (Burch, Clarke, McMillan, Dill, Hwang
// 1992: "Symbolic model checking: 10^20 states and beyond"). It decides every pattern of property as CTL.
//
// Semantics: ir/transition_system.hpp. `always`, `never`, `exactly one of` and `reachable` are about the reachable
// states. `inevitable p` is AF p, `p leads to q` AG (p -> AF q), `always possible p` AG EF p. Runs are infinite. If the
// system has justice conditions, only runs that meet each of them infinitely often count. A state with p and q
// satisfies `p leads to q`.
//
// Witnesses and counterexamples about single states have the fewest steps of the system. A lasso is a shortest path to
// a first state from which the property fails, followed by short, not necessarily shortest, paths.
//
// If a system is not total, or leaves the range of a variable, every CTL formula would be true on runs that do not
// exist. The engine searches the reached states for both, and then decides nothing (`faulty`).
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
    std::size_t depth = 0;  ///< steps from the initial states so far
    std::uint64_t bytes = 0;
    double seconds = 0;
};

struct SymbolicOptions {
    std::vector<std::string> properties = {};            ///< names; empty: all
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< bytes, for decision diagrams
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;                     ///< cancellation flag: return the results so far
    std::function<void(const SymbolicProgress&)> progress = {};  ///< called after every step of the search
    bool witnesses = true;                                       ///< a run for each `reachable` that holds
    bool by_kind = true;  ///< steps that change few bits are separate clusters, whose reachable states are computed by
                          ///< saturation,
    std::uint64_t one_by_one = 200'000;  ///< after this number of operation steps was spent on a breadth-first search
    std::atomic<std::uint64_t>* worked = nullptr;  ///< operation steps are added to it periodically
};

struct SymbolicResult {
    std::vector<Verdict> verdicts = {};               ///< in the order of the properties
    std::vector<std::optional<SystemRun>> runs = {};  ///< per verdict: counterexample, or witness of `reachable`
    std::optional<SystemFault> fault = {};
    std::string states = {};  ///< the exact number of reachable states, in decimal; empty: not all were reached
    std::size_t depth = 0;    ///< steps from the initial states in the breadth-first search; all, if not `by_kind`
    std::uint64_t bytes = 0;  ///< peak memory
    double seconds = 0;
};

/// Requires verify(system).empty().
SymbolicResult check_symbolic(const TransitionSystem& system, const SymbolicOptions& options = {});

}  // namespace grafverif
