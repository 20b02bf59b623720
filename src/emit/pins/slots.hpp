// SPDX-License-Identifier: MIT
// The slots of a state: where each location, variable and clock of an expanded network stands, and which of them terms
// and edges read and write.
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

/// `name` with `_` for all that is no letter and no digit.
std::string identifier(std::string name);

struct Slots {
    /// `network` is expanded, and outlives this.
    explicit Slots(const Network& network);

    const Network& network;
    std::vector<ProcessClocks> caps;
    std::vector<std::string> names = {};  ///< per slot of a state: letters, digits and `_`, each once
    std::vector<std::int64_t> initial = {};
    std::uint32_t scratch = 0;  ///< slots behind those of a state, for what is carried within a move
    std::vector<std::optional<Slot>> locations = {};            ///< per process; empty: it has one location
    std::vector<std::optional<Slot>> variables = {};            ///< per variable; empty: it has one value
    std::vector<std::vector<std::optional<Slot>>> clocks = {};  ///< per process and clock; empty: nobody asks for it

    const Network::Template& automaton(Id<Network::Process> process) const {
        return network.templates[network.processes[process].automaton];
    }
    /// The slots of the state that a term over the network reads.
    SlotSet read_by(const Exprs& exprs, Id<Expr> term) const;
    /// The assignments of an edge, those of the procedures that it calls behind its own.
    std::vector<Network::Assignment> effect(Id<Network::Process> process, const Network::Edge& edge) const;
    /// The clocks that an edge asks for: those of its constraint, and those of its target's invariant that it does not reset.
    std::vector<ClockInterval> asked(Id<Network::Process> process, const Network::Edge& edge) const;
};

/// What a group reads and writes.
struct Reach {
    SlotSet reads = {}, writes = {};
};
/// Whether it may move.
Reach enabling(const Slots& slots, Id<Network::Process> process, const Network::Edge& edge);
Reach reach(const Slots& slots, Id<Network::Process> process, const Network::Edge& edge);
Reach reach_of_time(const Slots& slots);

}  // namespace grafverif::pins
