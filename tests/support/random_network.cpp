// SPDX-License-Identifier: MIT
#include "support/random_network.hpp"

#include <array>

namespace grafverif {

namespace {

using Variable = Network::Variable;
using ParameterKind = Network::ParameterKind;

/// The leaves that a term may read: the variables, and the parameters of a template.
struct Leaves {
    std::vector<Id<Expr>> booleans = {}, integers = {};
    std::vector<Id<Expr>> constants = {};  ///< the integers that may bound a clock
};

struct Generator {
    Random& random;
    Network network = {};
    Type range = integer_type(-3, 9);
    Leaves globals = {};

    std::int64_t number(std::int64_t low, std::int64_t high) { return random_number(random, low, high); }
    bool often(int percent) { return chance(random, percent); }
    std::string numbered(const char* name, std::int64_t k) { return name + std::to_string(k); }

    template <class T>
    const T& pick(const std::vector<T>& from) {
        return from[static_cast<std::size_t>(number(0, static_cast<std::int64_t>(from.size()) - 1))];
    }
    template <class T>
    Id<T> pick_id(const Table<T>& from) {
        return {static_cast<std::uint32_t>(number(0, static_cast<std::int64_t>(from.size()) - 1))};
    }

    Id<Expr> integer_term(const Leaves& leaves, int depth) {
        Exprs& exprs = network.exprs;
        if (depth == 0 || often(40))
            return leaves.integers.empty() || often(40) ? exprs.integer(number(-3, 9)) : pick(leaves.integers);
        if (often(10)) return exprs.apply(Op::Negate, std::array{integer_term(leaves, depth - 1)});
        if (often(15))
            return exprs.conditional(boolean_term(leaves, depth - 1), integer_term(leaves, depth - 1),
                                     integer_term(leaves, depth - 1));
        const std::vector<Op> ops{Op::Plus, Op::Minus, Op::Times, Op::Divide, Op::Modulo};
        const Op op = pick(ops);
        const Id<Expr> left = integer_term(leaves, depth - 1);
        const bool divides = op == Op::Divide || op == Op::Modulo;
        return exprs.apply(op, left, divides ? exprs.integer(number(1, 4)) : integer_term(leaves, depth - 1));
    }

    Id<Expr> boolean_term(const Leaves& leaves, int depth) {
        Exprs& exprs = network.exprs;
        if (depth == 0 || often(30))
            return leaves.booleans.empty() || often(10) ? exprs.constant(often(50)) : pick(leaves.booleans);
        if (often(20)) return exprs.negation(boolean_term(leaves, depth - 1));
        if (often(30)) {
            const std::vector<Op> ops{Op::Equal, Op::NotEqual, Op::Less, Op::LessEqual, Op::Greater, Op::GreaterEqual};
            return exprs.apply(pick(ops), integer_term(leaves, depth - 1), integer_term(leaves, depth - 1));
        }
        if (often(10))
            return exprs.apply(often(50) ? Op::Equal : Op::NotEqual, boolean_term(leaves, depth - 1),
                               boolean_term(leaves, depth - 1));
        std::vector<Id<Expr>> operands;
        for (std::int64_t k = number(2, 3); k > 0; --k) operands.push_back(boolean_term(leaves, depth - 1));
        return often(50) ? exprs.conjunction(operands) : exprs.disjunction(operands);
    }

    void variables() {
        const std::int64_t count = number(3, 7);
        for (std::int64_t k = 0; k < count; ++k) {
            const bool boolean = k == 0 || (k > 1 && often(60));
            Variable variable{.name = numbered("v", k), .type = boolean ? Type{} : range};
            variable.initial = number(variable.type.low, variable.type.high);
            const Id<Variable> id = network.variables.add(variable);
            (boolean ? globals.booleans : globals.integers).push_back(network.exprs.leaf(Op::Variable, id.index));
        }
        for (std::int64_t k = number(0, 2); k > 0; --k)
            network.variables.add(
                {.name = numbered("scratch", k), .type = often(50) ? Type{} : range, .scratch = true});
    }

    Leaves add_parameters(Network::Template& automaton) {
        Leaves leaves = often(50) ? globals : Leaves{};
        for (std::int64_t k = number(0, 4); k > 0; --k) {
            const std::vector<ParameterKind> kinds{ParameterKind::Read, ParameterKind::Written,
                                                   ParameterKind::Constant};
            const ParameterKind kind = pick(kinds);
            const bool boolean = often(50);
            const Id<Network::Parameter> id =
                automaton.parameters.add({numbered("p", k), kind, boolean ? Type{} : range});
            const Id<Expr> leaf = network.exprs.leaf(Op::Parameter, id.index);
            (boolean ? leaves.booleans : leaves.integers).push_back(leaf);
            if (!boolean && kind == ParameterKind::Constant) leaves.constants.push_back(leaf);
        }
        return leaves;
    }

    Network::ClockConstraint bound(const Network::Template& automaton, const Leaves& leaves,
                                   std::vector<Op> relations) {
        const bool constant = leaves.constants.empty() || often(50);
        return {pick_id(automaton.clocks), pick(relations),
                constant ? network.exprs.integer(number(1, 5)) : pick(leaves.constants)};
    }

    /// Assigns writable variables. Scratch variables are used only in the form `x := value, y := x`.
    std::vector<Network::Assignment> assignments(const Network::Template& automaton, const Leaves& leaves) {
        std::vector<Network::Assignment> list;
        for (std::int64_t k = number(0, 3); k > 0; --k) {
            std::vector<Id<Expr>> targets = globals.booleans;
            targets.insert(targets.end(), globals.integers.begin(), globals.integers.end());
            for (const Id<Network::Parameter> id : automaton.parameters.ids())
                if (automaton.parameters[id].kind == ParameterKind::Written)
                    targets.push_back(network.exprs.leaf(Op::Parameter, id.index));
            const Id<Expr> target = pick(targets);
            Id<Expr> value = of_type(type_of(automaton, target), leaves);
            for (const Id<Variable> id : network.variables.ids()) {
                const Variable& scratch = network.variables[id];
                if (!scratch.scratch || scratch.type != type_of(automaton, target) || !often(30)) continue;
                list.push_back({network.exprs.leaf(Op::Variable, id.index), value});
                value = network.exprs.leaf(Op::Variable, id.index);
            }
            list.push_back({target, value});
        }
        return list;
    }

    Type type_of(const Network::Template& automaton, Id<Expr> leaf) const {
        const Expr& node = network.exprs[leaf];
        const auto index = static_cast<std::uint32_t>(node.value);
        return node.op == Op::Variable ? network.variables[{index}].type : automaton.parameters[{index}].type;
    }

    /// Returns a value that is usually in range, because engines stop at values out of range.
    Id<Expr> of_type(const Type& type, const Leaves& leaves) {
        if (type.boolean) return boolean_term(leaves, 2);
        if (often(20)) return integer_term(leaves, 1);
        return network.exprs.apply(Op::Modulo, integer_term(leaves, 2), network.exprs.integer(4));
    }

    void add_template(std::int64_t k) {
        Network::Template automaton;
        automaton.name = numbered("automaton", k);
        const Leaves leaves = add_parameters(automaton);
        for (std::int64_t c = number(0, 2); c > 0; --c) automaton.clocks.add({numbered("t", c)});
        const std::int64_t locations = number(1, 4);
        for (std::int64_t l = 0; l < locations; ++l) {
            Network::Location location{.name = numbered("l", l)};
            if (!automaton.clocks.empty() && l > 0 && often(40))
                location.invariant.push_back(bound(automaton, leaves, {Op::LessEqual, Op::LessEqual, Op::Less}));
            automaton.locations.add(std::move(location));
        }
        automaton.initial = {0};
        for (std::int64_t p = number(0, 2); p > 0; --p)
            automaton.procedures.add({numbered("act", p), assignments(automaton, leaves)});
        for (std::int64_t e = number(1, 6); e > 0; --e) add_edge(automaton, leaves);
        network.templates.add(std::move(automaton));
    }

    void add_edge(Network::Template& automaton, const Leaves& leaves) {
        Network::Edge edge{
            .from = pick_id(automaton.locations), .to = pick_id(automaton.locations), .urgent = often(40)};
        edge.guard = boolean_term(leaves, 3);
        if (!automaton.clocks.empty() && !edge.urgent && often(60))
            edge.constraint.push_back(
                bound(automaton, leaves, {Op::Less, Op::LessEqual, Op::Equal, Op::GreaterEqual, Op::Greater}));
        if (!automaton.clocks.empty() && often(40)) edge.resets.push_back(pick_id(automaton.clocks));
        for (const Network::ClockConstraint& bounded : automaton.locations[edge.to].invariant)
            if (edge.urgent && (edge.resets.empty() || edge.resets.front() != bounded.clock))
                edge.resets.push_back(bounded.clock);
        edge.assignments = assignments(automaton, leaves);
        if (!automaton.procedures.empty() && often(40)) edge.calls.push_back(pick_id(automaton.procedures));
        automaton.edges.add(std::move(edge));
    }

    void add_process(std::int64_t k) {
        Network::Process process{.name = numbered("P", k), .automaton = pick_id(network.templates)};
        const Network::Template& automaton = network.templates[process.automaton];
        for (const Network::Parameter& parameter : automaton.parameters) {
            const bool boolean = parameter.type.boolean;
            if (parameter.kind == ParameterKind::Constant)
                process.arguments.push_back(boolean ? number(0, 1) : number(1, 6));
            else
                process.arguments.push_back(Id<Variable>{static_cast<std::uint32_t>(
                    network.exprs[pick(boolean ? globals.booleans : globals.integers)].value)});
        }
        process.initial = automaton.locations[{0}].invariant.empty() ? Id<Network::Location>{0} : automaton.initial;
        if (often(30)) process.kind = Network::ProcessKind::Environment;
        network.processes.add(std::move(process));
    }

    void add_property(std::int64_t k) {
        Leaves leaves = globals;
        for (const Id<Network::Process> process : network.processes.ids())
            leaves.booleans.push_back(network.exprs.at(
                process.index, pick_id(network.templates[network.processes[process].automaton].locations).index));
        const std::vector<Pattern> patterns{Pattern::Always,      Pattern::Never,   Pattern::Reachable,
                                            Pattern::Inevitable,  Pattern::LeadsTo, Pattern::NoDeadlock,
                                            Pattern::ExactlyOneOf};
        Property property{
            .name = numbered("property", k), .text = often(50) ? "a <sentence> & more" : "", .pattern = pick(patterns)};
        const bool two = property.pattern == Pattern::LeadsTo || property.pattern == Pattern::ExactlyOneOf;
        const int operands = property.pattern == Pattern::NoDeadlock ? 0 : two ? 2 : 1;
        for (int i = 0; i < operands; ++i) property.operands.push_back(boolean_term(leaves, 2));
        property.at_stable = operands > 0 && often(20);
        property.expected_violated = often(20);
        network.properties.add(std::move(property));
    }
};

}  // namespace

Network random_network(Random& random) {
    Generator generator{random};
    Network& network = generator.network;
    network.name = "random";
    generator.variables();
    const std::int64_t templates = generator.number(1, 3);
    for (std::int64_t k = 0; k < templates; ++k) generator.add_template(k);
    const std::int64_t processes = generator.number(1, 4);
    for (std::int64_t k = 0; k < processes; ++k) generator.add_process(k);
    for (std::int64_t k = generator.number(0, 4); k > 0; --k) generator.add_property(k);
    Leaves& leaves = generator.globals;
    network.settled = generator.boolean_term(leaves, 2);
    return std::move(network);
}

}  // namespace grafverif
