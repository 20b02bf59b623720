// SPDX-License-Identifier: MIT
// Game: the supervisory-control game of the charts of a system (controllable) against its plant (uncontrollable).
//
// In each evolution, a chart clears transitions and sets outputs. The supervisor can refuse the chart the permission to
// clear a transition or to set an output. All other moves are uncontrollable: moves of the plant, of the environment
// and of timers, and the choice of the process that moves next. In terms of Ramadge and Wonham (1987), "Supervisory
// control of a class of discrete event processes", permissions are the controllable events. However, the supervisor
// cannot prevent an evolution as such.
//
// A state is losing if it is bad or if an uncontrollable move leads to a losing state. A state is also losing if an
// evolution of some chart leads to a losing state for every choice of permissions. Finally, a state is losing if every
// path to a marked state contains a losing state. All other states are winning; every uncontrollable move from a
// winning state leads to a winning state.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "check/symbolic/model.hpp"

namespace grafverif::supervise {

/// A controller of the system, which is a player of the game.
struct Player {
    /// Function of states and choices: true if the step is an evolution of this player.
    Bdd evolves = {};
    /// The permissions of the player. Each permission is a choice of the system; a variable of the space represents the
    /// choice.
    std::vector<Bdd> may = {};
};

/// The losing states, in stages in the order of their detection. For each state of a stage, one of these statements is
/// true: the state is bad; `blocked` is true for the stage; an uncontrollable move leads to an earlier stage; or an
/// evolution leads to an earlier stage for every choice of permissions.
struct LosingRegion {
    struct Stage {
        Bdd states = {};
        /// True if every path from these states to a marked state contains a losing state of an earlier stage.
        bool blocked = false;
    };
    std::vector<Stage> stages = {};
    Bdd all = {};
};

class Game {
public:
    /// The model must outlive the game. `reached` contains the states that are reachable if all permissions are
    /// granted.
    Game(const symbolic::StateSpace& model, const BddSpace& space, std::vector<Player> players, Bdd reached);

    std::size_t players() const { return players_.size(); }
    const std::vector<Bdd>& may(std::size_t player) const { return players_[player].may; }
    const Bdd& reached() const { return reached_; }

    /// `moved` returns the successors of `states` by uncontrollable moves; `moves_to` returns the predecessors of `to`
    /// by uncontrollable moves.
    Bdd moved(const Bdd& states) const { return model_.image(states, moves_); }
    Bdd moves_to(const Bdd& to) const { return model_.preimage(to, moves_); }
    /// Returns the states to which evolutions of a player lead from pairs of a state and permissions.
    Bdd evolved(std::size_t player, const Bdd& pairs) const;
    /// Returns the pairs of a state and permissions from which an evolution of the player leads to a state of `to`.
    Bdd evolves_to(std::size_t player, const Bdd& to) const { return model_.preimage(to, evolutions_[player]); }
    /// `ready` returns the states in which the player can evolve. `helpless` returns the states in which an evolution
    /// of the player leads to `to` for every choice of permissions.
    const Bdd& ready(std::size_t player) const { return ready_[player]; }
    Bdd helpless(std::size_t player, const Bdd& to) const { return ready(player) & ~states(~evolves_to(player, to)); }
    /// Functions of states and choices. `is_move` is true if the step is an uncontrollable move, not an evolution.
    /// `is_evolution` is true if the step is an evolution of the player.
    const Bdd& is_move() const { return is_move_; }
    const Bdd& is_evolution(std::size_t player) const { return players_[player].evolves; }
    /// Returns the states of `pairs`, which is a set of pairs of a state and permissions.
    Bdd states(const Bdd& pairs) const { return exists(pairs, all_may_); }

    /// Returns all losing states, given the bad states `bad` and the marked states `marked`. The argument `losing`
    /// contains the losing states that are already known.
    LosingRegion solve(const Bdd& bad, const Bdd& marked, LosingRegion losing = {}) const;
    /// Returns the pairs of a winning state and permissions under which an evolution of the player leads to a winning
    /// state.
    Bdd allowed(std::size_t player, const LosingRegion& losing) const;

private:
    Bdd unavoidable(const Bdd& to) const;
    Bdd coreachable(const LosingRegion& losing, const Bdd& marked) const;

    const symbolic::StateSpace& model_;
    std::vector<Player> players_ = {};
    Bdd reached_ = {}, all_may_ = {}, is_move_ = {};
    std::deque<bdd::ClusterSteps> moves_ = {};
    std::vector<std::deque<bdd::ClusterSteps>> evolutions_ = {};
    std::vector<Bdd> ready_ = {};
};

}  // namespace grafverif::supervise
