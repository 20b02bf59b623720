// SPDX-License-Identifier: MIT
// Direct execution of a TransitionSystem, state by state, without a model checker: the reference for its comparison
// with the Equations, and for tests of single steps.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "grafverif/ir/transition_system.hpp"

namespace grafverif {

struct SystemState {
    std::vector<std::int64_t> main = {};                    ///< per symbol of main; only state symbols are used
    std::vector<std::vector<std::int64_t>> instances = {};  ///< per instance and symbol
    auto operator<=>(const SystemState&) const = default;
};

/// The value of a free variable in the current state, or of a choice in the current step. `path` is `START`, or
/// `station.T_elapses` in an instance.
using Choose = std::function<std::int64_t(std::string_view path, Type type)>;

SystemState first_state(const TransitionSystem& system, const Choose& choose);
/// The state after a step with the choices of `choose`, or nothing: they are not permitted, or an invariant forbids the
/// state. Requests every choice and every free variable, in a fixed order.
std::optional<SystemState> step_taken(const TransitionSystem& system, const SystemState& state, const Choose& choose);
/// Every successor state, each once. Combines only permitted choices of each instance, so that automata without a move
/// cost nothing; nothing if free variables and choices have more than `limit` combinations.
std::optional<std::vector<SystemState>> successors(const TransitionSystem& system, const SystemState& state,
                                                   std::size_t limit = 100'000);
/// Every initial state, with the same limit.
std::optional<std::vector<SystemState>> first_states(const TransitionSystem& system, std::size_t limit = 100'000);

/// True if every invariant holds.
bool is_allowed(const TransitionSystem& system, const SystemState& state);

/// Requires that the system has neither choices nor invariants.
SystemState next_state(const TransitionSystem& system, const SystemState& state, const Choose& choose);

/// The value of a term over the symbols of main.
std::int64_t value_of(const TransitionSystem& system, const SystemState& state, Id<Expr> term);

/// The value of `START`, or of `station.X_2`, even if main has no symbol for it; fails the test if there is none.
std::int64_t value_of(const TransitionSystem& system, const SystemState& state, std::string_view path);

/// Sets a state symbol, as if `choose` had.
void set_value(const TransitionSystem& system, SystemState& state, std::string_view path, std::int64_t value);

/// True if there is such a name.
bool has_symbol(const TransitionSystem& system, std::string_view path);

}  // namespace grafverif
