// SPDX-License-Identifier: MIT
// supervisor_of: what a chart must be forbidden so that nothing bad happens and what is marked stays within reach.
//
// It answers by the game (game.hpp) on a system in which each transition and each output of the charts has a permission,
// a choice. A condition is over what its chart can see; two states that look the same get the same, and where a condition
// forbids something in one of them it forbids it in both.
//
// What is said of the conditions found is said of the states to which the system with them comes:
//   Least     whatever is forbidden there leads to a lost state: nobody could allow more
//   Several   nothing more can be allowed there in an evolution unless something else is forbidden in it instead;
//             transitions are forbidden before outputs, later ones before earlier ones
//   Cautious  somebody who saw all of the plant could allow more
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
    /// What can be forbidden: that a transition is cleared, that an output is set.
    struct Permission {
        Id<TransitionSystem::Symbol> symbol = {};  ///< of main: a Boolean choice; false forbids
        bool output = false;
        Id<Expr> effect = {};                 ///< over main: the transition is cleared in the step; the output is set
        std::vector<std::size_t> sites = {};  ///< of an output: what is seen while its actions may set it, one by one
        /// Per site, over main: its action sets the output in the step, if permitted. Missing or not valid: always while it is seen.
        std::vector<Id<Expr>> site_effects = {};
    };
    struct Controller {
        Id<Expr> evolves = {};            ///< over main: the step is one of its evolutions
        std::vector<Id<Expr>> seen = {};  ///< over main, of states: what it can see; what it writes is not seen
        std::vector<Permission> permissions = {};
    };
    std::vector<Controller> controllers = {};
    std::vector<Id<Expr>> bad = {};  ///< over main, of states: never to be; no value is bad
    Id<Expr> marked = {};            ///< likewise: always to be within reach
};

struct SuperviseOptions {
    std::uint64_t max_memory = std::uint64_t{2} << 30U;  ///< bytes, for decision diagrams
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;
    std::function<void(const std::string& doing)> progress = {};  ///< called now and then
};

struct Supervisor {
    enum class Outcome {
        Found,
        None,     ///< no conditions will do, over whatever
        Unknown,  ///< see `reason`
    };
    enum class Claim { Least, Several, Cautious };

    struct Literal {
        std::size_t seen = 0;  ///< of its controller
        bool value = true;
        bool operator==(const Literal&) const = default;
    };
    /// `all`: a conjunction of disjunctions, else a disjunction of conjunctions.
    struct Condition {
        std::size_t controller = 0, permission = 0;
        std::optional<std::size_t> site = {};  ///< of an output: which of its sites
        std::vector<std::vector<Literal>> terms = {};
        bool all = false;
        bool operator==(const Condition&) const = default;
    };
    /// A permission by its place.
    struct Which {
        std::size_t controller = 0, permission = 0;
        bool operator==(const Which&) const = default;
    };

    Outcome outcome = Outcome::Unknown;
    std::string reason = {};
    Claim claim = Claim::Least;
    std::vector<Condition> conditions = {};  ///< none: nothing need be forbidden
    std::vector<Which> hidden = {};          ///< Cautious: what somebody who sees the plant could allow more often
    std::vector<Which> traded = {};          ///< Several: what could be allowed more often if others were less
    /// None: a run without forbidding, of which no move can be helped, to what is bad; or, if `blocked`, to where nothing
    /// marked can be reached without it.
    std::optional<FlatRun> run = {};
    bool blocked = false;
    FlatSystem flat = {};  ///< whose variables the run gives values
};

/// Requires verify(system).empty().
Supervisor supervisor_of(const TransitionSystem& system, const Supervision& asked,
                         const SuperviseOptions& options = {});

}  // namespace grafverif
