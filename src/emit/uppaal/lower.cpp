// SPDX-License-Identifier: MIT
// Replaces constructs that UPPAAL templates do not support (see `lower`), before the project is written.
#include <algorithm>

#include "emit/uppaal/uppaal.hpp"
#include "support/unique_names.hpp"

namespace grafverif::uppaal {
namespace {

using Template = Network::Template;
using Location = Network::Location;

/// Returns the initial locations of the processes of each template, in the order of first use.
std::vector<std::vector<Id<Location>>> starts(const Network& network) {
    std::vector<std::vector<Id<Location>>> used(network.templates.size());
    for (const Network::Process& process : network.processes) {
        auto& list = used[process.automaton.index];
        if (std::ranges::find(list, process.initial) == list.end()) list.push_back(process.initial);
    }
    return used;
}

/// Creates one copy of each template per initial location of its processes. The copy that starts in the initial
/// location of the template keeps the name of the template. If no process starts in this location, the copy for the
/// first used location keeps the name.
void split_by_start(Network& network) {
    const std::vector<std::vector<Id<Location>>> used = starts(network);
    UniqueNames names;
    for (const Template& automaton : network.templates) names.take(automaton.name);

    Table<Template> templates;
    // The template for each element of `used`.
    std::vector<std::vector<Id<Template>>> variants(network.templates.size());
    for (const Id<Template> id : network.templates.ids()) {
        const Template& automaton = network.templates[id];
        const std::vector<Id<Location>>& list = used[id.index];
        if (list.empty()) templates.add(automaton);
        const bool own = std::ranges::find(list, automaton.initial) != list.end();
        for (const Id<Location> start : list) {
            const bool keeps_name = own ? start == automaton.initial : start == list.front();
            Template variant = automaton;
            variant.initial = start;
            if (!keeps_name) variant.name = names.fresh(automaton.name + '_' + automaton.locations[start].name);
            variants[id.index].push_back(templates.add(std::move(variant)));
        }
    }
    for (Network::Process& process : network.processes) {
        const std::vector<Id<Location>>& list = used[process.automaton.index];
        const auto place = std::ranges::find(list, process.initial) - list.begin();
        process.automaton = variants[process.automaton.index][static_cast<std::size_t>(place)];
    }
    network.templates = std::move(templates);
}

/// Sets the type of each integer constant: the range of its arguments if it exceeds UPPAAL's default integers,
/// otherwise the default.
void fit_constants(Network& network) {
    std::vector<std::vector<Type>> hulls;
    for (const Template& automaton : network.templates)
        hulls.emplace_back(automaton.parameters.size(), integer_type(least_integer, greatest_integer));
    for (const Network::Process& process : network.processes) {
        for (std::size_t i = 0; i < process.arguments.size(); ++i) {
            const auto* value = std::get_if<std::int64_t>(&process.arguments[i]);
            if (!value) continue;
            Type& hull = hulls[process.automaton.index][i];
            hull.low = std::min(hull.low, *value);
            hull.high = std::max(hull.high, *value);
        }
    }
    for (const Id<Template> id : network.templates.ids()) {
        for (const Id<Network::Parameter> parameter : network.templates[id].parameters.ids()) {
            Network::Parameter& constant = network.templates[id].parameters[parameter];
            if (constant.kind == Network::ParameterKind::Constant && !constant.type.boolean)
                constant.type = hulls[id.index][parameter.index];
        }
    }
}

}  // namespace

Network lower(Network network) {
    split_by_start(network);
    fit_constants(network);
    return network;
}

}  // namespace grafverif::uppaal
