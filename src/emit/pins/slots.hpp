// SPDX-License-Identifier: MIT
// Determines the slots of a state, which are the positions of the locations, variables and clocks of an expanded
// network. Also determines the slots that terms and edges read and write.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "ir/network_clocks.hpp"

namespace grafverif::pins {

using Slot = std::uint32_t;
using SlotSet = std::set<Slot>;

/// Returns `name` with all characters except letters and digits replaced by `_`.
std::string identifier(std::string name);

struct Slots {
    /// `network` must be expanded and must outlive this object.
    explicit Slots(const Network& network);

    const Network& network;
    std::vector<ProcessClocks> caps;
    std::vector<std::string> names = {};  ///< unique name of each slot of a state, with letters, digits and `_`
    std::vector<std::int64_t> initial = {};
    std::uint32_t scratch = 0;  ///< number of additional slots for temporary values during a move

    /// Slot of each process; empty if the process has a single location.
    std::vector<std::optional<Slot>> locations = {};
    /// Slot of each variable; empty if the variable has a single value.
    std::vector<std::optional<Slot>> variables = {};
    /// Slot per process and clock; empty if the clock is never compared.
    std::vector<std::vector<std::optional<Slot>>> clocks = {};

    const Network::Template& automaton(Id<Network::Process> process) const {
        return network.templates[network.processes[process].automaton];
    }
    /// Returns the slots of the state that a term of the network reads.
    SlotSet read_by(const Exprs& exprs, Id<Expr> term) const;
    /// Returns the assignments of an edge, followed by the assignments of the procedures that it calls.
    std::vector<Network::Assignment> effect(Id<Network::Process> process, const Network::Edge& edge) const;
    /// Returns the bounds of an edge for each clock: the bounds of the clock constraint and, if the edge does not reset
    /// the clock, the bounds of the invariant of its target.
    std::vector<ClockInterval> tested(Id<Network::Process> process, const Network::Edge& edge) const;
};

/// The slots that a group reads and writes.
struct Reach {
    SlotSet reads = {}, writes = {};
};
/// Returns the slots that determine if the edge is enabled.
Reach enabling(const Slots& slots, Id<Network::Process> process, const Network::Edge& edge);
Reach reach(const Slots& slots, Id<Network::Process> process, const Network::Edge& edge);
Reach reach_of_time(const Slots& slots);

}  // namespace grafverif::pins
