// SPDX-License-Identifier: MIT
// Walking through a Network by hand: what may happen next, and how far time can go. Moves themselves are those of
// ir/network_run.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"
#include "ir/network_run.hpp"

namespace grafverif {

/// How time can pass from a state on while no edge fires, in time units.
struct Leeway {
    bool may_pass = false;
    std::optional<std::int64_t> limit = {};   ///< until an invariant stops it; empty: for ever
    std::optional<std::int64_t> change = {};  ///< until an edge can fire that cannot yet; empty: never
    bool operator==(const Leeway&) const = default;
};

Leeway leeway(const Network& network, const NetworkState& state);

/// The processes that hold time up: an urgent edge of theirs can fire, or an invariant is at its bound.
std::vector<Id<Network::Process>> impatient(const Network& network, const NetworkState& state);

}  // namespace grafverif
