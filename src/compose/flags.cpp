// SPDX-License-Identifier: MIT
// Adds the flags EVOL_PL to the plant. An edge of the plant sets the flag EVOL_PL of a controller if and only if the
// edge assigns an input of this controller (CEP13 6.2). If the edges of two processes with the same template set
// different flags, a process uses a copy of the template (`sensor_2`). The components of the model are unchanged.
#include <algorithm>
#include <map>

#include "compose/controller.hpp"

namespace grafverif {

namespace {

/// For each edge of a template: the flags that it sets, numbered in the order of first use. Processes with equal
/// patterns share a template.
using FlagPattern = std::vector<std::vector<std::uint32_t>>;

struct Flags {
    FlagPattern pattern = {};
    std::vector<std::uint32_t> controllers = {};  ///< controller that is represented by each flag number
};

Flags flags_of(const Composition& composition, const Network::Process& process, const Network::Template& automaton) {
    const Network& network = composition.network;
    Flags flags;
    for (const Network::Edge& edge : automaton.edges) {
        std::vector<std::uint32_t>& set = flags.pattern.emplace_back();
        for (const Network::Assignment& assignment : edge.assignments) {
            const auto parameter = static_cast<std::size_t>(network.exprs[assignment.target].value);
            const auto variable = std::get<Id<Network::Variable>>(process.arguments[parameter]);
            for (const std::uint32_t controller : composition.readers[variable.index]) {
                auto number = std::ranges::find(flags.controllers, controller);
                if (number == flags.controllers.end()) number = flags.controllers.insert(number, controller);
                const auto flag = static_cast<std::uint32_t>(number - flags.controllers.begin());
                if (std::ranges::find(set, flag) == set.end()) set.push_back(flag);
            }
        }
    }
    return flags;
}

Network::Template with_flags(Composition& composition, Network::Template automaton, const Flags& flags) {
    Exprs& exprs = composition.network.exprs;
    UniqueNames names;
    for (const Network::Parameter& parameter : automaton.parameters) names.fresh(parameter.name);
    std::vector<Id<Expr>> parameters;
    for (std::size_t i = 0; i < flags.controllers.size(); ++i) {
        const Id<Network::Parameter> flag =
            automaton.parameters.add({names.fresh("EVOL_PL"), Network::ParameterKind::Written, {}});
        parameters.push_back(exprs.leaf(Op::Parameter, flag.index));
    }
    for (const Id<Network::Edge> id : automaton.edges.ids()) {
        Network::Edge& edge = automaton.edges[id];
        for (const std::uint32_t flag : flags.pattern[id.index])
            edge.assignments.push_back({parameters[flag], exprs.constant(true)});
        if (composition.ablations.sensors_not_urgent && !flags.pattern[id.index].empty()) edge.urgent = false;
    }
    return automaton;
}

}  // namespace

void add_plant_flags(Composition& composition) {
    Network& network = composition.network;
    const Table<Network::Template> plain = network.templates;
    std::vector<std::map<FlagPattern, Id<Network::Template>>> variants(plain.size());
    for (Network::Process& process : network.processes) {
        const Id<Network::Template> original = process.automaton;
        const Flags flags = flags_of(composition, process, plain[original]);
        const auto [variant, added] = variants[original.index].try_emplace(flags.pattern, original);
        if (added && variants[original.index].size() == 1) {
            network.templates[original] = with_flags(composition, plain[original], flags);
        } else if (added) {
            Network::Template copy = with_flags(composition, plain[original], flags);
            copy.name = composition.names.fresh(copy.name);
            variant->second = network.templates.add(std::move(copy));
        }
        process.automaton = variant->second;
        for (const std::uint32_t controller : flags.controllers)
            process.arguments.push_back(composition.controllers[controller].evol_pl);
    }
}

}  // namespace grafverif
