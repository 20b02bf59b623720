// SPDX-License-Identifier: MIT
#include "support/uppaal_queries_reader.hpp"

namespace grafverif::test {
namespace {

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

void QueryReader::read(pugi::xml_node queries) {
    for (const pugi::xml_node query : queries.children("query")) {
        const std::string comment = query.child_value("comment"),
                          outcome = query.child("expect").attribute("outcome").value();
        const bool fails = holds(comment.substr(comment.find('\n')), "not satisfied");
        const bool agrees =
            outcome.empty() ? fails && holds(comment, "this step") : outcome == (fails ? "failure" : "success");
        if (!agrees) throw std::runtime_error("comment and expected outcome differ: " + comment);
        read_query(query.child_value("formula"), comment);
    }
}

void QueryReader::read_query(const std::string& formula, const std::string& comment) {
    const std::string title = comment.substr(0, comment.find('\n')), remarks = comment.substr(comment.find('\n') + 1);
    Property property;
    property.name = title.substr(0, title.find(": "));
    if (holds(title, ": ")) property.text = title.substr(title.find(": ") + 2);
    property.at_stable = holds(remarks, "in quiescent states; ");
    property.expected_violated = holds(remarks, "not satisfied");
    Cursor cursor(formula);
    if (remarks.starts_with("as written; ")) {
        property.pattern = Pattern::RawUppaal;
        property.raw = formula;
    } else if (remarks.starts_with("this step can become active; ")) {
        property.pattern = Pattern::ReachableAllSteps;
        property.name.erase(property.name.find('.'));
        cursor.expect("E<>");
        const Id<Expr> step = read_operand(cursor, property);
        const bool continues = !network_.properties.empty() && (network_.properties.end() - 1)->name == property.name;
        if (continues) return (network_.properties.end() - 1)->operands.push_back(step);
        property.operands = {step};
    } else {
        read_formula(cursor, property);
        if (!cursor.at_end()) throw std::runtime_error("unexpected text at the end of `" + formula + "`");
    }
    network_.properties.add(std::move(property));
}

void QueryReader::read_formula(Cursor& cursor, Property& property) {
    if (cursor.accept("A[]")) return read_universal(cursor, property);
    property.pattern = cursor.at("E<>")   ? Pattern::Reachable
                       : cursor.at("A<>") ? Pattern::Inevitable
                                          : Pattern::LeadsTo;
    if (property.pattern != Pattern::LeadsTo) cursor.take();
    property.operands.push_back(read_operand(cursor, property));
    if (property.pattern != Pattern::LeadsTo) return;
    cursor.expect("-->");
    property.operands.push_back(read_operand(cursor, property));
}

void QueryReader::read_universal(Cursor& cursor, Property& property) {
    if (property.at_stable) {
        network_.settled = terms_.primary(cursor);
        cursor.expect("imply");
    }
    if (cursor.accept("not")) {
        const bool deadlock = cursor.accept("deadlock");
        property.pattern = deadlock ? Pattern::NoDeadlock : Pattern::Never;
        if (!deadlock) property.operands = {terms_.primary(cursor)};
        return;
    }
    if (read_exactly_one(cursor, property)) return;
    property.pattern = Pattern::Always;
    property.operands = {property.at_stable ? terms_.primary(cursor) : terms_.term(cursor)};
}

/// Reads `a + !b + (c && d) == 1`, in which all terms are Boolean. Returns false for any other text, which
/// is then not read.
bool QueryReader::read_exactly_one(Cursor& cursor, Property& property) {
    const std::size_t start = cursor.mark();
    try {
        do property.operands.push_back(terms_.primary(cursor));
        while (cursor.accept("+"));
        cursor.expect("==");
        property.pattern = Pattern::ExactlyOneOf;
        if (cursor.number() == 1 && cursor.at_end() && is_boolean(property.operands[0])) return true;
    } catch (const std::runtime_error&) {
        // The text is not a sum of terms, so the query has another pattern.
    }
    property.operands.clear();
    cursor.back_to(start);
    return false;
}

/// Reads the operand of a query. With `at stable`, the query has the form `settled && operand`; the function then
/// stores `settled` in the network, and returns the operand.
Id<Expr> QueryReader::read_operand(Cursor& cursor, const Property& property) {
    if (!property.at_stable) return terms_.term(cursor);
    network_.settled = terms_.primary(cursor);
    cursor.expect("&&");
    return terms_.primary(cursor);
}

bool QueryReader::is_boolean(Id<Expr> term) const {
    const Expr& node = network_.exprs[term];
    if (node.op == Op::Variable) return network_.variables[{static_cast<std::uint32_t>(node.value)}].type.boolean;
    if (node.op == Op::Conditional) return is_boolean(network_.exprs.operands(term)[1]);
    return node.op != Op::Integer && !is_arithmetic(node.op);
}

}  // namespace grafverif::test
