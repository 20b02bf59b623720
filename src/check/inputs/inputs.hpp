// SPDX-License-Identifier: MIT
// Decides properties about single states on input abstractions of a closed loop (ir/network_inputs.hpp).
//
// Each property starts with the coarsest levels: `Untimed` for the processes that it reads and for timers, `Chosen` for
// the others. Properties with equal levels share a search. The time unit of a search is the greatest common divisor of
// the durations in the abstraction. If the abstraction preserves a verdict, it is also the verdict on the complete
// loop. If a verdict that is not preserved has a run, this run is followed in the complete loop (follow.hpp). If this
// succeeds, the result is a run of the loop. Otherwise the level of a process that cannot perform what the run requires
// is raised, and the search is repeated. For a property that remains open, the search restarts with only autonomous
// instances abstracted.
//
// The searches run in rounds with growing bounds on states. A search that ends at the bound of a round is repeated in
// the next round. Therefore a property that requires a small search does not wait for one that requires a large search.
// Each round begins with a search for runs of the complete loop (novelty.hpp).
//
// An abstraction with a model error yields no verdict, because the states after the error are not explored.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "check/shares.hpp"
#include "check/timed/timed.hpp"

namespace grafverif {

/// Adds the observers of the current properties; returns the network unchanged if there are none.
using Observe = std::function<Network(const Network&)>;

struct InputLimits {
    std::uint64_t states = std::uint64_t{1} << 24U;  ///< maximum number of states of one search of an abstraction
    /// Maximum number of states of one search in which instances that read the loop are also abstracted.
    std::uint64_t coarse_states = std::uint64_t{1} << 22U;
    std::size_t followed = 200'000;  ///< maximum number of states of one guided search
    /// The same maximum for a run of an abstraction in which instances that read the loop are also abstracted.
    std::size_t followed_coarse = 20'000;
    /// Number of states of the complete loop that are searched before the abstractions; may be 0.
    std::uint64_t explored = std::uint64_t{1} << 20U;
    /// Maximum number of searches for one property in which only autonomous instances are abstracted.
    std::size_t rounds = 8;
    /// Maximum number of searches for one property in one round, except for the last round. Many searches of one
    /// property, usually `reachable all steps`, would use the time of the others.
    std::size_t searches_per_round = 8;
    /// Maximum number of preceding searches for one property in which instances that read the loop are also abstracted.
    std::size_t coarse_rounds = 32;
    /// Per property: an abstraction that decided the property in a similar loop. The search begins with this
    /// abstraction instead of the coarsest abstraction. Processes that are not named are complete.
    std::map<std::string, InputsAbstracted> known = {};
};

class InputAbstractionCheck;

/// Decides properties that are open in `result` because a limit ended its search, or because integer time is not exact
/// for them.
class InputSearch {
public:
    /// `loop` is expanded and has no observers. `result` is the result for observe(loop), with the verdicts that
    /// `options` select. The memory limits are those of `options`. All references must outlive the search.
    InputSearch(const Network& loop, const Observe& observe, const TimedOptions& options, TimedResult& result,
                const InputLimits& limits = {}, const InputAblations& ablations = {});
    ~InputSearch();
    InputSearch(InputSearch&&) = delete;

    /// Performs one round: searches of at most `states` states each. Returns false if no search is left for the next
    /// round.
    bool run(std::uint64_t states, const Deadline& deadline);

private:
    std::unique_ptr<InputAbstractionCheck> search_;
};

}  // namespace grafverif
