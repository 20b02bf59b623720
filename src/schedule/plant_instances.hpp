// SPDX-License-Identifier: MIT
// PlantInstances: the processes of a Network as instances of main, for all schedules.
#pragma once

#include <string>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "schedule/automaton_module.hpp"

namespace grafverif::schedule {

/// Signals of a schedule to the modules.
struct Signals {
    std::vector<Id<Symbol>> turns = {};  ///< per process
    Id<Symbol> first = {}, round = {}, tick = {};
    Id<Symbol> over = {};  ///< in rounds: all have had their turn
};

struct PlantInstances {
    Main& main;
    const AutomatonContext context;
    std::vector<AutomatonModule> automata = {};                  ///< per process; their modules have been moved into
                                                                 ///< the system
    std::vector<Id<TransitionSystem::Instance>> instances = {};  ///< per process
    std::vector<Id<Symbol>> variables = {};                      ///< per variable of the network: its symbol in main

    /// Adds modules and instances of every process, and variables of main for variables that none of them owns.
    /// `known`: existing symbols of main by variable of the network (outputs of controllers).
    PlantInstances(Main& main, AutomatonContext context, std::vector<Id<Symbol>> known);

    /// A symbol of the module of a process, as visible in main.
    Id<Expr> inner(std::size_t process, Id<Symbol> symbol) const { return main.inner(instances[process], symbol); }
    /// The process is in a location.
    Id<Expr> at(std::size_t process, std::uint32_t location) const {
        const Id<Symbol> held = automata[process].location;
        if (!held.valid()) return main.system.exprs.constant(true);
        return main.draft.is(main.member(instances[process], held), location);
    }
    /// The symbol of the variable passed to a process as argument number `argument`.
    Id<Symbol> argument(std::size_t process, std::size_t argument) const {
        const auto& arguments = context.network.processes[{static_cast<std::uint32_t>(process)}].arguments;
        return variables[std::get<Id<Network::Variable>>(arguments[argument]).index];
    }
    /// `automata[i].*symbol` for every process that has such a symbol.
    std::vector<Id<Expr>> each(Id<Symbol> AutomatonModule::*symbol) const;
    /// No process has an enabled urgent edge.
    Id<Expr> none_urgent() const;
    /// Names of a process for traces: its location, and its variables that no controller reads or writes.
    TransitionSystem::Component component(std::size_t process) const;

    /// Passes each instance its arguments.
    void wire(const Signals& signals) const;
    /// Sets the next values of the variables of main that processes write.
    void set_effects() const;
    /// One justice condition per movement of the plant and per timer, none for the environment.
    void add_fairness() const;
    /// `no_out_of_range`, if some automaton can leave a range.
    void add_range_property() const;
};

/// `of_NAME` per process: values of the choice of the moving process.
std::vector<std::string> movers(const Network& network);

/// Reports variables of the network that have too many values for a symbolic model.
void check_widths(const Network& network, Diagnostics& diagnostics);

}  // namespace grafverif::schedule
