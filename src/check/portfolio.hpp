// SPDX-License-Identifier: MIT
// Runs a portfolio of engines on one system. One thread runs the symbolic engine, which checks independent subsystems
// separately. If the symbolic engine does not finish within PortfolioOptions::alone steps, or within a quarter of the
// time limit, a second thread starts. The second thread first tries inexpensive proofs (PortfolioOptions::first), and
// then alternates PDR and BMC. The first engine that decides a property provides its verdict, and a note names the
// engine. When all properties are decided, all engines stop. Results are validated as in a run with a single engine, so
// verdicts do not depend on which engine finishes first. However, counterexamples may differ.
//
// If `jobs` is 1 or no thread can be started, the engines run sequentially: first each engine for a bounded time, and
// then each engine up to the deadline.
//
// One memory limit covers all engines. If the engines run in parallel, three quarters of the limit are available to
// decision diagrams. The solvers (PDR, BMC) stop when the memory that the program has allocated since the start of the
// check exceeds the limit. If all engines have ended and the symbolic engine had reached its share of the memory, the
// symbolic engine runs again with the complete memory limit.
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
    std::vector<std::string> properties = {};            ///< names of the properties to check; an empty list selects
                                                         ///< all
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< memory limit of all engines together, in bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;  ///< cancellation flag; if set, the check ends with the results so far
    std::function<void(const PortfolioProgress&)> progress = {};  ///< called periodically, in the caller's thread
    bool witnesses = true;                                        ///< if true, the result contains a run for each
                                                                  ///< `reachable` property that holds
    bool whole = false;          ///< if true, the symbolic engine does not decompose the system into subsystems
    bool equal_latches = false;  ///< see PdrOptions::equal_latches

    /// Number of steps of decision-diagram operations after which PDR and BMC start. PDR and BMC start no later than
    /// after a quarter of the time limit. If `alone` is 0, PDR and BMC start immediately.
    std::uint64_t alone = 0;
    /// Number of threads; if 1, the calling thread runs all engines.
    unsigned jobs = 0;
    /// Function that tries inexpensive proofs, such as localization, before PDR and BMC start. The function returns a
    /// verdict without a run for each property that it decides, and ends early when `stop` becomes true. May be null.
    std::function<std::vector<Verdict>(const std::atomic<bool>* stop)> first = {};
};

struct PortfolioResult : PdrResult {
    bool alone = false;  ///< true if only the symbolic engine was started; the verdicts then do not name an engine
};

/// Checks the properties with the portfolio. Requires verify(system).empty().
PortfolioResult check_together(const TransitionSystem& system, const PortfolioOptions& options = {});

}  // namespace grafverif
