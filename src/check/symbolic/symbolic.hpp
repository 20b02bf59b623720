// SPDX-License-Identifier: MIT
// The symbolic engine: a TransitionSystem as sets of states, each a Boolean function (Burch, Clarke, McMillan, Dill,
// Hwang 1992: "Symbolic model checking: 10^20 states and beyond"). It decides every pattern of property as CTL.
//
// Semantics: ir/transition_system.hpp. `always`, `never`, `exactly one of`, `reachable` speak of the reachable states.
// `inevitable p` is AF p, `p leads to q` AG (p -> AF q), `always possible p` AG EF p; a run is infinite, and where the
// system has justice conditions only runs that meet each of them infinitely often count. A state with p and q keeps
// `p leads to q`.
//
// Witnesses and counterexamples about single states are shortest, in steps of the system. A lasso is a shortest path to
// a first state from which the property fails, and from there ways kept short, not shortest.
//
// A system that is not total, or leaves the range of a variable, would make every CTL formula true on runs that do not
// exist; the engine looks for both in the states it reached, and then decides nothing (`faulty`).
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
    const std::atomic<bool>* stop = nullptr;                     ///< set by somebody else: end with what is known
    std::function<void(const SymbolicProgress&)> progress = {};  ///< called after every step of the search
    bool witnesses = true;                                       ///< a run for each `reachable` that holds
    bool by_kind = true;  ///< steps that change few bits are kept apart, and all they lead to is found by saturation,
    std::uint64_t one_by_one = 200'000;  ///< once so many steps of operations have been spent on a search step by step
};

struct SymbolicResult {
    std::vector<Verdict> verdicts = {};               ///< in the order of the properties
    std::vector<std::optional<SystemRun>> runs = {};  ///< per verdict: counterexample, or witness of `reachable`
    std::optional<SystemFault> fault = {};
    std::string states = {};  ///< the number of reachable states, exactly, in decimal; empty: not all were reached
    std::size_t depth = 0;    ///< steps from the initial states as far as it went one by one; all, if not `by_kind`
    std::uint64_t bytes = 0;  ///< most memory held at once
    double seconds = 0;
};

/// Requires verify(system).empty().
SymbolicResult check_symbolic(const TransitionSystem& system, const SymbolicOptions& options = {});

}  // namespace grafverif
