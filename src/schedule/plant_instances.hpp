// SPDX-License-Identifier: MIT
// PlantInstances: the processes of a Network as instances of main, whatever the schedule.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "ir/network_clocks.hpp"
#include "grafverif/ir/transition_system.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "schedule/properties.hpp"
#include "support/unique_names.hpp"

namespace grafverif::schedule {

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

using Symbol = TransitionSystem::Symbol;

/// What a schedule asks of automata.
enum class Discipline {
    Turns,        ///< a parameter `turn`: one edge where it is true, none where it is false
    Together,     ///< one edge in each step; none only where no urgent edge can be taken
    Rounds,       ///< in its `turn` likewise, once in each `round`, timed edges only in the `first` one
};

/// A movement that ends for certain: a location with an upper bound of time. `moving` over the module's symbols.
struct Movement {
    std::string location = {};
    Id<Symbol> moving = {};             ///< a definition
    Id<Symbol> ended = {};              ///< a variable: an edge from here to here has just ended one; or not valid
};

struct AutomatonModule {
    TransitionSystem::Module module = {};
    Id<Symbol> turn = {}, first = {}, round = {}, tick = {};    ///< parameters; not valid where there is none
    Id<Symbol> done = {};                                       ///< in rounds: it has had its turn in this one
    std::vector<Id<Network::Variable>> reads = {};              ///< the other parameters, in order, after those
    Id<Symbol> location = {};                                   ///< not valid: there is one location only
    std::vector<std::pair<Id<Network::Variable>, Id<Symbol>>> owned = {};
    /// A variable of main that the automaton writes: whether it does in this step, and the value.
    struct Effect {
        Id<Network::Variable> variable = {};
        Id<Symbol> writes = {}, value = {};
    };
    std::vector<Effect> effects = {};
    /// Firing conditions that live within a step only, as definitions.
    std::vector<std::pair<Id<Network::Variable>, Id<Symbol>>> within = {};
    Id<Symbol> edge = {};                                       ///< the choice: 0 for none, else one more than the edge's index
    Id<Symbol> must_move = {};                                  ///< definition: some urgent edge can be taken
    Id<Symbol> can_move = {};                                   ///< likewise any edge; only where clocks count
    Id<Symbol> may_wait = {};                                   ///< definition: its clocks let a unit of time pass; not valid: always
    Id<Symbol> stays = {};                                      ///< definition: it takes no edge in this step
    Id<Symbol> out_of_range = {};                               ///< not valid: no assignment can leave its range
    std::vector<Movement> movements = {};
};

/// How a Network is laid out in modules.
struct AutomatonContext {
    const Network& network;
    Discipline discipline = Discipline::Turns;
    std::vector<bool> shared = {};      ///< per variable: several processes write it, or nobody does
    bool fairness = false;
    std::vector<ProcessClocks> clocks = {};   ///< of the expanded network: clocks count; empty: they are left out
};

/// Two processes with equal keys have equal modules.
std::vector<std::int64_t> module_key(const AutomatonContext& context, Id<Network::Process> process);
AutomatonModule automaton_module(const AutomatonContext& context, Id<Network::Process> process, Exprs& exprs);

struct PlantInstances {
    Members& members;
    const AutomatonContext& context;
    UniqueNames& names;                                          ///< taken in main
    UniqueNames& modules;                                        ///< of modules
    std::vector<AutomatonModule> automata = {};                  ///< per process; their modules moved into the system
    std::vector<Id<TransitionSystem::Instance>> instances = {};  ///< per process
    std::vector<Id<Symbol>> variables = {};                      ///< per variable of the network: what holds it in main

    TransitionSystem& system() const { return members.system; }
    Id<Expr> leaf(Id<Symbol> symbol) const { return system().exprs.leaf(Op::Variable, symbol.index); }
    /// A symbol of the module of a process, as main sees it.
    Id<Expr> inner(std::size_t process, Id<Symbol> symbol) const {
        return leaf(member(members, instances[process], symbol));
    }
    /// A process is at a location.
    Id<Expr> at(std::size_t process, std::uint32_t location) const {
        const Id<Symbol> held = automata[process].location;
        if (!held.valid()) return system().exprs.constant(true);
        return system().exprs.apply(Op::Equal, inner(process, held), system().exprs.integer(location));
    }
    /// `condition` over every process, where it has such a symbol: `automata[i].*symbol`.
    std::vector<Id<Expr>> each(Id<Symbol> AutomatonModule::*symbol) const;
    /// What traces say of a process: its location, and its variables that no controller reads or writes.
    TransitionSystem::Component component(std::size_t process) const;
};

/// Adds modules and instances of every process; `variables` of main for what none of them owns. What main knows already
/// (outputs of controllers) is passed in `variables`, by variable of the network.
void add_instances(PlantInstances& plant);
/// What a schedule hands to the modules that ask for it.
struct Signals {
    std::vector<Id<Symbol>> turns = {};   ///< per process
    Id<Symbol> first = {}, round = {}, tick = {};
};
/// Hands each instance its arguments.
void wire(PlantInstances& plant, const Signals& signals);
/// The next values of the variables of main that processes write.
void add_effects(PlantInstances& plant);
/// One justice condition per movement of the plant and per timer, none of the environment.
void add_fairness(PlantInstances& plant);
/// `no_out_of_range`, where some automaton can leave a range.
void add_range_property(PlantInstances& plant);

/// A definition of main.
Id<Symbol> define(PlantInstances& plant, const std::string& wish, Id<Expr> value, const char* section);

/// Reports variables of the network that have too many values for a symbolic model.
void check_widths(const Network& network, Diagnostics& diagnostics);

}  // namespace grafverif::schedule
