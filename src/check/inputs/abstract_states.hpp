// SPDX-License-Identifier: MIT
// AbstractStates: all states of an input abstraction without clocks. Each process has the level Chosen (arbitrary
// outputs, no state) or Untimed (no clocks); see ir/network_inputs.hpp.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "check/inputs/follow.hpp"
#include "check/timed/machine.hpp"
#include "check/timed/store/packed_states.hpp"

namespace grafverif {

/// Returns the level of each process: Chosen for the instances of the *panel*, Untimed for all other processes. An
/// instance belongs to the panel if it reads only its own variables, need not move, and can always return to its
/// initial state (AbstractableProcess::returns). Instances in the set `read`, and instances that an Untimed process
/// reads, do not belong to the panel. If `all` is true, instances that cannot always return to their initial state also
/// belong to the panel. Only tests set `all`, to show that PossibleProof is unsound without the premise
/// (InputAblations::need_not_return).
std::vector<InputLevel> panel_levels(const Network& loop, const std::vector<AbstractableProcess>& instances,
                                     const std::set<Id<Network::Process>>& read, bool all = false);

/// Returns `levels`, a result of panel_levels, with the level Chosen for further instances, except for timers and for
/// instances in the set `read`. The outputs of these instances are read only by PLCs and by other Chosen instances.
std::vector<InputLevel> levels_with_plant(const Network& loop, const std::vector<AbstractableProcess>& instances,
                                          std::vector<InputLevel> levels,
                                          const std::set<Id<Network::Process>>& read = {});

class AbstractStates {
public:
    AbstractStates(const Network& loop, const std::vector<AbstractableProcess>& instances,
                   const std::vector<InputLevel>& levels);
    AbstractStates(AbstractStates&&) = delete;

    /// Searches the states. Returns true if all states were found. Returns false if the abstraction cannot be used: the
    /// abstraction has a model error, a race, a clock or too many combinations of inputs, or a PLC can stay in a
    /// location inside its cycle. Returns nullopt if a limit is reached; the next call continues the search.
    std::optional<bool> run(const FollowLimits& limits);

    /// Returns the moves of a state, with Moves::chosen if `with_choices` is true.
    const timed::Moves& expand(std::uint32_t state, bool with_choices = false);
    /// Returns the state to which move number `move` of the last expanded state leads.
    std::uint32_t successor(std::size_t move);
    const timed::Word* words(std::uint32_t state) const { return states_->words(state); }

    /// Returns the abstraction. The abstraction has the same list of properties as the loop.
    const Network& network() const { return network_; }
    /// True if, in the state that `words` represents, each PLC is in its waiting location W.
    bool all_wait(const timed::Word* words) const;
    std::size_t size() const { return states_->size(); }
    timed::Machine& machine() { return *machine_; }
    const timed::Machine& machine() const { return *machine_; }

private:
    bool is_supported() const;

    Network network_ = {};  // the abstraction
    std::optional<timed::Machine> machine_ = {};
    std::unique_ptr<PackedStates> states_ = {};
    std::size_t next_ = 0;  // number of the first state that is not expanded yet
    bool failed_ = false;
    timed::Moves moves_ = {};
    std::vector<timed::Word> now_ = {};
};

}  // namespace grafverif
