// SPDX-License-Identifier: MIT
// Hand-written networks for the tests of the UPPAAL emitter. The networks are small and contain one
// element of each kind.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"

namespace grafverif::test {

/// Short functions for the terms and entities of one network.
struct Hand {
    Network network = {};

    Id<Expr> v(Id<Network::Variable> variable) { return network.exprs.leaf(Op::Variable, variable.index); }
    Id<Expr> p(Id<Network::Parameter> parameter) { return network.exprs.leaf(Op::Parameter, parameter.index); }
    Id<Expr> number(std::int64_t value) { return network.exprs.integer(value); }
    Id<Expr> yes() { return network.exprs.constant(true); }
    Id<Expr> no() { return network.exprs.constant(false); }
    Id<Expr> neither(Id<Expr> operand) { return network.exprs.negation(operand); }
    Id<Expr> all(std::initializer_list<Id<Expr>> operands) { return network.exprs.conjunction(std::vector(operands)); }
    Id<Expr> any(std::initializer_list<Id<Expr>> operands) { return network.exprs.disjunction(std::vector(operands)); }
    Id<Expr> op(Op operation, Id<Expr> left, Id<Expr> right) { return network.exprs.apply(operation, left, right); }
    Id<Expr> at(Id<Network::Process> process, std::uint32_t location) {
        return network.exprs.at(process.index, location);
    }

    Id<Network::Variable> boolean(std::string name, Network::Role role, bool initial = false) {
        return network.variables.add({std::move(name), role, {}, initial ? 1 : 0, false, {}});
    }
    Id<Network::Variable> integer(std::string name, Network::Role role, std::int64_t low, std::int64_t high) {
        return network.variables.add({std::move(name), role, integer_type(low, high), low, false, {}});
    }
    Id<Network::Process> process(std::string name, Id<Network::Template> automaton,
                                 std::vector<Network::Argument> arguments, Network::ProcessKind kind,
                                 std::uint32_t initial = 0) {
        return network.processes.add({std::move(name), automaton, std::move(arguments), {initial}, kind, {}});
    }
    void property(std::string name, std::string text, Pattern pattern, std::vector<Id<Expr>> operands = {}) {
        network.properties.add(
            {.name = std::move(name), .text = std::move(text), .pattern = pattern, .operands = std::move(operands)});
    }
};

/// Returns a station: a cylinder with two position sensors that start at different ends, and a push
/// button. The chart of the station has two steps with a timer and a stored action, in the phased
/// grain. There is one property of each pattern.
Network station();

/// Returns two templates and three processes whose names are all UPPAAL keywords or names of other entities.
Network awkward_names();

/// Returns one location with many loops, and a complete graph of five locations, all with long labels.
Network crowded();

}  // namespace grafverif::test
