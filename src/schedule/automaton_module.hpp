// SPDX-License-Identifier: MIT
// One automaton of a Network as a module of the TransitionSystem (DESDES06 6.2). In each step it takes one of its edges
// or stays. A choice selects the edge, a transition constraint per edge restricts the choice, and location, variables
// and clocks have next values by cases over the edge taken.
//
//   MODULE cylinder_5_2(G_IN, G_OUT)
//   IVAR   edge : {stay, in_to_moving_out, ...};
//   VAR    location : {in, moving_out, out, moving_in};
//   ASSIGN next(location) := case edge = in_to_moving_out : moving_out; ...
//   DEFINE OUT := location = out;     if the location determines the value; otherwise a variable
//   TRANS  edge = in_to_moving_out -> location = in & G_OUT & !G_IN;
//
// Clocks are omitted, or count time units up to their caps (ir/network_clocks, the normalization of the timed engine):
// a step with `tick` increments each clock that is still compared in its location.
//
// Assignments are sequential in the automaton and simultaneous here: each value is a term over the values before the
// step. Variables with several writers (the flags of the PLC) are variables of main; the module defines when it writes
// them, and the values. An assignment that would leave the range of its variable sets `out_of_range` permanently and
// keeps the old value.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "ir/network_clocks.hpp"
#include "schedule/main.hpp"

namespace grafverif::schedule {

/// Constraints of a schedule on automata.
enum class Discipline {
    Turns,     ///< a parameter `turn`: takes one edge if it is true, none if it is false
    Together,  ///< one edge in each step; none only if no urgent edge can be taken
    Rounds,    ///< in its `turn` as Together, once in each `round`; timed edges only in the `first` one
};

/// Distribution of a Network over modules.
struct AutomatonContext {
    const Network& network;
    Discipline discipline = Discipline::Turns;
    std::vector<bool> shared = {};  ///< per variable: several processes write it, or none
    bool fairness = false;
    std::vector<ProcessClocks> clocks = {};  ///< of the expanded network if clocks count; empty if they are omitted
};

/// A movement that terminates: a location with an upper time bound. `moving` is a term over the module's symbols.
struct Movement {
    Id<Symbol> moving = {};  ///< a definition
    Id<Symbol> ended = {};   ///< a variable: an edge that ends the movement and restarts it has just been taken; or
                             ///< invalid
};

/// A variable of main that the automaton writes: `writes` is true if it does in this step.
struct Effect {
    Id<Network::Variable> variable = {};
    Id<Symbol> writes = {}, value = {};
};

struct AutomatonModule {
    using Held = std::pair<Id<Network::Variable>, Id<Symbol>>;

    TransitionSystem::Module module = {};
    Id<Symbol> turn = {}, first = {}, round = {}, tick = {};  ///< parameters; invalid if omitted
    std::vector<Id<Network::Variable>> reads = {};            ///< the other parameters, in order, after those
    Id<Symbol> edge = {};      ///< the choice: 0 for none, otherwise one more than the edge's index
    Id<Symbol> location = {};  ///< invalid if there is only one location
    std::vector<Held> owned = {};
    std::vector<Held> within = {};  ///< definitions: firing conditions that exist only within a step
    Id<Symbol> may_wait = {};       ///< definition: its clocks allow a time unit to pass; invalid: always true
    std::vector<Effect> effects = {};
    Id<Symbol> can_move = {};      ///< definition: an edge can be taken; only if clocks count
    Id<Symbol> must_move = {};     ///< definition: an urgent edge can be taken
    Id<Symbol> stays = {};         ///< definition: it takes no edge in this step
    Id<Symbol> out_of_range = {};  ///< invalid: every assignment stays in its range
    Id<Symbol> done = {};          ///< in rounds: it has had its turn in the current round
    std::vector<Movement> movements = {};
};

/// Two processes with equal keys have equal modules.
std::vector<std::int64_t> module_key(const AutomatonContext& context, Id<Network::Process> process);
AutomatonModule automaton_module(const AutomatonContext& context, Id<Network::Process> process, Exprs& exprs);

}  // namespace grafverif::schedule
