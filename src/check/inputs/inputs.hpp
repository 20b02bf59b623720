// SPDX-License-Identifier: MIT
// Decides properties about single states on input abstractions of a closed loop (ir/network_inputs.hpp).
//
// The search for a property starts with the coarsest levels: `Untimed` (without clocks) for timers and for the
// processes that the property reads, and `Chosen` (arbitrary outputs) for all other processes that are not PLCs.
// Properties with equal levels share a search. The time unit of a search is the greatest common divisor of the
// durations in the abstraction. If the abstraction preserves a verdict, the verdict is also the verdict on the complete
// loop. If a verdict depends on a run of the abstraction, a guided search looks for a similar run of the complete loop
// (follow.hpp). If the guided search finds a run, this run is reported. Otherwise, the level of a process that cannot
// perform its moves in the abstract run is raised, and the search is repeated. Usually several processes cannot perform
// their moves, and it is not known which of them the proof needs. The other choices become alternatives, which are
// searched after the searches of a round (alternatives.hpp). If a property remains undecided, the search restarts with
// an abstraction of only those instances that read nothing but their own variables (autonomous instances).
//
// The searches run in rounds with growing bounds on states. A search that ends at the bound of a round is repeated in
// the next round. Therefore a property that requires few states does not wait for a property that requires many states.
// Each round begins with a search for runs of the complete loop (novelty.hpp).
//
// After a round, a symbolic engine examines properties whose searches reached the bound. The abstraction is the same,
// except that `Chosen` processes become `Untimed`. A run that the symbolic engine finds is treated like a run that a
// search finds, and the symbolic engine continues with the raised levels. InputLimits::symbolic_share bounds the time
// of the symbolic engine.
//
// If an abstraction has a model error, its search gives no verdict, because the states after the error are not
// explored.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "check/shares.hpp"
#include "check/timed/timed.hpp"

namespace grafverif {

/// A function that adds the observers of the current properties to a network. If no property has an observer, the
/// function returns the network unchanged.
using Observe = std::function<Network(const Network&)>;

/// A task for the symbolic engine: to decide a property about all states on an abstraction of the loop.
struct ProofTask {
    /// Expanded network in which the clocks of some processes are ignored, with the observers of the current properties.
    const Network& abstraction;
    const std::string& property;
    /// Deadline of the proof of the property.
    Deadline share = {};
    /// Deadline of the proof that no state has a model error. This proof is valid for all abstractions of the loop.
    Deadline end = {};
    std::uint64_t memory = 0;  ///< memory limit in bytes
    const std::atomic<bool>* stop = nullptr;
};

/// Result of a ProofTask.
struct Proof {
    /// Holds: the property holds in all states, and no state has a model error. Violated: some state violates the
    /// property. Unknown: a limit was reached, or a model error is possible.
    Outcome outcome = Outcome::Unknown;
    /// If Violated: a run of the abstraction to a state that violates the property; empty if the run has a model error.
    std::optional<Run> run = {};
};
using StateProver = std::function<Proof(const ProofTask&)>;

struct InputLimits {
    /// Maximum number of states of one search of an abstraction.
    std::uint64_t states = std::uint64_t{1} << 24U;
    /// Maximum number of states of one coarse search, in which instances that read variables of the loop are also
    /// abstracted.
    std::uint64_t coarse_states = std::uint64_t{1} << 22U;
    /// Maximum number of transitions of one search with macro-steps, as a multiple of the maximum number of states of
    /// the round. (A macro-step combines many transitions.) The number of transitions is not limited in the last round.
    std::uint64_t transitions = 8;
    /// Maximum number of alternatives (alternatives.hpp) that are searched for one property in one round; may be 0.
    std::size_t alternatives = 32;
    /// Maximum number of transitions of these searches together, as `transitions`.
    std::uint64_t transitions_of_alternatives = 32;
    /// Alternatives are searched in rounds with at least this maximum number of states. In earlier rounds, the preferred
    /// search usually needs only a greater bound.
    std::uint64_t alternatives_from = std::uint64_t{1} << 17U;
    /// Maximum share of the time of all rounds that alternatives may use: `first_share` in the first round with
    /// alternatives, after which most properties are decided without alternatives, and `later_share` afterwards.
    double first_share = 0.1, later_share = 0.5;
    /// Maximum number of states of one guided search.
    std::size_t followed = 200'000;
    /// Maximum number of states of one guided search in the first rounds, for a run of a coarse abstraction. In later
    /// rounds, the maximum is four times the maximum number of states of the round, but at most `followed`.
    std::size_t followed_coarse = 20'000;
    /// Number of states of the complete loop that NoveltySearch explores before the abstractions are searched; may be
    /// 0.
    std::uint64_t explored = std::uint64_t{1} << 20U;
    /// Maximum number of searches for one property that abstract only autonomous instances.
    std::size_t rounds = 8;
    /// Maximum number of searches for one property in one round, except for the last round. Without this limit, many
    /// searches for one property, usually `reachable all steps`, would delay all other properties.
    std::size_t searches_per_round = 8;
    /// Maximum number of coarse searches for one property, before the searches that abstract only autonomous instances.
    std::size_t coarse_rounds = 32;
    /// The symbolic engine is used after each round whose maximum number of states is at least this number.
    std::uint64_t symbolic_from = std::uint64_t{1} << 17U;
    /// Maximum share of the time since the start of the search that the symbolic engine may use.
    double symbolic_share = 0.1;
    /// Per property: an abstraction that decided the property in a similar loop. The search begins with this
    /// abstraction instead of the coarsest abstraction. Processes that the abstraction does not name have the level
    /// Complete.
    std::map<std::string, InputsAbstracted> known = {};
};

class InputAbstractionCheck;

/// Decides properties with an unknown verdict in `result`, if the verdict is unknown because a limit ended the search
/// or because integer time is not exact for the property.
class InputSearch {
public:
    /// `loop` is expanded and has no observers. `result` is the result for observe(loop), with the verdicts that
    /// `options` select. The memory limit of `options` applies to each search. If `prove` is not null, the search calls
    /// `prove` for abstractions that exceed the maximum number of states of a round. All references must outlive the
    /// search.
    InputSearch(const Network& loop, const Observe& observe, const TimedOptions& options, TimedResult& result,
                const InputLimits& limits = {}, const InputAblations& ablations = {}, StateProver prove = {});
    ~InputSearch();
    InputSearch(InputSearch&&) = delete;

    /// Performs one round of searches; each search explores at most `states` states. Returns false if no search remains
    /// for the next round.
    bool run(std::uint64_t states, const Deadline& deadline);

private:
    std::unique_ptr<InputAbstractionCheck> search_;
};

}  // namespace grafverif
