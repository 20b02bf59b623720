// SPDX-License-Identifier: MIT
// Input abstraction: an over-approximation of a closed loop in which some inputs get arbitrary values when a PLC
// samples them.
//
// An instance is *autonomous* if its edges read only variables that no other process writes. Examples are a push
// button, a selector, a free input and a sensor of the environment. Other instances, such as a cylinder or a tank, read
// variables of the loop. A PLC usually reads an instance only when it samples the outputs of the instance. A property,
// an observer or another process can also read an instance. The abstraction represents each process that is not a PLC
// at one of four levels:
//
//   Chosen: The location, clocks and outputs of the instance are not stored. Each sampling by a PLC chooses one of the
//     reachable output valuations of the instance, independently of earlier samplings. All outputs of an instance are
//     chosen jointly, so a selector never has two positions.
//   Untimed: The location and outputs of the process are stored, and its clocks are ignored. Urgent edges remain
//     urgent. An edge with a clock constraint may be taken at any time; such an edge is never urgent.
//   Paced (for autonomous instances only): Upper bounds of clocks are ignored, and each lower bound is replaced by one
//     time unit of the search, so that the instance does not change twice within one instant.
//   Complete: The process is unchanged.
//
// Let N be the network and A the abstraction. Ignore the locations, clocks and outputs of the Chosen instances, the
// clocks of the Untimed and Paced processes, and EVOL_PL. Then each run of N is a run of A with the same delays, for
// the following reasons:
//   - An edge of a Chosen instance does not correspond to a move of A. If N begins a cycle because of an edge of a
//     Chosen instance (EVOL_PL), A takes the additional edge of the PLC, which can begin a cycle at any time in
//     location W. The values that N samples in this cycle are one of the valuations of A, because A has every valuation
//     that the instance can reach for arbitrary values of the other variables.
//   - A PLC cycle of A is never more urgent than in N: the additional edge is not urgent, and all other edges of the
//     PLC have the same guard as in N.
//   - An edge of an Untimed or Paced process has the same guard as in N, over the same values (a process that a stored
//     process reads is also stored). The clock constraints of the edge in A permit every delay that they permit in N.
//     An urgent edge has no clock constraint and keeps the invariant of its target (see verify). Therefore an urgent
//     edge is enabled in A only if it is enabled in N, and time can pass in A whenever it can pass in N.
//   - If N is quiescent, A is quiescent: the condition of quiescence of A omits only the conjuncts that read a Chosen
//     instance.
// Therefore, if an `always`, `never` or `exactly one of` property holds in A, the property holds in N. A `reachable`
// property that is violated in A is violated in N. Both conclusions, from A to N, also apply with
// `at stable`. A run of A is not necessarily a run of N.
//
// `no timelock` and `no deadlock` need other arguments, in which the abstracted instances do not move
// (docs/explanation/input-abstraction.md, "No timelock, no deadlock"); see ChoiceLifetime.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif {

enum class InputLevel : std::uint8_t { Chosen, Untimed, Paced, Complete };

/// Ablations of the premises of the input abstraction. If a member is true, one premise is dropped, so that tests can
/// show that this premise is necessary.
struct InputAblations {
    bool no_cycle_on_change = false;  ///< a change of a Chosen instance does not begin a cycle
    bool initial_values = false;      ///< Chosen instances keep their initial outputs

    /// A process that reads a Chosen instance always reads the initial outputs of this instance.
    bool ignore_readers = false;
    bool ignore_readings = false;  ///< all previous values are dead (ir/network/dead_values.hpp)

    /// Valuations are computed for the initial values of other variables instead of arbitrary values.
    bool own_guards_only = false;
    bool all_can_rest = false;  ///< instances with invariants or urgent edges are abstracted as if they need not move
    bool keep_quiescence = false;   ///< the condition of quiescence of the abstraction still reads Chosen instances
    bool urgent_on_clocks = false;  ///< edges of Untimed processes with a clock constraint become urgent

    // Premises of lets_time_pass (check/inputs/resting.hpp):
    bool ignore_bounds = false, ignore_outputs = false, ignore_moves = false;
    bool ignore_evolutions = false;  ///< evolutions of a PLC need not end
    bool ignore_errors = false;      ///< the proof that evolutions end ignores model errors
    bool search_evolutions = false;  ///< not a premise: a search proves that evolutions end, instead of evolutions_end

    // Premises of PossibleProof (check/inputs/possible.hpp):
    bool one_bound = false;         ///< rule 3 of possible.hpp is applied to only one bound of an invariant
    bool any_edge = false;          ///< edges in the rules of possible.hpp need not be possible for all clock values
    bool need_not_return = false;   ///< panel instances (possible.hpp) need not be able to return
    bool need_not_diverge = false;  ///< the proof does not require that time diverges

    bool need_not_begin_cycle = false;  ///< a move of a homing sequence need not begin a cycle of the PLC
    bool leave_freely = false;          ///< processes are assumed to leave each state to which they cannot return
    bool without_homing = false;        ///< not a premise: required states are computed without a homing sequence
    bool round_inward = false;  ///< clock bounds of observers are rounded to stronger bounds instead of weaker bounds
    // Premises of prove_response (check/inputs/response.hpp):
    bool need_not_take_time = false;  ///< runs with infinitely many moves in bounded time are permitted
    bool start_initially = false;     ///< an additional process is in its initial state when the last cycle begins
    bool one_situation = false;       ///< only one of the last situations is examined
};

/// A process that can be abstracted: an instance of the plant or the environment, or a timer of a controller.
struct AbstractableProcess {
    Id<Network::Process> process = {};
    std::vector<Id<Network::Variable>> outputs = {};  ///< outputs that the process writes, without flags

    std::vector<Id<Network::Variable>> read_outputs = {};  ///< the outputs that other processes read

    /// Superset of the reachable valuations of `read_outputs`, for arbitrary values of the clocks and of the variables
    /// of other processes: each row has one value per variable. If empty, `Chosen` is not available.
    std::vector<std::vector<std::int64_t>> valuations = {};
    /// Processes that read the outputs. A PLC is included only if it reads an output in a guard.
    std::vector<Id<Network::Process>> readers = {};
    bool autonomous = false;
    /// True if the process has no invariant and no urgent edge, so that it can remain in each location forever.
    bool can_rest = false;
    bool lively = false;  ///< true if the process is autonomous, `can_rest`, and can always move again after some time

    /// True if the process is autonomous, `can_rest`, and can always return to its initial state by edges whose clock
    /// constraints are only lower bounds.
    bool returns = false;

    bool operator==(const AbstractableProcess&) const = default;
};

/// Returns the processes that can be abstracted. `Chosen` is available for an instance if no other process writes its
/// outputs, it has at most 32 valuations, and no edge of the instance can have a model error. The result is empty if a
/// controller has a task cycle, because the abstraction assumes that a change of an input requests a scan. Requires that
/// `network` is expanded and has no observers.
std::vector<AbstractableProcess> abstractable_processes(const Network& network, const InputAblations& ablations = {});

/// Returns the least precise level that is more precise than `level` and available for the process. From least to most
/// precise, the levels are Chosen, Untimed, Paced, Complete.
InputLevel next_level(const AbstractableProcess& process, InputLevel level);

/// Sets the level to `Untimed` for each Chosen process whose outputs a stored (not Chosen) process reads.
void store_what_is_read(const std::vector<AbstractableProcess>& processes, std::vector<InputLevel>& levels);

/// The values that one PLC samples from one Chosen instance. At the beginning of each cycle, all valuations are
/// possible. Each edge of the PLC that reads one of `variables` restricts the set of possible valuations.
struct InputChoice {
    std::size_t instance = 0;  ///< index of the instance in the list of abstractable processes
    Id<Network::Process> plc = {};
    std::vector<Id<Network::Variable>> variables = {};
    std::vector<std::vector<std::int64_t>> valuations = {};
    bool kept = false;  ///< true if the set of possible valuations is part of the state

    /// True if the set remains unchanged between cycles until time passes (see ChoiceLifetime).
    bool until_delay = false;
    /// If valid: all valuations become possible again when this flag of the PLC becomes true.
    Id<Network::Variable> stable = {};
    Id<Network::Location> waiting = {};           ///< location of the PLC in which `stable` is read
    std::vector<Id<Network::Edge>> widened = {};  ///< edges of the PLC after which all valuations are possible again
};

/// Defines how long a chosen valuation remains the input of a PLC. With `Cycle`, the valuation remains until the cycle
/// of the PLC ends. With `Instant`, the valuation remains until time passes or the instance moves, so that the
/// abstraction has the same urgent edges as the loop while the instances do not move. With `Evolution`, the valuation
/// remains until the PLC is stable or an instance moves; clocks are ignored, and urgent edges of timers remain urgent.
enum class ChoiceLifetime : std::uint8_t { Cycle, Instant, Evolution };

struct InputAbstraction {
    /// The abstraction, in which processes, variables and edges have the same indices as in the original network.
    Network network = {};
    std::vector<InputChoice> choices = {};
    std::vector<Id<Network::Process>> paced = {};  ///< Paced instances, as argument of in_longest_unit

    /// Untimed timers. A search may restrict these timers: it takes their non-urgent edges only while their PLC waits.
    /// If only the PLC and its timers read the timers, the restriction changes no reachable state except in EVOL_TI.
    std::vector<Id<Network::Process>> deferred = {};
    /// PLCs that may begin a cycle whenever they wait and no timer has a request.
    std::vector<Id<Network::Process>> unprompted = {};
};

/// Builds the input abstraction. `levels` contains one level per process. Requires that store_what_is_read has been
/// applied to `levels`. Requires that no property to be decided on the result reads a Chosen instance.
InputAbstraction abstract_inputs(const Network& network, const std::vector<AbstractableProcess>& instances,
                                 const std::vector<InputLevel>& levels, const InputAblations& ablations = {},
                                 ChoiceLifetime lifetime = ChoiceLifetime::Cycle);

/// Converts `network` to the longest time unit in which all clock bounds are integers. Bounds of `paced` instances do
/// not affect the choice of the unit: they become 1, or 0 if they are shorter than the unit. Integer time is exact in
/// this unit, as in any unit that divides the bounds. Bounds of `rounded` processes do not affect the choice of the
/// unit either: lower bounds are rounded down to multiples of the unit, and upper bounds are rounded up, so that each
/// run remains possible. If both lists are empty, the result is `network` with the longest unit. Requires that
/// `network` is expanded, and that `rounded` processes have no constraint `clock == bound`.
Network in_longest_unit(Network network, const std::vector<Id<Network::Process>>& paced = {},
                        const std::vector<Id<Network::Process>>& rounded = {}, const InputAblations& ablations = {});

/// Converts `network` to the longest time unit in which the clock bounds of all processes except autonomous instances
/// are integers. Lower bounds of autonomous instances are rounded up and upper bounds are rounded down, so that each
/// run is a run of `network`; an instance may be unable to move. Requires that `network` is expanded.
Network in_longer_unit(Network network, const std::vector<AbstractableProcess>& instances);

/// Removes all clock constraints, invariants and resets of `automaton`.
void ignore_clocks(Network::Template& automaton);

/// Replaces each lower bound in `automaton` by `unit`, or by 0 if the bound is shorter than `unit`. Removes upper
/// bounds and makes all edges non-urgent.
void pace(const Network& network, const Network::Process& process, Network::Template& automaton, std::int64_t unit,
          Exprs& exprs);

}  // namespace grafverif
