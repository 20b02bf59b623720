// SPDX-License-Identifier: MIT
// Engines on a circuit: decide properties about states of a TransitionSystem (`always`, `never`, `exactly one of`,
// `reachable`). Property directed reachability (PDR) decides one at a time; bounded model checking (BMC) searches all
// runs of increasing length.
//
// `holds` (for `reachable`: violated) is based on an inductive invariant, which an independent second solver checks;
// BMC cannot prove it. Other engines may search in place of PDR (PdrOptions::reach); their results are validated in the
// same way. A violation comes with a run of the system, which is validated by its terms. BMC searches for runs shorter
// than one found by PDR; a note states if there are none.
//
// If a variable of a system can leave its range, nothing is decided about the system (`faulty`); PDR proves that none
// can. Totality is not checked: verdicts are about the states that runs reach.
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
    std::size_t frames = 0;  ///< of BMC: steps
    std::uint64_t bytes = 0;
    double seconds = 0;
};

/// Thrown by an engine in place of PDR without a result, or with an invalid one.
struct Undecided {
    UnknownReason obstacle = UnknownReason::Failed;
    std::string reason = {};
};

struct PdrOptions {
    /// InTurns: PDR for some time on each property, then BMC for a third of that time; both are repeated with fourfold
    /// time. A note names the engine that found the verdict.
    enum class Method { Pdr, Bmc, InTurns };
    Method method = Method::Pdr;
    std::chrono::steady_clock::duration first_step_of = std::chrono::milliseconds(250);
    std::optional<std::size_t> max_steps =
        {};  ///< for BMC: length of the searched runs; empty: limited by time and memory only
    /// Searches in place of PDR, as pdr::reach does; its results are validated.
    std::function<pdr::PdrAnswer(const Circuit& circuit, pdr::Literal bad, pdr::LimitMonitor& watch)> reach = {};
    bool equal_latches =
        false;  ///< first try the invariant that latches are equal: for the product of two similar systems
    std::vector<std::string> properties = {};            ///< names; empty: all
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;                ///< cancellation flag: return the results so far
    std::function<void(const PdrProgress&)> progress = {};  ///< called for every frame or step
    /// For InTurns. `answered` is called with every verdict that is not unknown, as soon as it is available; `moot`
    /// marks properties of the system that another engine has decided, which need no further work.
    std::function<void(const Verdict&, const std::optional<SystemRun>&)> answered = {};
    const std::vector<std::atomic<bool>>* moot = nullptr;
};

struct PdrResult {
    std::vector<Verdict> verdicts = {};               ///< in the order of the properties
    std::vector<std::optional<SystemRun>> runs = {};  ///< per verdict: counterexample, or witness of `reachable`
    std::optional<SystemFault> fault = {};
    std::vector<std::string> failures = {};  ///< internal failures: an invalid proof or run
};

/// Requires verify(system).empty().
PdrResult check_pdr(const TransitionSystem& system, const PdrOptions& options = {});

}  // namespace grafverif
