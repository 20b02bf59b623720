// SPDX-License-Identifier: MIT
// Derives Equations, Network and TransitionSystem from a Model. Only this file combines the passes of these
// derivations.
#include "pipeline/models.hpp"

#include <algorithm>

#include "check/vacuity.hpp"
#include "compose/observe.hpp"
#include "derive/derive.hpp"
#include "derive/program/controller.hpp"
#include "emit/nusmv/nusmv.hpp"
#include "plant/plant.hpp"
#include "schedule/controller.hpp"
#include "schedule/network.hpp"
#include "schedule/together.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"

namespace grafverif {

namespace {

std::optional<Equations> equations_of(const Model& model, const ClosedLoop& loop, Id<ClosedLoop::Controller> id,
                                      Diagnostics& diagnostics) {
    const ClosedLoop::Controller& controller = loop.controllers[id];
    const Chart& chart = model.charts[controller.chart];
    if (!chart.program) return derive(chart, diagnostics);
    ProgramController program{.name = chart.name, .cycle = controller.cycle, .origin = controller.origin};
    program.reads_stable = std::ranges::any_of(loop.properties, &Property::at_stable);
    for (const ClosedLoop::Symbol& symbol : loop.symbols)
        if (const auto* internal = std::get_if<ClosedLoop::InternalSymbol>(&symbol))
            if (internal->controller == id) program.observed.push_back({internal->variable.index});
    return controller_equations(*chart.program, program, diagnostics);
}

/// Returns the equations of each controller, in the order of the controllers of the loop.
std::optional<std::vector<Equations>> equations_of_controllers(const Model& model, const ClosedLoop& loop,
                                                               Diagnostics& diagnostics) {
    std::vector<Equations> all;
    for (const Id<ClosedLoop::Controller> id : loop.controllers.ids())
        if (auto equations = equations_of(model, loop, id, diagnostics)) all.push_back(std::move(*equations));
    if (all.size() != loop.controllers.size()) return {};
    return all;
}

bool interleave(const ClosedLoop& loop, const ModelOptions& how) {
    return how.untimed.plant == PlantApproach::Automata &&
           how.untimed.schedule.value_or(loop.schedule.value_or(Schedule::Interleaved)) == Schedule::Interleaved;
}

/// Returns the network from which the untimed model with interleaved processes is derived. The network contains the
/// loop and the observers of its properties.
std::optional<Network> with_observers(const Network& plant_network, const ClosedLoop& loop,
                                      std::span<const Equations> equations, const ModelOptions& how, Vacuity vacuity,
                                      Diagnostics& diagnostics) {
    const auto network = compose(plant_network, loop, equations, {how.grain, how.mode, {}}, diagnostics);
    if (!network) return {};
    std::vector<Id<Property>> requested = watched(*network);
    if (how.untimed.time == TimeModel::Abstract)  // clocks do not advance, so observers with a duration are omitted
        std::erase_if(requested, [&](Id<Property> id) { return network->properties[id].watch.duration_ms > 0; });
    return observed(*network, requested, vacuity);
}

/// Reports an error for each controller with a task cycle (a declared time between scans), because each step of the
/// untimed model is a PLC cycle. Returns true if no controller has a task cycle.
bool cycles_are_zero(const ClosedLoop& loop, Diagnostics& diagnostics) {
    bool zero = true;
    for (const ClosedLoop::Controller& controller : loop.controllers) {
        if (!controller.cycle) continue;
        diagnostics.add(messages::cycle_without_time(controller.cycle->origin, controller.name));
        zero = false;
    }
    return zero;
}

/// Reports an error for each controller that is a program, because the untimed model is built from the steps and
/// transitions of charts. Returns true if all controllers are charts.
bool are_charts(const Model& model, const ClosedLoop& loop, Diagnostics& diagnostics) {
    bool all = true;
    for (const ClosedLoop::Controller& controller : loop.controllers) {
        if (!model.charts[controller.chart].program) continue;
        diagnostics.add(messages::only_for_charts(controller.origin, controller.name,
                                                  "this untimed model supports only charts",
                                                  "use `--plant automata` with the schedule `interleaved`, or the "
                                                  "timed engine"));
        all = false;
    }
    return all;
}

std::optional<TransitionSystem> scheduled(const Model& model, const ClosedLoop& loop, const ModelOptions& how,
                                          Vacuity vacuity, Diagnostics& diagnostics) {
    ScheduleOptions options = how.untimed;
    options.mode = how.mode;
    if (!interleave(loop, how) && (!are_charts(model, loop, diagnostics) || !cycles_are_zero(loop, diagnostics)))
        return {};
    const auto equations = equations_of_controllers(model, loop, diagnostics);
    if (!equations) return {};
    if (options.plant != PlantApproach::Automata) {
        if (options.plant == PlantApproach::Constraints && !constraints_agree(loop, diagnostics)) return {};
        return schedule_controllers(model, loop, *equations, options);
    }
    const auto plant_network = plant(model, loop, diagnostics);
    if (!plant_network) return {};
    if (!interleave(loop, how)) return schedule_together(model, loop, *equations, *plant_network, options, diagnostics);
    const auto network = with_observers(*plant_network, loop, *equations, how, vacuity, diagnostics);
    return network ? schedule_network(model, loop, *equations, *network, options, diagnostics) : std::nullopt;
}

}  // namespace

ExecutionMode execution_mode(const Model& model, Id<Chart> chart, std::optional<ExecutionMode> requested) {
    std::optional<ExecutionMode> agreed;
    for (const ClosedLoop& loop : model.loops)
        for (const ClosedLoop::Controller& controller : loop.controllers) {
            if (controller.chart != chart) continue;
            if (agreed && *agreed != controller.mode) return requested.value_or(ExecutionMode::StabilitySearch);
            agreed = controller.mode;
        }
    return requested.value_or(agreed.value_or(ExecutionMode::StabilitySearch));
}

std::optional<Equations> equations_of(const Model& model, Id<Chart> chart, Diagnostics& diagnostics) {
    return derive(model.charts[chart], diagnostics);
}

std::optional<Network> network_of(const Model& model, Id<ClosedLoop> id, const ComposeOptions& options,
                                  Diagnostics& diagnostics) {
    const ClosedLoop& loop = model.loops[id];
    const auto equations = equations_of_controllers(model, loop, diagnostics);
    const auto plant_network = plant(model, loop, diagnostics);
    if (!equations || !plant_network) return {};
    auto network = compose(*plant_network, loop, *equations, options, diagnostics);
    if (network)
        for (const Property& property : loop.properties)
            if (reads_observer(loop, property))
                diagnostics.add(messages::not_expressible(
                    property.origin, property.name, "timed",
                    "the property reads a declared observer, and only untimed models support declared observers"));
    return network;
}

std::optional<Network> network_of(const Model& model, Id<ClosedLoop> loop, const ModelOptions& options,
                                  Diagnostics& diagnostics) {
    return network_of(model, loop, ComposeOptions{options.grain, options.mode, {}}, diagnostics);
}

namespace {

std::optional<TransitionSystem> system_of(const Model& model, Id<ClosedLoop> loop, const ModelOptions& options,
                                          Vacuity vacuity, Diagnostics& diagnostics) {
    auto system = scheduled(model, model.loops[loop], options, vacuity, diagnostics);
    if (system) *system = nusmv::sayable(std::move(*system));
    if (system) system->constants = model.loops[loop].constants;
    return system;
}

}  // namespace

std::optional<TransitionSystem> transition_system_of(const Model& model, Id<ClosedLoop> loop,
                                                     const ModelOptions& options, Diagnostics& diagnostics) {
    return system_of(model, loop, options, Vacuity::Ignored, diagnostics);
}

std::optional<TransitionSystem> system_with_probes(const Model& model, Id<ClosedLoop> loop, const ModelOptions& options,
                                                   Diagnostics& diagnostics) {
    return system_of(model, loop, options, Vacuity::Probed, diagnostics);
}

AbstractionTranslator translator_of_abstractions(const Model& model, Id<ClosedLoop> id) {
    return [&model, id, equations = std::optional<std::vector<Equations>>{}](
               const Network& abstraction) mutable -> std::optional<TransitionSystem> {
        Diagnostics known;  // no errors can occur, because the network exists
        if (!equations) equations = equations_of_controllers(model, model.loops[id], known);
        if (!equations) return {};
        return schedule_abstraction(model, model.loops[id], *equations, abstraction);
    };
}

Network network_with_probes(const Network& network) {
    Network made = observed(network, watched(network), Vacuity::Probed);
    add_external_probes(made.exprs, made.properties, made.settled.valid());
    return made;
}

std::optional<TransitionSystem> transition_system_of(const Model& model, Id<Chart> chart, const ModelOptions& options,
                                                     Diagnostics& diagnostics) {
    const auto equations = equations_of(model, chart, diagnostics);
    if (!equations) return {};
    return transition_system_of(model, chart, *equations, options.mode);
}

TransitionSystem transition_system_of(const Model& model, Id<Chart> chart, const Equations& equations,
                                      std::optional<ExecutionMode> mode) {
    return schedule_controller(equations, execution_mode(model, chart, mode));
}

SystemToCheck system_to_check(const TransitionSystem& system, const Model& model, Id<ClosedLoop> id,
                              const ModelOptions& how) {
    const ClosedLoop& loop = model.loops[id];
    SystemToCheck check{system, charts_of(model, loop), abstraction_of(how, &loop)};
    if (interleave(loop, how))
        check.network = [&model, &loop, how, requested = false,
                         made = std::optional<Network>{}]() mutable -> const std::optional<Network>& {
            if (std::exchange(requested, true)) return made;
            Diagnostics known;  // no errors can occur, because the system was derived from the same model
            const auto equations = equations_of_controllers(model, loop, known);
            const auto plant_network = plant(model, loop, known);
            if (!equations || !plant_network) return made;
            if (const auto composed = with_observers(*plant_network, loop, *equations, how, Vacuity::Ignored, known))
                made = expand(*composed);
            return made;
        };
    return check;
}

std::vector<const Chart*> charts_of(const Model& model, const ClosedLoop& loop) {
    std::vector<const Chart*> charts;
    for (const ClosedLoop::Controller& controller : loop.controllers) charts.push_back(&model.charts[controller.chart]);
    return charts;
}

}  // namespace grafverif
