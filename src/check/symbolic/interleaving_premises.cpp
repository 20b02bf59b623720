// SPDX-License-Identifier: MIT
#include "check/symbolic/interleaving_premises.hpp"

#include <map>

namespace grafverif::symbolic {

namespace {

/// Maximum number of states of a run that `waiting_run` returns.
constexpr std::size_t longest_run = 20'000;

}  // namespace

InterleavingPremises::InterleavingPremises(const TransitionSystem& part, Check& check, Id<Expr> waits,
                                           const std::vector<Id<Expr>>& moves)
    : model_(check.model()), reached_(check.reached()), waits_(check.meaning(part, waits)) {
    for (const Id<Expr> move : moves) moves_ |= check.meaning(part, move);
    wait_steps_ = model_.steps_where(waits_);
    move_steps_ = model_.steps_where(moves_);
}

const Bdd& InterleavingPremises::ready() {
    if (!ready_) ready_ = reached_ & model_.preimage(reached_, wait_steps_);
    return *ready_;
}

bool InterleavingPremises::never_locks() { return (reached_ & ~can_reach(model_, reached_, ready())).is_false(); }

const Bdd& InterleavingPremises::waiting_forever() {
    if (waiting_forever_) return *waiting_forever_;
    Bdd staying = reached_;
    for (Bdd before; before != staying;) {
        before = staying;
        staying = can_reach(model_, staying, staying & model_.preimage(staying, wait_steps_));
    }
    return waiting_forever_.emplace(std::move(staying));
}

const Bdd& InterleavingPremises::moving_forever() {
    if (moving_forever_) return *moving_forever_;
    Bdd staying = reached_;
    for (Bdd before; before != staying;) {
        before = staying;
        staying &= model_.preimage(staying, move_steps_);
    }
    return moving_forever_.emplace(std::move(staying));
}

/// Returns the states of a shortest path of moves from `from` through states of `within` to a state of `goal`. The
/// result includes the first and the last state of the path. If there is no path, the result is empty.
std::vector<State> InterleavingPremises::moves_to(const State& from, const Bdd& goal, const Bdd& within) const {
    bdd::Rings rings;
    for (bool more = rings.add(model_.only(from)); more && (rings.each.back() & goal).is_false();)
        more = rings.add(model_.image(rings.each.back(), move_steps_) & within);
    const std::optional<std::size_t> nearest = rings.nearest(goal);
    if (!nearest) return {};
    return bdd::path_back(
        *nearest, model_.pick(rings.each[*nearest] & goal, {}), [&](std::size_t ring, const State& next) {
            return model_.pick(model_.preimage(model_.only(next), move_steps_) & rings.each[ring], next);
        });
}

/// Appends to `run` all states of `states` except the last, each with the choices of the move to the next state.
void InterleavingPremises::add_moves(const std::vector<State>& states, FlatRun& run) const {
    for (std::size_t i = 0; i + 1 < states.size(); ++i)
        run.states.push_back(model_.values(states[i], &states[i + 1], moves_));
}

/// Appends to `run` moves between states of `within`, starting in `from`, until a state is repeated. Requires that a
/// move leads from each state of `within` to a state of `within`.
void InterleavingPremises::follow_moves(State from, const Bdd& within, FlatRun& run) const {
    std::map<State, std::size_t> seen;
    while (seen.emplace(from, run.states.size()).second) {
        const State next = model_.pick(model_.image(model_.only(from), move_steps_) & within, from);
        add_moves({from, next}, run);
        from = next;
    }
    run.loop = seen.at(from);
}

std::optional<FlatRun> InterleavingPremises::waiting_run() {
    const Bdd staying = waiting_forever();
    const Bdd waiting = staying & model_.preimage(staying, wait_steps_);
    FlatRun run;
    std::map<State, std::size_t> seen;
    State state = model_.pick(staying & model_.initial(), {});
    while (seen.emplace(state, run.states.size()).second) {
        if (run.states.size() > longest_run) return {};
        const std::vector<State> path = moves_to(state, waiting, staying);
        add_moves(path, run);
        state = model_.pick(model_.image(model_.only(path.back()), wait_steps_) & staying, path.back());
        run.states.push_back(model_.values(path.back(), &state, waits_));
    }
    run.loop = seen.at(state);
    return run;
}

FlatRun InterleavingPremises::moves_on(const std::vector<std::int64_t>& from, const Bdd& goal) const {
    const State first = model_.state_of(from);
    FlatRun run;
    const std::vector<State> path = moves_to(first, goal, reached_);
    if (path.empty()) {
        follow_moves(first, reached_, run);
        return run;
    }
    add_moves(path, run);
    run.states.push_back(model_.values(path.back(), nullptr, Bdd::constant(true)));
    return run;
}

FlatRun InterleavingPremises::endless_run() {
    const Bdd staying = moving_forever();
    FlatRun run;
    const std::vector<State> path = moves_to(model_.pick(model_.initial(), {}), staying, reached_);
    add_moves(path, run);
    follow_moves(path.back(), staying, run);
    return run;
}

}  // namespace grafverif::symbolic
