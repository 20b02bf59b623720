// SPDX-License-Identifier: MIT
// Runs a portfolio of engines on one system. The symbolic engine runs in one thread, decomposed into subsystems. If
// this engine has not finished, a second thread starts after PortfolioOptions::alone operations of the engine, at the
// latest after a quarter of the time limit. The second thread runs localization, and then alternates PDR and BMC. The
// first engine that decides a property provides its verdict, and a note names the engine. When all properties are
// decided, all engines stop. Results are validated as in a single-engine run, so verdicts do not depend on which engine
// finishes first. Counterexamples may depend on which engine finishes first.
//
// If `jobs` is 1 or no thread can be started, the engines run sequentially: first each engine for a bounded time, and
// then each engine up to the deadline.
//
// One memory limit covers all engines. If the engines run in parallel, three quarters of the limit are available to
// decision diagrams. The solvers (PDR, BMC) stop when the memory that the program has allocated since the start of the
// check exceeds the limit. If all engines have ended and decision diagrams had too little memory, the symbolic engine
// runs again with the complete memory limit.
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
    const std::atomic<bool>* stop = nullptr;  ///< cancellation flag; if set, the check ends with the results so far
    std::function<void(const PortfolioProgress&)> progress = {};  ///< called periodically, in the caller's thread
    bool witnesses = true;                                        ///< return a run for each `reachable` that holds
    bool whole = false;          ///< true: the symbolic engine does not decompose the system
    bool equal_latches = false;  ///< see PdrOptions
    /// Number of steps of decision-diagram operations after which the other engines start. They start at the latest
    /// after a quarter of the time limit. If `alone` is 0, they start immediately.
    std::uint64_t alone = 0;
    unsigned jobs = 0;  ///< number of threads; 1: the calling thread runs all engines
    /// Function that tries inexpensive proofs before the solvers start. It returns verdicts without runs for the
    /// properties that it decides, and ends early when `stop` is set.
    std::function<std::vector<Verdict>(const std::atomic<bool>* stop)> first = {};
};

struct PortfolioResult : PdrResult {
    bool alone = false;  ///< true: only the symbolic engine was started, and the verdicts do not name an engine
};

/// Checks the properties with the portfolio. Requires verify(system).empty().
PortfolioResult check_together(const TransitionSystem& system, const PortfolioOptions& options = {});

}  // namespace grafverif
