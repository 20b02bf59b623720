// SPDX-License-Identifier: MIT
// PlantInstances: the processes of a Network as instances of main, whatever the schedule.
#pragma once

#include <string>
#include <vector>

#include "grafverif/schedule/options.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "schedule/automaton_module.hpp"
#include "schedule/properties.hpp"
#include "support/unique_names.hpp"

namespace grafverif::schedule {

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
