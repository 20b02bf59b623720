// SPDX-License-Identifier: MIT
// Proves `always possible p` for dense time, where a search in integer time cannot (docs/explanation/timed-engine.md,
// "Exactness", 5).
//
// States are those of the loop without clocks. A state is *good* if in every dense state that agrees with it a run to p
// begins. The proof finds good states by four rules, each with a move that is possible for all values of the clocks:
//
//   1. p holds.
//   2. An urgent edge is enabled, and leads to a good state.
//   3. No urgent edge is enabled, and some bounds of invariants are in force. Time passes until one of them is reached.
//      So for each bound, some enabled edge that waits for its clock alone leads to a good state.
//   4. No urgent edge is enabled, and no bound is in force. Time passes until all clocks are large. Then some enabled
//      edge that has no upper bound leads to a good state.
//
// Not all states need to be good. The *panel* are the autonomous instances that can rest and can always return to their
// initial state by edges that only wait. If `no timelock` has been proved with instances at rest (ir/network_inputs.hpp,
// check/inputs/resting.hpp), time diverges while the panel returns, from any state of the loop. Then the PLCs end their
// cycles. So it is sufficient that those states are good in which the panel is in its initial state and each PLC waits.
// These are found in an abstraction in which the panel is Chosen and all other processes are Untimed; the flag that the
// panel sets, EVOL_PL, may have either value.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "check/inputs/follow.hpp"

namespace grafverif {

class PossibleProof {
public:
    /// `loop`: complete, expanded, without observers and strict constraints; must outlive the proof.
    PossibleProof(const Network& loop, const std::vector<AbstractableProcess>& instances,
                  const InputAblations& ablations = {});
    ~PossibleProof();

    /// The levels of the abstraction in which the states to be proved are found.
    const std::vector<InputLevel>& levels() const;
    /// True: the property, `always possible`, holds. False: this method cannot prove it. Nothing: a limit is reached.
    std::optional<bool> proves(const Property& property, const FollowLimits& limits);
    /// States explored by all calls.
    std::size_t states() const;

private:
    class States;
    std::unique_ptr<States> states_;
};

}  // namespace grafverif
