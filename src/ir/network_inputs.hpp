// SPDX-License-Identifier: MIT
// Input abstraction: an over-approximation of a closed loop in which inputs get their values when a PLC samples them.
//
// An instance is *autonomous* if its edges read only variables that it alone writes: a push button, a selector, a free
// input, a sensor of the environment. The loop depends on it only through the samples of the PLCs, unless a property,
// an observer or another instance reads it. It is abstracted on one of four levels:
//
//   Chosen    its location, clocks and outputs are not stored. Each sampling chooses one of its reachable output
//             valuations (jointly: a selector never shows two positions), independently of earlier ones.
//   Untimed   its location and outputs are stored; its clocks are ignored, so it may move at any time.
//   Paced     its upper bounds are ignored, its lower bounds are one time unit of the search: it does not change twice
//             within one instant.
//   Complete  it is unchanged.
//
// Let N be the network and A the abstraction. Each run of N is, up to the locations, clocks and outputs of the
// abstracted instances and EVOL_PL, a run of A with the same delays:
//   - an edge of a Chosen instance corresponds to no move of A. If N begins a cycle because of it (EVOL_PL), A takes
//     the
//     additional edge that begins a cycle at any time in W. The values that N then samples are one of the valuations.
//   - no PLC cycle of A is more urgent than in N: the additional edge is not urgent, the others have the guard of N.
//   - an edge of an Untimed or Paced instance needs no more time than in N, and stops no time in A.
// Hence `always`, `never`, `exactly one of` that hold in A hold in N. A `reachable` that is violated in A is violated
// in N. Both are true with `at stable` as well (A is quiescent where N is). Other verdicts and runs of A do not
// transfer to N.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

enum class InputLevel : std::uint8_t { Chosen, Untimed, Paced, Complete };

struct AutonomousInstance {
    Id<Network::Process> process = {};
    std::vector<Id<Network::Variable>> outputs = {};         ///< variables that it writes, without EVOL_PL
    std::vector<std::vector<std::int64_t>> valuations = {};  ///< per row one value per output; clocks ignored
    bool is_read = false;  ///< read by a process outside the sampling of PLCs: `Chosen` is not available

    bool operator==(const AutonomousInstance&) const = default;
};

/// Autonomous instances that can be abstracted: at most 32 valuations, no value out of range, no urgent edge that
/// determines if the loop is quiescent. Requires: `network` is expanded and without observers.
std::vector<AutonomousInstance> autonomous_instances(const Network& network);

/// Sampling of one Chosen instance by one PLC. At the beginning of each cycle all valuations are possible; each edge of
/// the PLC that reads one of the variables narrows the set.
struct InputChoice {
    std::size_t instance = 0;  ///< index in the list of autonomous instances
    Id<Network::Process> plc = {};
    std::vector<Id<Network::Variable>> variables = {};
    std::vector<std::vector<std::int64_t>> valuations = {};
    bool kept = false;                            ///< the set is part of a state: edges after the first one read it
    std::vector<Id<Network::Edge>> widened = {};  ///< edges of the PLC after which all valuations are possible again
};

/// Premises that are omitted on purpose, for tests that show that each of them is needed.
struct InputAblations {
    bool no_cycle_on_change = false;  ///< a cycle begins only if the rest of the loop requests it
    bool initial_values = false;      ///< Chosen instances keep their initial outputs
    bool ignore_readers = false;      ///< is_read is ignored: readers of a Chosen instance see its initial outputs
};

struct InputAbstraction {
    Network network = {};  ///< processes, variables and edges of the original keep their numbers
    std::vector<InputChoice> choices = {};
    std::vector<Id<Network::Process>> paced = {};  ///< for in_longest_unit
};

/// `levels`: one per instance; `Chosen` requires that it is not `is_read`. Terms of properties of `network` that read a
/// Chosen instance have no meaning in the result.
InputAbstraction abstract_inputs(const Network& network, const std::vector<AutonomousInstance>& instances,
                                 const std::vector<InputLevel>& levels, const InputAblations& ablations = {});

/// Converts to the longest time unit in which all clock bounds are integers. Bounds of Paced instances are not
/// considered: they become 1, or 0 if they are shorter than the unit. Integer time is exact in it as in any unit that
/// divides the bounds. Without `paced`: the same network in that unit. Requires: `network` is expanded.
Network in_longest_unit(Network network, const std::vector<Id<Network::Process>>& paced = {});

/// Lower bounds of `automaton` become `unit`, or 0 if they are shorter; upper bounds are removed, and no edge is urgent.
void pace(const Network& network, const Network::Process& process, Network::Template& automaton, std::int64_t unit,
          Exprs& exprs);

}  // namespace grafverif
