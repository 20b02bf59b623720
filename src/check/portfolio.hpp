// SPDX-License-Identifier: MIT
// Portfolio of engines on one system. The symbolic engine runs in one thread, decomposed into subsystems. After a share
// of the time, localization joins in a second thread, followed by PDR and BMC, which alternate. The first engine that
// decides a property provides its verdict, and a note names the engine. When all properties are decided, all engines
// stop. Results are validated as in a single-engine run, so verdicts do not depend on which engine finishes first.
// Counterexamples may depend on it.
//
// Without a second thread, the engines run sequentially, each except the last for a bounded share of the time.
//
// One memory limit covers all engines. Three quarters of it are available to decision diagrams. The solvers stop when
// the memory that the program has allocated since the start exceeds the limit. If all engines have ended and the
// diagrams had too little memory, they may use all of it.
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
    std::vector<std::string> properties = {};            ///< names of the properties to check; all if empty
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< memory limit of all engines together, in bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;                      ///< cancellation flag: return the results so far
    std::function<void(const PortfolioProgress&)> progress = {};  ///< called periodically, in the caller's thread
    bool witnesses = true;                                        ///< return a run for each `reachable` that holds
    bool whole = false;                                           ///< the symbolic engine does not decompose the system
    bool equal_latches = false;                                   ///< see PdrOptions
    /// Number of steps of operations on decision diagrams after which the other engines start. They start at the latest
    /// after a quarter of the time, or immediately if 0.
    std::uint64_t alone = 0;
    unsigned jobs = 0;  ///< number of threads; no threads are started if 1
    /// Inexpensive proofs before the solvers start. Returns verdicts without runs for the properties that it decides.
    /// Ends when `stop` is set.
    std::function<std::vector<Verdict>(const std::atomic<bool>* stop)> first = {};
};

struct PortfolioResult : PdrResult {
    bool alone = false;  ///< the symbolic engine ended before other engines started, and the verdicts have no note
};

/// Checks the properties with the portfolio. Requires verify(system).empty().
PortfolioResult check_together(const TransitionSystem& system, const PortfolioOptions& options = {});

}  // namespace grafverif
