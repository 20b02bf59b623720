// SPDX-License-Identifier: MIT
// Executes a TransitionSystem directly, state by state, without a model checker. This
// implementation is the reference for comparisons with the Equations, and for tests of single
// steps.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "grafverif/ir/transition_system.hpp"

namespace grafverif {

struct SystemState {
    /// Indexed by symbol of the main module; only the entries of state symbols are used.
    std::vector<std::int64_t> main = {};
    std::vector<std::vector<std::int64_t>> instances = {};  ///< indexed by instance and symbol
    auto operator<=>(const SystemState&) const = default;
};

/// Returns the value of a free variable in the current state, or of a choice in the current step. `path` is `START`, or
/// `station.T_elapses` for a symbol of an instance.
using Choose = std::function<std::int64_t(std::string_view path, Type type)>;

SystemState first_state(const TransitionSystem& system, const Choose& choose);
/// Returns the state after a step with the choices of `choose`. Returns nothing if the choices are not permitted, or if
/// an invariant forbids the state. Calls `choose` for every choice and every free variable, in a fixed order.
std::optional<SystemState> step_taken(const TransitionSystem& system, const SystemState& state, const Choose& choose);
/// Returns every successor state once. The function combines only permitted choices of each instance, so that automata
/// without a move do not increase the number of combinations. Returns nothing if free variables and
/// choices have more than `limit` combinations.
std::optional<std::vector<SystemState>> successors(const TransitionSystem& system, const SystemState& state,
                                                   std::size_t limit = 100'000);
/// Returns every initial state, with the same limit.
std::optional<std::vector<SystemState>> first_states(const TransitionSystem& system, std::size_t limit = 100'000);

/// True if every invariant holds.
bool is_allowed(const TransitionSystem& system, const SystemState& state);

/// Returns the next state. Requires that the system has neither choices nor invariants.
SystemState next_state(const TransitionSystem& system, const SystemState& state, const Choose& choose);

/// Returns the value of a term over the symbols of the main module.
std::int64_t value_of(const TransitionSystem& system, const SystemState& state, Id<Expr> term);

/// Returns the value of `START`, or of `station.X_2`, even if the main module has no symbol for it. Fails the test if
/// the name does not exist.
std::int64_t value_of(const TransitionSystem& system, const SystemState& state, std::string_view path);

/// Sets a state symbol, as if `choose` had chosen the value.
void set_value(const TransitionSystem& system, SystemState& state, std::string_view path, std::int64_t value);

/// True if the name exists.
bool has_symbol(const TransitionSystem& system, std::string_view path);

}  // namespace grafverif
