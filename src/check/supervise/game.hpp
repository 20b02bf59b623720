// SPDX-License-Identifier: MIT
// Supervisory-control game: the charts of a system (controllable) against its plant (uncontrollable).
//
// In each evolution a chart clears transitions and sets outputs; the supervisor restricts both by permissions. All
// other moves are uncontrollable: plant, environment, timers and scheduling. In terms of Ramadge and Wonham (1987),
// "Supervisory control of a class of discrete event processes", permissions are the controllable events, except that an
// evolution itself cannot be prevented.
//
// A state is losing if it is bad, or if an uncontrollable move or an evolution under every permission leads to a losing
// state. It is also losing if no marked state is reachable without a losing state. All other states are winning; every
// uncontrollable move from a winning state leads to a winning state.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "check/symbolic/model.hpp"

namespace grafverif::supervise {

/// A controller of the system as a player.
struct Player {
    Bdd evolves = {};           ///< over states and choices: true if the step is one of its evolutions
    std::vector<Bdd> may = {};  ///< its permissions: each is a choice, a variable of the space
};

/// The losing states, in the order of their detection: each set is bad or blocked, or one move or evolution leads from
/// each of its states to earlier ones.
struct LosingRegion {
    struct Stage {
        Bdd states = {};
        bool blocked = false;  ///< no marked state is reachable from here without an earlier losing state
    };
    std::vector<Stage> stages = {};
    Bdd all = {};
};

class Game {
public:
    /// The model must outlive the game. `reached`: the states reachable under all permissions.
    Game(const symbolic::StateSpace& model, const BddSpace& space, std::vector<Player> players, Bdd reached);

    std::size_t players() const { return players_.size(); }
    const std::vector<Bdd>& may(std::size_t player) const { return players_[player].may; }
    const Bdd& reached() const { return reached_; }

    /// The successors of `states` by uncontrollable moves; the predecessors of `to`.
    Bdd moved(const Bdd& states) const { return model_.image(states, moves_); }
    Bdd moves_to(const Bdd& to) const { return model_.preimage(to, moves_); }
    /// The successors of pairs of states and permissions by evolutions of a player.
    Bdd evolved(std::size_t player, const Bdd& pairs) const;
    /// The pairs whose evolution leads to one of `to`.
    Bdd evolves_to(std::size_t player, const Bdd& to) const { return model_.preimage(to, evolutions_[player]); }
    /// The states in which the player can evolve; those of them whose evolution leads to `to` under every permission.
    const Bdd& ready(std::size_t player) const { return ready_[player]; }
    Bdd helpless(std::size_t player, const Bdd& to) const { return ready(player) & ~states(~evolves_to(player, to)); }
    /// Over states and choices: true if the step is not an evolution; true if it is one of the player.
    const Bdd& is_move() const { return is_move_; }
    const Bdd& is_evolution(std::size_t player) const { return players_[player].evolves; }
    /// `pairs` without the permissions.
    Bdd states(const Bdd& pairs) const { return exists(pairs, all_may_); }

    /// All losing states for the bad states `bad`; `lost`: those already known.
    LosingRegion solve(const Bdd& bad, const Bdd& marked, LosingRegion lost = {}) const;
    /// The pairs of winning states in which the player can evolve, and permissions whose evolution leads to a winning
    /// state.
    Bdd allowed(std::size_t player, const LosingRegion& lost) const;

private:
    Bdd unwilling(const Bdd& to) const;
    Bdd coreachable(const LosingRegion& lost, const Bdd& marked) const;

    const symbolic::StateSpace& model_;
    std::vector<Player> players_ = {};
    Bdd reached_ = {}, all_may_ = {}, is_move_ = {};
    std::deque<bdd::ClusterSteps> moves_ = {};
    std::vector<std::deque<bdd::ClusterSteps>> evolutions_ = {};
    std::vector<Bdd> ready_ = {};
};

}  // namespace grafverif::supervise
