// SPDX-License-Identifier: MIT
// Translates one automaton of a Network to a module of the TransitionSystem (DESDES06 6.2). In each step the automaton
// takes one of its edges or stays in its location. A choice selects the edge, and a transition constraint per edge
// restricts the choice. The next values of the location, the variables and the clocks are conditional terms that depend
// on the chosen edge.
//
//   MODULE cylinder_5_2(G_IN, G_OUT)
//   IVAR   edge : {stay, in_to_moving_out, ...};
//   VAR    location : {in, moving_out, out, moving_in};
//   ASSIGN next(location) := case edge = in_to_moving_out : moving_out; ...
//   DEFINE OUT := location = out;     if the location determines the value; otherwise OUT is a variable
//   TRANS  edge = in_to_moving_out -> location = in & G_OUT & !G_IN;
//
// Clocks are omitted, or count time units up to their caps (ir/network_clocks, as in the timed engine): a step in which
// `tick` is true increments each clock that can be compared before its next reset.
//
// An automaton executes assignments sequentially, but a module assigns all next values simultaneously. Therefore each
// next value is expressed by the values before the step. Variables with several writers (the flags of the PLC) are
// variables of main. For each variable of main that a module writes, the module defines the condition under which it
// writes the variable, and the value that it writes. An assignment of a value outside the range of its variable sets
// `out_of_range` permanently and does not change the variable.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "ir/network_clocks.hpp"
#include "schedule/main.hpp"

namespace grafverif::schedule {

/// Restrictions that a schedule imposes on the steps of automata.
enum class Discipline {
    /// The automaton takes one edge in a step in which the parameter `turn` is true, and no edge in all other steps.
    Turns,
    Together,  ///< in each step, the automaton takes one edge, or no edge if none of its urgent edges is enabled
    /// Like `Together`, but the automaton takes an edge only in a step in which `turn` is true. The automaton takes at
    /// most one edge in each `round`, and a timed edge only in the `first` round.
    Rounds,
};

/// Context of the translation of automata: the network, and the variables that are shared by several processes.
struct AutomatonContext {
    const Network& network;
    Discipline discipline = Discipline::Turns;
    std::vector<bool> shared = {};  ///< for each variable: true if several processes write it
    bool fairness = false;
    /// Clock analysis of the expanded network for discrete time; empty for abstract time, in which clocks are omitted.
    std::vector<ProcessClocks> clocks = {};
};

/// A terminating movement of a plant component: the automaton stays in a location with an upper time bound.
struct Movement {
    Id<Symbol> moving = {};  ///< definition: true while the movement is in progress
    /// Variable: true if the previous step took an edge that ends the movement and restarts it. Invalid if the
    /// automaton has no edge of this type.
    Id<Symbol> ended = {};
};

/// A variable of main that the automaton writes. `writes` is true if the automaton writes the variable in the current
/// step.
struct Effect {
    Id<Network::Variable> variable = {};
    Id<Symbol> writes = {}, value = {};
};

struct AutomatonModule {
    using Held = std::pair<Id<Network::Variable>, Id<Symbol>>;

    TransitionSystem::Module module = {};
    /// Parameters; invalid if the module does not have the parameter.
    Id<Symbol> turn = {}, first = {}, round = {}, tick = {};
    /// Variables that are passed as further parameters, which follow the parameters `turn` to `tick`.
    std::vector<Id<Network::Variable>> reads = {};
    Id<Symbol> edge = {};      ///< choice: 0 for no edge, otherwise the index of the edge plus one
    Id<Symbol> location = {};  ///< location; invalid if there is only one location
    std::vector<Held> owned = {};
    /// Definitions: scratch variables (firing conditions), which have a value only within a step.
    std::vector<Held> within = {};
    /// Definition: true if the clocks permit one time unit to pass; invalid if it is always true.
    Id<Symbol> may_wait = {};
    std::vector<Effect> effects = {};
    /// Definition: true if an edge of the automaton can be taken; invalid for abstract time.
    Id<Symbol> can_move = {};
    Id<Symbol> must_move = {};  ///< definition: true if an urgent edge can be taken
    Id<Symbol> stays = {};      ///< definition: true if the automaton takes no edge in the step
    /// True after a fault; invalid if no assigned value can be outside the range of its variable and no term can divide
    /// by zero.
    Id<Symbol> out_of_range = {};
    Id<Symbol> done = {};  ///< only for Rounds: true after the automaton's turn in the current round
    std::vector<Movement> movements = {};
};

/// Returns a key for the module of a process. Processes with equal keys have equal modules.
std::vector<std::int64_t> module_key(const AutomatonContext& context, Id<Network::Process> process);
AutomatonModule automaton_module(const AutomatonContext& context, Id<Network::Process> process, Exprs& exprs);

}  // namespace grafverif::schedule
