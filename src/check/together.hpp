// SPDX-License-Identifier: MIT
// Portfolio engine: runs the symbolic engine in one thread (decomposed into subsystems, as when it runs alone) and
// alternates PDR and BMC in a second thread, on one system. The first engine that decides a property provides its
// verdict, and a note names that engine. When all properties are decided, all engines stop.
//
// Results are validated as in a single-engine run, so verdicts do not depend on which engine finishes first; the
// counterexample may.
//
// One memory limit covers all engines: half of it is available to decision diagrams, and the solvers stop when the
// process has allocated more than the limit since the start.
#pragma once

#include "check/pdr/check.hpp"
#include "check/symbolic/symbolic.hpp"

namespace grafverif {

/// The last progress report of each engine.
struct TogetherProgress {
    SymbolicProgress symbolic = {};
    PdrProgress pdr = {};
};

struct TogetherOptions {
    std::vector<std::string> properties = {};            ///< names; empty: all
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< bytes, of all engines
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;                     ///< cancellation flag: return the results so far
    std::function<void(const TogetherProgress&)> progress = {};  ///< called periodically, by the caller's thread
    bool witnesses = true;                                       ///< a run for each `reachable` that holds
    bool whole = false;                                          ///< the symbolic engine does not decompose the system
    bool equal_latches = false;                                  ///< see PdrOptions
};

/// Requires verify(system).empty(). Throws if the system refuses a thread.
PdrResult check_together(const TransitionSystem& system, const TogetherOptions& options = {});

}  // namespace grafverif
