// SPDX-License-Identifier: MIT
// Determines the possible next events and delays of a Network, for interactive exploration. ir/network_run executes the
// moves.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"
#include "ir/network_run.hpp"

namespace grafverif {

/// The delays that are possible from a state without taking an edge, in time units.
struct Leeway {
    bool may_pass = false;
    /// Time until an invariant prevents further delay; empty if no invariant does.
    std::optional<std::int64_t> limit = {};
    /// Time until a disabled edge becomes enabled; empty if delay enables no edge.
    std::optional<std::int64_t> change = {};
    bool operator==(const Leeway&) const = default;
};

Leeway leeway(const Network& network, const NetworkState& state);

/// Returns the clock constraints in the invariant of the current location of process `id` that one more unit of time
/// would violate.
std::vector<Network::ClockConstraint> reached_bounds(const Network& network, const NetworkState& state,
                                                     Id<Network::Process> id);

/// Returns the processes that prevent time from passing, because an urgent edge is enabled or an invariant has reached
/// its bound.
std::vector<Id<Network::Process>> impatient(const Network& network, const NetworkState& state);

/// Continues a finite run, whose states are `states`, by edges of processes that prevent time from passing, until no
/// such edge is enabled or a state repeats. Returns false if an edge causes a model error, or after 10,000 edges.
bool continue_without_delay(const Network& network, Run& run, std::vector<NetworkState>& states);

}  // namespace grafverif
