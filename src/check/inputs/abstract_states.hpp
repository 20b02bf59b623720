// SPDX-License-Identifier: MIT
// AbstractStates: all states of an input abstraction (ir/network_inputs.hpp) without clocks, in which each process is
// Chosen or Untimed.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "check/inputs/follow.hpp"
#include "check/timed/machine.hpp"
#include "check/timed/store/packed_states.hpp"

namespace grafverif {

/// Returns levels: the instances of the *panel* are Chosen, and all other processes are Untimed. An instance belongs to
/// the panel if it is autonomous, need not move, and can always return to its initial state
/// (AbstractableProcess::returns). Instances of `read`, and instances that an Untimed process reads, do not belong to
/// the panel. If `all` is true, instances that cannot always return to their initial state also belong to the panel.
/// Only tests set `all`, to show that PossibleProof needs the premise (InputAblations::need_not_return).
std::vector<InputLevel> panel_levels(const Network& loop, const std::vector<AbstractableProcess>& instances,
                                     const std::set<Id<Network::Process>>& read, bool all = false);

class AbstractStates {
public:
    AbstractStates(const Network& loop, const std::vector<AbstractableProcess>& instances,
                   const std::vector<InputLevel>& levels);
    AbstractStates(AbstractStates&&) = delete;

    /// Searches the states. Returns true if all states were found. Returns false if the abstraction cannot be used: it
    /// has a model error, a clock or too many combinations of inputs, or a PLC can remain inside its cycle. Returns
    /// nullopt if a limit is reached; the next call continues the search.
    std::optional<bool> run(const FollowLimits& limits);

    /// `expand` returns the moves of a state. After a call of `expand`, `successor` returns the state to which move
    /// number `move` of the expanded state leads.
    const timed::Moves& expand(std::uint32_t state);
    std::uint32_t successor(std::size_t move);
    const timed::Word* words(std::uint32_t state) const { return states_->words(state); }

    /// Returns the abstraction. Its list of properties is that of the loop.
    const Network& network() const { return network_; }
    /// True if each PLC is in W in the state that `words` represents.
    bool all_wait(const timed::Word* words) const;
    std::size_t size() const { return states_->size(); }
    timed::Machine& machine() { return *machine_; }
    const timed::Machine& machine() const { return *machine_; }

private:
    bool is_supported() const;

    Network network_ = {};  // the abstraction
    std::optional<timed::Machine> machine_ = {};
    std::unique_ptr<PackedStates> states_ = {};
    std::size_t next_ = 0;  // number of the first state that is not expanded
    bool failed_ = false;
    timed::Moves moves_ = {};
    std::vector<timed::Word> now_ = {};
};

}  // namespace grafverif
