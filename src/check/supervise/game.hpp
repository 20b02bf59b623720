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
    Bdd evolves = {};           ///< function of states and choices: true if the step is one of its evolutions
    std::vector<Bdd> may = {};  ///< permissions; each is a choice, represented by a variable of the space
};

/// The losing states, in stages in the order of their detection. The states of a stage are bad or blocked, or one move
/// or evolution leads from each of them to an earlier stage.
struct LosingRegion {
    struct Stage {
        Bdd states = {};
        bool blocked = false;  ///< no marked state is reachable from here unless an earlier losing state is passed
    };
    std::vector<Stage> stages = {};
    Bdd all = {};
};

class Game {
public:
    /// The model must outlive the game. `reached` contains the states that are reachable under all permissions.
    Game(const symbolic::StateSpace& model, const BddSpace& space, std::vector<Player> players, Bdd reached);

    std::size_t players() const { return players_.size(); }
    const std::vector<Bdd>& may(std::size_t player) const { return players_[player].may; }
    const Bdd& reached() const { return reached_; }

    /// Return the successors of `states`, and the predecessors of `to`, by uncontrollable moves.
    Bdd moved(const Bdd& states) const { return model_.image(states, moves_); }
    Bdd moves_to(const Bdd& to) const { return model_.preimage(to, moves_); }
    /// Returns the successors of pairs of a state and permissions by evolutions of a player.
    Bdd evolved(std::size_t player, const Bdd& pairs) const;
    /// Returns the pairs whose evolution leads to a state of `to`.
    Bdd evolves_to(std::size_t player, const Bdd& to) const { return model_.preimage(to, evolutions_[player]); }
    /// Return the states in which the player can evolve, and those of them whose evolution leads to `to` under every
    /// permission.
    const Bdd& ready(std::size_t player) const { return ready_[player]; }
    Bdd helpless(std::size_t player, const Bdd& to) const { return ready(player) & ~states(~evolves_to(player, to)); }
    /// Functions of states and choices. The first is true if the step is not an evolution, the second if it is an
    /// evolution of the player.
    const Bdd& is_move() const { return is_move_; }
    const Bdd& is_evolution(std::size_t player) const { return players_[player].evolves; }
    /// Returns the states of `pairs`, without the permissions.
    Bdd states(const Bdd& pairs) const { return exists(pairs, all_may_); }

    /// Returns all losing states for the bad states `bad`. `lost` contains those that are already known.
    LosingRegion solve(const Bdd& bad, const Bdd& marked, LosingRegion lost = {}) const;
    /// Returns the pairs of a winning state in which the player can evolve and permissions with which the evolution
    /// leads to a winning state.
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
