// SPDX-License-Identifier: MIT
// Running a Network move by move, straight from its definition (ir/network.hpp; CEP13 section 2): what the replay of a
// counterexample, `simulate` and the tests of the engines use. Slow and plain; clocks are not capped.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// Where a network stands. Scratch variables keep whatever was written last.
struct NetworkState {
    std::vector<Id<Network::Location>> locations = {};   ///< one per process
    std::vector<std::int64_t> variables = {};            ///< one per variable
    std::vector<std::vector<std::int64_t>> clocks = {};  ///< per process, one per clock, in time units

    bool operator==(const NetworkState&) const = default;
};

NetworkState initial_state(const Network& network);

/// What comes of a move that was tried.
struct Step {
    enum class Result {
        Done,
        Blocked,     ///< guard, clock constraint, invariant or urgency forbids it
        OutOfRange,  ///< `variable` would leave its range
        NoValue,     ///< division by zero
    };
    Result result = Result::Done;
    Id<Network::Variable> variable = {};
};

/// Performs `move` on `state`; anything but Done leaves the state as it was.
Step perform(const Network& network, NetworkState& state, const Move& move);

/// Every edge that can fire now, in the order of processes and edges. Edges that break off (see Step) are among them.
std::vector<Fire> enabled(const Network& network, const NetworkState& state);

/// Whether one unit of time may pass.
bool may_delay(const Network& network, const NetworkState& state);

/// The value of an expression over variables and At (a property's operand, or `settled`); empty: division by zero.
std::optional<std::int64_t> value(const Network& network, const NetworkState& state, Id<Expr> expr);

/// The states that `run` goes through, the initial one first: one more than moves. Empty when a move is blocked, or
/// when the loop does not lead back to the same locations and variables.
std::optional<std::vector<NetworkState>> replay(const Network& network, const Run& run);

}  // namespace grafverif
