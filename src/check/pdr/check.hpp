// SPDX-License-Identifier: MIT
// Circuit-based engines: decide properties about states of a TransitionSystem (`always`, `never`, `exactly one of`,
// `reachable`). Property directed reachability (PDR) decides one property at a time. Bounded model checking (BMC)
// searches all runs up to a length that is increased step by step.
//
// A property `holds` (for `reachable`: is violated) if there is an inductive invariant, which an independent second
// solver checks. BMC cannot prove that a property holds. Other engines can be used in place of PDR (PdrOptions::reach);
// their results are validated in the same way. For a violation, the engine returns a run, which is validated with the
// terms of the system. If PDR finds a run, BMC searches for shorter runs, and a note states whether a shorter run may
// exist.
//
// If a variable of a system can leave its range, no property is decided (`faulty`); otherwise induction or PDR proves
// that this is impossible. The engine does not check whether the system is total, because verdicts concern only states
// that runs reach.
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
    std::size_t frames = 0;  ///< number of frames of PDR, or of steps that BMC has searched
    std::uint64_t bytes = 0;
    double seconds = 0;
};

/// Thrown by an engine that is used in place of PDR, if it has no result or an invalid result.
struct Undecided {
    UnknownReason obstacle = UnknownReason::Failed;
    std::string reason = {};
};

struct PdrOptions {
    /// Alternating: PDR runs for some time on each property, and then BMC on all properties for a third of the time
    /// that PDR has used. Then both run again, with four times the time. A note names the engine that found the
    /// verdict.
    enum class Method { Pdr, Bmc, Alternating };
    Method method = Method::Pdr;
    std::chrono::steady_clock::duration first_step_of = std::chrono::milliseconds(250);
    /// For BMC: maximum length of the searched runs; if empty, only time and memory limit the search.
    std::optional<std::size_t> max_steps = {};
    /// Engine that is used in place of PDR, with the interface of pdr::reach. Its results are validated.
    std::function<pdr::PdrAnswer(const Circuit& circuit, pdr::Literal bad, pdr::LimitMonitor& watch)> reach = {};
    /// True: first tries the invariant that latches are equal (for the product of two similar systems).
    bool equal_latches = false;
    std::vector<std::string> properties = {};            ///< names of the properties to check; all if empty
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< memory limit in bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;                ///< cancellation flag: return the results so far
    std::function<void(const PdrProgress&)> progress = {};  ///< called for every frame or step
    /// For Alternating. `answered` is called with every decided verdict as soon as it is available. `decided_elsewhere`
    /// marks properties of the system for which no further work is necessary, because another engine has decided them.
    std::function<void(const Verdict&, const std::optional<SystemRun>&)> answered = {};
    const std::vector<std::atomic<bool>>* decided_elsewhere = nullptr;
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
