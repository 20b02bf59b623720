// SPDX-License-Identifier: MIT
// Portfolio of engines on one system. The symbolic engine works in one thread, by sub-loops. After a share of the time
// for itself, cells and then PDR and BMC in turns join in another. The first that decides a property has decided it,
// and a note names it; when all is decided the others end. What they find is checked as it is when each works alone, so
// verdicts do not depend on who was first; which run is shown may.
//
// Without a second thread they work sequentially, each but the last for a bounded share of the time.
//
// The memory allowed bounds all of it: three quarters are for decision diagrams, and the solvers end if all that the
// program took since the beginning exceeds it. When all have ended and memory was short, diagrams may have all of it.
#pragma once

#include "check/pdr/check.hpp"
#include "check/symbolic/symbolic.hpp"

namespace grafverif {

/// The last progress report of each engine.
struct PortfolioProgress {
    SymbolicProgress symbolic = {};
    PdrProgress pdr = {};
};

struct PortfolioOptions {
    std::vector<std::string> properties = {};            ///< names; empty: all
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< bytes, of all engines
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;                      ///< cancellation flag: return the results so far
    std::function<void(const PortfolioProgress&)> progress = {};  ///< called periodically, by the caller's thread
    bool witnesses = true;                                        ///< a run for each `reachable` that holds
    bool whole = false;                                           ///< the symbolic engine does not decompose the system
    bool equal_latches = false;                                   ///< see PdrOptions
    /// Steps of operations on decision diagrams after which the others join, or after a quarter of the time; 0: at
    /// once.
    std::uint64_t alone = 0;
    unsigned jobs = 0;  ///< 1: no thread is started
    /// Cheap proofs, before the solvers begin: verdicts without runs, of the properties that it decides. Ends on
    /// `stop`.
    std::function<std::vector<Verdict>(const std::atomic<bool>* stop)> first = {};
};

struct PortfolioResult : PdrResult {
    bool alone =
        false;  ///< the symbolic engine ended before the others joined: the verdicts are its own, without a note
};

/// Requires verify(system).empty().
PortfolioResult check_together(const TransitionSystem& system, const PortfolioOptions& options = {});

}  // namespace grafverif
