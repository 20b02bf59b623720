// SPDX-License-Identifier: MIT
// All states of an input abstraction (ir/network_inputs.hpp) in which no clock remains: each process is Chosen or
// Untimed.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "check/inputs/follow.hpp"
#include "check/inputs/packed_states.hpp"
#include "check/timed/machine.hpp"

namespace grafverif {

/// The levels in which the *panel* is Chosen: autonomous instances that can rest and can always return to their initial
/// state by edges that only wait. All other processes are Untimed, and instances that one of these or `read` reads.
/// `all`: also instances that may not return (a wrong premise for PossibleProof).
std::vector<InputLevel> panel_levels(const Network& loop, const std::vector<AbstractableProcess>& instances,
                                     const std::set<Id<Network::Process>>& read, bool all = false);

class AbstractStates {
public:
    AbstractStates(const Network& loop, const std::vector<AbstractableProcess>& instances,
                   const std::vector<InputLevel>& levels);
    AbstractStates(AbstractStates&&) = delete;

    /// True: all are found. False: the abstraction has a model error, a clock remains, or a PLC may not end its cycle.
    /// Nothing: a limit is reached; a further call continues.
    std::optional<bool> run(const FollowLimits& limits);

    /// Every move of a state. Afterwards `successor` gives the states that they lead to.
    const timed::Moves& expand(std::uint32_t state);
    std::uint32_t successor(std::size_t move);
    const timed::Word* words(std::uint32_t state) const { return states_->words(state); }

    /// The abstraction; its properties are those of the loop.
    const Network& network() const { return network_; }
    /// True if each PLC waits.
    bool all_wait(const timed::Word* words) const;
    std::size_t size() const { return states_->size(); }
    timed::Machine& machine() { return *machine_; }
    const timed::Machine& machine() const { return *machine_; }

private:
    bool is_supported() const;

    Network network_ = {};  // the abstraction
    std::optional<timed::Machine> machine_ = {};
    std::unique_ptr<PackedStates> states_ = {};
    std::size_t next_ = 0;  // the first state that is not expanded
    bool failed_ = false;
    timed::Moves moves_ = {};
    std::vector<timed::Word> now_ = {};
};

}  // namespace grafverif
