// SPDX-License-Identifier: MIT
// Proves `always possible p` for dense time. A search in integer time cannot prove `always possible` if the model has
// clocks (docs/explanation/timed-engine.md, "Exactness", 5).
//
// The proof considers the states of the loop without clocks. Such a state represents all states of dense time with the
// same locations and variables. It is *good* if a state with p is reachable from each state of dense time that it
// represents. The proof finds good states by four rules. A move in these rules must be possible for all values of the
// clocks. A state is good if one of the following conditions is satisfied:
//
//   1. p holds.
//   2. An urgent edge is enabled in the state and leads to a good state.
//   3. No urgent edge is enabled, and the invariants of the current locations have at least one bound. For each bound,
//      an edge that covers the bound (EdgeTiming::covers) and whose guard holds leads to a good state. This is
//      sufficient because time passes until one of the bounds is reached.
//   4. No urgent edge is enabled, and the invariants of the current locations have no bound. An edge whose guard holds
//      and that is enabled for all large clock values (EdgeTiming::at_last) leads to a good state. This is sufficient
//      because time passes until all clocks are large.
//
// The property holds although some states are not good, as follows. The *panel* consists of the autonomous instances
// that need not move and can always return to their initial state by edges whose clock constraints are only lower
// bounds. Assume that `no timelock` has been proved for runs in which such instances do not move
// (ir/network_inputs.hpp, check/inputs/resting.hpp). Then, from any state of the loop, time can diverge while the panel
// returns to its initial state, and the PLCs end their cycles. Therefore it is sufficient that all states are good in
// which the panel is in its initial state and each PLC waits. These states are found in an abstraction in which the
// panel is Chosen and all other processes are Untimed. The flag that the panel sets, EVOL_PL, may have either value.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "check/inputs/follow.hpp"

namespace grafverif {

class PossibleProof {
public:
    /// `loop` must be complete and expanded, have neither observers nor strict constraints, and outlive the proof.
    PossibleProof(const Network& loop, const std::vector<AbstractableProcess>& instances,
                  const InputAblations& ablations = {});
    ~PossibleProof();

    /// Returns the levels of the abstraction in which the states that must be good are found.
    const std::vector<InputLevel>& levels() const;
    /// Returns true if `property`, which is `always possible`, holds; false if this method cannot prove it; nullopt if
    /// a limit is reached. The next call with the same property continues the search.
    std::optional<bool> proves(const Property& property, const FollowLimits& limits);
    /// Returns the number of states that all calls explored.
    std::size_t states() const;

private:
    class States;
    std::unique_ptr<States> states_;
};

}  // namespace grafverif
