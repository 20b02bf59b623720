// SPDX-License-Identifier: MIT
#include "schedule/sequencer.hpp"

namespace grafverif::schedule {

namespace {

constexpr const char* of_sequencers = "the sequencers";

std::vector<std::string> movers_or_none(const Network& plant) {
    std::vector<std::string> names = movers(plant);
    names.emplace_back("none");
    return names;
}

}  // namespace

Sequencer::Sequencer(Main& main, const Network& plant)
    : main_(main),
      move_(main.draft.add("move", movers_or_none(plant), TransitionSystem::ChoiceSymbol{},
                           "process that moves next in a round")),
      state_(main.draft.add("sequencer", {"controllers", "controlled", "PIR", "PTR", "POU", "PTE"},
                            TransitionSystem::StateSymbol{}, of_sequencers)),
      first_(main.draft.add("first_round", Type{}, TransitionSystem::StateSymbol{}, of_sequencers)),
      changed_(main.draft.add("changed", Type{}, TransitionSystem::StateSymbol{}, of_sequencers)) {}

Id<Expr> Sequencer::considered() const { return main_.system.exprs.disjunction(is(Controlled), is(Test)); }

Signals Sequencer::signals(const PlantInstances& plant) {
    Exprs& exprs = main_.system.exprs;
    Signals found{.first = first_};
    for (const Id<Network::Process> process : plant.context.network.processes.ids())
        found.turns.push_back(main_.draft.define(plant.context.network.processes[process].name + "_moves",
                                                 moves(process.index), "turns"));
    found.over = main_.draft.define("round_over", exprs.conjunction(plant.each(&AutomatonModule::done)), "turns");
    const Id<Expr> continues = exprs.negation(main_.draft.leaf(found.over));
    found.round = main_.draft.define("in_round", exprs.conjunction(is(Treatment), continues), "turns");
    return found;
}

void Sequencer::run(const PlantInstances& plant, const Signals& signals, Id<Expr> controllers_settled) {
    Draft& main = main_.draft;
    Exprs& exprs = main.exprs;
    const Id<Expr> over = main.leaf(signals.over), in_round = main.leaf(signals.round), changed = main.leaf(changed_);
    const auto state = [&](State value) { return exprs.integer(value); };
    const auto when = [&](Id<Expr> condition, State then, State otherwise) {
        return exprs.conditional(condition, state(then), state(otherwise));
    };
    Id<Expr> next = state(Controllers);  // sequencer state that follows PTE
    next = exprs.conditional(is(OutputsWritten), state(Test), next);
    next = exprs.conditional(is(Treatment),
                             when(exprs.conjunction(over, exprs.negation(changed)), OutputsWritten, Treatment), next);
    next = exprs.conditional(is(InputsRead), state(Treatment), next);
    next = exprs.conditional(is(Controlled), state(InputsRead), next);
    next = exprs.conditional(is(Controllers), when(controllers_settled, Controlled, Controllers), next);
    main.set(state_, TransitionSystem::StateSymbol{state(Controllers), next});

    const Id<Expr> still_first = exprs.conjunction(main.leaf(first_), exprs.negation(over));
    main.set(first_, TransitionSystem::StateSymbol{exprs.constant(true), implies(exprs, is(Treatment), still_first)});
    std::vector<Id<Expr>> acts{changed};
    for (std::size_t process = 0; process < plant.automata.size(); ++process) {
        const Id<Expr> stays = plant.inner(process, plant.automata[process].stays);
        acts.push_back(exprs.conjunction(moves(process), exprs.negation(stays)));
    }
    main.set(changed_, TransitionSystem::StateSymbol{exprs.constant(false),
                                                     exprs.conjunction(in_round, exprs.disjunction(acts))});
    main.module.transitions.push_back(exprs.apply(Op::Equal, moves(plant.automata.size()), exprs.negation(in_round)));
}

void Sequencer::add_properties() const {
    const auto settles = [&](const char* name, const char* text, State from, State to) {
        main_.system.properties.add(
            {.name = name, .text = text, .pattern = Pattern::LeadsTo, .operands = {is(from), is(to)}});
    };
    settles("plant_settles", "every evolution of the plant terminates", Treatment, Test);
    settles("controllers_settle", "every evolution of the controllers terminates", Controllers, Controlled);
}

}  // namespace grafverif::schedule
