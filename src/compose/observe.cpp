// SPDX-License-Identifier: MIT
#include "compose/observe.hpp"

#include <algorithm>
#include <cassert>
#include <optional>
#include <string>
#include <utility>

#include "compose/observer.hpp"
#include "compose/vacuity.hpp"
#include "support/unique_names.hpp"

namespace grafverif {

namespace {

/// Encodes the location of a process as a variable `at_NAME`, which each edge that changes the location assigns.
class Places {
public:
    Places(Network& network, UniqueNames& names)
        : network_(network), names_(names), variables_(network.processes.size()) {}

    Id<Expr> at(const Expr& node) {
        const Id<Network::Process> process{at_process(node)};
        const Network::Template& automaton = network_.templates[network_.processes[process].automaton];
        if (automaton.locations.size() == 1) return network_.exprs.constant(true);
        if (!variables_[process.index].valid()) add_location_variable(network_.processes[process].automaton);
        return network_.exprs.apply(Op::Equal, network_.exprs.leaf(Op::Variable, variables_[process.index].index),
                                    network_.exprs.integer(at_location(node)));
    }

    /// Returns a copy of `term` that can be used in guards: location tests are replaced by tests of the variables
    /// `at_NAME`.
    Id<Expr> readable(Id<Expr> term) {
        const Exprs from = network_.exprs;  // a copy, because the function adds terms to the table
        return translate(from, term, network_.exprs, [&](const Expr& leaf) {
            return leaf.op == Op::At ? at(leaf) : network_.exprs.leaf(leaf.op, static_cast<std::uint32_t>(leaf.value));
        });
    }

private:
    /// Adds a parameter to a template, and assignments of the new location to this parameter on its edges. Adds a
    /// variable `at_NAME` as the argument of each process of the template.
    void add_location_variable(Id<Network::Template> id) {
        Network::Template& automaton = network_.templates[id];
        UniqueNames own;
        for (const Network::Parameter& parameter : automaton.parameters) own.fresh(parameter.name);
        const Type type = integer_type(0, static_cast<std::int64_t>(automaton.locations.size()) - 1);
        const auto place = automaton.parameters.add({own.fresh("at"), Network::ParameterKind::Written, type});
        const Id<Expr> target = network_.exprs.leaf(Op::Parameter, place.index);
        for (Network::Edge& edge : automaton.edges)
            if (edge.from != edge.to) edge.assignments.push_back({target, network_.exprs.integer(edge.to.index)});
        for (const Id<Network::Process> process : network_.processes.ids()) {
            Network::Process& of = network_.processes[process];
            if (of.automaton != id) continue;
            variables_[process.index] = network_.variables.add({.name = names_.fresh("at_" + of.name),
                                                                .role = Network::Role::Flag,
                                                                .type = type,
                                                                .initial = of.initial.index});
            of.arguments.emplace_back(variables_[process.index]);
        }
    }

    Network& network_;
    UniqueNames& names_;
    std::vector<Id<Network::Variable>> variables_;
};

/// Changes every edge of the loop: the edge is enabled only after all observers have read the current state, and it
/// starts a new round of the observers.
void show_every_state(Network& network, Id<Expr> look) {
    const Id<Expr> seen = network.exprs.apply(Op::Equal, look, network.exprs.integer(0));
    const Id<Expr> first = network.exprs.integer(1);
    for (Network::Template& automaton : network.templates)
        for (Network::Edge& edge : automaton.edges) {
            edge.guard = network.exprs.conjunction(edge.guard, seen);
            edge.assignments.push_back({look, first});
        }
}

/// Expresses the property in terms of the locations of its observer `process`.
Property question(Network& network, Property property, Id<Network::Process> process, const ObserverMade& made) {
    const auto somewhere = [&](const std::vector<Id<Network::Location>>& locations) {
        std::vector<Id<Expr>> places;
        for (const Id<Network::Location> location : locations)
            places.push_back(network.exprs.at(process.index, location.index));
        return network.exprs.disjunction(places);
    };
    property.pattern = made.settled.empty() ? Pattern::Never : Pattern::LeadsTo;
    property.operands = {somewhere(made.pending)};
    if (!made.settled.empty()) property.operands.push_back(somewhere(made.settled));
    property.at_stable = false;
    return property;
}

}  // namespace

std::vector<Id<Property>> watched(const Network& network) {
    std::vector<Id<Property>> found;
    for (const Id<Property> id : network.properties.ids())
        if (network.properties[id].pattern == Pattern::Watched) found.push_back(id);
    return found;
}

Network observed(const Network& network, const std::vector<Id<Property>>& chosen, Vacuity vacuity) {
    Network made = network;
    made.properties = {};
    UniqueNames names;
    for (const Network::Variable& variable : network.variables) names.fresh(variable.name);
    for (const Network::Template& automaton : network.templates) names.fresh(automaton.name);
    for (const Network::Process& process : network.processes) names.fresh(process.name);

    // First translates the terms that observers read, and then adds the assignments of their variables. The edges of
    // observers, which are added afterwards, do not need these assignments.
    Places places(made, names);
    std::vector<ObserverTerms> terms;
    for (const Id<Property> id : chosen) {
        ObserverTerms& of = terms.emplace_back();
        for (const Id<Expr> operand : network.properties[id].operands) of.operands.push_back(places.readable(operand));
        of.considered = network.properties[id].at_stable ? places.readable(network.settled) : made.exprs.constant(true);
    }
    Id<Expr> look;
    if (!chosen.empty()) {
        const Id<Network::Variable> flag =
            made.variables.add({.name = names.fresh("look"),
                                .role = Network::Role::Flag,
                                .type = integer_type(0, static_cast<std::int64_t>(chosen.size())),
                                .initial = 1});
        look = made.exprs.leaf(Op::Variable, flag.index);
        show_every_state(made, look);
    }
    std::vector<Property> probes;
    for (const Property& property : network.properties) {
        if (property.pattern != Pattern::Watched) {
            made.properties.add(property);
            continue;
        }
        const auto known =
            std::ranges::find(chosen, property.name, [&](Id<Property> id) { return network.properties[id].name; });
        if (known == chosen.end()) continue;
        const auto position = known - chosen.begin();
        const bool last = known + 1 == chosen.end();
        ObserverTerms& of = terms[static_cast<std::size_t>(position)];
        of.active = made.exprs.apply(Op::Equal, look, made.exprs.integer(position + 1));
        of.look = look;
        of.next = made.exprs.integer(last ? 0 : position + 2);
        ObserverMade observer =
            observer_of(made.exprs, property.watch, of, property.watch.duration_ms / network.time_unit_ms);
        observer.automaton.name = names.fresh("observer_" + property.name);
        observer.automaton.origin = property.origin;
        Network::Process process{.name = names.fresh(property.name + "_watch"),
                                 .initial = observer.automaton.initial,
                                 .kind = Network::ProcessKind::Observer,
                                 .origin = property.origin};
        Id<Network::Variable> followed;
        if (vacuity == Vacuity::Probed) followed = follow_scope(made, names, property, of, observer.automaton);
        process.automaton = made.templates.add(std::move(observer.automaton));
        const Id<Network::Process> id = made.processes.add(std::move(process));
        made.properties.add(question(made, property, id, observer));
        if (vacuity == Vacuity::Probed)
            for (Property& probe : vacuity_probes(made, property, of, id, followed)) probes.push_back(std::move(probe));
    }
    for (Property& probe : probes) made.properties.add(std::move(probe));
    assert(verify(made).empty());
    return made;
}

}  // namespace grafverif
