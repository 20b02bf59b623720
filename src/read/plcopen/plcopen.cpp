// SPDX-License-Identifier: MIT
#include "read/plcopen/plcopen.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>
#include <optional>
#include <regex>
#include <string>
#include <unordered_set>

#include "read/plcopen/diagram.hpp"
#include "read/plcopen/network.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"

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

void PlcopenReader::refuse(Span where, std::string_view what, std::string_view hint) {
    if (of_program) diagnostics().add(messages::not_in_program(where, what, hint));
    else draft.refuse(where, what, hint);
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
            if (const pugi::xml_node base = child(one, "baseType"); base && reader.of_program)
                made.name = type_of(reader, base).name;
            made.low = reader.expression(reader.xml.text(range, "lower"));
            made.high = reader.expression(reader.xml.text(range, "upper"));
        }
        if (name == "array" && reader.of_program) {
            made = type_of(reader, child(one, "baseType"));
            made.composite = true;
            std::vector<std::array<Id<st::Expr>, 2>> dimensions;
            for (const pugi::xml_node& dimension : children(one, "dimension"))
                dimensions.push_back({reader.expression(reader.xml.text(dimension, "lower")),
                                      reader.expression(reader.xml.text(dimension, "upper"))});
            made.dimensions.insert(made.dimensions.begin(), dimensions.begin(), dimensions.end());
        }
        if (name == "enum" && reader.of_program)
            for (const pugi::xml_node& value_node : children(child(one, "values"), "value")) {
                if (attribute(value_node, "value"))
                    reader.refuse(reader.xml.where(value_node, "value"), "an explicit number of an enumeration value",
                                  "remove the attribute `value`");
                made.values.push_back(reader.name(value(value_node, "name"), reader.xml.where(value_node, "name")));
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
        variable.retain = reader.flag(list, "retain") || reader.flag(list, "persistent");
        variable.name = reader.name(value(node, "name"), reader.xml.where(node, "name"));
        variable.type = type_of(reader, child(node, "type"));
        variable.address = value(node, "address");
        variable.where = reader.xml.where(node);
        if (const pugi::xml_node text = child(node, "documentation")) variable.comment = reader.xml.content(text);
        const pugi::xml_node initial = child(child(node, "initialValue"), "simpleValue");
        const std::string type = st::capitals(reader.file.text(variable.type.name));
        const bool simple = type == "BOOL" || type == "TIME" || type.ends_with("INT") || type.ends_with("BYTE") ||
                            type.ends_with("WORD");
        if (reader.of_program && child(node, "initialValue") && !initial)
            reader.refuse(reader.xml.where(child(node, "initialValue")), "the initial value of an array or structure",
                          "assign the elements in the program");
        if (initial && (simple || reader.of_program) && !variable.type.composite)
            variable.initial = reader.expression(reader.xml.text(initial, "value"));
        variables.push_back(std::move(variable));
    }
}

/// Returns a unit for a POU, with the type, name and variables of the POU.
st::Unit unit_of(PlcopenReader& reader, pugi::xml_node pou) {
    st::Unit unit;
    const std::string kind = value(pou, "pouType");
    unit.kind = kind == "program"                         ? st::UnitKind::Program
                : kind == "function" && reader.of_program ? st::UnitKind::Function
                                                          : st::UnitKind::FunctionBlock;
    unit.name = reader.name(value(pou, "name"), reader.xml.where(pou, "name"));
    unit.where = reader.xml.where(pou);
    for (const pugi::xml_node& list : child(pou, "interface").children())
        if (list.type() == pugi::node_element && local_name(list.name()).ends_with("Vars"))
            read_variables(reader, list, unit.variables);
    return unit;
}

/// Reads the actions of a POU: actions in Structured Text and, in CODESYS programs, actions that are charts. A later
/// stage rejects actions in other languages.
void read_actions(PlcopenReader& reader, pugi::xml_node pou, st::Unit& unit) {
    for (const pugi::xml_node& node : children(child(pou, "actions"), "action")) {
        st::Action action;
        action.name = reader.name(value(node, "name"), reader.xml.where(node, "name"));
        action.where = reader.xml.where(node);
        const pugi::xml_node text = child(child(node, "body"), "ST"), chart = child(child(node, "body"), "SFC");
        if (text) action.body = reader.statements(reader.xml.text(text));
        else if (chart && reader.is_codesys_program()) action.networks = read_network(reader, unit, chart);
        else action.opaque = true;
        unit.actions.push_back(std::move(action));
    }
}

/// Returns the `documentation` of a POU, and the comments and XML comments of its drawing. The importer writes the
/// documentation and the comments before the chart.
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

/// Returns the descendants of `root` with one of the names, in the order of the file. Does not search the descendants
/// of a returned element.
std::vector<pugi::xml_node> all_of(pugi::xml_node root, std::initializer_list<std::string_view> names) {
    std::vector<pugi::xml_node> found;
    for (pugi::xml_node node = root.first_child(); node;) {
        const bool wanted = std::ranges::find(names, local_name(node.name())) != names.end();
        if (wanted) found.push_back(node);
        if (node.first_child() && !wanted) {
            node = node.first_child();
            continue;
        }
        while (node && node != root && !node.next_sibling()) node = node.parent();
        node = node == root ? pugi::xml_node() : node.next_sibling();
    }
    return found;
}

}  // namespace

st::File read_plcopen(const Xml& xml, const Sources& sources, Draft& draft) {
    PlcopenReader reader{xml, sources, draft};
    reader.file.source = xml.source();
    std::vector<pugi::xml_node> pous;
    pugi::xml_node program;  // first POU in Structured Text, for the error message of a file without charts
    for (const pugi::xml_node& node : all_of(xml.root(), {"globalVars", "pou"})) {
        if (is(node, "globalVars")) read_variables(reader, node, reader.file.globals);
        else if (child(child(node, "body"), "SFC")) pous.push_back(node);
        else if (child(child(node, "body"), "ST") && !program) program = node;
    }
    for (const pugi::xml_node& pou : pous) {
        st::Unit unit = unit_of(reader, pou);
        unit.comment = remarks(reader, pou);
        read_actions(reader, pou, unit);
        unit.networks = read_network(reader, unit, child(child(pou, "body"), "SFC"));
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

namespace {

void read_body(PlcopenReader& reader, pugi::xml_node pou, st::Unit& unit,
               const std::unordered_set<std::string>& functions) {
    const std::vector<pugi::xml_node> bodies = children(pou, "body");
    if (bodies.size() > 1) reader.refuse(reader.xml.where(bodies[1]), "a second body of a unit", "combine the bodies");
    const pugi::xml_node body = bodies.empty() ? pugi::xml_node() : bodies.front();
    const pugi::xml_node chart = child(body, "SFC");
    read_actions(reader, pou, unit);
    for (const pugi::xml_node& node : body.children()) {
        if (node.type() != pugi::node_element || is(node, "addData") || is(node, "documentation")) continue;
        if (is(node, "ST")) unit.body = reader.statements(reader.xml.text(node));
        else if (is(node, "LD") || is(node, "FBD")) unit.body = statements_of(reader, unit, node, functions);
        else if (node == chart) unit.networks = read_network(reader, unit, node);
        else
            reader.refuse(reader.xml.where(node), "a body in `" + std::string(local_name(node.name())) + '`',
                          "write it in Structured Text, LD, FBD or SFC");
    }
}

/// Converts an xsd:duration in days and smaller units, such as `PT0.01S`, to milliseconds. The result is empty for
/// other texts.
std::optional<std::int64_t> milliseconds(const std::string& text) {
    static const std::regex pattern(
        R"(P(?:(\d{1,6})D)?(?:T(?:(\d{1,6})H)?(?:(\d{1,6})M)?(?:(\d{1,6})(?:\.(\d{1,3})0*)?S)?)?)");
    std::smatch match;
    if (text.size() > 64 || !std::regex_match(text, match, pattern)) return {};
    std::int64_t total = 0;
    constexpr std::array<std::int64_t, 4> units = {86'400'000, 3'600'000, 60'000, 1'000};
    for (std::size_t i = 0; i < units.size(); ++i)
        if (match[i + 1].matched) total += std::stoll(match[i + 1].str()) * units[i];
    if (match[5].matched) total += std::stoll((match[5].str() + "00").substr(0, 3));
    return total;
}

/// Returns the interval of a task. The attribute contains a duration of IEC 61131-3 or of XML Schema.
Id<st::Expr> interval_of(PlcopenReader& reader, pugi::xml_node task) {
    auto known = milliseconds(value(task, "interval"));
    for (const pugi::xml_node& data : children(child(task, "addData"), "data")) {  // settings of CODESYS
        const pugi::xml_node settings = child(data, "TaskSettings");
        const std::string kind = value(settings, "KindOfTask"), unit = value(settings, "IntervalUnit");
        if (!settings) continue;
        if (kind != "Cyclic" && kind != "Freewheeling")
            reader.refuse(reader.xml.where(settings, "KindOfTask"), "an event-triggered task",
                          "give the task an interval");
        if (kind != "Cyclic" || value(settings, "Interval").empty()) continue;
        const std::int64_t factor = unit == "us" ? 1 : unit == "ms" ? 1000 : unit == "s" ? 1'000'000 : 0;
        const std::string text = value(settings, "Interval");
        std::int64_t number = 0;
        const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (factor == 0 || failure != std::errc() || end != text.data() + text.size() || number <= 0 ||
            number > 1'000'000'000 || number * factor % 1000 != 0) {
            reader.refuse(reader.xml.where(settings, "Interval"), "this interval of a task",
                          "use a positive whole number of milliseconds");
            continue;
        }
        known = number * factor / 1000;
    }
    if (!known) return reader.expression(reader.xml.text(task, "interval"));
    const Id<st::Expr> interval = reader.make(st::Op::Time, {}, reader.xml.where(task, "interval"));
    reader.node(interval).value = *known;
    return interval;
}

void read_tasks(PlcopenReader& reader, pugi::xml_node resource) {
    const auto instance = [&](pugi::xml_node node, st::Name task) {
        const std::string_view type = !value(node, "typeName").empty() ? "typeName"
                                      : attribute(node, "type")        ? "type"
                                                                : "name";  // CODESYS writes the type in this attribute
        reader.file.instances.push_back({reader.name(value(node, "name"), reader.xml.where(node, "name")),
                                         task,
                                         reader.name(value(node, type), reader.xml.where(node, type)),
                                         {},
                                         reader.xml.where(node)});
    };
    for (const pugi::xml_node& node : children(resource, "task")) {
        st::Task task{reader.name(value(node, "name"), reader.xml.where(node, "name")), {}, reader.xml.where(node)};
        if (const pugi::xml_attribute single = attribute(node, "single"); single && *single.value() != '\0')
            reader.refuse(reader.xml.where(node, "single"), "an event-triggered task", "give the task an interval");
        if (attribute(node, "interval")) {
            const Id<st::Expr> interval = interval_of(reader, node);
            if (interval.valid()) {
                const Id<st::Expr> argument =
                    reader.make(st::Op::Argument, {interval}, reader.xml.where(node, "interval"));
                reader.node(argument).word = reader.file.intern("INTERVAL");
                task.arguments.push_back(argument);
            }
        }
        for (const pugi::xml_node& each : children(node, "pouInstance")) instance(each, task.name);
        reader.file.tasks.push_back(std::move(task));
    }
    for (const pugi::xml_node& each : children(resource, "pouInstance")) instance(each, {});
}

/// True if CODESYS, or a tool based on CODESYS, wrote the file: the file then contains `data` elements whose names
/// begin with the web address of the vendor.
bool is_codesys(pugi::xml_node root) {
    for (const pugi::xml_node& data : all_of(root, {"data"}))
        if (value(data, "name").starts_with("http://www.3s-software.com/plcopenxml/")) return true;
    return false;
}

/// Reads a data type of the project.
void read_type(PlcopenReader& reader, pugi::xml_node node) {
    st::TypeDeclaration made;
    made.name = reader.name(value(node, "name"), reader.xml.where(node, "name"));
    made.where = reader.xml.where(node);
    made.type = type_of(reader, child(node, "baseType"));
    const pugi::xml_node structure = child(child(node, "baseType"), "struct");
    made.structure = bool(structure);
    if (structure) read_variables(reader, structure, made.members);
    if (const pugi::xml_node initial = child(child(node, "initialValue"), "simpleValue"))
        made.initial = reader.expression(reader.xml.text(initial, "value"));
    else if (child(node, "initialValue"))
        reader.refuse(reader.xml.where(child(node, "initialValue")), "the initial value of an array or structure",
                      "assign the elements in the program");
    reader.file.types.push_back(std::move(made));
}

}  // namespace

st::File read_plcopen_program(const Xml& xml, const Sources& sources, Diagnostics& diagnostics) {
    Draft draft(xml.source(), false, diagnostics);
    PlcopenReader reader{xml, sources, draft, true};
    reader.file.source = xml.source();
    if (is_codesys(xml.root())) reader.file.dialect = st::Dialect::Codesys;
    for (const pugi::xml_node& type : all_of(xml.root(), {"dataType"})) read_type(reader, type);
    for (const pugi::xml_node& list : all_of(xml.root(), {"globalVars"})) {
        if (attribute(list, "name"))
            reader.file.global_lists.push_back(reader.name(value(list, "name"), xml.where(list, "name")));
        read_variables(reader, list, reader.file.globals);
    }
    const std::vector<pugi::xml_node> pous = all_of(xml.root(), {"pou"});
    std::unordered_set<std::string> functions;
    for (const pugi::xml_node& pou : pous)
        if (value(pou, "pouType") == "function") functions.insert(st::capitals(value(pou, "name")));
    for (const pugi::xml_node& pou : pous) {
        st::Unit unit = unit_of(reader, pou);
        if (const pugi::xml_node result = child(child(pou, "interface"), "returnType"))
            unit.result = type_of(reader, result);
        read_body(reader, pou, unit, functions);
        reader.file.units.push_back(std::move(unit));
    }
    for (const pugi::xml_node& resource : all_of(xml.root(), {"resource"})) read_tasks(reader, resource);
    return std::move(reader.file);
}

}  // namespace grafverif
