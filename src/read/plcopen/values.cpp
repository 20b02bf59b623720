// SPDX-License-Identifier: MIT
#include "read/plcopen/values.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "support/messages.hpp"

namespace grafverif {

namespace {

// Maximum number of values of one network. The limit is necessary because each connection copies the expression at its
// source, so that the number of values can grow exponentially.
constexpr std::size_t most_values = 100'000;

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

}  // namespace

bool is_marked(pugi::xml_node node, std::string_view attribute) {
    const std::string how = value(node, attribute);
    return !how.empty() && how != "none";
}

Id<st::Expr> PlcopenValues::at(pugi::xml_node point, std::size_t depth) {
    std::vector<Id<st::Expr>> lines;
    for (const PlcopenLine& line : lines_of(reader_, network_, point)) {
        const Id<st::Expr> one = of(line, depth + 1);
        if (!one.valid()) return {};
        lines.push_back(one);
    }
    if (lines.empty()) return {};
    return lines.size() == 1 ? lines.front() : reader_.make(st::Op::Or, lines, reader_.xml.where(point));
}

Id<st::Expr> PlcopenValues::of(const PlcopenLine& line, std::size_t depth) {
    const pugi::xml_node node = line.source;
    const Span where = reader_.xml.where(node);
    if (values_ > most_values) return {};
    if (depth > deepest) {
        reader_.refuse(where, "a network that has a cycle or more than " + std::to_string(deepest) + " levels",
                       "simplify the network");
        return {};
    }
    if (++values_ > most_values) {
        reader_.refuse(where, "a network that is too large because a value is copied for each element that reads it",
                       "assign values that several elements read to variables");
        return {};
    }
    if (is(node, "inVariable")) return variable(node, "negated");
    if (is(node, "inOutVariable")) return variable(node, "negatedOut");
    if (is(node, "leftPowerRail")) return reader_.make(st::Op::True, {}, where);
    if (is(node, "connector") || is(node, "continuation")) return at(node, depth);
    if (is(node, "contact")) return contact(node, depth);
    if (is(node, "block")) return block(node, line.output, depth);
    return other_element(node, depth);
}

Id<st::Expr> PlcopenValues::other_element(pugi::xml_node node, std::size_t) {
    if (is(node, "contact")) {
        (void)passes_on(node);
        return {};
    }
    reader_.refuse(reader_.xml.where(node), "a `" + std::string(local_name(node.name())) + "` in a condition",
                   "write the condition in Structured Text");
    return {};
}

Id<st::Expr> PlcopenValues::negated(pugi::xml_node node, Id<st::Expr> term, std::string_view mark) {
    if (!term.valid() || !reader_.flag(node, mark)) return term;
    return reader_.make(st::Op::Not, {term}, reader_.xml.where(node));
}

bool PlcopenValues::passes_on(pugi::xml_node node) {
    for (const std::string_view mark : {"edge", "edgeIn", "edgeOut", "storage", "storageIn", "storageOut"}) {
        if (!is_marked(node, mark)) continue;
        const bool edge = mark.starts_with("edge");
        const Span where = reader_.xml.where(node, mark);
        if (reader_.of_program)
            reader_.refuse(where, edge ? "an edge at this element" : "a value stored at this element",
                           edge ? "use a contact or coil with an edge, or `R_TRIG`" : "use a coil");
        else
            reader_.refuse(
                where, edge ? "an edge in the network of a condition" : "a value stored in the network of a condition",
                edge ? "store the previous value in a variable of the chart" : "store it in an action");
        return false;
    }
    return true;
}

Id<st::Expr> PlcopenValues::variable(pugi::xml_node node, std::string_view mark) {
    if (!passes_on(node)) return {};
    if (!reader_.of_program && !sources_of(reader_, network_, node).empty()) {
        reader_.refuse(reader_.xml.where(node), "a variable that a condition assigns", "assign it in an action");
        return {};
    }
    if (reader_.of_program && is(node, "inOutVariable") && is_connected(node)) {
        reader_.refuse(reader_.xml.where(node),
                       "an element that assigns a variable and passes its value to another element",
                       "assign the variable in one network and read it in the next");
        return {};
    }
    const Id<st::Expr> term = reader_.expression(reader_.xml.text(child(node, "expression")));
    if (term.valid()) is_read(term);
    return negated(node, term, mark);
}

Id<st::Expr> PlcopenValues::operand(pugi::xml_node node) {
    return reader_.expression(reader_.xml.text(child(node, "variable")));
}

Id<st::Expr> PlcopenValues::contact(pugi::xml_node node, std::size_t depth) {
    if (is_marked(node, "edge") || is_marked(node, "storage")) return other_element(node, depth);
    const Id<st::Expr> term = operand(node);
    if (term.valid()) is_read(term);
    const Id<st::Expr> own = negated(node, term);
    const Id<st::Expr> before = wired(node, depth, "this contact");
    if (!own.valid() || !before.valid()) return {};
    if (reader_.node(before).op == st::Op::True) return own;
    return reader_.make(st::Op::And, {before, own}, reader_.xml.where(node));
}

Id<st::Expr> PlcopenValues::wired(pugi::xml_node point, std::size_t depth, std::string_view what) {
    if (!lines_of(reader_, network_, point).empty()) return at(point, depth);
    reader_.diagnostics().add(messages::missing_part(reader_.xml.where(point), what, "connection"));
    return {};
}

Id<st::Expr> PlcopenValues::pin(pugi::xml_node pin, std::size_t depth) {
    return passes_on(pin) ? negated(pin, wired(pin, depth, "an input of this block")) : Id<st::Expr>{};
}

Id<st::Expr> PlcopenValues::unsupported(pugi::xml_node block, std::string_view what) {
    reader_.refuse(
        reader_.xml.where(block, "typeName"), what,
        reader_.of_program ? "write this network in Structured Text" : "write the condition in Structured Text");
    return {};
}

Id<st::Expr> PlcopenValues::other_block(pugi::xml_node node, const std::string&, std::size_t) {
    return unsupported(node, "the block `" + value(node, "typeName") + "` in a condition");
}

Id<st::Expr> PlcopenValues::block(pugi::xml_node node, const std::string& output, std::size_t depth) {
    const std::string type = st::capitals(value(node, "typeName"));
    const auto* function = std::ranges::find(functions, type, &Function::name);
    if ((type != "NOT" && function == functions.end()) || !value(node, "instanceName").empty())
        return other_block(node, output, depth);
    std::vector<Id<st::Expr>> inputs;
    for (const pugi::xml_node& each : children(child(node, "inputVariables"), "variable")) {
        if (st::capitals(value(each, "formalParameter")) == "EN") {
            if (reader_.of_program && !is_connected(each)) continue;
            return unsupported(node, "a block with a separate enable condition");
        }
        const Id<st::Expr> one = pin(each, depth);
        if (!one.valid()) return {};
        inputs.push_back(one);
    }
    std::vector<pugi::xml_node> outputs = children(child(node, "outputVariables"), "variable");
    if (reader_.of_program)
        std::erase_if(outputs,
                      [](pugi::xml_node each) { return st::capitals(value(each, "formalParameter")) == "ENO"; });
    if (outputs.size() > 1 || st::capitals(output) == "ENO")
        return unsupported(
            node, reader_.of_program ? "this output of the block" : "a block with several outputs in a condition");
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
    while (inputs.size() > 2 && (type == "ADD" || type == "MUL")) {  // binary operators, applied from left to right
        const Id<st::Expr> first = reader_.make(function->op, {inputs[0], inputs[1]}, where);
        inputs.erase(inputs.begin());
        inputs.front() = first;
    }
    const Id<st::Expr> found = reader_.make(type == "NOT" ? st::Op::Not : function->op, inputs, where);
    if (outputs.empty()) return found;
    return passes_on(outputs.front()) ? negated(outputs.front(), found) : Id<st::Expr>{};
}

}  // namespace grafverif
