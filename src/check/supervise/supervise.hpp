// SPDX-License-Identifier: MIT
// supervisor_of: synthesizes restrictions of charts. Under the restrictions, no bad state is reachable, and marked
// states remain reachable.
//
// The synthesis solves a game (game.hpp) on a system in which each transition and each output of the charts has a
// *permission*: a choice that allows the transition to be cleared or the output to be set. The condition of a
// permission states when the permission is granted. A condition reads only the observations of its chart, so that the
// restrictions are equal in states with equal observations.
//
// The conditions are classified; the classification considers only states that are reachable under the conditions:
//   `Least`:    Every refused permission would lead to a losing state, so that no supervisor can grant more
//               permissions.
//   `Several`:  A permission could be granted more often only if another permission were refused more often. The
//               synthesis refuses transitions before outputs, and later elements before earlier elements.
//   `Cautious`: A supervisor that observes the complete plant could grant more permissions.
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
    /// A permission to clear a transition or to set an output.
    struct Permission {
        /// Symbol of the main module: a Boolean choice, which is false if the permission is refused.
        Id<TransitionSystem::Symbol> symbol = {};
        bool output = false;
        /// Term over the main module: true if the step clears the transition or sets the output.
        Id<Expr> effect = {};
        /// For an output: indices of observations, one for each action that may set the output. Each of these
        /// observations is called a site.
        std::vector<std::size_t> sites = {};
        /// For each site, a term over the main module: true if the action of the site sets the output in the step and
        /// the permission is granted. If the term is missing or invalid, the action sets the output whenever the
        /// observation of the site is true.
        std::vector<Id<Expr>> site_effects = {};
    };
    struct Controller {
        /// Term over the main module: true if the step is an evolution of the controller.
        Id<Expr> evolves = {};
        /// Terms over the main module, without choices: the observations of the controller. A controller does not
        /// observe its outputs.
        std::vector<Id<Expr>> seen = {};
        std::vector<Permission> permissions = {};
    };
    std::vector<Controller> controllers = {};
    /// Terms over the main module, without choices. A state is bad if one of these terms is true or undefined.
    std::vector<Id<Expr>> bad = {};
    Id<Expr> marked = {};  ///< term over the main module, without choices: marks the states that must remain reachable
};

struct SuperviseOptions {
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< memory limit of decision diagrams, in bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;
    std::function<void(const std::string& doing)> progress = {};  ///< called periodically
};

struct Supervisor {
    enum class Outcome {
        Found,
        /// No supervisor exists: even conditions that read all variables cannot avoid all bad states and keep marked
        /// states reachable.
        None,
        Unknown,  ///< the synthesis was inconclusive; `reason` states why
    };
    enum class Permissiveness { Least, Several, Cautious };

    struct Literal {
        std::size_t seen = 0;  ///< index of the observation, in Controller::seen
        bool value = true;
        bool operator==(const Literal&) const = default;
    };
    /// The condition of one permission. If `all` is true, `terms` is a conjunction of disjunctions; otherwise, `terms`
    /// is a disjunction of conjunctions.
    struct Condition {
        std::size_t controller = 0, permission = 0;
        std::optional<std::size_t> site = {};  ///< for an output: index of the site
        std::vector<std::vector<Literal>> terms = {};
        bool all = false;
        bool operator==(const Condition&) const = default;
    };
    /// A permission, identified by its indices.
    struct Selection {
        std::size_t controller = 0, permission = 0;
        bool operator==(const Selection&) const = default;
    };

    Outcome outcome = Outcome::Unknown;
    std::string reason = {};
    Permissiveness claim = Permissiveness::Least;
    /// Conditions; empty if no restriction is necessary.
    std::vector<Condition> conditions = {};
    /// With Permissiveness::Cautious: permissions that a supervisor with full observation could grant more often.
    std::vector<Selection> hidden = {};
    /// With Permissiveness::Several: permissions that could be granted more often if other permissions were refused
    /// more often.
    std::vector<Selection> traded = {};
    /// With Outcome::Found: permissions that the conditions refuse in some reachable state and that have no effect in
    /// any reachable state. The transition of such a permission is never cleared, or the output of such a permission is
    /// never set.
    std::vector<Selection> disabled = {};
    /// An observation, identified by its indices.
    struct Observation {
        std::size_t controller = 0, seen = 0;
        bool operator==(const Observation&) const = default;
    };
    /// With Outcome::Found: observations that are true in some reachable state of the system without conditions, but
    /// not in any reachable state with the conditions.
    std::vector<Observation> newly_unreachable = {};
    /// For each term of Supervision::bad: true if the term is true or undefined in some state that is reachable without
    /// conditions. Empty if the outcome is Unknown or if no condition is necessary.
    std::vector<bool> violated = {};
    /// With Outcome::None: a run to a bad state in which all permissions are granted. No supervisor can prevent this
    /// run. If `blocked` is true, the run leads to a state from which every path to a marked state contains a losing
    /// state.
    std::optional<FlatRun> run = {};
    bool blocked = false;
    FlatSystem flat = {};  ///< system with the variables of `run`
};

/// Synthesizes the conditions. Requires verify(system).empty().
Supervisor supervisor_of(const TransitionSystem& system, const Supervision& requested,
                         const SuperviseOptions& options = {});

}  // namespace grafverif
