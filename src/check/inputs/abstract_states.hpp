// SPDX-License-Identifier: MIT
// AbstractStates: all states of an input abstraction without clocks. Each process has the level Chosen (arbitrary
// outputs, no state) or Untimed (no clocks); see ir/network_inputs.hpp.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "check/inputs/follow.hpp"
#include "check/timed/machine.hpp"
#include "check/timed/store/column.hpp"
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
    /// Returns true if a search considers the move by `edge` from one packed state to another.
    using Admits = std::function<bool(const timed::Word* from, std::uint32_t edge, const timed::Word* to)>;

    AbstractStates(const Network& loop, const std::vector<AbstractableProcess>& instances,
                   const std::vector<InputLevel>& levels);
    /// Records the moves. Of the properties, considers only the one named `property`; the states do not contain the
    /// variables that have no effect in the loop with this property (timed::unread_variables). If `admits` is null, the
    /// search begins in the initial state. Otherwise it begins in the states that are passed to `add`, and considers only
    /// moves for which `admits` returns true.
    AbstractStates(const Network& loop, const std::vector<AbstractableProcess>& instances,
                   const std::vector<InputLevel>& levels, const std::string& property, Admits admits);
    AbstractStates(AbstractStates&&) = delete;

    /// Adds a state, with Layout::words words, from which the search begins. Returns its number.
    std::uint32_t add(const timed::Word* words) { return states_->add(words).state; }

    /// Searches the states. Returns true if all states were found. Returns false if the abstraction cannot be used: the
    /// abstraction has a model error, a race, a clock or too many combinations of inputs, or a PLC can stay in a
    /// location inside its cycle. Returns nullopt if a limit is reached; the next call continues the search.
    std::optional<bool> run(const FollowLimits& limits);

    /// Returns the moves of a state, with Moves::chosen if `with_choices` is true.
    const timed::Moves& expand(std::uint32_t state, bool with_choices = false);
    /// Returns the state to which move number `move` of the last expanded state leads; Store::none if the search does
    /// not consider this move.
    std::uint32_t successor(std::size_t move);
    /// Calls `visit(edge, next)` for each recorded move of a state; `next` is Store::none if the search does not consider
    /// the move. Requires that `run` has returned true.
    template <class Visit>
    void each_move(std::uint32_t state, const Visit& visit) const {
        const std::size_t end = state + 1 < first_moves_.size() ? first_moves_[state + 1] : recorded_.size();
        for (std::size_t i = first_moves_[state]; i < end; ++i) visit(recorded_[i].edge, recorded_[i].next);
    }
    std::size_t recorded_moves() const { return recorded_.size(); }
    const timed::Word* words(std::uint32_t state) const { return states_->words(state); }

    /// Copies the locations and the stored variables of a state to packed words in the layout `to`. The layout belongs to
    /// a network with the processes and variables of the loop.
    void copy(const timed::Word* state, const timed::Layout& to, timed::Word* words) const;

    /// Returns the abstraction. The abstraction has the same list of properties as the loop, or only the given property.
    const Network& network() const { return network_; }
    /// Returns, per variable, true if the states contain no value of the variable.
    const timed::VariableSet& unstored() const { return unstored_; }
    /// True if, in the state that `words` represents, each PLC is in its waiting location W.
    bool all_wait(const timed::Word* words) const;
    std::size_t size() const { return states_->size(); }
    std::uint64_t bytes() const { return states_->bytes() + recorded_.bytes() + first_moves_.bytes(); }
    timed::Machine& machine() { return *machine_; }
    const timed::Machine& machine() const { return *machine_; }

private:
    void build(const Network& loop, const std::vector<AbstractableProcess>& instances,
               const std::vector<InputLevel>& levels);
    bool is_supported() const;

    struct Recorded {
        std::uint32_t edge = 0, next = 0;
    };

    const Admits admits_ = nullptr;
    const bool records_ = false;
    timed::Column<std::size_t> first_moves_ = {};  // per expanded state: index of its first move in recorded_
    timed::Column<Recorded> recorded_ = {};
    Network network_ = {};  // the abstraction
    timed::VariableSet unstored_ = {};
    std::optional<timed::Machine> machine_ = {};
    std::unique_ptr<PackedStates> states_ = {};
    std::size_t next_ = 0;  // number of the first state that is not expanded yet
    bool failed_ = false;
    timed::Moves moves_ = {};
    std::vector<timed::Word> now_ = {};
};

}  // namespace grafverif
