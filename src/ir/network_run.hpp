// SPDX-License-Identifier: MIT
// Network simulator: performs single moves, directly after the definition of the semantics (ir/network.hpp; CEP13
// section 2). Used by the replay of counterexamples, `simulate` and tests of the engines. Simple instead of fast;
// clocks are not capped.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// State of a network. Scratch variables keep their last written value.
struct NetworkState {
    std::vector<Id<Network::Location>> locations = {};   ///< per process
    std::vector<std::int64_t> variables = {};            ///< per variable
    std::vector<std::vector<std::int64_t>> clocks = {};  ///< per process and clock, in time units

    bool operator==(const NetworkState&) const = default;
};

NetworkState initial_state(const Network& network);

/// Result of an attempted move.
struct Step {
    enum class Result {
        Done,
        Blocked,     ///< forbidden by guard, clock constraint, invariant or urgency
        OutOfRange,  ///< `variable` would leave its range
        NoValue,     ///< division by zero
    };
    Result result = Result::Done;
    Id<Network::Variable> variable = {};
};

/// Performs `move` on `state`; if the result is not Done, the state is unchanged.
Step perform(const Network& network, NetworkState& state, const Move& move);

/// All enabled edges, in the order of processes and edges, including those that cause a model error (see Step).
std::vector<Fire> enabled(const Network& network, const NetworkState& state);

/// True if one unit of time can pass.
bool may_delay(const Network& network, const NetworkState& state);

/// Value of an expression over variables and At (a property's operand, or `settled`); empty: division by zero.
std::optional<std::int64_t> value(const Network& network, const NetworkState& state, Id<Expr> expr);

/// The states of `run`, beginning with the initial state: one more than moves. Empty if a move is blocked, or if the
/// lasso does not close with the same locations and variables.
std::optional<std::vector<NetworkState>> replay(const Network& network, const Run& run);

}  // namespace grafverif
