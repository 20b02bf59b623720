// SPDX-License-Identifier: MIT
// Engines on a circuit: properties about states of a TransitionSystem (`always`, `never`, `exactly one of`, `reachable`),
// by property directed reachability, one at a time (PDR), or by looking at all runs of one step, two steps, and so on (BMC,
// bounded model checking).
//
// `holds` (of `reachable`: violated) rests on an inductive invariant, checked by a second solver that has seen nothing of the
// search; BMC never says it. Others may search in place of PDR (PdrOptions::reach): what they find is checked alike. What is
// reached comes with a run of the system, held against its terms before it is told. A run of ours is looked at for shorter
// ones by BMC; a note says whether there are none.
//
// A system that leaves the range of a variable means nothing, and nothing is decided about it (`faulty`); it is proved, by PDR,
// that none does. That every state has a step is not looked at: verdicts are about the states that runs reach.
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

/// Thrown by who searches in place of the engine, where it has no answer, or one that means nothing.
struct Undecided {
    Obstacle obstacle = Obstacle::Failed;
    std::string reason = {};
};

struct PdrOptions {
    /// InTurns: PDR for a while on each property, then BMC for a third of that, then both for four times as long, and so on; a note
    /// says which of them found the verdict.
    enum class Method { Pdr, Bmc, InTurns };
    Method method = Method::Pdr;
    std::chrono::steady_clock::duration first_turn = std::chrono::milliseconds(250);
    std::optional<std::size_t> max_steps =
        {};  ///< of BMC: of the runs that it looks at; empty: as time and memory allow
    /// Searches in place of PDR, as pdr::reach does; what it finds is checked all the same.
    std::function<pdr::Answer(const Circuit& circuit, pdr::Literal bad, pdr::Watch& watch)> reach = {};
    bool equal_latches =
        false;  ///< first try the invariant that latches are equal: for two similar systems side by side
    std::vector<std::string> properties = {};            ///< names; empty: all
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;                ///< set by somebody else: end with what is known
    std::function<void(const PdrProgress&)> progress = {};  ///< called for every frame or step
    /// Of InTurns. Called with every verdict that is not unknown, as soon as it is there; which properties of the system somebody
    /// else has decided meanwhile: nothing more is done for them.
    std::function<void(const Verdict&, const std::optional<SystemRun>&)> answered = {};
    const std::vector<std::atomic<bool>>* moot = nullptr;
};

struct PdrResult {
    std::vector<Verdict> verdicts = {};               ///< in the order of the properties
    std::vector<std::optional<SystemRun>> runs = {};  ///< per verdict: counterexample, or witness of `reachable`
    std::optional<SystemFault> fault = {};
    std::vector<std::string> failures = {};  ///< ours: a proof or a run that does not stand up
};

/// Requires verify(system).empty().
PdrResult check_pdr(const TransitionSystem& system, const PdrOptions& options = {});

}  // namespace grafverif
