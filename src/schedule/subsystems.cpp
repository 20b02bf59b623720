// SPDX-License-Identifier: MIT
#include "schedule/subsystems.hpp"

#include "ir/literal.hpp"
#include "ir/network_subsystems.hpp"

namespace grafverif::schedule {

namespace {

using Subsystem = TransitionSystem::Subsystem;

/// Sets the values that replace the members of omitted instances in main: omitted instances cannot move, have no urgent
/// edges and do not prevent time from passing.
void omit_members(const PlantInstances& plant, const NetworkSubsystems& parts, std::vector<Subsystem>& made) {
    Main& main = plant.main;
    Exprs& exprs = main.system.exprs;
    std::vector<std::uint32_t> process(main.system.instances.size());
    for (std::uint32_t index = 0; index < plant.instances.size(); ++index)
        process[plant.instances[index].index] = index;
    for (const auto& [inner, symbol] : main.members) {
        const auto& [instance, of] = inner;
        const std::uint32_t whose = process[instance.index];
        const Type type = main.draft.module.symbols[symbol].type;
        const bool lets_pass = of == plant.automata[whose].may_wait;
        made[parts.of_process[whose]].without.emplace_back(
            symbol, lets_pass ? exprs.constant(true) : literal(exprs, type, type.low));
    }
}

}  // namespace

Id<Expr> over_main(const PlantInstances& plant, Id<Expr> term) {
    return translate(plant.context.network.exprs, term, plant.main.system.exprs, [&](const Expr& leaf) {
        if (leaf.op == Op::At) return plant.at(at_process(leaf), at_location(leaf));
        return plant.main.draft.leaf(plant.variables[static_cast<std::size_t>(leaf.value)]);
    });
}

std::vector<Subsystem> interleaved_subsystems(const PlantInstances& plant, const std::vector<Id<Expr>>& turns) {
    const Network& network = plant.context.network;
    const NetworkSubsystems parts = parts_of(network);
    if (parts.count < 2) return {};
    Exprs& exprs = plant.main.system.exprs;
    std::vector<Subsystem> made(parts.count);
    std::vector<std::vector<Id<Expr>>> moves(parts.count);
    for (std::uint32_t process = 0; process < turns.size(); ++process) {
        made[parts.of_process[process]].instances.push_back(plant.instances[process]);
        moves[parts.of_process[process]].push_back(turns[process]);
    }
    for (std::uint32_t part = 0; part < parts.count; ++part) {
        made[part].name = name_of_part(network, parts, part);
        made[part].moves = exprs.disjunction(moves[part]);
        if (parts.settled.empty()) continue;
        std::vector<Id<Expr>> settled;
        for (const Id<Expr> conjunct : parts.settled[part]) settled.push_back(over_main(plant, conjunct));
        made[part].settled = exprs.conjunction(settled);
    }
    omit_members(plant, parts, made);
    for (const Id<Network::Variable> id : network.variables.ids()) {
        const std::uint32_t part = parts.of_variable[id.index];
        const Id<Symbol> symbol = plant.variables[id.index];
        if (part == NetworkSubsystems::none || !symbol.valid()) continue;
        const Network::Variable& variable = network.variables[id];
        if (std::holds_alternative<TransitionSystem::StateSymbol>(plant.main.draft.module.symbols[symbol].kind))
            made[part].without.emplace_back(symbol, literal(exprs, variable.type, variable.initial));
    }
    return made;
}

}  // namespace grafverif::schedule
