// SPDX-License-Identifier: MIT
// Translates the properties of a loop, and `settled`, to terms of its network.
#include <algorithm>
#include <string>

#include "compose/controller.hpp"
#include "ir/slots.hpp"
#include "support/overloaded.hpp"
#include "syntax/print/sentence.hpp"

namespace grafverif {

namespace {

Id<Expr> formula_of(const ClosedLoop& loop, const ClosedLoop::Symbol& symbol, Composition& composition) {
    Network& network = composition.network;
    const auto in_controller = [&](const ControllerParts& parts, Id<Equations::Variable> variable) {
        return leaf(network, parts.variable[variable.index]);
    };
    return std::visit(overloaded{
                          [&](const ClosedLoop::SharedSymbol& of) { return leaf(network, {of.shared.index}); },
                          [&](const ClosedLoop::InternalSymbol& of) {
                              return in_controller(composition.controllers[of.controller.index], {of.variable.index});
                          },
                          [&](const ClosedLoop::StepSymbol& of) {
                              const ControllerParts& parts = composition.controllers[of.controller.index];
                              return in_controller(parts, parts.equations->steps[of.step.index].variable);
                          },
                          [&](const ClosedLoop::LocationSymbol& of) {
                              return network.exprs.at(of.instance.index, of.location.index);
                          },
                          [&](const ClosedLoop::OwnSymbol& of) {
                              const auto& arguments = network.processes[{of.instance.index}].arguments;
                              return leaf(network, std::get<Id<Network::Variable>>(arguments[own_argument(loop, of)]));
                          },
                          [&](const ClosedLoop::TimeSymbol& of) {
                              const ControllerParts& parts = composition.controllers[of.controller.index];
                              return in_controller(parts, end_of(*parts.equations, of));
                          },
                          // The function reads_observer excludes properties with this symbol.
                          [](const ClosedLoop::ObserverSymbol&) -> Id<Expr> { unreachable(); },
                      },
                      symbol);
}

/// Adds one formula per urgent edge of a process, which states that the process is in the source location and the guard
/// holds.
void add_enabled(Network& network, Id<Network::Process> id, std::vector<Id<Expr>>& found) {
    const Slots slots(network, id);
    TermCopier terms = slots.terms(network.exprs);
    for (const Network::Edge& edge : slots.automaton.edges) {
        if (!edge.urgent) continue;
        const Id<Expr> guard = terms(edge.guard);
        const bool anywhere = slots.automaton.locations.size() == 1;
        const Id<Expr> here = anywhere ? network.exprs.constant(true) : network.exprs.at(id.index, edge.from.index);
        found.push_back(network.exprs.conjunction(here, guard));
    }
}

}  // namespace

Id<Expr> settled(Composition& composition) {
    Network& network = composition.network;
    std::vector<Id<Expr>> conjuncts;
    for (const Id<Network::Controller> id : network.controllers.ids()) {
        const Network::Controller& controller = network.controllers[id];
        const ControllerParts& parts = composition.controllers[id.index];
        conjuncts.push_back(network.exprs.at(controller.process.index, controller.waiting.index));
        conjuncts.push_back(leaf(network, parts.stable));
        if (parts.evol_pl.valid()) conjuncts.push_back(network.exprs.negation(leaf(network, parts.evol_pl)));
        if (parts.evol_ti.valid()) conjuncts.push_back(network.exprs.negation(leaf(network, parts.evol_ti)));
        for (const Id<Network::Variable> pending : parts.pending)
            conjuncts.push_back(network.exprs.negation(leaf(network, pending)));
    }
    std::vector<Id<Expr>> enabled;
    for (const Id<Network::Process> id : network.processes.ids()) {
        const Network::ProcessKind kind = network.processes[id].kind;
        const bool timer = kind == Network::ProcessKind::Timer && !composition.ablations.timers_as_published;
        if (kind != Network::ProcessKind::Controller && !timer) add_enabled(network, id, enabled);
    }
    for (const Id<Expr> edge : enabled) conjuncts.push_back(network.exprs.negation(edge));
    return network.exprs.conjunction(conjuncts);
}

void add_properties(Composition& composition, const ClosedLoop& loop) {
    Network& network = composition.network;
    UniqueNames taken;
    for (const Property& property : loop.properties) taken.fresh(property.name);
    const auto add = [&](Property property) {
        for (Id<Expr>& operand : property.operands)
            operand = translate(loop.exprs, operand, network.exprs, [&](const Expr& node) {
                return formula_of(loop, loop.symbols[{static_cast<std::uint32_t>(node.value)}], composition);
            });
        if (property.pattern == Pattern::ReachableAllSteps)
            for (const ControllerParts& parts : composition.controllers)
                for (const Equations::StepActivity& step : parts.equations->steps)
                    property.operands.push_back(leaf(network, parts.variable[step.variable.index]));
        taken.fresh(property.name);
        network.properties.add(std::move(property));
    };
    for (const Property& property : loop.properties)
        if (!reads_observer(loop, property)) add(property);
    for (Property& constraint : constraints_to_prove(loop)) add(std::move(constraint));
    if (!composition.race.valid()) return;
    const bool programs = std::ranges::any_of(composition.controllers,
                                              [](const ControllerParts& parts) { return parts.equations->is_program; });
    network.properties.add({.name = taken.fresh("no_race"),
                            .text = std::string("no two stored actions assign different values to one variable") +
                                    (programs ? ", and no program has a run-time fault" : ""),
                            .pattern = Pattern::Never,
                            .operands = {leaf(network, composition.race)}});
}

}  // namespace grafverif
