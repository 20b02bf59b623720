// SPDX-License-Identifier: MIT
#include "read/plcopen/plcopen.hpp"

#include <string>

#include "read/plcopen/network.hpp"
#include "support/messages.hpp"

namespace grafverif {

Id<st::Expr> PlcopenReader::expression(const st::Text& text) {
    return st::parse_expression(text, file, sources, diagnostics()).value_or(Id<st::Expr>{});
}

st::Block PlcopenReader::statements(const st::Text& text) {
    return st::parse_statements(text, file, sources, diagnostics()).value_or(st::Block{});
}

Id<st::Expr> PlcopenReader::make(st::Op op, const std::vector<Id<st::Expr>>& operands, Span where) {
    st::Expr expr;
    expr.op = op;
    expr.where = where;
    const Id<st::Expr> id = file.exprs.add(expr);
    for (const Id<st::Expr> one : operands) st::append(file.exprs, id, one);
    return id;
}

namespace {

st::Section section_of(std::string_view list) {
    if (list == "inputVars") return st::Section::Input;
    if (list == "outputVars") return st::Section::Output;
    if (list == "inOutVars") return st::Section::InOut;
    if (list == "externalVars") return st::Section::External;
    if (list == "globalVars") return st::Section::Global;
    if (list == "tempVars") return st::Section::Temporary;
    return st::Section::Local;
}

st::Type type_of(PlcopenReader& reader, pugi::xml_node type) {
    st::Type made;
    for (const pugi::xml_node& one : type.children()) {
        if (one.type() != pugi::node_element) continue;
        const std::string_view name = local_name(one.name());
        const std::string text = name == "derived" ? value(one, "name") : std::string(name);
        made.name = reader.name(text, reader.xml.where(one));
        made.composite = name == "array" || name == "pointer" || name == "struct" || name == "enum";
        if (name == "subrangeSigned" || name == "subrangeUnsigned") {
            const pugi::xml_node range = child(one, "range");
            made.name = reader.name("INT", reader.xml.where(one));
            made.low = reader.expression(reader.xml.text(range, "lower"));
            made.high = reader.expression(reader.xml.text(range, "upper"));
        }
    }
    if (!made.name.valid()) made.name = reader.name("?", reader.xml.where(type));
    return made;
}

void read_variables(PlcopenReader& reader, pugi::xml_node list, std::vector<st::Variable>& variables) {
    for (const pugi::xml_node& node : children(list, "variable")) {
        st::Variable variable;
        variable.section = section_of(local_name(list.name()));
        variable.constant = reader.flag(list, "constant");
        variable.name = reader.name(value(node, "name"), reader.xml.where(node, "name"));
        variable.type = type_of(reader, child(node, "type"));
        variable.address = value(node, "address");
        variable.where = reader.xml.where(node);
        if (const pugi::xml_node text = child(node, "documentation")) variable.comment = reader.xml.content(text);
        const pugi::xml_node initial = child(child(node, "initialValue"), "simpleValue");
        const std::string type = st::capitals(reader.file.text(variable.type.name));
        const bool simple = type == "BOOL" || type == "TIME" || type.ends_with("INT") || type.ends_with("BYTE") ||
                            type.ends_with("WORD");
        if (initial && simple && !variable.type.composite)
            variable.initial = reader.expression(reader.xml.text(initial, "value"));
        variables.push_back(std::move(variable));
    }
}

/// Reads the actions of the POU in Structured Text; actions in other languages are rejected at their uses.
void read_actions(PlcopenReader& reader, pugi::xml_node pou, st::Unit& unit) {
    for (const pugi::xml_node& node : children(child(pou, "actions"), "action")) {
        st::Action action;
        action.name = reader.name(value(node, "name"), reader.xml.where(node, "name"));
        action.where = reader.xml.where(node);
        const pugi::xml_node text = child(child(node, "body"), "ST");
        if (text) action.body = reader.statements(reader.xml.text(text));
        else action.opaque = true;
        unit.actions.push_back(std::move(action));
    }
}

/// Comments of the drawing and XML comments are placed before the chart.
std::string remarks(PlcopenReader& reader, pugi::xml_node pou) {
    std::string text;
    if (const pugi::xml_node documentation = child(pou, "documentation"))
        text = reader.xml.content(documentation) + '\n';
    const pugi::xml_node chart = child(child(pou, "body"), "SFC");
    for (const pugi::xml_node& node : chart.children()) {
        if (is(node, "comment")) text += reader.xml.content(child(node, "content")) + '\n';
        if (node.type() == pugi::node_comment) text += std::string(node.value()) + '\n';
    }
    return text;
}

}  // namespace

st::File read_plcopen(const Xml& xml, const Sources& sources, Draft& draft) {
    PlcopenReader reader{xml, sources, draft};
    reader.file.source = xml.source();
    std::vector<pugi::xml_node> pous;
    pugi::xml_node program;  // in Structured Text; reported if there is no chart
    for (pugi::xml_node node = xml.root().first_child(); node;) {
        if (is(node, "globalVars")) read_variables(reader, node, reader.file.globals);
        if (is(node, "pou") && child(child(node, "body"), "SFC")) pous.push_back(node);
        if (is(node, "pou") && child(child(node, "body"), "ST") && !program) program = node;
        const bool enter = node.first_child() && !is(node, "pou");
        if (enter) {
            node = node.first_child();
            continue;
        }
        while (node && node != xml.root() && !node.next_sibling()) node = node.parent();
        node = node == xml.root() ? pugi::xml_node() : node.next_sibling();
    }
    for (const pugi::xml_node& pou : pous) {
        st::Unit unit;
        unit.kind = value(pou, "pouType") == "program" ? st::UnitKind::Program : st::UnitKind::FunctionBlock;
        unit.name = reader.name(value(pou, "name"), xml.where(pou, "name"));
        unit.where = xml.where(pou);
        unit.comment = remarks(reader, pou);
        for (const pugi::xml_node& list : child(pou, "interface").children())
            if (list.type() == pugi::node_element && local_name(list.name()).ends_with("Vars"))
                read_variables(reader, list, unit.variables);
        read_actions(reader, pou, unit);
        read_network(reader, unit, child(child(pou, "body"), "SFC"), {});
        reader.file.units.push_back(std::move(unit));
    }
    if (pous.empty() && program) {
        st::Unit unit;
        unit.name = reader.name(value(program, "name"), xml.where(program, "name"));
        unit.where = xml.where(program);
        reader.file.units.push_back(std::move(unit));
    }
    return std::move(reader.file);
}

}  // namespace grafverif
