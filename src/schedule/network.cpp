// SPDX-License-Identifier: MIT
// Translates a network with interleaving: one process of the network moves in each step. The choice `move` of main
// selects the process; the modules of the processes implement the moves (automaton_module.hpp). A module moves if and
// only if main selects its process. Therefore two processes never move simultaneously.
//
// Completeness: every run of the network is preserved, because in every state each process that can move may be chosen.
// Soundness: only the abstraction of time adds runs. The value `none` (and, if clocks are counted, the tick) can be
// chosen only if time can pass in the network, that is, if no urgent edge is enabled. Totality (every state has a
// successor): if an urgent edge is enabled, its process can move. If no urgent edge is enabled and time is abstract,
// `none` can be chosen. If clocks are counted, a process can move or time can pass; `none` can be chosen only in a
// state in which no process can move and no time can pass. The step with `none` leads to the same state.
//
// The properties of the loop are translated to terms over symbols of main (properties.hpp). The controllers of the
// network map the names of the loop to main.
#include "schedule/network.hpp"

#include <algorithm>
#include <cassert>

#include "ir/patterns.hpp"
#include "ir/probes.hpp"
#include "ir/slots.hpp"
#include "ir/words_of.hpp"
#include "schedule/observers.hpp"
#include "schedule/plant_instances.hpp"
#include "schedule/scope.hpp"
#include "schedule/subsystems.hpp"
#include "syntax/print/sentence.hpp"

namespace grafverif {

namespace {

using namespace schedule;
using System = TransitionSystem;

/// Marks the variables of main, which are the variables that several processes write.
std::vector<bool> shared_variables(const Network& network) {
    std::vector<std::size_t> writers(network.variables.size());
    for (const Id<Network::Process> process : network.processes.ids())
        for (const Id<Network::Variable> variable : Slots(network, process).written()) ++writers[variable.index];
    std::vector<bool> shared;
    for (const std::size_t count : writers) shared.push_back(count > 1);
    return shared;
}

// -- choice of the moving process -------------------------------------------------------------------------------------

/// The choice `move`, whose value is the process that moves. The value `none` follows the values for processes, and the
/// value for time follows `none`.
struct MoveChoice {
    Id<Symbol> symbol = {};
    std::size_t processes = 0;

    Id<Expr> of(const Main& main, std::size_t who) const {
        return main.draft.is(symbol, static_cast<std::int64_t>(who));
    }
    Id<Expr> of_none(const Main& main) const { return of(main, processes); }
    Id<Expr> of_time(const Main& main) const { return of(main, processes + 1); }
};

MoveChoice add_move(Main& main, const Network& network, bool discrete) {
    std::vector<std::string> values = movers(network);
    values.emplace_back("none");
    if (discrete) values.emplace_back("of_time");
    return {main.draft.add("move", std::move(values), System::ChoiceSymbol{}, "process that moves in a step"),
            network.processes.size()};
}

/// Passes to each process the condition that it moves, and to the clocks the condition that time passes.
void wire_moves(const PlantInstances& plant, const MoveChoice& move, bool discrete) {
    Main& main = plant.main;
    const Network& network = plant.context.network;
    Signals signals;
    constexpr const char* turns = "turns, the parameter `turn` of the modules: true if the process moves in this step";
    for (const Id<Network::Process> process : network.processes.ids())
        signals.turns.push_back(
            main.draft.define(network.processes[process].name + "_moves", move.of(main, process.index), turns));
    if (discrete) {
        signals.tick = main.draft.define("tick", move.of_time(main), "true if a unit of time passes in this step");
        main.system.ticks = main.draft.leaf(signals.tick);
        main.system.tick_ms = network.time_unit_ms;
    }
    plant.wire(signals);
}

/// Conditions under which a process can move (`can_move`) or time can pass (`can_wait`). `can_move` and `can_wait` are
/// invalid unless clocks are counted.
struct Offers {
    Id<Expr> can_move = {}, can_wait = {};
};

/// Constrains the choice. With abstract time, `none` can be chosen if no urgent edge is enabled. With discrete time, a
/// process moves or time passes whenever possible.
Offers add_offers(const PlantInstances& plant, const MoveChoice& move, bool discrete) {
    Main& main = plant.main;
    Exprs& exprs = main.system.exprs;
    std::vector<Id<Expr>>& transitions = main.draft.module.transitions;
    const Id<Expr> nobody = move.of_none(main);
    if (!discrete) {
        transitions.push_back(implies(exprs, nobody, plant.none_urgent()));
        return {};
    }
    std::vector<Id<Expr>> waits = plant.each(&AutomatonModule::may_wait);
    waits.push_back(plant.none_urgent());
    const Offers offers{exprs.disjunction(plant.each(&AutomatonModule::can_move)), exprs.conjunction(waits)};
    transitions.push_back(implies(exprs, main.system.ticks, offers.can_wait));
    const Id<Expr> stuck = exprs.negation(exprs.disjunction(offers.can_move, offers.can_wait));
    transitions.push_back(implies(exprs, nobody, stuck));
    return offers;
}

// -- properties -------------------------------------------------------------------------------------------------------

/// Adds a property of the network.
void add_translated(const PlantInstances& plant, Property property) {
    for (Id<Expr>& operand : property.operands) operand = over_main(plant, operand);
    plant.main.system.properties.add(std::move(property));
}

/// Adds the property that excludes races, if races are possible.
void add_race_property(const PlantInstances& plant) {
    const Id<Network::Variable> race = plant.context.network.race;
    if (!race.valid()) return;
    add_never(plant.main.system, "no_race", "no two stored actions assign different values to one variable",
              {plant.main.draft.leaf(plant.variables[race.index])});
}

/// Adds the property of the network that has the name of `property` and reads its observer (compose/observe.hpp),
/// followed by its vacuity probes (ir/probes.hpp). If the network has no such property, adds `property` itself.
void add_watched(const LoopMeaning& meaning, const PlantInstances& plant, const Property& property) {
    const Network& network = plant.context.network;
    const auto known = std::ranges::find(network.properties, property.name, &Property::name);
    if (known == network.properties.end()) return add_property(meaning, property);
    add_translated(plant, *known);
    for (const Property& probe : network.properties)
        if (probed_by(probe) == property.name) add_translated(plant, probe);
}

/// Adds the observers, the properties of the loop, and the properties that exclude races and values outside their
/// ranges. Properties that read an observer are added after all other properties of the loop.
void add_queries(LoopMeaning& meaning, const PlantInstances& plant) {
    const ClosedLoop& loop = meaning.loop;
    add_observers(meaning);
    for (const Property& property : loop.properties)
        if (property.pattern == Pattern::Watched) add_watched(meaning, plant, property);
        else if (!reads_observer(loop, property)) add_property(meaning, property);
    for (const Property& constraint : constraints_to_prove(loop)) add_property(meaning, constraint);
    add_race_property(plant);
    for (const Property& property : loop.properties)
        if (property.pattern != Pattern::Watched && reads_observer(loop, property)) add_property(meaning, property);
    plant.add_range_property();
}

/// Adds the properties of the network about all states, and the properties that exclude races and values outside their
/// ranges.
void add_network_queries(const PlantInstances& plant) {
    const Network& network = plant.context.network;
    for (const Property& property : network.properties) {
        const bool about_race = network.race.valid() && !property.origin.source.valid() && property.name == "no_race";
        if (is_about_all_states(property.pattern) && !about_race) add_translated(plant, property);
    }
    add_race_property(plant);
    plant.add_range_property();
}

/// Returns the subsystems of the network. The result is empty if there are observers, because each observer reads the
/// complete network.
System::Subsystems parts(const PlantInstances& plant, const MoveChoice& move, const Offers& offers) {
    Main& main = plant.main;
    const bool watched = std::ranges::find(plant.context.network.processes, Network::ProcessKind::Observer,
                                           &Network::Process::kind) != plant.context.network.processes.end();
    if (!main.system.observers.empty() || watched) return {};
    std::vector<Id<Expr>> turns;
    for (std::size_t process = 0; process < move.processes; ++process) turns.push_back(move.of(main, process));
    System::Subsystems made{.each = interleaved_subsystems(plant, turns)};
    made.waits = main.system.ticks.valid() ? main.system.ticks : move.of_none(main);
    made.can_move = offers.can_move;
    made.can_wait = offers.can_wait;
    return made;
}

// -- names for traces -------------------------------------------------------------------------------------------------

/// Returns a condition that is true in steps in which the PLC takes an edge for which `is_chosen` returns true.
template <class Choice>
Id<Expr> takes(const PlantInstances& plant, Id<Network::Process> plc, const Choice& is_chosen) {
    const Network& network = plant.context.network;
    const Network::Template& cycle = network.templates[network.processes[plc].automaton];
    const Id<Symbol> edge = plant.main.member(plant.instances[plc.index], plant.automata[plc.index].edge);
    std::vector<Id<Expr>> found;
    for (const Id<Network::Edge> id : cycle.edges.ids())
        if (is_chosen(cycle.edges[id])) found.push_back(plant.main.draft.is(edge, id.index + 1));
    return plant.main.system.exprs.disjunction(found);
}

/// Returns a condition that is true in steps in which the PLC takes an edge that calls the procedure, or an invalid id
/// if there is no such procedure.
Id<Expr> calls(const PlantInstances& plant, Id<Network::Process> plc, Id<Network::Procedure> procedure) {
    if (!procedure.valid()) return {};
    return takes(plant, plc, [&](const Network::Edge& edge) { return has_call(edge, procedure); });
}

System::Controller words(const PlantInstances& plant, const Network::Controller& controller,
                         const Equations& equations) {
    const std::size_t plc = controller.process.index;
    const auto place = [&](Id<Equations::Variable> id) {
        const Id<Network::Variable> variable = controller.variables[id.index];
        for (const auto& [known, symbol] : plant.automata[plc].within)  // scratch variables do not belong to the state
            if (known == variable) return plant.main.member(plant.instances[plc], symbol);
        return plant.variables[variable.index];
    };
    const auto when = [&](Id<Network::Procedure> procedure) { return calls(plant, controller.process, procedure); };
    System::Controller made{.words = words_of<Symbol>(equations, controller.words.mode, place),
                            .starts = when(controller.start),
                            .samples = when(controller.fire),
                            .evolves = when(controller.evolve),
                            .writes = when(controller.write)};
    made.words.cycle = controller.words.cycle;
    for (const Id<Network::Variable> held : controller.words.held)
        made.words.held.push_back(plant.variables[held.index]);
    if (made.words.cycle)
        made.scans = takes(plant, controller.process, [](const Network::Edge& edge) { return !edge.urgent; });
    return made;
}

enum class PropertiesOf { Loop, Network };

TransitionSystem interleaved(const Model& model, const ClosedLoop& loop, std::span<const Equations> equations,
                             const Network& network, const ScheduleOptions& options, PropertiesOf properties) {
    const bool discrete = options.time == TimeModel::Discrete;
    Main main(network.name);
    const MoveChoice move = add_move(main, network, discrete);
    const PlantInstances plant(main,
                               {network, Discipline::Turns, shared_variables(network), options.fairness,
                                discrete ? analyse_clocks(expand(network)) : std::vector<ProcessClocks>{}},
                               {});
    wire_moves(plant, move, discrete);
    plant.set_effects();
    const Offers offers = add_offers(plant, move, discrete);
    // Fairness: movements terminate and time diverges; therefore no urgent edge is postponed forever.
    if (options.fairness) {
        plant.add_fairness();
        main.draft.module.justice.push_back(plant.none_urgent());
    }
    std::vector<Id<Symbol>> shared = plant.variables;
    shared.resize(loop.shared.size());
    const auto variable = [&](std::size_t controller, Id<Equations::Variable> id) {
        const Id<Network::Controller> of{static_cast<std::uint32_t>(controller)};
        return plant.variables[network.controllers[of].variables[id.index].index];
    };
    const auto at = [&](std::size_t process, std::uint32_t location) { return plant.at(process, location); };
    LoopMeaning meaning{.main = main,
                        .model = model,
                        .loop = loop,
                        .equations = equations,
                        .shared = std::move(shared),
                        .variable = variable,
                        .at = at,
                        .own = [&](std::size_t process, std::size_t place) { return plant.argument(process, place); },
                        .can_move = offers.can_move,
                        .can_wait = offers.can_wait};
    if (properties == PropertiesOf::Loop) add_queries(meaning, plant);
    else add_network_queries(plant);
    main.system.settled = over_main(plant, network.settled);
    main.system.scope = network_scope(network, options);
    for (const Id<Network::Controller> id : network.controllers.ids())
        main.system.controllers.push_back(words(plant, network.controllers[id], equations[id.index]));
    for (const Id<Network::Process> process : network.processes.ids())
        if (const auto kind = network.processes[process].kind;
            kind != Network::ProcessKind::Controller && kind != Network::ProcessKind::Observer)
            main.system.components.push_back(plant.component(process.index));
    main.system.parts = parts(plant, move, offers);
    return main.finish();
}

}  // namespace

std::optional<TransitionSystem> schedule_network(const Model& model, const ClosedLoop& loop,
                                                 std::span<const Equations> equations, const Network& network,
                                                 const ScheduleOptions& options, Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    check_widths(network, diagnostics);
    if (diagnostics.errors() != errors) return {};
    TransitionSystem system = interleaved(model, loop, equations, network, options, PropertiesOf::Loop);
    assert(verify(system).empty());
    return system;
}

std::optional<TransitionSystem> schedule_abstraction(const Model& model, const ClosedLoop& loop,
                                                     std::span<const Equations> equations, const Network& abstraction) {
    Diagnostics found;
    check_widths(abstraction, found);
    if (found.errors() != 0) return {};
    const bool timed = std::ranges::any_of(abstraction.processes, [&](const Network::Process& process) {
        const Network::Template& automaton = abstraction.templates[process.automaton];
        return std::ranges::any_of(automaton.edges, [](const auto& edge) { return !edge.constraint.empty(); }) ||
               std::ranges::any_of(automaton.locations, [](const auto& place) { return !place.invariant.empty(); });
    });
    ScheduleOptions options;
    options.time = timed ? TimeModel::Discrete : TimeModel::Abstract;
    TransitionSystem system = interleaved(model, loop, equations, abstraction, options, PropertiesOf::Network);
    assert(verify(system).empty());
    return system;
}

}  // namespace grafverif
