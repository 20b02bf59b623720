// SPDX-License-Identifier: MIT
// Reads the conditions of transitions in PLCopen XML: inline Structured Text, a named transition of the POU, or a
// connected network of a Function Block Diagram (FBD) or Ladder Diagram (LD).
#include "read/plcopen/values.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

/// Reads a condition in Structured Text: an expression or, for a named transition, an assignment
/// `NAME := EXPRESSION;`.
Id<st::Expr> structured(PlcopenReader& reader, pugi::xml_node text) {
    const st::Text pieces = reader.xml.text(text);
    const std::string content = reader.xml.content(text);
    const std::size_t assign = content.find(":=");
    if (assign == std::string::npos) return reader.expression(pieces);
    const st::Block block = reader.statements(pieces);
    if (block.size() != 1 || reader.file.statements[block.front()].kind != st::StatementKind::Assign) return {};
    return reader.file.statements[block.front()].value;
}

/// Reads the body of a condition: Structured Text, or an LD or FBD network. The network must end in one coil or
/// variable; its value is the condition.
Id<st::Expr> body_condition(PlcopenReader& reader, pugi::xml_node body, Span where) {
    if (const pugi::xml_node text = child(body, "ST")) return structured(reader, text);
    for (const std::string_view language : {"LD", "FBD"}) {
        const pugi::xml_node diagram = child(body, language);
        if (!diagram) continue;
        const PlcopenNetwork network = network_of(reader, diagram);
        std::vector<pugi::xml_node> ends;
        for (const pugi::xml_node& element : network.elements)
            if (is(element, "coil") || is(element, "outVariable")) ends.push_back(element);
        if (ends.size() == 1) return PlcopenValues(reader, network).into(ends.front());
        reader.refuse(where, "a network that does not end in exactly one coil or variable",
                      "end it in one coil or variable");
        return {};
    }
    reader.refuse(where, "a condition in a language other than Structured Text, LD and FBD",
                  "write it in Structured Text");
    return {};
}

}  // namespace

Id<st::Expr> condition_of(PlcopenReader& reader, const st::Unit&, const PlcopenNetwork& network,
                          pugi::xml_node transition) {
    const pugi::xml_node condition = child(transition, "condition");
    const Span where = reader.xml.where(condition ? condition : transition);
    const std::size_t errors = reader.diagnostics().errors();
    Id<st::Expr> found;
    if (const pugi::xml_node reference = child(condition, "reference")) {
        // If the POU has no transition with this name, the name denotes a Boolean variable.
        pugi::xml_node pou = transition;
        while (pou && !is(pou, "pou")) pou = pou.parent();
        const std::string wanted = st::capitals(value(reference, "name"));
        pugi::xml_node named;
        for (const pugi::xml_node& one : children(child(pou, "transitions"), "transition"))
            if (st::capitals(value(one, "name")) == wanted) named = one;
        found = named ? body_condition(reader, child(named, "body"), reader.xml.where(named))
                      : reader.expression(reader.xml.text(reference, "name"));
    } else if (const pugi::xml_node inner = child(condition, "inline")) {
        found = body_condition(reader, inner, reader.xml.where(inner));
    } else if (child(condition, "connectionPointIn")) {
        found = PlcopenValues(reader, network).at(condition);
    } else if (!children(condition, "connection").empty()) {  // PLCopen XML, version 1.01
        for (const pugi::xml_node& connection : children(condition, "connection")) {
            const pugi::xml_node source = network.find(value(connection, "refLocalId"));
            if (!source)
                reader.diagnostics().add(messages::dangling_reference(reader.xml.where(connection, "refLocalId"),
                                                                      value(connection, "refLocalId"), "element"));
            else found = PlcopenValues(reader, network).from(source);
        }
    } else if (child(condition, "ST")) {
        found = structured(reader, child(condition, "ST"));
    }
    if (!found.valid() && reader.diagnostics().errors() == errors && !reader.draft.lossy())
        reader.diagnostics().add(messages::missing_part(where, "this transition", "condition"));
    if (found.valid() && reader.flag(condition, "negated")) return reader.make(st::Op::Not, {found}, where);
    return found;
}

}  // namespace grafverif
