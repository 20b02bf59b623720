// SPDX-License-Identifier: MIT
// What a part of a loop is to the others with which it takes turns: whether it lets them wait for it, and the runs that
// show it (docs/engines.md, "Sub-loops").
//
// A step of the part waits or moves; where clocks count, waiting is the passing of time, and one that does neither
// repeats a state that nothing can leave.
#pragma once

#include <optional>
#include <vector>

#include "check/symbolic/check.hpp"

namespace grafverif::symbolic {

class Turns {
public:
    /// `waits`, `moves`: over main of `part`, what a step does. Requires check.complete(); `check` is of `part`, and
    /// outlives this.
    Turns(const TransitionSystem& part, Check& check, Id<Expr> waits, const std::vector<Id<Expr>>& moves);

    /// Some run waits again and again.
    bool diverges() { return !(waiting_for_ever() & model_.initial()).is_false(); }
    /// From each state that it reaches it can wait again.
    bool never_locks();
    /// No run moves for ever without waiting.
    bool rests() { return moving_for_ever().is_false(); }
    /// The states that it reaches in which it can wait.
    const Bdd& ready();
    const Bdd& reached() const { return reached_; }
    /// Whether the state with these values is one of them.
    bool reaches(const std::vector<std::int64_t>& values) const { return evaluate(reached_, model_.state_of(values)); }

    /// A run that waits again and again; none: it is too long. Requires diverges().
    std::optional<FlatRun> waiting_run();
    /// Moves from the state with these values to one of `goal`; where they lead to none, moves for ever. Requires that
    /// moves end there only.
    FlatRun moves_on(const std::vector<std::int64_t>& from, const Bdd& goal) const;
    /// The states without a move.
    Bdd still() const { return reached_ & ~model_.preimage(reached_, move_steps_); }
    /// A run of moves from the beginning, without end. Requires that it does not rest, and that waiting changes nothing.
    FlatRun endless_run();

private:
    const Bdd& waiting_for_ever();
    const Bdd& moving_for_ever();
    std::vector<State> moves_to(const State& from, const Bdd& goal, const Bdd& within) const;
    void add_moves(const std::vector<State>& states, FlatRun& run) const;
    void walk(State from, const Bdd& within, FlatRun& run) const;

    const StateSpace& model_;
    Bdd reached_ = {}, waits_ = {}, moves_ = {};
    std::deque<bdd::Steps> wait_steps_ = {}, move_steps_ = {};
    std::optional<Bdd> ready_ = {}, waiting_for_ever_ = {}, moving_for_ever_ = {};
};

}  // namespace grafverif::symbolic
