// SPDX-License-Identifier: MIT
// ProcessStates: the states and moves of one process of a network, for all values of the variables that other processes
// write. A state consists of the location of the process and of the values of the variables that only this process
// writes. Clocks are not part of the state.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "check/timed/components.hpp"
#include "check/timed/layout.hpp"
#include "ir/network_clocks.hpp"
#include "ir/slots.hpp"
#include "ir/variable_users.hpp"

namespace grafverif {

/// A request that a timer accepts, and the Boolean variables of the timer that have one fixed value after all edges
/// which accept this request.
struct TimerRequest {
    Id<Network::Variable> request = {};
    std::vector<std::pair<Id<Network::Variable>, bool>> results = {};
};

class ProcessStates {
public:
    using Values = std::vector<std::int64_t>;
    struct State {
        Id<Network::Location> location = {};
        Values values = {};  ///< values of the variables `own()`
        auto operator<=>(const State&) const = default;
    };
    struct Move {
        std::uint32_t from = 0, to = 0;  ///< indices in `states()`
        std::uint32_t edge = 0;
        std::uint32_t valuation = 0;  ///< index in `valuations()`
    };

    /// The arguments must outlive the object.
    ProcessStates(const Network& network, const VariableUsers& users, const ProcessClocks& clocks,
                  Id<Network::Process> id, const timed::Limits& limits);

    /// Computes all moves. Returns false if there are too many moves, if a value may be undefined or out of range, or
    /// if the process is not supported.
    bool explore();

    bool leaves_bounds() const { return bounds_left_; }

    /// True if no cycle of urgent edges contains an edge that assigns a variable which another process (if `to_plcs` is
    /// true: a PLC) reads. A variable of another process is constant if `steady` is true for the variable; otherwise
    /// the variable can change at any time.
    bool shows_finitely(const std::vector<bool>& steady, bool to_plcs) const;

    /// True if, while the variables of other processes are constant, each cycle of urgent edges contains an edge that
    /// accepts a request.
    bool moves_finitely() const;

    /// True if each cycle of edges with at least one non-urgent edge takes at least one unit of time.
    bool repeats_slowly() const;

    /// Returns the requests that the process accepts, if it is a timer.
    std::vector<TimerRequest> requests() const;

    /// Returns, per state, true if the process can be in the state at arbitrarily late times while time diverges.
    /// Premise: from some time on, the process is only in states for which `possible` is true, and the variables of
    /// other processes have only valuations for which `admitted` is true. A state is excluded if the process must leave
    /// it and cannot return to it. The process must leave a state if the invariant of its location has a bound, or if
    /// each admitted valuation enables an urgent edge. If `leave_freely` is true (InputAblations), the process is
    /// assumed to leave every state. Requires that some valuation is admitted.
    std::vector<bool> late(const std::vector<bool>& possible, const std::vector<bool>& admitted,
                           bool leave_freely = false) const;

    Id<Network::Process> process() const { return id_; }
    const Network::Template& automaton() const { return slots_.automaton; }
    /// Returns the variables that only this process writes.
    const std::vector<Id<Network::Variable>>& own() const { return own_; }
    /// Returns the variables that the process reads and that other processes write.
    const std::vector<Id<Network::Variable>>& others() const { return others_; }
    /// Returns all joint values of the variables `others()`.
    const std::vector<Values>& valuations() const { return valuations_; }
    /// Sets the location and the variables `own()` of packed words in the layout `to` to those of a state.
    void place(const State& state, const timed::Layout& to, timed::Word* words) const {
        to.locations[id_.index].set(words, state.location.index);
        for (std::size_t i = 0; i < own_.size(); ++i) to.variables[own_[i].index].set(words, state.values[i]);
    }
    /// Returns all states; the first state is the initial state.
    const std::vector<State>& states() const { return states_; }
    const std::vector<Move>& moves() const { return moves_; }

private:
    const Network::Edge& edge(std::uint32_t id) const { return slots_.automaton.edges[{id}]; }

    /// True if the edge requires that a clock is at least 1, and each cycle that contains the edge resets this clock.
    bool takes_time(std::uint32_t id) const;

    bool is_own(Id<Network::Variable> variable) const { return std::ranges::find(own_, variable) != own_.end(); }

    bool is_timer() const { return slots_.process.kind == Network::ProcessKind::Timer; }
    /// True if no process other than the PLCs and this process writes the variable.
    bool is_written_by_plcs(Id<Network::Variable> variable) const;

    /// Returns the request that the edge of a timer accepts: a variable v such that `v` is a conjunct of the guard, the
    /// edge assigns false to v, and only PLCs set v to true.
    std::optional<Id<Network::Variable>> accepted(const Network::Edge& edge) const;
    bool only_ends(Id<Network::Variable> request) const;
    /// True if each edge that assigns `variable` accepts `variable` as a request.
    bool accepts_only(Id<Network::Variable> variable) const;
    bool accepts_request(const Network::Edge& edge) const { return accepted(edge).has_value(); }

    /// True if another process (if `by_plcs` is true: a PLC) reads `variable`, which the edge assigns. False if
    /// `variable` is the request that the edge accepts.
    bool is_seen(const Network::Edge& edge, Id<Network::Variable> variable, bool by_plcs) const;

    bool is_simple() const;

    bool enumerate();

    std::uint32_t number_of(const State& state);

    std::optional<std::int64_t> value(Id<Expr> term, const Values& own, const Values& others) const;

    bool expand(std::uint32_t from, std::uint32_t valuation);

    /// True if a move that satisfies `counts` is on a cycle of `moves`.
    template <class Counts>
    bool repeats(const std::vector<const Move*>& moves, const Counts& counts) const {
        std::vector<std::vector<std::uint32_t>> next(states_.size());
        for (const Move* const move : moves) next[move->from].push_back(move->to);
        timed::Components components(states_.size(), limits_, [&](std::uint32_t state, const auto& take) {
            std::ranges::for_each(next[state], take);
        });
        for (const Move* const move : moves) components.visit(move->from);
        return std::ranges::any_of(moves, [&](const Move* move) {
            return counts(*move) && components.of(move->from) == components.of(move->to);
        });
    }

    const timed::Limits& limits_;
    const Network& network_;
    const VariableUsers& users_;
    const Id<Network::Process> id_;
    const Slots slots_;
    std::vector<Id<Network::Variable>> own_ = {}, others_ = {};
    std::vector<EdgeTiming> timing_ = {};  // timing of each edge
    std::vector<bool> accepts_ = {};       // per edge: true if it accepts a request
    std::vector<bool> shows_[2] = {};      // per edge: true if it assigns a variable that another process (index 0) or
                                           // a PLC (index 1) reads
    std::vector<Values> valuations_ = {};  // all joint values of the variables in others_
    std::vector<State> states_ = {};
    std::map<State, std::uint32_t> numbers_ = {};
    std::vector<Move> moves_ = {};
    bool bounds_left_ = true;
};

}  // namespace grafverif
