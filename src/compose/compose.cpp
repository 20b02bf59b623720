// SPDX-License-Identifier: MIT
#include "compose/compose.hpp"

#include <algorithm>
#include <cassert>

#include "compose/controller.hpp"
#include "compose/procedures.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"

namespace grafverif {

namespace {

void take_names(const Network& network, UniqueNames& names) {
    for (const Network::Variable& variable : network.variables) names.fresh(variable.name);
    for (const Network::Template& automaton : network.templates) names.fresh(automaton.name);
    for (const Network::Process& process : network.processes) names.fresh(process.name);
}

ControllerParts parts_of(const ClosedLoop& loop, Id<ClosedLoop::Controller> id, const Equations& equations,
                         const ComposeOptions& options) {
    const ClosedLoop::Controller& controller = loop.controllers[id];
    ControllerParts parts{.equations = &equations, .name = controller.name, .origin = controller.origin};
    if (loop.controllers.size() > 1) parts.prefix = controller.name + "_";
    parts.mode = options.mode.value_or(controller.mode);
    if (equations.is_program) parts.mode = ExecutionMode::EveryCycle;
    if (options.ablations.cycle_unless_stable) parts.mode = ExecutionMode::EveryCycle;
    parts.cycle = controller.cycle;
    parts.starts = parts.cycle || starts(equations, parts.mode);
    return parts;
}

/// Reports a variable that two controllers assign. The reader already reports such variables for input files, but
/// compose does not rely on this check.
void check_writers(const Composition& composition, const ClosedLoop& loop, Diagnostics& diagnostics) {
    std::vector<const ControllerParts*> writers(composition.network.variables.size(), nullptr);
    for (const ControllerParts& parts : composition.controllers) {
        for (const Id<Equations::Variable> id : parts.equations->variables.ids()) {
            if (parts.equations->variables[id].role != Equations::Role::Output) continue;
            const Id<Network::Variable> variable = parts.variable[id.index];
            const ControllerParts*& writer = writers[variable.index];
            if (writer)
                diagnostics.add(messages::second_writer(loop.origin, composition.network.variables[variable].name,
                                                        writer->name, parts.name));
            writer = &parts;
        }
    }
}

/// Reports the option `--mode stability-search` if a controller is a program, because programs do not have this mode.
void check_mode(const ClosedLoop& loop, std::span<const Equations> equations, const ComposeOptions& options,
                Diagnostics& diagnostics) {
    for (const Id<ClosedLoop::Controller> id : loop.controllers.ids())
        if (equations[id.index].is_program && options.mode == ExecutionMode::StabilitySearch)
            diagnostics.add(messages::only_for_charts(loop.controllers[id].origin, loop.controllers[id].name,
                                                      "only charts have the mode stability-search", "omit `--mode`"));
}

/// Finds, for each variable, the controllers without a task cycle that read it. A change of the variable requests a
/// cycle of these controllers.
void find_readers(Composition& composition) {
    composition.readers.resize(composition.network.variables.size());
    for (std::uint32_t controller = 0; controller < composition.controllers.size(); ++controller) {
        const ControllerParts& parts = composition.controllers[controller];
        if (parts.cycle) continue;
        for (const Id<Equations::Variable> id : parts.equations->variables.ids())
            if (parts.equations->variables[id].role == Equations::Role::Input)
                composition.readers[parts.variable[id.index].index].push_back(controller);
    }
}

}  // namespace

std::optional<Network> compose(const Network& plant, const ClosedLoop& loop, std::span<const Equations> equations,
                               const ComposeOptions& options, Diagnostics& diagnostics) {
    assert(equations.size() == loop.controllers.size());
    Composition composition{.network = plant, .ablations = options.ablations};
    Network& network = composition.network;
    network.grain = options.grain.value_or(loop.grain);
    std::size_t parts_to_name = network.variables.size() + network.templates.size() + network.processes.size();
    for (const Equations& of : equations) parts_to_name += of.variables.size() + of.timers.size();
    composition.names.reserve(2 * parts_to_name);
    take_names(network, composition.names);
    for (const Id<ClosedLoop::Controller> id : loop.controllers.ids()) {
        ControllerParts parts = parts_of(loop, id, equations[id.index], options);
        declare(composition, loop, parts);
        composition.controllers.push_back(std::move(parts));
    }
    const std::size_t errors = diagnostics.errors();
    check_writers(composition, loop, diagnostics);
    check_mode(loop, equations, options, diagnostics);
    if (diagnostics.errors() != errors) return {};

    if (std::ranges::any_of(equations, [](const Equations& of) { return !faults(of).empty(); }))
        composition.race =
            network.variables.add({.name = composition.names.fresh("race"), .role = Network::Role::Flag});
    network.race = composition.race;
    find_readers(composition);
    add_plant_flags(composition);
    for (const ControllerParts& parts : composition.controllers)
        add_timers(composition, parts, add_cycle(composition, parts));
    network.settled = settled(composition);
    add_properties(composition, loop);
    assert(verify(network).empty());
    return std::move(composition.network);
}

}  // namespace grafverif
