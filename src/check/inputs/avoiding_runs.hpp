// SPDX-License-Identifier: MIT
// AvoidingRuns: the runs of an abstraction without clocks that avoid q forever, and the situations in which they remain.
//
// Only runs in which time diverges are considered (check/inputs/response.hpp). Such a run finally remains in one
// strongly connected component of the states without q, or in one state.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

#include "check/inputs/abstract_states.hpp"
#include "check/inputs/process_states.hpp"
#include "check/timed/components.hpp"

namespace grafverif {

/// A set of *situations*: joint values of the steps, the internal variables, and the locations of stored processes. A
/// run of the loop and the corresponding runs of all abstractions agree on these values (ir/network_inputs.hpp).
struct Situations {
    /// Columns of `values` in ascending order: the index of a variable, or the number of variables of the loop plus the
    /// index of a process.
    std::vector<std::uint32_t> columns = {};
    std::set<std::vector<std::int64_t>> values = {};  ///< each with one value per column

    /// Returns the situations without the columns that `columns` does not contain.
    Situations restricted_to(const std::vector<std::uint32_t>& columns) const;
};

/// Runs that avoid q and finally remain in some states, the *last states*. Before a run remains in the last states, its
/// last cycle of the PLC begins in one of the *starts*.
struct Remainder {
    std::vector<std::uint32_t> states = {};  ///< the last states
    Situations last = {};                    ///< the situations of the last states
    /// The Chosen processes (indices in the list of processes) whose values can end the runs.
    std::set<std::size_t> deciding = {};

    // Results of AvoidingRuns::find_starts:
    Situations passed = {};  ///< the situations from the beginning of the last cycle on
    /// Packed states in which the last cycle may begin; valid as long as the abstraction exists.
    std::vector<const timed::Word*> starts = {};
    bool from_initial = false;  ///< true if a run may remain in the last states before the first cycle begins
};

class AvoidingRuns {
public:
    using Levels = std::vector<InputLevel>;

    /// `property` is an `inevitable` or a `leads to` of `loop`. If `within` is not null, only runs that finally remain in
    /// its last states are considered. `loop` and `within` must outlive the object and must not move.
    AvoidingRuns(const Network& loop, const std::vector<AbstractableProcess>& instances, const Property& property,
                 const Levels& levels, const Remainder* within = nullptr);

    /// Explores all states that are reachable from the initial state. For the result, see AbstractStates::run.
    std::optional<bool> explore(const FollowLimits& limits);

    /// Explores the states of a refinement of `coarser` from the starts of the remainder `within` of `coarser` on.
    /// `stored` are the processes that this abstraction stores in addition. The loop must have one PLC. For the result,
    /// see AbstractStates::run.
    ///
    /// In a start, the two abstractions agree with the loop except for the additional processes, the flags that these
    /// processes set, and values without effect: samples, which the cycle overwrites before it reads them, and dead
    /// previous values (ir/network/dead_values.hpp).
    std::optional<bool> explore(const AvoidingRuns& coarser, const std::vector<const ProcessStates*>& stored,
                                const FollowLimits& limits, const InputAblations& ablations);

    /// Returns the runs that avoid q, by the processes that can end them. If `situations` is not null, only runs that
    /// finally remain in these situations are considered. Returns nullopt if a limit is reached. Requires that `explore`
    /// has returned true.
    std::optional<std::vector<Remainder>> remaining(const Situations* situations, const FollowLimits& limits);

    /// Finds the starts of a remainder. Returns false if a limit is reached or there are too many moves.
    bool find_starts(Remainder& remainder, const FollowLimits& limits);

    /// True if no state has p. Requires that `explore` has returned true.
    bool vacuous() const { return !requested_; }
    const Levels& levels() const { return levels_; }
    std::size_t states() const { return states_.size(); }
    std::uint64_t bytes() const {
        return states_.bytes() + starts_.bytes() + predecessors_.capacity() * sizeof(Predecessor);
    }

private:
    struct Predecessor {
        std::uint32_t state = 0;
        bool begins = false;  // true if the move begins a cycle of a PLC
    };

    /// Properties of a strongly connected component of states without q.
    struct Component {
        bool stays = false;                // true if time can pass forever in one of the states
        bool repeats = false;              // true if the component has a cycle
        bool urgent = true;                // true if an urgent edge is enabled in each state of the component
        std::vector<bool> moves = {};      // per process: true if one of its edges connects two states of the component
        std::vector<bool> unbounded = {};  // per process: true if, in some state, the invariant of its location has no
                                           // bound
        std::set<std::size_t> deciding = {};
    };

    /// Situations in the layout of this abstraction.
    struct PackedSituations {
        PackedSituations(const AvoidingRuns& runs, const Situations& situations);
        bool contain(const timed::Word* words);

        std::vector<timed::Word> mask = {};
        PackedStates rows;
        std::vector<timed::Word> now = {};
    };

    std::uint32_t compiled(Id<Expr> term);
    bool is_goal(const timed::Word* words);
    bool is_urgent(std::uint32_t state) const;
    bool is_bounded(std::uint32_t process, std::uint32_t state) const;
    bool may_stay(std::uint32_t state);
    bool may_repeat(const Component& component) const;

    void find_awaiting(const timed::Limits& limits);
    bool admits(const timed::Word* from, std::uint32_t edge, const timed::Word* to);
    bool begins_cycle(std::uint32_t edge) const;
    const timed::Field& field(std::uint32_t column) const;
    void add_to(Situations& situations, const timed::Word* words) const;
    void find_predecessors(const timed::Limits& limits);
    template <class Components>
    void add(std::uint32_t state, const Components& components, Component& component);
    template <class Components>
    void add_deciding(std::uint32_t state, const Components& components, Component& component);

    const Network& loop_;
    const Levels levels_;
    const Remainder* const within_;
    std::optional<PackedSituations> passed_ = {}, last_ = {};  // situations of `within_`
    AbstractStates states_;
    const Property& property_;  // the property, with terms of the abstraction
    const bool is_inevitable_;
    const std::uint32_t p_, q_;
    std::vector<bool> is_stored_;              // per process: false for instances with the level Chosen
    std::vector<std::uint32_t> columns_ = {};  // columns of the situations
    // Per state without q: true if q is awaited (the state follows a state with p), or, in a refinement, if the
    // situation is one of the last situations.
    std::vector<bool> considered_ = {};
    bool requested_ = false;
    PackedStates starts_;  // of a refinement: the states before the first states
    std::unordered_multimap<std::uint32_t, std::uint32_t> starts_of_ = {};  // per first state: numbers in starts_
    // Predecessors of state s: elements from first_of_[s] to first_of_[s + 1] of predecessors_.
    std::vector<std::size_t> first_of_ = {};
    std::vector<Predecessor> predecessors_ = {};
    std::vector<std::int64_t> registers_ = {};
};

}  // namespace grafverif
