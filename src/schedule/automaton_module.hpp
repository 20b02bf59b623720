// SPDX-License-Identifier: MIT
// Translates one automaton of a Network to a module of the TransitionSystem (DESDES06 6.2). In each step the automaton
// takes one of its edges or stays in its location. A choice selects the edge, and a transition constraint per edge
// restricts the choice. The next values of location, variables and clocks are defined by cases over the edge that is
// taken.
//
//   MODULE cylinder_5_2(G_IN, G_OUT)
//   IVAR   edge : {stay, in_to_moving_out, ...};
//   VAR    location : {in, moving_out, out, moving_in};
//   ASSIGN next(location) := case edge = in_to_moving_out : moving_out; ...
//   DEFINE OUT := location = out;     if the location determines the value; otherwise a variable
//   TRANS  edge = in_to_moving_out -> location = in & G_OUT & !G_IN;
//
// Clocks are omitted, or count time units up to their caps (ir/network_clocks, as in the timed engine): a step with
// `tick` increments each clock that is compared in the current location or in a later location.
//
// Assignments are sequential in the automaton and simultaneous in the module: each value is a term over the values
// before the step. Variables with several writers (the flags of the PLC) are variables of main. The module defines when
// it writes these variables, and the values that it writes. An assignment of a value outside the range of its variable
// sets `out_of_range` permanently and does not change the variable.
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
    Turns,     ///< the automaton takes one edge if the parameter `turn` is true, and no edge if it is false
    Together,  ///< the automaton takes one edge in each step, or no edge if no urgent edge can be taken
    Rounds,    ///< as Together, but only if `turn` is true, once in each `round`; timed edges only in the `first` round
};

/// Context of the translation of automata: the network, and the assignment of its variables to modules.
struct AutomatonContext {
    const Network& network;
    Discipline discipline = Discipline::Turns;
    std::vector<bool> shared = {};  ///< for each variable: true if several processes write it
    bool fairness = false;
    /// Clock analysis of the expanded network if clocks are counted; empty if they are omitted.
    std::vector<ProcessClocks> clocks = {};
};

/// A movement that terminates, represented by a location with an upper time bound. `moving` is a term over the module's
/// symbols.
struct Movement {
    Id<Symbol> moving = {};  ///< definition: the movement is in progress
    /// Variable: the previous step took an edge that ends the movement and restarts it; may be invalid.
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
    Id<Symbol> turn = {}, first = {}, round = {}, tick = {};  ///< parameters; invalid if omitted
    std::vector<Id<Network::Variable>> reads = {};            ///< the other parameters, which follow those above
    Id<Symbol> edge = {};      ///< choice: 0 for no edge, otherwise the index of the edge plus one
    Id<Symbol> location = {};  ///< location; invalid if there is only one location
    std::vector<Held> owned = {};
    std::vector<Held> within = {};  ///< definitions: firing conditions that exist only within a step
    Id<Symbol> may_wait = {};  ///< definition: the clocks permit a time unit to pass; invalid if this is always true
    std::vector<Effect> effects = {};
    Id<Symbol> can_move = {};      ///< definition: an edge can be taken; exists only if clocks are counted
    Id<Symbol> must_move = {};     ///< definition: an urgent edge can be taken
    Id<Symbol> stays = {};         ///< definition: this step takes no edge
    Id<Symbol> out_of_range = {};  ///< invalid if no assignment can leave its range and no term can divide by zero
    Id<Symbol> done = {};          ///< in rounds: true after the automaton's turn in the current round
    std::vector<Movement> movements = {};
};

/// Returns a key: processes with equal keys have equal modules.
std::vector<std::int64_t> module_key(const AutomatonContext& context, Id<Network::Process> process);
AutomatonModule automaton_module(const AutomatonContext& context, Id<Network::Process> process, Exprs& exprs);

}  // namespace grafverif::schedule
