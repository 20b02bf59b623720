// SPDX-License-Identifier: MIT
// expand: each process gets a template of its own, its arguments written in place of the parameters. What an engine
// reads, and what the emitters' tests compare with.
#include "grafverif/ir/network.hpp"

namespace grafverif {

namespace {

/// Terms of `from` as `process` reads them; of none: those of properties.
TermCopier reading(const Network& from, const Network::Process* process, Exprs& to) {
    return {from.exprs, to, [&from, process, &to](const Expr& node) {
                const auto index = static_cast<std::uint32_t>(node.value);
                if (node.op == Op::At) return to.at(at_process(node), at_location(node));
                if (node.op != Op::Parameter) return to.leaf(node.op, index);
                const Network::Argument& argument = process->arguments[index];
                if (const auto* variable = std::get_if<Id<Network::Variable>>(&argument))
                    return to.leaf(Op::Variable, variable->index);
                const std::int64_t value = std::get<std::int64_t>(argument);
                const Type& type = from.templates[process->automaton].parameters[{index}].type;
                return type.boolean ? to.constant(value != 0) : to.integer(value);
            }};
}

Network::Template expanded(const Network& network, const Network::Process& process, Exprs& exprs) {
    Network::Template automaton = network.templates[process.automaton];
    TermCopier copy = reading(network, &process, exprs);
    const auto copy_constraints = [&copy](std::vector<Network::ClockConstraint>& list) {
        for (Network::ClockConstraint& constraint : list) constraint.bound = copy(constraint.bound);
    };
    const auto copy_assignments = [&copy](std::vector<Network::Assignment>& list) {
        for (auto& [target, value] : list) {
            target = copy(target);
            value = copy(value);
        }
    };
    automaton.name = process.name;
    automaton.parameters = {};
    automaton.initial = process.initial;
    for (Network::Location& location : automaton.locations) copy_constraints(location.invariant);
    for (Network::Procedure& procedure : automaton.procedures) copy_assignments(procedure.assignments);
    for (Network::Edge& edge : automaton.edges) {
        edge.guard = copy(edge.guard);
        copy_constraints(edge.constraint);
        copy_assignments(edge.assignments);
    }
    return automaton;
}

}  // namespace

Network expand(const Network& network) {
    Network flat;
    flat.name = network.name;
    flat.grain = network.grain;
    flat.time_unit_ms = network.time_unit_ms;
    flat.variables = network.variables;
    flat.processes = network.processes;
    flat.controllers = network.controllers;
    flat.properties = network.properties;
    flat.race = network.race;

    for (const Id<Network::Process> id : flat.processes.ids()) {
        flat.processes[id].automaton = flat.templates.add(expanded(network, network.processes[id], flat.exprs));
        flat.processes[id].arguments.clear();
    }
    TermCopier copy = reading(network, nullptr, flat.exprs);
    for (Property& property : flat.properties)
        for (Id<Expr>& operand : property.operands) operand = copy(operand);
    if (network.settled.valid()) flat.settled = copy(network.settled);
    return flat;
}

}  // namespace grafverif
