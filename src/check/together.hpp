// SPDX-License-Identifier: MIT
// Engines beside each other: the symbolic engine in one thread (by sub-loops, as it is alone), PDR and BMC in turns in another, on one system. The first
// of them that decides a property has decided it, and a note says which; where all is decided the others end. What they
// find is checked as it is when each works alone, so verdicts do not depend on who was first; which run shows one may.
//
// The memory allowed bounds all of it: half is for decision diagrams, and the solvers end where all that the program took
// since the beginning exceeds it.
#pragma once

#include "check/pdr/check.hpp"
#include "check/symbolic/symbolic.hpp"

namespace grafverif {

/// What each of them told last.
struct TogetherProgress {
    SymbolicProgress symbolic = {};
    PdrProgress pdr = {};
};

struct TogetherOptions {
    std::vector<std::string> properties = {};            ///< names; empty: all
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< bytes, of all engines
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;                     ///< set by somebody else: end with what is known
    std::function<void(const TogetherProgress&)> progress = {};  ///< called now and then, by the caller's thread
    bool witnesses = true;                                       ///< a run for each `reachable` that holds
    bool whole = false;                                          ///< the symbolic engine takes nothing apart
    bool equal_latches = false;                                  ///< see PdrOptions
};

/// Requires verify(system).empty(). What the system refuses to a thread is thrown here.
PdrResult check_together(const TransitionSystem& system, const TogetherOptions& options = {});

}  // namespace grafverif
