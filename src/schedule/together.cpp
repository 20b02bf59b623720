// SPDX-License-Identifier: MIT
// Controllers and automata read variables of each other. Therefore all instances and their symbols are added first. The
// outputs of the controllers are added before the automata, because the automata read these outputs as variables of the
// network with the same index. The variables of the automata are the inputs of the controllers. Then the arguments of
// the instances are set. Elements of the complete system (fairness, `settled`, properties) are added last.
#include "schedule/together.hpp"

#include <algorithm>
#include <cassert>
#include <optional>

#include "schedule/controller_instances.hpp"
#include "schedule/observers.hpp"
#include "schedule/scope.hpp"
#include "schedule/sequencer.hpp"
#include "syntax/print/sentence.hpp"

namespace grafverif {

namespace {

using namespace schedule;

/// Returns the symbols of the shared variables of the loop that are outputs of controllers; the other entries are
/// invalid.
std::vector<Id<Symbol>> outputs(const ControllerInstances& controllers, const ClosedLoop& loop) {
    std::vector<Id<Symbol>> shared(loop.shared.size());
    controllers.share_outputs(loop, shared);
    return shared;
}

/// Sets the arguments `turn` and `elapse` of the controllers. Returns the conditions under which controllers run. The
/// result is empty if the controllers run in every step.
std::vector<Id<Expr>> wire_moves(const ControllerInstances& controllers, const std::optional<Sequencer>& sequencer) {
    Draft& main = controllers.main.draft;
    const auto timed = [](const ControllerPart& part) { return !part.equations.timers.empty(); };
    Id<Symbol> turn, elapse;
    if (sequencer) turn = main.define("controllers_run", sequencer->is(Sequencer::Controllers), "turns");
    if (std::ranges::any_of(controllers.parts, timed))
        elapse = main.define("time_passes",
                             sequencer ? sequencer->is(Sequencer::InputsRead) : main.exprs.constant(true), "turns");
    for (std::size_t index = 0; index < controllers.parts.size(); ++index) {
        if (turn.valid()) controllers.arguments(index).push_back(turn);
        if (timed(controllers.parts[index])) controllers.arguments(index).push_back(elapse);
    }
    if (!turn.valid()) return {};
    return std::vector<Id<Expr>>(controllers.parts.size(), main.leaf(turn));
}

/// Returns the condition that the evolution of the controllers has ended: controllers with stability search are
/// quiescent, and all other controllers have executed one cycle. The first cycle directly follows the first evolution
/// of the controller.
Id<Expr> evolution_over(const ControllerInstances& controllers) {
    std::vector<Id<Expr>> over;
    for (std::size_t index = 0; index < controllers.parts.size(); ++index) {
        const ControllerModule& module = controllers.modules[index];
        const bool searches = controllers.parts[index].mode == ExecutionMode::StabilitySearch;
        const Id<Symbol> when = searches ? module.settled : module.started;
        if (when.valid()) over.push_back(controllers.inner(index, when));
    }
    return controllers.main.system.exprs.conjunction(over);
}

TransitionSystem together(const Model& model, const ClosedLoop& loop, std::span<const Equations> equations,
                          const Network& network, const ScheduleOptions& options, Schedule schedule) {
    const bool sequenced = schedule == Schedule::Sequenced;
    Main main(loop.name);
    const ControllerInstances controllers(main, controller_parts(loop, equations, options.mode), sequenced, true);
    controllers.name();
    std::optional<Sequencer> sequencer;
    if (sequenced) sequencer.emplace(main, network);
    const PlantInstances plant(main,
                               {network,
                                sequenced ? Discipline::Rounds : Discipline::Together,
                                std::vector<bool>(network.variables.size()),
                                options.fairness,
                                {}},
                               outputs(controllers, loop));
    const Signals signals = sequenced ? sequencer->signals(plant) : Signals{};
    plant.wire(signals);
    std::vector<Id<Symbol>> shared = plant.variables;
    shared.resize(loop.shared.size());
    controllers.wire_inputs(loop, shared);
    const std::vector<Id<Expr>> runs = wire_moves(controllers, sequencer);
    if (sequenced) sequencer->run(plant, signals, evolution_over(controllers));
    if (options.fairness) plant.add_fairness();

    TransitionSystem& system = main.system;
    system.scope = together_scope(schedule, controllers.parts, options.fairness);
    system.settled =
        sequenced ? sequencer->considered() : system.exprs.conjunction(controllers.settled(), plant.none_urgent());
    LoopMeaning meaning{.main = main,
                        .model = model,
                        .loop = loop,
                        .equations = equations,
                        .shared = std::move(shared),
                        .variable = [&](std::size_t controller,
                                        Id<Equations::Variable> id) { return controllers.variable(controller, id); },
                        .at = [&](std::size_t process, std::uint32_t location) { return plant.at(process, location); },
                        .own = [&](std::size_t process, std::size_t place) { return plant.argument(process, place); },
                        .checked_when_stable = sequenced};
    add_observers(meaning, sequenced ? system.settled : Id<Expr>{});
    for (const Property& property : loop.properties) add_property(meaning, property);
    for (const Property& constraint : constraints_to_prove(loop)) add_property(meaning, constraint);
    controllers.add_fault_properties();
    plant.add_range_property();
    if (sequenced) sequencer->add_properties();
    controllers.add_words(runs);
    for (std::size_t process = 0; process < plant.automata.size(); ++process)
        system.components.push_back(plant.component(process));
    return main.finish();
}

}  // namespace

std::optional<TransitionSystem> schedule_together(const Model& model, const ClosedLoop& loop,
                                                  std::span<const Equations> equations, const Network& plant,
                                                  const ScheduleOptions& options, Diagnostics& diagnostics) {
    const Schedule schedule = options.schedule.value_or(loop.schedule.value_or(Schedule::Interleaved));
    assert(schedule != Schedule::Interleaved);
    const std::size_t errors = diagnostics.errors();
    check_widths(plant, diagnostics);
    if (diagnostics.errors() != errors) return {};
    TransitionSystem system = together(model, loop, equations, plant, options, schedule);
    assert(verify(system).empty());
    return system;
}

}  // namespace grafverif
