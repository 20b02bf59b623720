// SPDX-License-Identifier: MIT
#include "check/supervise/game.hpp"

#include <utility>

namespace grafverif::supervise {

Game::Game(const symbolic::StateSpace& model, const BddSpace& space, std::vector<Player> players, Bdd reached)
    : model_(model), players_(std::move(players)), reached_(std::move(reached)) {
    std::vector<std::uint32_t> permissions;
    Bdd evolution;
    for (const Player& player : players_) {
        for (const Bdd& each : player.may) permissions.push_back(each.top());
        evolution |= player.evolves;
    }
    all_may_ = variable_set(space, permissions);
    is_move_ = ~evolution;
    moves_ = model_.steps_where(is_move_);
    for (std::size_t player = 0; player < players_.size(); ++player) {
        evolutions_.push_back(model_.steps_where(players_[player].evolves, permissions));
        ready_.push_back(reached_ & states(evolves_to(player, Bdd::constant(true))));
    }
}

Bdd Game::evolved(std::size_t player, const Bdd& pairs) const {
    return states(model_.image(pairs, evolutions_[player]));
}

/// Returns the states in which the supervisor cannot prevent a step to `to`: an uncontrollable move leads to `to`, or
/// an evolution of some player (controller) leads to `to` for every choice of permissions.
Bdd Game::unavoidable(const Bdd& to) const {
    Bdd found = moves_to(to);
    for (std::size_t player = 0; player < players(); ++player) found |= helpless(player, to);
    return found & reached_;
}

Bdd Game::allowed(std::size_t player, const LosingRegion& losing) const {
    return ready(player) & ~losing.all & ~evolves_to(player, losing.all);
}

/// Returns the winning states from which a path through winning states leads to a marked state.
Bdd Game::coreachable(const LosingRegion& losing, const Bdd& marked) const {
    const Bdd won = reached_ & ~losing.all;
    std::vector<Bdd> pairs;
    for (std::size_t player = 0; player < players(); ++player) pairs.push_back(allowed(player, losing));
    Bdd found = won & marked;
    for (Bdd latest = found; !latest.is_false();) {
        Bdd before = moves_to(latest);
        for (std::size_t player = 0; player < players(); ++player)
            before |= states(pairs[player] & evolves_to(player, latest));
        latest = before & won & ~found;
        found |= latest;
    }
    return found;
}

LosingRegion Game::solve(const Bdd& bad, const Bdd& marked, LosingRegion losing) const {
    const auto add = [&](const Bdd& states, bool blocked) {
        const Bdd found = states & reached_ & ~losing.all;
        if (found.is_false()) return false;
        losing.stages.push_back({found, blocked});
        losing.all |= found;
        return true;
    };
    add(bad, false);
    do {
        while (add(unavoidable(losing.all), false)) {
        }
    } while (add(~coreachable(losing, marked), true));
    return losing;
}

}  // namespace grafverif::supervise
