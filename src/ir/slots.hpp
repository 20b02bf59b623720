// SPDX-License-Identifier: MIT
// Slots: variables that one process reads or writes, with the parameters of its template resolved. A slot is a
// parameter bound to a variable, or a variable that the template names directly. A parameter that is bound to a
// constant is replaced by the constant.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "ir/literal.hpp"

namespace grafverif {

struct Slots {
    const Network& network;
    const Network::Process& process;
    const Network::Template& automaton;

    Slots(const Network& of, Id<Network::Process> id)
        : network(of), process(of.processes[id]), automaton(of.templates[process.automaton]) {}

    /// Returns the variable of a Parameter or Variable leaf; invalid for a constant.
    Id<Network::Variable> variable(const Expr& leaf) const {
        const auto index = static_cast<std::uint32_t>(leaf.value);
        if (leaf.op == Op::Variable) return {index};
        const auto* bound = std::get_if<Id<Network::Variable>>(&process.arguments[index]);
        return bound ? *bound : Id<Network::Variable>{};
    }
    std::int64_t constant(const Expr& leaf) const {
        return std::get<std::int64_t>(process.arguments[static_cast<std::size_t>(leaf.value)]);
    }
    /// Returns the constant that is bound to a Parameter leaf, as a term.
    Id<Expr> literal_of(const Expr& leaf, Exprs& exprs) const {
        const Id<Network::Parameter> parameter{static_cast<std::uint32_t>(leaf.value)};
        return literal(exprs, automaton.parameters[parameter].type, constant(leaf));
    }

    /// Copies terms of the template into `to`, with the parameters resolved.
    TermCopier terms(Exprs& to) const {
        return {network.exprs, to, [this, &to](const Expr& leaf) {
                    const Id<Network::Variable> of = variable(leaf);
                    return of.valid() ? to.leaf(Op::Variable, of.index) : literal_of(leaf, to);
                }};
    }

    /// Returns all assignments of an edge in the order of execution.
    std::vector<Network::Assignment> assignments(const Network::Edge& edge) const {
        std::vector<Network::Assignment> all = edge.assignments;
        for (const Id<Network::Procedure> call : edge.calls) {
            const std::vector<Network::Assignment>& body = automaton.procedures[call].assignments;
            all.insert(all.end(), body.begin(), body.end());
        }
        return all;
    }

    /// Return the variables that the process reads in guards and values (`read`), the variables that it writes
    /// (`written`), and all of them (`used`), in order of first occurrence.
    std::vector<Id<Network::Variable>> read() const { return collect(true, false); }
    std::vector<Id<Network::Variable>> written() const { return collect(false, true); }
    std::vector<Id<Network::Variable>> used() const { return collect(true, true); }

    /// Returns the name of `variable` in the template: the name of the parameter, or the name of a variable that the
    /// template names directly.
    std::string name(Id<Network::Variable> variable) const {
        for (const Id<Network::Parameter> parameter : automaton.parameters.ids())
            if (const auto* bound = std::get_if<Id<Network::Variable>>(&process.arguments[parameter.index]))
                if (*bound == variable) return automaton.parameters[parameter].name;
        return network.variables[variable].name;
    }

private:
    std::vector<Id<Network::Variable>> collect(bool reads, bool writes) const {
        std::vector<Id<Network::Variable>> found;
        std::vector<bool> seen(network.variables.size());
        const auto take = [&](Id<Expr> term) {
            for (const Id<Expr> leaf : leaves(network.exprs, term)) {
                const Id<Network::Variable> id = variable(network.exprs[leaf]);
                if (!id.valid() || seen[id.index]) continue;
                seen[id.index] = true;
                found.push_back(id);
            }
        };
        for (const Network::Edge& edge : automaton.edges) {
            if (reads) take(edge.guard);
            for (const Network::Assignment& assignment : assignments(edge)) {
                if (writes) take(assignment.target);
                if (reads) take(assignment.value);
            }
        }
        return found;
    }
};

}  // namespace grafverif
