// SPDX-License-Identifier: MIT
#include "emit/pins/slots.hpp"

#include <algorithm>
#include <cctype>

#include "support/unique_names.hpp"

namespace grafverif::pins {

namespace {

void add(SlotSet& set, const std::optional<Slot>& slot) {
    if (slot) set.insert(*slot);
}

}  // namespace

std::string identifier(std::string name) {
    for (char& character : name)
        if (std::isalnum(static_cast<unsigned char>(character)) == 0) character = '_';
    return name;
}

Slots::Slots(const Network& expanded) : network(expanded), caps(analyse_clocks(expanded)) {
    UniqueNames unique;
    const auto take = [&](const std::string& name, std::int64_t first) {
        names.push_back(unique.fresh(identifier(name)));
        initial.push_back(first);
        return static_cast<Slot>(names.size() - 1);
    };
    for (const Id<Network::Process> id : network.processes.ids()) {
        const Network::Process& process = network.processes[id];
        const bool moves = automaton(id).locations.size() > 1;
        locations.push_back(moves ? std::optional(take(process.name, process.initial.index)) : std::nullopt);
        clocks.emplace_back();
        for (const Id<Network::Clock> clock : automaton(id).clocks.ids())
            clocks.back().push_back(caps[id.index].greatest[clock.index] > 0
                                        ? std::optional(take(process.name + "_" + automaton(id).clocks[clock].name, 0))
                                        : std::nullopt);
    }
    variables.resize(network.variables.size());
    for (const Id<Network::Variable> id : network.variables.ids()) {
        const Network::Variable& variable = network.variables[id];
        if (variable.scratch || variable.type.low == variable.type.high) continue;
        variables[id.index] = take(variable.name, variable.initial);
    }
    for (const Id<Network::Variable> id : network.variables.ids())
        if (network.variables[id].scratch) variables[id.index] = static_cast<Slot>(names.size()) + scratch++;
}

SlotSet Slots::read_by(const Exprs& exprs, Id<Expr> term) const {
    SlotSet found;
    std::set<std::uint32_t> seen = {term.index};
    std::vector<Id<Expr>> open = {term};
    while (!open.empty()) {
        const Expr& node = exprs[open.back()];
        open.pop_back();
        if (node.op == Op::At) add(found, locations[at_process(node)]);
        if (node.op == Op::Variable)
            if (const auto slot = variables[static_cast<std::size_t>(node.value)]; slot && *slot < names.size())
                found.insert(*slot);
        for (const Id<Expr> operand : exprs.operands(node))
            if (seen.insert(operand.index).second) open.push_back(operand);
    }
    return found;
}

std::vector<Network::Assignment> Slots::effect(Id<Network::Process> process, const Network::Edge& edge) const {
    std::vector<Network::Assignment> all = edge.assignments;
    for (const Id<Network::Procedure> call : edge.calls) {
        const auto& body = automaton(process).procedures[call].assignments;
        all.insert(all.end(), body.begin(), body.end());
    }
    return all;
}

std::vector<ClockInterval> Slots::tested(Id<Network::Process> process, const Network::Edge& edge) const {
    const std::size_t count = automaton(process).clocks.size();
    std::vector<ClockInterval> wanted = admitted(network, edge.constraint, count);
    const std::vector<ClockInterval> after = admitted(network, automaton(process).locations[edge.to].invariant, count);
    for (std::uint32_t clock = 0; clock < count; ++clock) {
        if (!resets(edge, {clock})) wanted[clock].high = std::min(wanted[clock].high, after[clock].high);
        else if (!after[clock].contains(0)) wanted[clock] = {1, 0};  // an empty range {1, 0} admits no value
    }
    return wanted;
}

Reach enabling(const Slots& slots, Id<Network::Process> process, const Network::Edge& edge) {
    Reach found{slots.read_by(slots.network.exprs, edge.guard), {}};
    add(found.reads, slots.locations[process.index]);
    for (const std::optional<Slot>& clock : slots.clocks[process.index]) add(found.reads, clock);
    if (slots.network.race.valid()) add(found.reads, slots.variables[slots.network.race.index]);
    return found;
}

Reach reach(const Slots& slots, Id<Network::Process> process, const Network::Edge& edge) {
    Reach found = enabling(slots, process, edge);
    for (const Network::Assignment& assignment : slots.effect(process, edge)) {
        found.reads.merge(slots.read_by(slots.network.exprs, assignment.value));
        const auto target = static_cast<std::size_t>(slots.network.exprs[assignment.target].value);
        if (const auto slot = slots.variables[target]; slot && *slot < slots.names.size()) found.writes.insert(*slot);
    }
    if (edge.from != edge.to) add(found.writes, slots.locations[process.index]);
    for (const std::optional<Slot>& clock : slots.clocks[process.index]) add(found.writes, clock);
    return found;
}

Reach reach_of_time(const Slots& slots) {
    Reach found;
    for (const Id<Network::Process> id : slots.network.processes.ids()) {
        for (const Network::Edge& edge : slots.automaton(id).edges)
            if (edge.urgent) found.reads.merge(enabling(slots, id, edge).reads);
        if (!slots.clocks[id.index].empty()) add(found.reads, slots.locations[id.index]);
        for (const std::optional<Slot>& clock : slots.clocks[id.index]) {
            add(found.reads, clock);
            add(found.writes, clock);
        }
    }
    if (slots.network.race.valid()) add(found.reads, slots.variables[slots.network.race.index]);
    return found;
}

}  // namespace grafverif::pins
