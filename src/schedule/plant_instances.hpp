// SPDX-License-Identifier: MIT
// PlantInstances: represents the processes of a Network by instances of main, for all schedules.
#pragma once

#include <string>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "schedule/automaton_module.hpp"

namespace grafverif::schedule {

/// Conditions that a schedule passes to the modules of processes as parameters.
struct Signals {
    /// For each process: condition that is true in a step in which the process may move.
    std::vector<Id<Symbol>> turns = {};
    Id<Symbol> first = {}, round = {}, tick = {};
    Id<Symbol> over = {};  ///< in rounds: true if all processes have had their turn in this round
};

struct PlantInstances {
    Main& main;
    const AutomatonContext context;
    /// Module of each process. The contents of the modules have been moved into the system.
    std::vector<AutomatonModule> automata = {};
    std::vector<Id<TransitionSystem::Instance>> instances = {};  ///< instance of each process
    std::vector<Id<Symbol>> variables = {};                      ///< symbol in main for each variable of the network

    /// Adds an instance, and if necessary a module, for every process. Adds a variable of main for each variable of the
    /// network that belongs to no module and has no symbol in `known`. `known` contains the symbols of main that
    /// already represent variables of the network (outputs of controllers).
    PlantInstances(Main& main, AutomatonContext context, std::vector<Id<Symbol>> known);

    /// Returns a term of main that reads a symbol of the module of a process.
    Id<Expr> inner(std::size_t process, Id<Symbol> symbol) const { return main.inner(instances[process], symbol); }
    /// Returns a condition that is true if the process is in `location`.
    Id<Expr> at(std::size_t process, std::uint32_t location) const {
        const Id<Symbol> held = automata[process].location;
        if (!held.valid()) return main.system.exprs.constant(true);
        return main.draft.is(main.member(instances[process], held), location);
    }
    /// Returns the symbol of the variable that is argument number `argument` of a process.
    Id<Symbol> argument(std::size_t process, std::size_t argument) const {
        const auto& arguments = context.network.processes[{static_cast<std::uint32_t>(process)}].arguments;
        return variables[std::get<Id<Network::Variable>>(arguments[argument]).index];
    }
    /// Returns `automata[i].*symbol` for every process that has such a symbol.
    std::vector<Id<Expr>> each(Id<Symbol> AutomatonModule::*symbol) const;
    /// Returns a condition that is true if no process has an enabled urgent edge.
    Id<Expr> none_urgent() const;
    /// Returns the data about a process that traces need: the symbol of its location, and its variables that
    /// controllers neither read nor write.
    TransitionSystem::Component component(std::size_t process) const;

    /// Sets the arguments of each instance: the variables that its module reads, and the conditions in `signals`.
    void wire(const Signals& signals) const;
    /// Sets the next values of the variables of main that processes write.
    void set_effects() const;
    /// Adds one justice condition for each movement of the plant and for each timer. Movements of the environment have
    /// no justice condition.
    void add_fairness() const;
    /// Adds the property `no_out_of_range` if some automaton can assign a value outside the range of a variable.
    void add_range_property() const;
};

/// Returns `of_NAME` for each process. These names are the values of the choice that selects the moving process.
std::vector<std::string> movers(const Network& network);

/// Reports variables of the network that have too many values for a symbolic model.
void check_widths(const Network& network, Diagnostics& diagnostics);

}  // namespace grafverif::schedule
