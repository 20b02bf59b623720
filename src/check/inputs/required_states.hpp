// SPDX-License-Identifier: MIT
// RequiredStates: a set of states of a closed loop such that each run of the loop can be continued to a state of the
// set. Therefore `always possible p` holds if a state in which p holds is reachable from each required state.
//
// Premises: an instance of the *panel* is autonomous, need not move, and can always return to its initial state by edges
// whose clock constraints are only lower bounds. `no timelock` has been proved for runs in which autonomous instances
// that need not move stay in their locations (ir/network_inputs.hpp, check/inputs/resting.hpp). Then each run can be
// continued such that time diverges while the panel performs finitely many moves of our choice; each move can be
// performed after some time, and the PLCs end their cycles. Time passes only in states without an enabled urgent edge.
// Therefore only states without an enabled urgent edge are required.
//
// Without a homing sequence, the panel returns to its initial state. The required states are the states of an
// abstraction (levels of panel_levels) in which each PLC waits and the panel is in its initial state.
//
// A *homing sequence* of an automaton is an input sequence after which few states are possible (E. F. Moore,
// Gedanken-experiments on sequential machines, 1956, for the case of one state). Here, the automaton is the PLC with its
// timers, and the inputs are moves of the panel. For example, an operator presses the emergency stop, and the charts
// return to their initial situations. The sequence is computed in an abstraction in which the panel and the plant have
// the level Chosen, so that it is valid for all states of the plant:
//   - a move of a panel instance is used only if its flag makes an urgent edge of the waiting PLC enabled, or another
//     process has an enabled urgent edge. Therefore a cycle of the PLC begins after the move, and samples the new values.
//   - after the move, the waiting states of the PLC are those that are reachable by the edges that begin a cycle, and
//     then by all edges that are possible with the new values of the panel and arbitrary values of the plant.
//   - the next move is the one after which the fewest waiting states are possible.
// After the last move, the variables that the PLC writes have only values that occur in the found states. Each process
// of the plant leaves the states in which it must move, and does not return to a state without a path to it
// (ProcessStates::late). The required states are the combinations of the remaining states of the PLC, its timers and the
// processes of the plant. This set may be larger or smaller than the set without a homing sequence.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "check/inputs/abstract_states.hpp"
#include "check/inputs/process_states.hpp"
#include "check/timed/timed.hpp"

namespace grafverif {

class RequiredStates {
public:
    /// `panel_levels` are the levels of the function panel_levels. A homing sequence requires that the loop has one
    /// controller. `loop` must be expanded, must not be an abstraction, and must outlive the object.
    RequiredStates(const Network& loop, const std::vector<AbstractableProcess>& instances,
                   const std::vector<InputLevel>& panel_levels, bool with_sequence, const InputAblations& ablations);
    RequiredStates(RequiredStates&&) = delete;

    /// Searches the abstraction and the homing sequence. Returns true if the required states are known, false if the
    /// method does not support the loop, and nullopt if a limit is reached; the next call continues the search.
    std::optional<bool> find(const FollowLimits& limits);

    /// Calls `visit` for each required state, in the layout `to` of a network with the processes and variables of the
    /// loop. Some states may have an enabled urgent edge. Requires that `find` has returned true. Returns false if a
    /// limit is reached.
    bool each(const timed::Layout& to, const FollowLimits& limits,
              const std::function<void(const timed::Word*)>& visit) const;

    /// Describes the moves of the homing sequence, such as "`ESTOP` becomes true".
    const std::vector<std::string>& sequence() const { return sequence_; }
    std::size_t size() const { return states_.size(); }

private:
    /// An instance at the level Chosen.
    struct Chosen {
        ProcessStates local;
        bool is_panel = false;
        std::uint32_t now = 0;  // instance of the panel: number of its state after the moves of the homing sequence
        std::vector<bool> late = {};  // per state: true if the state is possible at late times after these moves
    };
    struct PanelMove {
        std::size_t instance = 0;  // index in chosen_
        std::uint32_t to = 0;      // number of the state to which the move leads
    };
    struct Combination;
    using Numbers = std::vector<std::uint32_t>;  // numbers of states of the abstraction

    bool find_sequence(const FollowLimits& limits);
    std::string text_of(const PanelMove& move) const;
    bool begins_cycle(const ProcessStates& local, std::uint32_t edge);
    bool begins_cycle(const std::set<Id<Network::Variable>>& flags);
    std::vector<timed::Word> admitted(const PanelMove& move) const;
    std::optional<Numbers> after(const PanelMove& move, std::size_t most, const FollowLimits& limits);
    std::size_t waiting(const Numbers& states) const;
    void find_late_states();
    std::vector<bool> admitted_valuations(const ProcessStates& local) const;
    bool combine(std::size_t first, Combination& combination) const;

    const Network& loop_;
    const std::vector<AbstractableProcess> instances_;
    const InputAblations ablations_;
    const TimedOptions options_ = {};
    const timed::Limits unlimited_{options_};
    const VariableUsers users_;
    const std::vector<ProcessClocks> clocks_;
    const bool with_sequence_;
    const std::vector<InputLevel> levels_;
    AbstractStates states_;
    std::deque<Chosen> chosen_ = {};  // empty without a homing sequence
    // Flags that Chosen instances set. The abstraction does not contain their values.
    std::vector<Id<Network::Variable>> flags_ = {};
    std::optional<bool> is_supported_ = {};                        // empty if not computed yet
    std::map<std::set<Id<Network::Variable>>, bool> begins_ = {};  // results of begins_cycle
    std::vector<std::string> sequence_ = {};
    Numbers found_ = {};  // states of the abstraction that are possible after the homing sequence
};

}  // namespace grafverif
