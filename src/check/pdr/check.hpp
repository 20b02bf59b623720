// SPDX-License-Identifier: MIT
// Circuit-based engines: decide properties about states of a TransitionSystem (`always`, `never`, `exactly one of`,
// `reachable`). Property directed reachability (PDR) decides one property at a time. Bounded model checking (BMC)
// searches all runs up to a length that is increased step by step.
//
// PDR proves that a property holds (for `reachable`: that it is violated) by an inductive invariant, which an
// independent second solver checks. BMC has a result only if it finds a run. Other engines can be used in place of PDR
// (PdrOptions::reach); their results are validated in the same way. For a violation, the engine returns a run; this run
// is validated by evaluating the terms of the system. If PDR finds a run, BMC searches for a shorter run. If a shorter
// run may still exist, a note states this.
//
// If a reachable step can assign a variable a value outside its range, no property is decided (obstacle `faulty`).
// Otherwise, induction or PDR proves that no reachable step assigns a value outside the range. The engine does not
// check that every state has a successor, because verdicts concern only states that finite runs reach.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "check/pdr/latch_pairs.hpp"
#include "check/pdr/pdr.hpp"
#include "grafverif/ir/verdict.hpp"
#include "ir/flat_system.hpp"

namespace grafverif {

struct PdrProgress {
    std::string property = {};
    std::size_t frames = 0;  ///< number of frames of PDR, or number of steps up to which BMC has searched
    std::uint64_t bytes = 0;
    double seconds = 0;
};

/// Exception of an engine that is used in place of PDR: the engine has no result or an invalid result.
struct Undecided {
    UnknownReason obstacle = UnknownReason::Failed;
    std::string reason = {};
};

struct PdrOptions {
    /// Alternating: PDR runs for a limited time on each property. Then BMC runs on all properties for a third of the
    /// time that PDR has used. The two engines alternate in this way; the time limit of PDR is multiplied by four in
    /// each round. A note names the engine that found the verdict.
    enum class Method { Pdr, Bmc, Alternating };
    Method method = Method::Pdr;
    std::chrono::steady_clock::duration first_step_of = std::chrono::milliseconds(250);
    /// Time limit of the BMC search for a run that is shorter than the run of PDR, in addition to the time that PDR
    /// took.
    std::chrono::steady_clock::duration shorten_for = std::chrono::seconds(2);
    /// For BMC: maximum length of the searched runs; if empty, only time and memory limit the search.
    std::optional<std::size_t> max_steps = {};
    /// Engine that is used in place of PDR, with the interface of pdr::reach. The results of this engine are validated.
    std::function<pdr::PdrAnswer(const Circuit& circuit, pdr::Literal bad, pdr::LimitMonitor& watch)> reach = {};
    /// If true, the check first tries the invariant that some latches are always equal (EqualLatches), and then PDR.
    /// This invariant is useful for the product of two similar systems.
    bool equal_latches = false;
    /// Called for each property that an inductive invariant proves, after the invariant has been checked. The invariant
    /// is the complement of the cubes; it excludes the states in which `bad` is true.
    std::function<void(const std::string& property, const Circuit& circuit, pdr::Literal bad,
                       const std::vector<pdr::Cube>& cubes)>
        proved = {};
    /// Called for each property that a run decides, after the run has been validated. In the last state of the run, `bad`
    /// is true. `inputs` are the values of the inputs in each state.
    std::function<void(const std::string& property, const Circuit& circuit, pdr::Literal bad,
                       const std::vector<std::vector<bool>>& inputs)>
        shown = {};
    /// Candidates for invariants of two literals (see LatchPairs); may be null. If the vector is empty and the check
    /// computes such pairs, the check stores them in the vector.
    std::vector<pdr::NamedCube>* pairs = nullptr;
    std::vector<std::string> properties = {};            ///< names of the properties to check; an empty list selects
                                                         ///< all
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< memory limit in bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;  ///< cancellation flag; if set, the check ends with the results so far
    std::function<void(const PdrProgress&)> progress = {};  ///< called for every frame of PDR and every step of BMC

    /// Used only by Alternating. `answered` is called with every decided verdict as soon as the verdict is available.
    /// `decided_elsewhere` has one flag per property of the system. If another engine has decided a property, its flag
    /// is true, and the check does not continue with this property.
    std::function<void(const Verdict&, const std::optional<SystemRun>&)> answered = {};
    const std::vector<std::atomic<bool>>* decided_elsewhere = nullptr;
};

struct PdrResult {
    std::vector<Verdict> verdicts = {};               ///< verdicts in the order of the properties
    std::vector<std::optional<SystemRun>> runs = {};  ///< counterexample of each violated property, or witness of
                                                      ///< `reachable`
    std::optional<SystemFault> fault = {};
    std::vector<std::string> failures = {};  ///< internal failures: an invalid proof or run
};

/// Checks the properties of `system`. Requires verify(system).empty().
PdrResult check_pdr(const TransitionSystem& system, const PdrOptions& options = {});

}  // namespace grafverif
