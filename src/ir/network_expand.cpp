// SPDX-License-Identifier: MIT
// expand: each process gets a template of its own, its arguments written in place of the parameters. What an engine
// reads, and what the emitters' tests compare with.
#include "grafverif/ir/network.hpp"

namespace grafverif {

namespace {

/// Copies terms of one table into another under one meaning of the leaves; equal terms are copied once.
class Copier {
public:
    Copier(const Network& from, Network& to)
        : from_(from), to_(to), copies_(from.exprs.size()), process_(from.exprs.size(), 0) {}

    /// From here on, parameters mean the arguments of `process`.
    void enter(const Network::Process* process) {
        here_ = process;
        ++walk_;
    }

    Id<Expr> operator()(Id<Expr> root) {
        if (process_[root.index] == walk_) return copies_[root.index];
        const Id<Expr> result = copied(root);
        process_[root.index] = walk_;
        copies_[root.index] = result;
        return result;
    }

    template <class Constraints>
    Constraints constraints(Constraints list) {
        for (Network::ClockConstraint& constraint : list) constraint.bound = (*this)(constraint.bound);
        return list;
    }

    std::vector<Network::Assignment> assignments(std::vector<Network::Assignment> list) {
        for (auto& [target, value] : list) {
            target = (*this)(target);
            value = (*this)(value);
        }
        return list;
    }

private:
    Id<Expr> copied(Id<Expr> root) {
        const Expr& node = from_.exprs[root];
        if (node.op == Op::Parameter) return argument(static_cast<std::uint32_t>(node.value));
        if (node.op == Op::At) return to_.exprs.at(at_process(node), at_location(node));
        if (is_leaf(node.op)) return to_.exprs.leaf(node.op, static_cast<std::uint32_t>(node.value));
        if (node.op == Op::Integer) return to_.exprs.integer(node.value);
        if (node.op == Op::True || node.op == Op::False) return to_.exprs.constant(node.op == Op::True);
        std::vector<Id<Expr>> operands;
        operands.reserve(node.count);
        for (const Id<Expr> operand : from_.exprs.operands(root)) operands.push_back((*this)(operand));
        return to_.exprs.apply(node.op, operands);
    }

    Id<Expr> argument(std::uint32_t parameter) {
        const Network::Argument& argument = here_->arguments[parameter];
        if (const auto* variable = std::get_if<Id<Network::Variable>>(&argument))
            return to_.exprs.leaf(Op::Variable, variable->index);
        const std::int64_t value = std::get<std::int64_t>(argument);
        const Type& type = from_.templates[here_->automaton].parameters[{parameter}].type;
        return type.boolean ? to_.exprs.constant(value != 0) : to_.exprs.integer(value);
    }

    const Network& from_;
    Network& to_;
    const Network::Process* here_ = nullptr;
    std::vector<Id<Expr>> copies_;
    std::vector<std::uint32_t> process_;  // the walk in which a copy was made
    std::uint32_t walk_ = 0;
};

Network::Template expanded(const Network& network, const Network::Process& process, Copier& copy) {
    Network::Template automaton = network.templates[process.automaton];
    copy.enter(&process);
    automaton.name = process.name;
    automaton.parameters = {};
    automaton.initial = process.initial;
    for (Network::Location& location : automaton.locations)
        location.invariant = copy.constraints(std::move(location.invariant));
    for (Network::Procedure& procedure : automaton.procedures)
        procedure.assignments = copy.assignments(std::move(procedure.assignments));
    for (Network::Edge& edge : automaton.edges) {
        edge.guard = copy(edge.guard);
        edge.constraint = copy.constraints(std::move(edge.constraint));
        edge.assignments = copy.assignments(std::move(edge.assignments));
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

    Copier copy(network, flat);
    for (Network::Process& process : flat.processes) {
        process.automaton = flat.templates.add(expanded(network, process, copy));
        process.arguments.clear();
    }
    copy.enter(nullptr);
    for (Property& property : flat.properties)
        for (Id<Expr>& operand : property.operands) operand = copy(operand);
    if (network.settled.valid()) flat.settled = copy(network.settled);
    return flat;
}

}  // namespace grafverif
