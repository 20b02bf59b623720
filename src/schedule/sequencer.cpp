// SPDX-License-Identifier: MIT
#include "schedule/sequencer.hpp"

namespace grafverif::schedule {

namespace {

constexpr const char* section = "the sequencers";

}  // namespace

Sequencer::Sequencer(Assembly& assembly, PlantInstances& plant)
    : assembly_(assembly), plant_(plant), processes_(plant.context.network.processes.size()) {
    const auto add = [&](const std::string& wish, Type type, decltype(Symbol::kind) kind, const char* where,
                         std::vector<std::string> values) {
        return assembly.main().symbols.add(
            {assembly.names.fresh(wish), type, std::move(kind), where, {}, std::move(values)});
    };
    std::vector<std::string> movers;
    for (const Network::Process& process : plant.context.network.processes) movers.push_back("of_" + process.name);
    movers.emplace_back("none");
    move_ = add("move", integer_type(0, static_cast<std::int64_t>(processes_)), TransitionSystem::ChoiceSymbol{},
                "whose turn it is in a round", std::move(movers));
    state_ = add("sequencer", integer_type(Controllers, Test), TransitionSystem::StateSymbol{}, section,
                 {"controllers", "controlled", "PIR", "PTR", "POU", "PTE"});
    first_ = add("first_round", {}, TransitionSystem::StateSymbol{}, section, {});
    changed_ = add("changed", {}, TransitionSystem::StateSymbol{}, section, {});
}

Id<Expr> Sequencer::is(std::int64_t state) {
    Exprs& exprs = assembly_.system.exprs;
    return exprs.apply(Op::Equal, plant_.leaf(state_), exprs.integer(state));
}

Id<Expr> Sequencer::judged() { return assembly_.system.exprs.disjunction(is(Controlled), is(Test)); }

Id<Expr> Sequencer::moves(std::size_t process) {
    Exprs& exprs = assembly_.system.exprs;
    return exprs.apply(Op::Equal, plant_.leaf(move_), exprs.integer(static_cast<std::int64_t>(process)));
}

Signals Sequencer::signals() {
    Exprs& exprs = assembly_.system.exprs;
    Signals found;
    for (std::size_t process = 0; process < processes_; ++process)
        found.turns.push_back(define(
            plant_, plant_.context.network.processes[{static_cast<std::uint32_t>(process)}].name + "_moves",
            moves(process), "turns"));
    round_over_ = define(plant_, "round_over", exprs.conjunction(plant_.each(&AutomatonModule::done)), "turns");
    in_round_ = define(plant_, "in_round", exprs.conjunction(is(Treatment), exprs.negation(plant_.leaf(round_over_))), "turns");
    found.first = first_;
    found.round = in_round_;
    return found;
}

void Sequencer::set(Id<Symbol> symbol, Id<Expr> initial, Id<Expr> next) {
    assembly_.main().symbols[symbol].kind = TransitionSystem::StateSymbol{initial, next};
}

void Sequencer::run(Id<Expr> controllers_settled) {
    Exprs& exprs = assembly_.system.exprs;
    std::vector<Id<Expr>> acts{plant_.leaf(changed_)};
    for (std::size_t process = 0; process < processes_; ++process)
        acts.push_back(exprs.conjunction(moves(process),
                                         exprs.negation(plant_.inner(process, plant_.automata[process].stays))));
    const Id<Expr> over = plant_.leaf(round_over_), in_round = plant_.leaf(in_round_);
    const Id<Expr> off = exprs.constant(false), on = exprs.constant(true);

    const auto state = [&](State value) { return exprs.integer(value); };
    Id<Expr> next = state(Controllers);   // after PTE
    next = exprs.conditional(is(OutputsWritten), state(Test), next);
    next = exprs.conditional(is(Treatment),
                             exprs.conditional(exprs.conjunction(over, exprs.negation(plant_.leaf(changed_))),
                                               state(OutputsWritten), state(Treatment)),
                             next);
    next = exprs.conditional(is(InputsRead), state(Treatment), next);
    next = exprs.conditional(is(Controlled), state(InputsRead), next);
    next = exprs.conditional(is(Controllers),
                             exprs.conditional(controllers_settled, state(Controlled), state(Controllers)), next);
    set(state_, state(Controllers), next);

    const Id<Expr> in_treatment = is(Treatment);
    const Id<Expr> still_first = exprs.conjunction(plant_.leaf(first_), exprs.negation(over));
    set(first_, on, exprs.disjunction(exprs.negation(in_treatment), still_first));
    set(changed_, off, exprs.conjunction(in_round, exprs.disjunction(acts)));
    assembly_.main().transitions.push_back(exprs.apply(Op::Equal, moves(processes_), exprs.negation(in_round)));
}

void Sequencer::add_properties() {
    TransitionSystem& system = assembly_.system;
    const auto settles = [&](const char* name, const char* text, State from, State to) {
        system.properties.add({.name = name, .text = text, .pattern = Pattern::LeadsTo, .operands = {is(from), is(to)}});
    };
    settles("plant_settles", "every evolution of the plant comes to an end", Treatment, Test);
    settles("controllers_settle", "every evolution of the controllers comes to an end", Controllers, Controlled);
}

}  // namespace grafverif::schedule
