// SPDX-License-Identifier: MIT
// Game: the charts of a system, which may be held back, against its plant, which may not.
//
// In each of its evolutions a chart clears a set of transitions and sets outputs; whoever holds it back chooses, by its
// permissions, which of those that it would clear and set. Everything else moves as it likes: the plant, its environment,
// timers, and who is next. Of Ramadge and Wonham (1987), "Supervisory control of a class of discrete event processes":
// permissions are the controllable events, an evolution alone excepted that happens in any case, with or without them.
//
// Lost is where whoever holds back loses, however clever: a bad state; a state from which a move of the plant, or an
// evolution whatever it may do, leads to a lost one; and a state from which no marked one can be reached any more without
// a lost one. The others are won, and all moves of the plant from there lead to won states.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "check/symbolic/model.hpp"

namespace grafverif::supervise {

/// A controller of the system as a player.
struct Player {
    Bdd evolves = {};           ///< over states and choices: the step is one of its evolutions
    std::vector<Bdd> may = {};  ///< its permissions: each a choice, a variable of the space
};

/// What has been lost, in the order in which it was found: each set is bad or blocked, or one move or evolution leads
/// from each of its states to those before it.
struct Lost {
    struct Stage {
        Bdd states = {};
        bool blocked = false;  ///< no marked state can be reached from here without one that was lost before
    };
    std::vector<Stage> stages = {};
    Bdd all = {};
};

class Game {
public:
    /// The model outlives this. `reached`: the states to which moves lead, whatever is permitted.
    Game(const symbolic::StateSpace& model, const BddSpace& space, std::vector<Player> players, Bdd reached);

    std::size_t players() const { return players_.size(); }
    const std::vector<Bdd>& may(std::size_t player) const { return players_[player].may; }
    const Bdd& reached() const { return reached_; }

    /// Where moves that nobody holds back lead from `states`; from where one leads to `to`.
    Bdd moved(const Bdd& states) const { return model_.image(states, moves_); }
    Bdd moves_to(const Bdd& to) const { return model_.preimage(to, moves_); }
    /// Where the evolutions of a player lead from `pairs` of states and permissions.
    Bdd evolved(std::size_t player, const Bdd& pairs) const;
    /// The pairs of which its evolution leads to one of `to`.
    Bdd evolves_to(std::size_t player, const Bdd& to) const { return model_.preimage(to, evolutions_[player]); }
    /// The states in which it can evolve; those of which its evolution leads to `to` whatever is permitted.
    const Bdd& ready(std::size_t player) const { return ready_[player]; }
    Bdd helpless(std::size_t player, const Bdd& to) const { return ready(player) & ~states(~evolves_to(player, to)); }
    /// Over states and choices: the step is no evolution; it is one of the player.
    const Bdd& is_move() const { return is_move_; }
    const Bdd& is_evolution(std::size_t player) const { return players_[player].evolves; }
    /// `pairs` without what is permitted.
    Bdd states(const Bdd& pairs) const { return exists(pairs, all_may_); }

    /// All that is lost where `bad` is; `lost` is what is known already.
    Lost solve(const Bdd& bad, const Bdd& marked, Lost lost = {}) const;
    /// The pairs of won states in which the player is ready, and of which its evolution leads to no lost one.
    Bdd allowed(std::size_t player, const Lost& lost) const;

private:
    Bdd unwilling(const Bdd& to) const;
    Bdd coreachable(const Lost& lost, const Bdd& marked) const;

    const symbolic::StateSpace& model_;
    std::vector<Player> players_ = {};
    Bdd reached_ = {}, all_may_ = {}, is_move_ = {};
    std::deque<bdd::Steps> moves_ = {};
    std::vector<std::deque<bdd::Steps>> evolutions_ = {};
    std::vector<Bdd> ready_ = {};
};

}  // namespace grafverif::supervise
