// SPDX-License-Identifier: MIT
// InterleavingPremises: facts about one part (independent subsystem) of a loop. Verdicts about the other parts, whose
// steps are interleaved with the steps of this part, depend on these facts (docs/explanation/decomposition.md,
// "Sub-loops"). The class also returns runs that demonstrate the facts.
//
// In a step, the part waits or moves. If the loop has clocks, the part waits in each step in which time passes. If the
// part neither waits nor moves in a step, the step repeats a state from which no other step is possible.
#pragma once

#include <optional>
#include <vector>

#include "check/symbolic/check.hpp"

namespace grafverif::symbolic {

class InterleavingPremises {
public:
    /// `waits` and `moves` are terms over the module `main` of `part`. `waits` is true in a step in which the part
    /// waits; each term of `moves` is true in a step in which one process moves. Requires check.complete(). `check` is
    /// the check of `part` and must outlive the object.
    InterleavingPremises(const TransitionSystem& part, Check& check, Id<Expr> waits,
                         const std::vector<Id<Expr>>& moves);

    /// True if the part waits infinitely often in some run.
    bool diverges() { return !(waiting_forever() & model_.initial()).is_false(); }
    /// True if, from each reachable state, the part can reach a step in which it waits.
    bool never_locks();
    /// True if the part has no infinite sequence of moves without waiting.
    bool rests() { return moving_forever().is_false(); }
    /// Returns the reachable states in which the part can wait.
    const Bdd& ready();
    const Bdd& reached() const { return reached_; }
    /// True if the state with these values is reachable.
    bool reaches(const std::vector<std::int64_t>& values) const { return evaluate(reached_, model_.state_of(values)); }

    /// Returns a run in which the part waits infinitely often, or nullopt if the run would be too long. Requires
    /// diverges().
    std::optional<FlatRun> waiting_run();
    /// Returns a run of moves from the state with the values `from` to a state of `goal`. If no sequence of moves
    /// reaches a state of `goal`, returns an infinite run of moves. Requires that every maximal finite sequence of
    /// moves ends in `goal`.
    FlatRun moves_on(const std::vector<std::int64_t>& from, const Bdd& goal) const;
    /// Returns the reachable states from which no move is possible.
    Bdd still() const { return reached_ & ~model_.preimage(reached_, move_steps_); }
    /// Returns an infinite run of moves from the initial state. Requires that rests() is false and that waiting does
    /// not change the state.
    FlatRun endless_run();

private:
    const Bdd& waiting_forever();
    const Bdd& moving_forever();
    std::vector<State> moves_to(const State& from, const Bdd& goal, const Bdd& within) const;
    void add_moves(const std::vector<State>& states, FlatRun& run) const;
    void follow_moves(State from, const Bdd& within, FlatRun& run) const;

    const StateSpace& model_;
    Bdd reached_ = {}, waits_ = {}, moves_ = {};
    std::deque<bdd::ClusterSteps> wait_steps_ = {}, move_steps_ = {};
    std::optional<Bdd> ready_ = {}, waiting_forever_ = {}, moving_forever_ = {};
};

}  // namespace grafverif::symbolic
