// SPDX-License-Identifier: MIT
// Conditions of transitions in PLCopen XML: inline Structured Text, a named transition of the POU, or a connected
// network (FBD, LD) of variables, contacts, and blocks for Boolean and arithmetic functions.
#include <algorithm>
#include <array>

#include "read/plcopen/network.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

constexpr std::size_t deepest_network = 200;

struct Function {
    std::string_view name = {};
    st::Op op = st::Op::And;
};
constexpr std::array<Function, 14> functions = {{{"AND", st::Op::And},
                                                 {"OR", st::Op::Or},
                                                 {"XOR", st::Op::Xor},
                                                 {"ADD", st::Op::Plus},
                                                 {"SUB", st::Op::Minus},
                                                 {"MUL", st::Op::Times},
                                                 {"DIV", st::Op::Divide},
                                                 {"MOD", st::Op::Modulo},
                                                 {"GT", st::Op::Greater},
                                                 {"GE", st::Op::GreaterEqual},
                                                 {"EQ", st::Op::Equal},
                                                 {"NE", st::Op::NotEqual},
                                                 {"LE", st::Op::LessEqual},
                                                 {"LT", st::Op::Less}}};

class Connected {
public:
    Connected(PlcopenReader& reader, const PlcopenNetwork& network) : reader_(reader), network_(network) {}

    /// Value at a connection point; several incoming lines form an OR. Invalid if it is not connected.
    Id<st::Expr> at(pugi::xml_node point, std::size_t depth = 0) {
        std::vector<Id<st::Expr>> lines;
        for (const pugi::xml_node& source : sources_of(reader_, network_, point)) {
            const Id<st::Expr> one = of(source, depth + 1);
            if (!one.valid()) return {};
            lines.push_back(one);
        }
        if (lines.empty()) return {};
        return lines.size() == 1 ? lines.front() : reader_.make(st::Op::Or, lines, reader_.xml.where(point));
    }

    Id<st::Expr> from(pugi::xml_node source) { return of(source, 0); }

    /// Value assigned to the coil or variable at the end of the network.
    Id<st::Expr> into(pugi::xml_node end) { return passes_on(end) ? negated(end, at(end)) : Id<st::Expr>{}; }

private:
    Id<st::Expr> of(pugi::xml_node node, std::size_t depth) {
        const Span where = reader_.xml.where(node);
        if (depth > deepest_network) {
            reader_.draft.refuse(where, "a cyclic network, or one with more than 200 levels", "simplify it");
            return {};
        }
        if (is(node, "inVariable")) return variable(node, "negated");
        if (is(node, "inOutVariable")) return variable(node, "negatedOut");
        if (is(node, "leftPowerRail")) return reader_.make(st::Op::True, {}, where);
        if (is(node, "connector") || is(node, "continuation")) return at(node, depth);
        if (is(node, "contact")) return contact(node, depth);
        if (is(node, "block")) return block(node, depth);
        reader_.draft.refuse(where, "a `" + std::string(local_name(node.name())) + "` in a condition",
                             "write the condition in Structured Text");
        return {};
    }

    Id<st::Expr> negated(pugi::xml_node node, Id<st::Expr> term, std::string_view mark = "negated") {
        if (!term.valid() || !reader_.flag(node, mark)) return term;
        return reader_.make(st::Op::Not, {term}, reader_.xml.where(node));
    }

    /// True if a variable, contact, coil or pin passes a value without an edge, set or reset.
    bool passes_on(pugi::xml_node node) {
        for (const std::string_view mark : {"edge", "edgeIn", "edgeOut", "storage", "storageIn", "storageOut"}) {
            const std::string how = value(node, mark);
            if (how.empty() || how == "none") continue;
            const bool edge = mark.starts_with("edge");
            reader_.draft.refuse(
                reader_.xml.where(node, mark),
                edge ? "an edge in the network of a condition" : "a value stored in the network of a condition",
                edge ? "store the previous value in a variable of the chart" : "store it in an action");
            return false;
        }
        return true;
    }

    Id<st::Expr> variable(pugi::xml_node node, std::string_view mark) {
        if (!passes_on(node)) return {};
        if (!sources_of(reader_, network_, node).empty()) {
            reader_.draft.refuse(reader_.xml.where(node), "a variable that a condition assigns",
                                 "assign it in an action");
            return {};
        }
        return negated(node, reader_.expression(reader_.xml.text(child(node, "expression"))), mark);
    }

    Id<st::Expr> contact(pugi::xml_node node, std::size_t depth) {
        if (!passes_on(node)) return {};
        const Id<st::Expr> own = negated(node, reader_.expression(reader_.xml.text(child(node, "variable"))));
        const Id<st::Expr> before = wired(node, depth, "this contact");
        if (!own.valid() || !before.valid()) return {};
        if (reader_.node(before).op == st::Op::True) return own;
        return reader_.make(st::Op::And, {before, own}, reader_.xml.where(node));
    }

    /// Like at(), but reports an unconnected point.
    Id<st::Expr> wired(pugi::xml_node point, std::size_t depth, std::string_view what) {
        if (!sources_of(reader_, network_, point).empty()) return at(point, depth);
        reader_.diagnostics().add(messages::missing_part(reader_.xml.where(point), what, "connection"));
        return {};
    }

    Id<st::Expr> unsupported(pugi::xml_node block, std::string_view what) {
        reader_.draft.refuse(reader_.xml.where(block, "typeName"), what, "write the condition in Structured Text");
        return {};
    }

    Id<st::Expr> block(pugi::xml_node node, std::size_t depth) {
        const std::string type = st::capitals(value(node, "typeName"));
        const auto* function = std::ranges::find(functions, type, &Function::name);
        if (type != "NOT" && function == functions.end())
            return unsupported(node, "the block `" + value(node, "typeName") + "` in a condition");
        std::vector<Id<st::Expr>> inputs;
        for (const pugi::xml_node& pin : children(child(node, "inputVariables"), "variable")) {
            if (!passes_on(pin)) return {};
            if (st::capitals(value(pin, "formalParameter")) == "EN")
                return unsupported(node, "a block with a separate enable condition");
            const Id<st::Expr> one = negated(pin, wired(pin, depth, "an input of this block"));
            if (!one.valid()) return {};
            inputs.push_back(one);
        }
        const std::vector<pugi::xml_node> outputs = children(child(node, "outputVariables"), "variable");
        if (outputs.size() > 1) return unsupported(node, "a block with several outputs in a condition");
        const bool any_number = type == "AND" || type == "OR" || type == "XOR" || type == "ADD" || type == "MUL";
        const std::size_t wanted = type == "NOT" ? 1 : 2;
        const Span where = reader_.xml.where(node, "typeName");
        if (inputs.size() < wanted || (inputs.size() > wanted && !any_number)) {
            reader_.diagnostics().add(messages::bad_value(where, "number of inputs of this block",
                                                          std::to_string(inputs.size()),
                                                          wanted == 1  ? "one"
                                                          : any_number ? "at least two"
                                                                       : "two"));
            return {};
        }
        const Id<st::Expr> found = reader_.make(type == "NOT" ? st::Op::Not : function->op, inputs, where);
        if (outputs.empty()) return found;
        return passes_on(outputs.front()) ? negated(outputs.front(), found) : Id<st::Expr>{};
    }

    PlcopenReader& reader_;
    const PlcopenNetwork& network_;
};

/// A body in Structured Text. For named transitions, `NAME := EXPRESSION;` is also accepted.
Id<st::Expr> structured(PlcopenReader& reader, pugi::xml_node text) {
    const st::Text pieces = reader.xml.text(text);
    const std::string content = reader.xml.content(text);
    const std::size_t assign = content.find(":=");
    if (assign == std::string::npos) return reader.expression(pieces);
    const st::Block block = reader.statements(pieces);
    if (block.size() != 1 || reader.file.statements[block.front()].kind != st::StatementKind::Assign) return {};
    return reader.file.statements[block.front()].value;
}

/// A body: Structured Text, or an LD or FBD network that ends in one coil or variable, the condition.
Id<st::Expr> body_condition(PlcopenReader& reader, pugi::xml_node body, Span where) {
    if (const pugi::xml_node text = child(body, "ST")) return structured(reader, text);
    for (const std::string_view language : {"LD", "FBD"}) {
        const pugi::xml_node diagram = child(body, language);
        if (!diagram) continue;
        const PlcopenNetwork network = network_of(reader, diagram);
        std::vector<pugi::xml_node> ends;
        for (const pugi::xml_node& element : network.elements)
            if (is(element, "coil") || is(element, "outVariable")) ends.push_back(element);
        if (ends.size() == 1) return Connected(reader, network).into(ends.front());
        reader.draft.refuse(where, "a network without exactly one coil or variable at its end", "give it one");
        return {};
    }
    reader.draft.refuse(where, "a condition in a language other than Structured Text", "write it in Structured Text");
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
        // A transition of the POU with this name, otherwise a Boolean variable.
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
        found = Connected(reader, network).at(condition);
    } else if (!children(condition, "connection").empty()) {  // version 1.01
        for (const pugi::xml_node& connection : children(condition, "connection")) {
            const pugi::xml_node source = network.find(value(connection, "refLocalId"));
            if (!source)
                reader.diagnostics().add(messages::dangling_reference(reader.xml.where(connection, "refLocalId"),
                                                                      value(connection, "refLocalId"), "element"));
            else found = Connected(reader, network).from(source);
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
