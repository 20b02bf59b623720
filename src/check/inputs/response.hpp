// SPDX-License-Identifier: MIT
// Proves `inevitable q` and `p leads to q` on an abstraction without clocks. Properties with a time bound (`within`)
// are not supported.
//
// Premises: `no timelock` is proved, and no run has infinitely many moves in bounded time (check/inputs/resting.hpp).
// Therefore time diverges in each maximal run of the loop. The corresponding run of the abstraction has one of two
// forms:
//   - The run has a last move; after this move, no urgent edge is enabled and no current location has an invariant with
//     a bound.
//   - The run has infinitely many moves. Infinitely many states of the run have no enabled urgent edge, and no process
//     stays forever in a location whose invariant has a bound.
// The conditions on locations concern only processes that the abstraction stores.
//
// The first abstraction has the level Chosen for the panel and for all instances of the plant that the property does not
// read. If the abstraction has runs of these forms without q, these runs finally remain in few situations. Every run of
// the loop without q also remains in these situations, because the loop and all abstractions agree on the situation.
// Therefore it is sufficient to exclude runs that remain in these situations. For each of them, an instance whose values
// can end the run is stored, and only these situations are explored (divide and compose: C. Wang, R. Bloem,
// G. D. Hachtel, K. Ravi, F. Somenzi, Divide and Compose: SCC Refinement for Language Emptiness, CONCUR 2001). If this
// exploration excludes no run, further instances are stored. Finally, all states of the abstraction with the levels of
// panel_levels are explored.
//
// A run enters the situations at an unknown state of the additional instance. The exploration begins with the last cycle
// of the PLC that begins before the run remains in the situations: this cycle samples the outputs of the instance, which
// may be in any of its states (ProcessStates). The next cycles begin in the situations. This requires that the loop has
// one PLC.
//
// The property holds if each run of these forms reaches q (for `p leads to q`: after each state in which p holds).
#pragma once

#include <optional>
#include <vector>

#include "check/inputs/follow.hpp"

namespace grafverif {

struct ResponseResult {
    /// True if the property is proved, false if this method cannot prove the property, nullopt if a limit was reached.
    std::optional<bool> holds = {};
    /// True if p holds in no state that the search found, so that `p leads to q` holds vacuously.
    bool vacuous = false;
    std::vector<InputLevel> levels = {};
    std::size_t states = 0;
    std::size_t refinements = 0;  ///< number of explorations of few situations
};

/// Proves `property`, which is a property of `loop`. Requires that `loop` is expanded, is not an abstraction, and has
/// neither observers nor strict clock constraints.
ResponseResult prove_response(const Network& loop, const std::vector<AbstractableProcess>& instances,
                              const Property& property, const FollowLimits& limits,
                              const InputAblations& ablations = {});

}  // namespace grafverif
