// SPDX-License-Identifier: MIT
// Decides properties about single states on input abstractions of a closed loop (ir/network_inputs.hpp).
//
// Each property begins with the coarsest levels: `Untimed` for the processes that it reads and for timers, `Chosen` for
// the others. Properties with equal levels share a search, whose time unit is the greatest common divisor of the
// durations in the abstraction. A verdict that the abstraction preserves is a verdict of the complete loop. A run that
// it does not preserve is followed in the complete loop (follow.hpp); if that succeeds, it is a real run. Otherwise the
// level of a process that cannot do what the run requires of it is raised, and the search is repeated. A property that
// remains open begins again with autonomous instances abstracted only.
//
// The searches run in rounds with growing bounds on states. A search that ends at the bound of a round is repeated in
// the next round. So a property that a small search decides does not wait for one that needs a large search. Each round
// begins with a search for runs of the complete loop (novelty.hpp).
//
// An abstraction with a model error gives no verdict, since the states after the error are not explored.
#pragma once

#include <functional>
#include <memory>

#include "check/shares.hpp"
#include "check/timed/timed.hpp"

namespace grafverif {

/// Adds the observers of the current properties; the identity if there are none.
using Observe = std::function<Network(const Network&)>;

struct InputLimits {
    std::uint64_t states = std::uint64_t{1} << 24U;         ///< of one search of an abstraction
    std::uint64_t coarse_states = std::uint64_t{1} << 22U;  ///< while plants are abstracted
    std::size_t followed = 200'000;                         ///< states of one guided search
    std::size_t followed_coarse = 20'000;              ///< the same while instances that read the loop are abstracted
    std::uint64_t explored = std::uint64_t{1} << 20U;  ///< of the complete loop, before the abstractions; 0: none
    std::size_t rounds = 8;                            ///< searches of one property
    std::size_t coarse_rounds = 32;                    ///< before those, with instances that read the loop abstracted
};

/// Bounds of the rounds.
inline constexpr std::uint64_t input_rounds[] = {1U << 14U, 1U << 17U, 1U << 20U, 1U << 24U};

class InputAbstractionCheck;

/// Decides the properties that `result` leaves open because of its bound on states.
class InputSearch {
public:
    /// `loop`: expanded, without observers; `result` is that of observe(loop), with the verdicts of `options`. The
    /// limits of memory are those of `options`. All references outlive the search.
    InputSearch(const Network& loop, const Observe& observe, const TimedOptions& options, TimedResult& result,
                const InputLimits& limits = {}, const InputAblations& ablations = {});
    ~InputSearch();
    InputSearch(InputSearch&&) = delete;

    /// One round: searches of at most `states` states each. False if no search is left for the next round.
    bool run(std::uint64_t states, const Deadline& deadline);

private:
    std::unique_ptr<InputAbstractionCheck> search_;
};

}  // namespace grafverif
