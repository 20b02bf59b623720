// SPDX-License-Identifier: MIT
// A TransitionSystem executed as it stands, state by state: what it means, without any model checker. For the law that
// it agrees with the Equations, and for tests that look at single steps.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "grafverif/ir/transition_system.hpp"

namespace grafverif {

struct SystemState {
    std::vector<std::int64_t> main = {};                    ///< per symbol of main; only state symbols count
    std::vector<std::vector<std::int64_t>> instances = {};  ///< likewise per instance
    auto operator<=>(const SystemState&) const = default;
};

/// The value of a free variable in the state at hand, or of a choice in the step at hand. `path` is `START`, or `station.T_elapses` in an instance.
using Choose = std::function<std::int64_t(std::string_view path, Type type)>;

SystemState first_state(const TransitionSystem& system, const Choose& choose);
/// The state after a step with the choices that `choose` makes, or nothing: they are not on offer, or an invariant
/// forbids the state. Every choice and every free variable is asked for, in a fixed order.
std::optional<SystemState> taken_step(const TransitionSystem& system, const SystemState& state, const Choose& choose);
/// Every state that some step leads to, each once. Choices of an instance are made within what its own module offers, so
/// that automata that stay cost nothing; nothing where free variables and choices have more than `limit` ways.
std::optional<std::vector<SystemState>> successors(const TransitionSystem& system, const SystemState& state,
                                                   std::size_t limit = 100'000);
/// Every state that the system can begin in; likewise.
std::optional<std::vector<SystemState>> first_states(const TransitionSystem& system, std::size_t limit = 100'000);

/// Whether every invariant holds.
bool is_allowed(const TransitionSystem& system, const SystemState& state);

/// Requires that the system has neither choices nor invariants.
SystemState next_state(const TransitionSystem& system, const SystemState& state, const Choose& choose);

/// The value of a term over the symbols of main.
std::int64_t value_of(const TransitionSystem& system, const SystemState& state, Id<Expr> term);

/// The value of `START`, or of `station.X_2`, whether or not main has a symbol for it; fails the test if there is none.
std::int64_t value_of(const TransitionSystem& system, const SystemState& state, std::string_view path);

/// Gives a state symbol the value, as if `choose` had.
void set_value(const TransitionSystem& system, SystemState& state, std::string_view path, std::int64_t value);

/// Whether there is such a name.
bool has_symbol(const TransitionSystem& system, std::string_view path);

}  // namespace grafverif
