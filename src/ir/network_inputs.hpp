// SPDX-License-Identifier: MIT
// Input abstraction: an over-approximation of a closed loop in which inputs get their values when a PLC samples them.
//
// An instance is *autonomous* if its edges read only variables that it alone writes: a push button, a selector, a free
// input, a sensor of the environment. Other instances read the loop: a cylinder, a tank. The PLCs depend on an instance
// only through their samples, unless a property, an observer or another process reads it. Each process that is not a
// PLC is part of the abstraction on one of four levels:
//
//   Chosen    its location, clocks and outputs are not stored. Each sampling chooses one of its reachable output
//             valuations (jointly: a selector never shows two positions), independently of earlier ones.
//   Untimed   its location and outputs are stored; its clocks and its urgency are ignored, so it may move at any time.
//   Paced     autonomous instances only: its upper bounds are ignored, its lower bounds are one time unit of the
//   search:
//             it does not change twice within one instant.
//   Complete  it is unchanged.
//
// Let N be the network and A the abstraction. Each run of N is, up to the locations, clocks and outputs of the
// abstracted processes and EVOL_PL, a run of A with the same delays:
//   - an edge of a Chosen instance corresponds to no move of A. If N begins a cycle because of it (EVOL_PL), A takes the
//     additional edge that begins a cycle at any time in W. The values that N then samples are one of the valuations:
//     these are all that the instance can reach, for any values of the other variables.
//   - no PLC cycle of A is more urgent than in N: the additional edge is not urgent, the others have the guard of N.
//   - an edge of an Untimed or Paced process has the guard of N on the same values (a process that a stored process reads
//     is stored), needs no more time than in N, and stops no time in A.
//   - A is quiescent where N is: of the condition, only what reads a Chosen instance is omitted.
// Hence `always`, `never`, `exactly one of` that hold in A hold in N. A `reachable` that is violated in A is violated
// in N. Both are true with `at stable` as well. Runs of A do not transfer to N.
//
// `no timelock` holds in N under three premises on A with ChoiceLifetime::Instant. (1) All abstracted instances can
// rest. (2) The urgent edges of A have no cycle. (3) In each state without enabled urgent edge, each bound of an
// invariant can be left in time (premise of dense time, docs/explanation/timed-engine.md). In a state of N, let the
// abstracted instances rest. Urgent edges lead to a state without urgent edges: they are edges of A, or begin a cycle
// that EVOL_PL requests, as an additional edge of A does, once for each PLC. There time passes, or stops at a bound
// that an edge leaves; each clock stops it once in an instant. `no deadlock` holds in N if also one instance is lively.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

enum class InputLevel : std::uint8_t { Chosen, Untimed, Paced, Complete };

/// Premises that are omitted on purpose, for tests that show that each of them is needed.
struct InputAblations {
    bool no_cycle_on_change = false;  ///< a cycle begins only if the rest of the loop requests it
    bool initial_values = false;      ///< Chosen instances keep their initial outputs
    bool ignore_readers = false;      ///< a process that reads a Chosen instance sees its initial outputs
    bool own_guards_only = false;     ///< valuations are computed for the initial values of other variables
    bool all_can_rest = false;     ///< instances with invariants or urgent edges are abstracted as if they could rest
    bool keep_quiescence = false;  ///< the condition of quiescence still reads Chosen instances
};

/// A process that can be abstracted: an instance of plant or environment, or a timer of a controller.
struct AbstractableProcess {
    Id<Network::Process> process = {};
    std::vector<Id<Network::Variable>> outputs = {};  ///< that it writes, without flags
    /// Reachable, clocks ignored; per row one value per output. Empty: `Chosen` is not available.
    std::vector<std::vector<std::int64_t>> valuations = {};
    std::vector<Id<Network::Process>> readers = {};  ///< of the outputs; of PLCs, those that read them in a guard
    bool autonomous = false;
    bool can_rest = false;  ///< no invariant and no urgent edge: it need not move
    bool lively = false;    ///< autonomous, can rest, and can always move after some time

    bool operator==(const AbstractableProcess&) const = default;
};

/// `Chosen` is available to instances that alone write their outputs, with at most 32 valuations and no value out of
/// range. Requires: `network` is expanded and without observers.
std::vector<AbstractableProcess> abstractable_processes(const Network& network, const InputAblations& ablations = {});

/// The level after `level` that the process can have.
InputLevel next_level(const AbstractableProcess& process, InputLevel level);

/// Raises Chosen processes that a stored process reads to `Untimed`.
void store_what_is_read(const std::vector<AbstractableProcess>& processes, std::vector<InputLevel>& levels);

/// The inputs of one Chosen instance as one PLC samples them. The set of valuations that are still possible is all of
/// them at the beginning of each cycle; each edge of the PLC that reads one of the variables narrows it.
struct InputChoice {
    std::size_t instance = 0;  ///< index in the list of abstractable processes
    Id<Network::Process> plc = {};
    std::vector<Id<Network::Variable>> variables = {};
    std::vector<std::vector<std::int64_t>> valuations = {};
    bool kept = false;                            ///< the set is part of a state: edges after the first one read it
    bool until_delay = false;                     ///< a set that cycles leave as it is: see ChoiceLifetime
    std::vector<Id<Network::Edge>> widened = {};  ///< edges of the PLC after which all valuations are possible again
};

/// How long a valuation that a PLC has chosen is its input. `Cycle`: until the cycle ends. `Instant`: until time passes
/// or the instance moves, so that the urgent edges of the abstraction are those of the loop while the instances rest.
enum class ChoiceLifetime : std::uint8_t { Cycle, Instant };

struct InputAbstraction {
    Network network = {};  ///< processes, variables and edges of the original keep their numbers
    std::vector<InputChoice> choices = {};
    std::vector<Id<Network::Process>> paced = {};  ///< for in_longest_unit
};

/// `levels`: one per process, after store_what_is_read. Terms of properties of `network` that read a Chosen instance
/// have no meaning in the result.
InputAbstraction abstract_inputs(const Network& network, const std::vector<AbstractableProcess>& instances,
                                 const std::vector<InputLevel>& levels, const InputAblations& ablations = {},
                                 ChoiceLifetime lifetime = ChoiceLifetime::Cycle);

/// Converts to the longest time unit in which all clock bounds are integers. Bounds of Paced instances are not
/// considered: they become 1, or 0 if they are shorter than the unit. Integer time is exact in it as in any unit that
/// divides the bounds. Without `paced`: the same network in that unit. Requires: `network` is expanded.
Network in_longest_unit(Network network, const std::vector<Id<Network::Process>>& paced = {});

/// Lower bounds of `automaton` become `unit`, or 0 if they are shorter; upper bounds are removed, and no edge is
/// urgent.
void pace(const Network& network, const Network::Process& process, Network::Template& automaton, std::int64_t unit,
          Exprs& exprs);

}  // namespace grafverif
