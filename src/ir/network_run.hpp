// SPDX-License-Identifier: MIT
// Network simulator: performs single moves as a direct implementation of the semantics (ir/network.hpp; CEP13 section
// 2). The replay of counterexamples, the command `simulate` and tests of the engines use the simulator. The
// implementation favours simplicity over speed; clock values are not reduced to a maximum value.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// A state of a network. Scratch variables keep their last written value.
struct NetworkState {
    std::vector<Id<Network::Location>> locations = {};   ///< location of each process
    std::vector<std::int64_t> variables = {};            ///< value of each variable
    std::vector<std::vector<std::int64_t>> clocks = {};  ///< value of each clock of each process, in time units

    bool operator==(const NetworkState&) const = default;
};

/// Returns the template of a process.
inline const Network::Template& automaton(const Network& network, Id<Network::Process> process) {
    return network.templates[network.processes[process].automaton];
}

/// Returns the edge of a move.
inline const Network::Edge& taken_edge(const Network& network, const Fire& fire) {
    return automaton(network, fire.process).edges[fire.edge];
}

NetworkState initial_state(const Network& network);

/// The result of an attempted move.
struct Step {
    enum class Result {
        Done,
        Blocked,     ///< a guard, clock constraint, invariant or urgent edge forbids the move
        OutOfRange,  ///< the edge assigns `variable` a value outside its range
        NoValue,     ///< a term of the edge has no value, for example because of a division by zero
    };
    Result result = Result::Done;
    Id<Network::Variable> variable = {};
};

/// Performs `move` on `state`; if the result is not Done, `state` is unchanged.
Step perform(const Network& network, NetworkState& state, const Move& move);

/// Returns all enabled edges, in the order of processes and edges. The result includes edges that cause a model error
/// (see Step).
std::vector<Fire> enabled(const Network& network, const NetworkState& state);

/// True if an urgent edge is enabled, so that time cannot pass.
bool urgent_edge_waits(const Network& network, const NetworkState& state);

/// True if one unit of time can pass.
bool may_delay(const Network& network, const NetworkState& state);

/// Returns the value of an expression over variables and At (an operand of a property, or `settled`), or nullopt if the
/// value is undefined.
std::optional<std::int64_t> value(const Network& network, const NetworkState& state, Id<Expr> expr);

/// Returns the states of `run`, beginning with the initial state. The number of states is the number of moves plus one.
/// The result is nullopt if a move is not possible. The result is also nullopt if the run has a loop, and the last
/// state differs from the first state of the loop in locations or variables.
std::optional<std::vector<NetworkState>> replay(const Network& network, const Run& run);

}  // namespace grafverif
