// SPDX-License-Identifier: MIT
// Terms, constraints and assignments in UPPAAL syntax.
#include "emit/uppaal/text.hpp"

#include <ostream>

#include "emit/wrapped_text.hpp"

namespace grafverif::uppaal {
namespace {

std::string_view token(Op relation) { return uppaal_spelling(relation).token; }

LeafPrinter leaf_printer(const Network& network, const Names& names, Id<Network::Template> automaton) {
    return [&network, &names, automaton](std::ostream& out, const Expr& node) {
        const auto index = static_cast<std::size_t>(node.value);
        if (node.op == Op::Variable) {
            out << names.variables[index];
            return;
        }
        if (node.op == Op::Parameter) {
            out << names.locals[automaton.index].parameters[index];
            return;
        }
        const Id<Network::Process> process{at_process(node)};
        const LocalNames& local = names.locals[network.processes[process].automaton.index];
        out << names.processes[process.index] << '.' << local.locations[at_location(node)];
    };
}

const std::vector<std::string>& clock_names(const Names& names, Id<Network::Template> automaton) {
    return names.locals[automaton.index].clocks;
}

}  // namespace

Terms::Terms(const Network& network, const Names& names, Id<Network::Template> automaton)
    : network_(&network), names_(&names), automaton_(automaton), leaf_(leaf_printer(network, names, automaton)) {}

void Terms::write(std::ostream& out, Id<Expr> root) const {
    print_expr(out, network_->exprs, root, uppaal_spelling, leaf_);
}

std::string Terms::text(Id<Expr> root) const { return expr_text(network_->exprs, root, uppaal_spelling, leaf_); }

std::string Terms::bracketed(Id<Expr> root) const {
    const Op op = network_->exprs[root].op;
    return op == Op::Not || uppaal_spelling(op).precedence == atom_precedence ? text(root) : '(' + text(root) + ')';
}

std::string Terms::text(const std::vector<Network::ClockConstraint>& constraints) const {
    std::string joined;
    for (const auto& [clock, relation, bound] : constraints) {
        if (!joined.empty()) joined += " && ";
        joined += clock_names(*names_, automaton_)[clock.index];
        joined += ' ';
        joined += token(relation);
        joined += ' ';
        joined += is_comparison(network_->exprs[bound].op) ? bracketed(bound) : text(bound);
    }
    return joined;
}

std::string Terms::text(const Network::Assignment& assignment) const {
    return text(assignment.target) + " = " + text(assignment.value);
}

void Terms::write_statement(std::ostream& out, const Network::Assignment& assignment) const {
    const Exprs& exprs = network_->exprs;
    Id<Expr> value = assignment.value;
    for (; exprs[value].op == Op::Conditional; value = exprs.operands(value)[2]) {
        out << "if (";
        write(out, exprs.operands(value)[0]);
        out << ") ";
        write(out, assignment.target);
        out << " = ";
        write(out, exprs.operands(value)[1]);
        out << ';';
        if (exprs.operands(value)[2] == assignment.target) return;
        out << " else ";
    }
    write(out, assignment.target);
    out << " = ";
    write(out, value);
    out << ';';
}

std::vector<std::string> lines_of(std::string_view text, std::size_t width) {
    const auto lines = wrapped(text, width, [](std::string_view before) {
        return before.ends_with(',') || before.ends_with(" &&") || before.ends_with(" ||");
    });
    return {lines.begin(), lines.end()};
}

}  // namespace grafverif::uppaal
