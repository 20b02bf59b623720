// SPDX-License-Identifier: MIT
// expand: gives each process a separate template in which the arguments are substituted for the parameters. The engines
// use the expanded network, and the tests of the emitters compare their models with it.
#include "grafverif/ir/network.hpp"
#include "ir/network_terms.hpp"
#include "ir/slots.hpp"

namespace grafverif {

namespace {

Network::Template expanded(const Slots& slots, Exprs& exprs) {
    Network::Template automaton = slots.automaton;
    TermCopier copy = slots.terms(exprs);
    automaton.name = slots.process.name;
    automaton.parameters = {};
    automaton.initial = slots.process.initial;
    replace_terms(automaton, copy);
    return automaton;
}

}  // namespace

Network expand(const Network& network) {
    Network flat;
    flat.name = network.name;
    flat.grain = network.grain;
    flat.time_unit_ms = network.time_unit_ms;
    flat.constants = network.constants;
    flat.variables = network.variables;
    flat.processes = network.processes;
    flat.controllers = network.controllers;
    flat.properties = network.properties;
    flat.race = network.race;

    for (const Id<Network::Process> id : flat.processes.ids()) {
        flat.processes[id].automaton = flat.templates.add(expanded(Slots(network, id), flat.exprs));
        flat.processes[id].arguments.clear();
    }
    TermCopier copy(network.exprs, flat.exprs, [&flat](const Expr& node) {
        return node.op == Op::At ? flat.exprs.at(at_process(node), at_location(node))
                                 : flat.exprs.leaf(node.op, static_cast<std::uint32_t>(node.value));
    });
    for (Property& property : flat.properties)
        for (Id<Expr>& operand : property.operands) operand = copy(operand);
    if (network.settled.valid()) flat.settled = copy(network.settled);
    return flat;
}

}  // namespace grafverif
