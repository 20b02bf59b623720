// SPDX-License-Identifier: MIT
// Circuit-based engines: decide properties about states of a TransitionSystem (`always`, `never`, `exactly one of`,
// `reachable`). Property directed reachability (PDR) decides them one at a time. Bounded model checking (BMC) searches
// all runs of increasing length.
//
// A property `holds` (for `reachable`: is violated) if there is an inductive invariant, which an independent second
// solver checks. BMC cannot prove this. Other engines may search in place of PDR (PdrOptions::reach); their results are
// validated in the same way. A violation comes with a run of the system, which is validated with its terms. If PDR
// finds a run, BMC searches for shorter ones; a note states if there are none.
//
// If a variable of a system can leave its range, no property is decided (`faulty`); PDR proves that this is impossible.
// Totality is not checked: verdicts concern the states that runs reach.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "check/pdr/pdr.hpp"
#include "grafverif/ir/verdict.hpp"
#include "ir/flat_system.hpp"

namespace grafverif {

struct PdrProgress {
    std::string property = {};
    std::size_t frames = 0;  ///< number of steps searched by BMC
    std::uint64_t bytes = 0;
    double seconds = 0;
};

/// Thrown by an engine in place of PDR if it has no result or an invalid one.
struct Undecided {
    UnknownReason obstacle = UnknownReason::Failed;
    std::string reason = {};
};

struct PdrOptions {
    /// InTurns: PDR runs for some time on each property, then BMC for a third of that time. Both are repeated with four
    /// times the time. A note names the engine that found the verdict.
    enum class Method { Pdr, Bmc, InTurns };
    Method method = Method::Pdr;
    std::chrono::steady_clock::duration first_step_of = std::chrono::milliseconds(250);
    std::optional<std::size_t> max_steps =
        {};  ///< for BMC: length of the searched runs; if empty, only time and memory limit the search
    /// Searches in place of PDR, as pdr::reach does. The results are validated.
    std::function<pdr::PdrAnswer(const Circuit& circuit, pdr::Literal bad, pdr::LimitMonitor& watch)> reach = {};
    bool equal_latches =
        false;  ///< first tries the invariant that latches are equal, for the product of two similar systems
    std::vector<std::string> properties = {};            ///< names of the properties to check; all if empty
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< memory limit in bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;                ///< cancellation flag: return the results so far
    std::function<void(const PdrProgress&)> progress = {};  ///< called for every frame or step
    /// For InTurns. `answered` is called with every verdict that is not unknown, as soon as it is available; `moot`
    /// marks properties of the system that another engine has decided and that require no further work.
    std::function<void(const Verdict&, const std::optional<SystemRun>&)> answered = {};
    const std::vector<std::atomic<bool>>* moot = nullptr;
};

struct PdrResult {
    std::vector<Verdict> verdicts = {};               ///< verdicts in the order of the properties
    std::vector<std::optional<SystemRun>> runs = {};  ///< counterexample of each verdict, or witness of `reachable`
    std::optional<SystemFault> fault = {};
    std::vector<std::string> failures = {};  ///< internal failures: an invalid proof or run
};

/// Checks the properties of `system`. Requires verify(system).empty().
PdrResult check_pdr(const TransitionSystem& system, const PdrOptions& options = {});

}  // namespace grafverif
