// SPDX-License-Identifier: MIT
// Proves `always possible p` for dense time. A search in integer time cannot prove this property if the model has
// clocks (docs/explanation/timed-engine.md, "Exactness", 5).
//
// The states are those of the loop without clocks. A state is *good* if a run to a state with p begins in every state
// of dense time with the same locations and variables. The proof finds good states by four rules. Each move in these
// rules is possible for all values of the clocks. A state is good if one of the following conditions is satisfied:
//
//   1. p holds.
//   2. An urgent edge is enabled and leads to a good state.
//   3. No urgent edge is enabled, and some bounds of invariants are in force. For each bound, some enabled edge that
//      waits only for the clock of this bound leads to a good state. This is sufficient because time passes until one
//      of the bounds is reached.
//   4. No urgent edge is enabled, and no bound is in force. Some enabled edge without an upper bound leads to a good
//      state. This is sufficient because time passes until all clocks are large.
//
// Not all states need to be good. The *panel* consists of the autonomous instances that can rest and can always return
// to their initial state by edges whose clock constraints are only lower bounds. If `no timelock` has been proved with
// instances at rest (ir/network_inputs.hpp, check/inputs/resting.hpp), time diverges while the panel returns, from any
// state of the loop. Then the PLCs end their cycles. Therefore it is sufficient that the states are good in which the
// panel is in its initial state and each PLC waits. These states are found in an abstraction in which the panel is
// Chosen and all other processes are Untimed. The flag that the panel sets, EVOL_PL, may have either value.
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
    /// a limit is reached. The next call continues the search if it
    /// is for the same property.
    std::optional<bool> proves(const Property& property, const FollowLimits& limits);
    /// Returns the number of states that all calls explored.
    std::size_t states() const;

private:
    class States;
    std::unique_ptr<States> states_;
};

}  // namespace grafverif
