// SPDX-License-Identifier: MIT
#include "schedule/plant_instances.hpp"

#include <map>

#include "support/messages.hpp"

namespace grafverif::schedule {

namespace {

using System = TransitionSystem;

constexpr std::int64_t most_values = 4096;   // beyond it, the time that NuSMV takes for an integer is felt

System::Module& main_of(PlantInstances& plant) { return plant.system().modules[plant.system().main]; }

}  // namespace

std::vector<Id<Expr>> PlantInstances::each(Id<Symbol> AutomatonModule::*symbol) const {
    std::vector<Id<Expr>> found;
    for (std::size_t process = 0; process < automata.size(); ++process)
        if ((automata[process].*symbol).valid()) found.push_back(inner(process, automata[process].*symbol));
    return found;
}

TransitionSystem::Component PlantInstances::component(std::size_t process) const {
    const Network::Process& of = context.network.processes[{static_cast<std::uint32_t>(process)}];
    System::Component made{.name = of.name};
    made.kind = of.kind == Network::ProcessKind::Timer         ? System::Component::Kind::Timer
                : of.kind == Network::ProcessKind::Environment ? System::Component::Kind::Environment
                                                               : System::Component::Kind::Plant;
    if (automata[process].location.valid()) made.location = member(members, instances[process], automata[process].location);
    for (const auto& [variable, symbol] : automata[process].owned) {
        const Network::Variable& owned = context.network.variables[variable];
        const TransitionSystem::Named named{owned.name, member(members, instances[process], symbol)};
        if (owned.role == Network::Role::Plant) made.variables.push_back(named);
        if (owned.role == Network::Role::Input) made.inputs.push_back(named);
    }
    return made;
}

Id<Symbol> define(PlantInstances& plant, const std::string& wish, Id<Expr> value, const char* section) {
    return main_of(plant).symbols.add({plant.names.fresh(wish), {}, System::DefineSymbol{value}, section, {}, {}});
}

void add_instances(PlantInstances& plant) {
    const Network& network = plant.context.network;
    System& system = plant.system();
    std::map<std::vector<std::int64_t>, Id<System::Module>> known;
    std::vector<std::size_t> first_of;   // per module of the system: the process it was made for
    for (const Id<Network::Process> id : network.processes.ids()) {
        AutomatonModule automaton = automaton_module(plant.context, id, system.exprs);
        const auto [module, fresh] = known.try_emplace(module_key(plant.context, id));
        if (fresh) {
            automaton.module.name = plant.modules.fresh(automaton.module.name);
            module->second = system.modules.add(std::move(automaton.module));
        }
        const std::string name = plant.names.fresh(network.processes[id].name);
        plant.instances.push_back(system.instances.add({name, module->second, {}}));
        plant.automata.push_back(std::move(automaton));
    }
    plant.variables.resize(network.variables.size());
    for (std::size_t process = 0; process < plant.automata.size(); ++process)
        for (const auto& [variable, symbol] : plant.automata[process].owned)
            plant.variables[variable.index] = member(plant.members, plant.instances[process], symbol);
    for (const Id<Network::Variable> id : network.variables.ids()) {
        const Network::Variable& variable = network.variables[id];
        if (plant.variables[id.index].valid() || variable.scratch) continue;
        const Id<Expr> initial = variable.type.boolean ? system.exprs.constant(variable.initial != 0)
                                                       : system.exprs.integer(variable.initial);
        plant.variables[id.index] = main_of(plant).symbols.add({plant.names.fresh(variable.name), variable.type,
                                                                System::DefineSymbol{initial}, "variables of all",
                                                                variable.origin, {}});
    }
}

void wire(PlantInstances& plant, const Signals& signals) {
    for (std::size_t process = 0; process < plant.automata.size(); ++process) {
        const AutomatonModule& automaton = plant.automata[process];
        std::vector<Id<Symbol>> arguments;
        if (automaton.turn.valid()) arguments.push_back(signals.turns[process]);
        if (automaton.first.valid()) arguments.push_back(signals.first);
        if (automaton.round.valid()) arguments.push_back(signals.round);
        if (automaton.tick.valid()) arguments.push_back(signals.tick);
        for (const Id<Network::Variable> variable : automaton.reads)
            arguments.push_back(plant.variables[variable.index]);
        plant.system().instances[plant.instances[process]].arguments = std::move(arguments);
    }
}

void add_effects(PlantInstances& plant) {
    System& system = plant.system();
    std::map<Id<Network::Variable>, std::vector<std::pair<Id<Expr>, Id<Expr>>>> writers;
    for (std::size_t process = 0; process < plant.automata.size(); ++process)
        for (const AutomatonModule::Effect& effect : plant.automata[process].effects)
            writers[effect.variable].emplace_back(plant.inner(process, effect.writes),
                                                  plant.inner(process, effect.value));
    for (const auto& [variable, effects] : writers) {
        const Id<Symbol> symbol = plant.variables[variable.index];
        const Id<Expr> initial = std::get<System::DefineSymbol>(main_of(plant).symbols[symbol].kind).value;
        Id<Expr> next = plant.leaf(symbol);
        for (auto effect = effects.rbegin(); effect != effects.rend(); ++effect)
            next = system.exprs.conditional(effect->first, effect->second, next);
        main_of(plant).symbols[symbol].kind = System::StateSymbol{initial, next};
    }
}

void add_fairness(PlantInstances& plant) {
    Exprs& exprs = plant.system().exprs;
    for (std::size_t process = 0; process < plant.automata.size(); ++process) {
        const Network::ProcessKind kind =
            plant.context.network.processes[{static_cast<std::uint32_t>(process)}].kind;
        if (kind != Network::ProcessKind::Plant && kind != Network::ProcessKind::Timer) continue;
        for (const Movement& movement : plant.automata[process].movements) {
            const Id<Expr> rests = exprs.negation(plant.inner(process, movement.moving));
            const Id<Expr> ended =
                movement.ended.valid() ? plant.inner(process, movement.ended) : exprs.constant(false);
            main_of(plant).justice.push_back(exprs.disjunction(rests, ended));
        }
    }
}

void add_range_property(PlantInstances& plant) {
    std::string names;
    for (std::size_t process = 0; process < plant.automata.size(); ++process)
        if (plant.automata[process].out_of_range.valid())
            names += (names.empty() ? "" : ", ") + plant.system().instances[plant.instances[process]].name;
    add_never(plant.system(), "no_out_of_range", "no assignment leaves the range of its variable: " + names,
              plant.each(&AutomatonModule::out_of_range));
}

void check_widths(const Network& network, Diagnostics& diagnostics) {
    for (const Network::Variable& variable : network.variables) {
        const std::int64_t values = variable.type.high - variable.type.low + 1;
        if (values > most_values)
            diagnostics.add(messages::too_wide(variable.origin, variable.name, values, most_values));
    }
}

}  // namespace grafverif::schedule
