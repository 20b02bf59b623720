// SPDX-License-Identifier: MIT
#include "schedule/plant_instances.hpp"

#include <map>

#include "ir/literal.hpp"
#include "schedule/properties.hpp"
#include "support/messages.hpp"

namespace grafverif::schedule {

namespace {

using System = TransitionSystem;

// Maximum number of values of an integer variable; with more values, NuSMV becomes noticeably slow.
constexpr std::int64_t most_values = 4096;

}  // namespace

PlantInstances::PlantInstances(Main& in, AutomatonContext laid_out, std::vector<Id<Symbol>> known)
    : main(in), context(std::move(laid_out)), variables(std::move(known)) {
    const Network& network = context.network;
    std::map<std::vector<std::int64_t>, Id<System::Module>> modules;
    for (const Id<Network::Process> id : network.processes.ids()) {
        AutomatonModule automaton = automaton_module(context, id, main.system.exprs);
        const auto [module, fresh] = modules.try_emplace(module_key(context, id));
        if (fresh) module->second = main.add_module(std::move(automaton.module));
        instances.push_back(main.add_instance(network.processes[id].name, module->second));
        automata.push_back(std::move(automaton));
    }
    variables.resize(network.variables.size());
    for (std::size_t process = 0; process < automata.size(); ++process)
        for (const auto& [variable, symbol] : automata[process].owned)
            variables[variable.index] = main.member(instances[process], symbol);
    for (const Id<Network::Variable> id : network.variables.ids()) {
        const Network::Variable& variable = network.variables[id];
        if (variables[id.index].valid() || variable.scratch) continue;
        const Id<Expr> initial = literal(main.system.exprs, variable.type, variable.initial);
        variables[id.index] = main.draft.add(variable.name, variable.type, System::DefineSymbol{initial},
                                             "shared variables", variable.origin);
    }
}

std::vector<Id<Expr>> PlantInstances::each(Id<Symbol> AutomatonModule::*symbol) const {
    std::vector<Id<Expr>> found;
    for (std::size_t process = 0; process < automata.size(); ++process)
        if ((automata[process].*symbol).valid()) found.push_back(inner(process, automata[process].*symbol));
    return found;
}

Id<Expr> PlantInstances::none_urgent() const {
    Exprs& exprs = main.system.exprs;
    return exprs.negation(exprs.disjunction(each(&AutomatonModule::must_move)));
}

TransitionSystem::Component PlantInstances::component(std::size_t process) const {
    const Network::Process& of = context.network.processes[{static_cast<std::uint32_t>(process)}];
    System::Component made{.name = of.name};
    made.kind = of.kind == Network::ProcessKind::Timer         ? System::Component::Kind::Timer
                : of.kind == Network::ProcessKind::Environment ? System::Component::Kind::Environment
                                                               : System::Component::Kind::Plant;
    const AutomatonModule& automaton = automata[process];
    if (automaton.location.valid()) made.location = main.member(instances[process], automaton.location);
    for (const auto& [variable, symbol] : automaton.owned) {
        const Network::Variable& owned = context.network.variables[variable];
        const TransitionSystem::Named named{owned.display_name(), main.member(instances[process], symbol)};
        if (owned.role == Network::Role::Plant) made.variables.push_back(named);
        if (owned.role == Network::Role::Input) made.inputs.push_back(named);
    }
    return made;
}

void PlantInstances::wire(const Signals& signals) const {
    for (std::size_t process = 0; process < automata.size(); ++process) {
        const AutomatonModule& automaton = automata[process];
        std::vector<Id<Symbol>> arguments;
        if (automaton.turn.valid()) arguments.push_back(signals.turns[process]);
        if (automaton.first.valid()) arguments.push_back(signals.first);
        if (automaton.round.valid()) arguments.push_back(signals.round);
        if (automaton.tick.valid()) arguments.push_back(signals.tick);
        for (const Id<Network::Variable> variable : automaton.reads) arguments.push_back(variables[variable.index]);
        main.system.instances[instances[process]].arguments = std::move(arguments);
    }
}

void PlantInstances::set_effects() const {
    std::map<Id<Network::Variable>, std::vector<std::pair<Id<Expr>, Id<Expr>>>> writers;
    for (std::size_t process = 0; process < automata.size(); ++process)
        for (const Effect& effect : automata[process].effects)
            writers[effect.variable].emplace_back(inner(process, effect.writes), inner(process, effect.value));
    for (const auto& [variable, effects] : writers) {
        const Id<Symbol> symbol = variables[variable.index];
        const Id<Expr> initial = std::get<System::DefineSymbol>(main.draft.module.symbols[symbol].kind).value;
        Id<Expr> next = main.draft.leaf(symbol);
        for (auto effect = effects.rbegin(); effect != effects.rend(); ++effect)
            next = main.system.exprs.conditional(effect->first, effect->second, next);
        main.draft.set(symbol, System::StateSymbol{initial, next});
    }
}

void PlantInstances::add_fairness() const {
    Exprs& exprs = main.system.exprs;
    for (std::size_t process = 0; process < automata.size(); ++process) {
        const Network::ProcessKind kind = context.network.processes[{static_cast<std::uint32_t>(process)}].kind;
        // The time between two scans of the task cycle is the only movement of a PLC.
        if (kind == Network::ProcessKind::Environment || kind == Network::ProcessKind::Observer) continue;
        for (const Movement& movement : automata[process].movements) {
            const Id<Expr> ended = movement.ended.valid() ? inner(process, movement.ended) : exprs.constant(false);
            main.draft.module.justice.push_back(implies(exprs, inner(process, movement.moving), ended));
        }
    }
}

void PlantInstances::add_range_property() const {
    std::string names;
    for (std::size_t process = 0; process < automata.size(); ++process)
        if (automata[process].out_of_range.valid())
            names += (names.empty() ? "" : ", ") + main.system.instances[instances[process]].name;
    add_never(main.system, "no_out_of_range", "no assignment leaves the range of its variable: " + names,
              each(&AutomatonModule::out_of_range));
}

std::vector<std::string> movers(const Network& network) {
    std::vector<std::string> names;
    for (const Network::Process& process : network.processes) names.push_back("of_" + process.name);
    return names;
}

void check_widths(const Network& network, Diagnostics& diagnostics) {
    for (const Network::Variable& variable : network.variables) {
        const std::int64_t values = variable.type.high - variable.type.low + 1;
        if (values > most_values)
            diagnostics.add(messages::too_wide(variable.origin, variable.name, values, most_values));
    }
}

}  // namespace grafverif::schedule
