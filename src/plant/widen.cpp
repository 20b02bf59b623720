// SPDX-License-Identifier: MIT
#include "plant/widen.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace grafverif {

namespace {

using Variable = Network::Variable;

/// Which variables must have one type: union-find with path halving.
class Classes {
public:
    explicit Classes(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), std::uint32_t{0}); }

    std::uint32_t of(std::uint32_t variable) {
        for (; parent_[variable] != variable; variable = parent_[variable])
            parent_[variable] = parent_[parent_[variable]];
        return variable;
    }
    void join(std::uint32_t left, std::uint32_t right) { parent_[of(left)] = of(right); }

private:
    std::vector<std::uint32_t> parent_;
};

}  // namespace

void unify_ranges(Network& network) {
    Classes classes(network.variables.size());
    std::vector<std::vector<Id<Variable>>> first(network.templates.size());  // per template and parameter
    for (const Id<Network::Template> id : network.templates.ids())
        first[id.index].resize(network.templates[id].parameters.size());
    for (const Network::Process& process : network.processes) {
        for (std::size_t i = 0; i < process.arguments.size(); ++i) {
            const auto* variable = std::get_if<Id<Variable>>(&process.arguments[i]);
            if (!variable || network.variables[*variable].type.boolean) continue;
            Id<Variable>& other = first[process.automaton.index][i];
            if (other.valid()) classes.join(variable->index, other.index);
            other = *variable;
        }
    }
    for (const Id<Variable> id : network.variables.ids()) {
        const Type& type = network.variables[id].type;
        Type& hull = network.variables[{classes.of(id.index)}].type;
        hull.low = std::min(hull.low, type.low);
        hull.high = std::max(hull.high, type.high);
    }
    for (const Id<Variable> id : network.variables.ids())
        network.variables[id].type = network.variables[{classes.of(id.index)}].type;
    for (const Id<Network::Template> id : network.templates.ids()) {
        Network::Template& automaton = network.templates[id];
        for (const Id<Network::Parameter> parameter : automaton.parameters.ids())
            if (const Id<Variable> variable = first[id.index][parameter.index]; variable.valid())
                automaton.parameters[parameter].type = network.variables[variable].type;
    }
}

}  // namespace grafverif
