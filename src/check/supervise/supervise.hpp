// SPDX-License-Identifier: MIT
// supervisor_of: synthesizes the restrictions of charts under which no bad state is reachable and marked states stay
// reachable.
//
// It solves the game (game.hpp) on a system in which each transition and each output of the charts has a permission,
// which is a choice. A condition is over the observations of its chart: states with equal observations are restricted
// equally.
//
// The conditions are classified by the states that are reachable under them:
//   Least     every refused permission there leads to a losing state: no supervisor could allow more
//   Several   in an evolution more can be allowed only if another permission is refused instead; transitions are
//             refused before outputs, later ones before earlier ones
//   Cautious  a supervisor that observes the complete plant could allow more
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ir/flat_system.hpp"

namespace grafverif {

struct Supervision {
    /// A permission: to clear a transition, or to set an output.
    struct Permission {
        Id<TransitionSystem::Symbol> symbol = {};  ///< of main: a Boolean choice; false refuses
        bool output = false;
        Id<Expr> effect = {};                 ///< over main: true if the transition is cleared, or the output is set,
                                              ///< in the step
        std::vector<std::size_t> sites = {};  ///< of an output: observations while its actions may set it, one by one
        /// Per site, over main: true if its action sets the output in the step, if permitted. Missing or not valid:
        /// always while the site is observed.
        std::vector<Id<Expr>> site_effects = {};
    };
    struct Controller {
        Id<Expr> evolves = {};            ///< over main: true if the step is one of its evolutions
        std::vector<Id<Expr>> seen = {};  ///< over main, of states: its observations; its outputs are not observed
        std::vector<Permission> permissions = {};
    };
    std::vector<Controller> controllers = {};
    std::vector<Id<Expr>> bad = {};  ///< over main, of states: to be avoided; undefined counts as bad
    Id<Expr> marked = {};            ///< over main, of states: must stay reachable
};

struct SuperviseOptions {
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< bytes, for decision diagrams
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;
    std::function<void(const std::string& doing)> progress = {};  ///< called periodically
};

struct Supervisor {
    enum class Outcome {
        Found,
        None,     ///< no conditions suffice, even over all variables
        Unknown,  ///< see `reason`
    };
    enum class Permissiveness { Least, Several, Cautious };

    struct Literal {
        std::size_t seen = 0;  ///< of its controller
        bool value = true;
        bool operator==(const Literal&) const = default;
    };
    /// `all`: a conjunction of disjunctions; otherwise a disjunction of conjunctions.
    struct Condition {
        std::size_t controller = 0, permission = 0;
        std::optional<std::size_t> site = {};  ///< of an output: index of its site
        std::vector<std::vector<Literal>> terms = {};
        bool all = false;
        bool operator==(const Condition&) const = default;
    };
    /// A permission by its indices.
    struct Selection {
        std::size_t controller = 0, permission = 0;
        bool operator==(const Selection&) const = default;
    };

    Outcome outcome = Outcome::Unknown;
    std::string reason = {};
    Permissiveness claim = Permissiveness::Least;
    std::vector<Condition> conditions = {};  ///< none: no restriction is needed
    std::vector<Selection> hidden = {};      ///< Cautious: permissions that a supervisor with full observation could
                                             ///< give more often
    std::vector<Selection> traded = {};      ///< Several: permissions that could be given more often if others were
                                             ///< refused more often
    /// None: a run under all permissions to a bad state, none of whose moves can be prevented; if `blocked`, to a state
    /// from which every path to a marked one contains a losing state.
    std::optional<FlatRun> run = {};
    bool blocked = false;
    FlatSystem flat = {};  ///< the variables of the run
};

/// Requires verify(system).empty().
Supervisor supervisor_of(const TransitionSystem& system, const Supervision& requested,
                         const SuperviseOptions& options = {});

}  // namespace grafverif
