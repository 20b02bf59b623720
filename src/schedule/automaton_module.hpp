// SPDX-License-Identifier: MIT
// One automaton of a Network as a module of the TransitionSystem (DESDES06 6.2). In each step it takes one of its
// edges, or stays: a choice says which, a transition constraint per edge says when, and location, variables and clocks
// have next values by the edge taken.
//
//   MODULE cylinder_5_2(G_IN, G_OUT)
//   IVAR   edge : {stay, in_to_moving_out, ...};
//   VAR    location : {in, moving_out, out, moving_in};
//   ASSIGN next(location) := case edge = in_to_moving_out : moving_out; ...
//   DEFINE OUT := location = out;     where the location tells the value; else a variable
//   TRANS  edge = in_to_moving_out -> location = in & G_OUT & !G_IN;
//
// Clocks are left out, or count units of time up to their caps (ir/network_clocks, the normalisation of the timed
// engine): a step with `tick` adds one to each that its location still compares with something.
//
// Assignments are sequential in the automaton and simultaneous here: each value is written over the values before the
// step. What several automata write (the flags of the PLC) is a variable of main; the module says when it writes it,
// and what. An assignment that would leave the range of its variable sets `out_of_range` for ever and keeps the value.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "ir/network_clocks.hpp"
#include "schedule/main.hpp"

namespace grafverif::schedule {

/// What a schedule asks of automata.
enum class Discipline {
    Turns,     ///< a parameter `turn`: one edge where it is true, none where it is false
    Together,  ///< one edge in each step; none only where no urgent edge can be taken
    Rounds,    ///< in its `turn` likewise, once in each `round`, timed edges only in the `first` one
};

/// How a Network is laid out in modules.
struct AutomatonContext {
    const Network& network;
    Discipline discipline = Discipline::Turns;
    std::vector<bool> shared = {};  ///< per variable: several processes write it, or nobody does
    bool fairness = false;
    std::vector<ProcessClocks> clocks = {};  ///< of the expanded network: clocks count; empty: they are left out
};

/// A movement that ends for certain: a location with an upper bound of time. `moving` over the module's symbols.
struct Movement {
    Id<Symbol> moving = {};  ///< a definition
    Id<Symbol> ended = {};   ///< a variable: an edge from here to here has just ended one; or not valid
};

/// A variable of main that the automaton writes: whether it does in this step, and the value.
struct Effect {
    Id<Network::Variable> variable = {};
    Id<Symbol> writes = {}, value = {};
};

struct AutomatonModule {
    using Held = std::pair<Id<Network::Variable>, Id<Symbol>>;

    TransitionSystem::Module module = {};
    Id<Symbol> turn = {}, first = {}, round = {}, tick = {};  ///< parameters; not valid where there is none
    std::vector<Id<Network::Variable>> reads = {};            ///< the other parameters, in order, after those
    Id<Symbol> edge = {};      ///< the choice: 0 for none, else one more than the edge's index
    Id<Symbol> location = {};  ///< not valid: there is one location only
    std::vector<Held> owned = {};
    std::vector<Held> within = {};  ///< definitions: firing conditions that live within a step only
    Id<Symbol> may_wait = {};       ///< definition: its clocks let a unit of time pass; not valid: always
    std::vector<Effect> effects = {};
    Id<Symbol> can_move = {};      ///< definition: some edge can be taken; only where clocks count
    Id<Symbol> must_move = {};     ///< definition: some urgent edge can be taken
    Id<Symbol> stays = {};         ///< definition: it takes no edge in this step
    Id<Symbol> out_of_range = {};  ///< not valid: no assignment can leave its range
    Id<Symbol> done = {};          ///< in rounds: it has had its turn in this one
    std::vector<Movement> movements = {};
};

/// Two processes with equal keys have equal modules.
std::vector<std::int64_t> module_key(const AutomatonContext& context, Id<Network::Process> process);
AutomatonModule automaton_module(const AutomatonContext& context, Id<Network::Process> process, Exprs& exprs);

}  // namespace grafverif::schedule
