// SPDX-License-Identifier: MIT
// PossibleProof: proves `always possible p` for dense time. A search in integer time cannot prove `always possible` if
// the model has clocks (docs/explanation/timed-engine.md, "Exactness", 5).
//
// The proof considers the states of the loop without clocks. A state without clocks represents all dense-time states
// with the same locations and variables. The state is *good* if a state in which p holds is reachable from each
// dense-time state that it represents. The proof finds good states by four rules. A move in these rules must be
// possible for all values of the clocks. A state is good if one of the following conditions is satisfied:
//
//   1. p holds in the state.
//   2. An urgent edge is enabled in the state and leads to a good state.
//   3. No urgent edge is enabled, and the invariants of the current locations have at least one bound. For each bound,
//      an edge that is enabled when the bound is reached (EdgeTiming::covers) and whose guard holds leads to a good
//      state. This condition is sufficient because time passes until one of the bounds is reached.
//   4. No urgent edge is enabled, and the invariants of the current locations have no bound. An edge whose guard holds
//      and that is enabled for all large clock values (EdgeTiming::at_last) leads to a good state. This condition is
//      sufficient because time can pass until all clocks are large.
//
// The proof does not require that all states are good. It is sufficient that the required states are good
// (check/inputs/required_states.hpp, which also states the premises). The proof is first attempted with the required
// states after a homing sequence, and then with the required states without a homing sequence.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "check/inputs/follow.hpp"

namespace grafverif {

class PossibleProof {
public:
    /// `loop` must be expanded, must not be an abstraction, must have neither observers nor strict clock constraints,
    /// and must outlive the proof.
    PossibleProof(const Network& loop, const std::vector<AbstractableProcess>& instances,
                  const InputAblations& ablations = {});
    ~PossibleProof();

    /// Returns the levels of the abstraction whose states are considered: Chosen for the panel, Untimed for all other
    /// processes.
    const std::vector<InputLevel>& levels() const;
    /// Returns true if the `always possible` property `property` holds, false if the four rules cannot prove the
    /// property, and nullopt if a limit is reached. After nullopt, the next call with the same property continues the
    /// search.
    std::optional<bool> proves(const Property& property, const FollowLimits& limits);
    /// Returns the moves of the homing sequence of the last proof (RequiredStates::sequence).
    const std::vector<std::string>& sequence() const;
    /// Returns the total number of states explored in all calls of `proves`.
    std::size_t states() const;

private:
    class States;
    std::unique_ptr<States> states_;
};

}  // namespace grafverif
