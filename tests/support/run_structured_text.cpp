// SPDX-License-Identifier: MIT
#include "support/run_structured_text.hpp"

#include <limits>
#include <pugixml.hpp>
#include <sstream>
#include <stdexcept>

namespace grafverif {

struct SmallPlc::Instance {
    enum class Kind { Unit, OnDelay, OffDelay };
    Kind kind = Kind::Unit;
    const st::Unit* unit = nullptr;
    std::map<std::string, std::int64_t> values = {};  ///< the values of the variables, with names in capitals
    std::map<std::string, std::unique_ptr<Instance>> blocks = {};
    std::int64_t since = -1;  ///< the start of a timer; -1: the timer is not running
};

namespace {

[[noreturn]] void refuse(const std::string& what) { throw std::runtime_error(what); }

}  // namespace

std::string units_of_plcopen(const std::string& xml) {
    pugi::xml_document document;
    if (!document.load_string(xml.c_str())) refuse("not XML");
    std::string text;
    for (const pugi::xml_node pou : document.child("project").child("types").child("pous").children("pou")) {
        const std::string type = pou.attribute("pouType").value();
        const std::string word = type == "program" ? "PROGRAM" : type == "functionBlock" ? "FUNCTION_BLOCK" : "";
        if (word.empty()) refuse("not a unit: " + type);
        text += word + ' ' + pou.attribute("name").value() + '\n';
        for (const pugi::xml_node section : pou.child("interface").children()) {
            const std::string name = section.name();
            if (name == "documentation") continue;
            text += name == "inputVars" ? "VAR_INPUT" : name == "outputVars" ? "VAR_OUTPUT" : "VAR";
            text += section.attribute("constant").as_bool() ? " CONSTANT\n" : "\n";
            for (const pugi::xml_node variable : section.children("variable")) {
                const pugi::xml_node kind = variable.child("type").first_child();
                const std::string derived = kind.attribute("name").value();
                text +=
                    std::string(variable.attribute("name").value()) + " : " + (derived.empty() ? kind.name() : derived);
                const pugi::xml_node initial = variable.child("initialValue").child("simpleValue");
                if (initial) text += std::string(" := ") + initial.attribute("value").value();
                text += ";\n";
            }
            text += "END_VAR\n";
        }
        text += std::string(pou.child("body").child("ST").child("xhtml").text().get()) + "\nEND_" + word + '\n';
    }
    return text;
}

SmallPlc::SmallPlc(const std::vector<std::string>& units, const std::string& unit) {
    for (const std::string& text : units) {
        Diagnostics diagnostics;
        const Id<Source> source = sources_.add({"unit.st", text});
        if (parse_units({{{source, 0, static_cast<std::uint32_t>(text.size())}, false}}, file_, sources_, diagnostics))
            continue;
        std::ostringstream out;
        render_text(diagnostics.all(), sources_, Colour::Plain, out);
        refuse(out.str());
    }
    main_ = instance(unit);
}

SmallPlc::~SmallPlc() = default;

const st::Unit* SmallPlc::unit_named(const std::string& wanted) const {
    for (const st::Unit& unit : file_.units)
        if (st::capitals(file_.text(unit.name)) == wanted) return &unit;
    return nullptr;
}

std::unique_ptr<SmallPlc::Instance> SmallPlc::instance(const std::string& type) const {
    auto made = std::make_unique<Instance>();
    if (type == "TON" || type == "TOF") {
        made->kind = type == "TON" ? Instance::Kind::OnDelay : Instance::Kind::OffDelay;
        made->values = {{"IN", 0}, {"PT", 0}, {"Q", 0}, {"ET", 0}};
        return made;
    }
    made->unit = unit_named(st::capitals(type));
    if (made->unit == nullptr) refuse("unknown unit `" + type + "`");
    for (const st::Variable& variable : made->unit->variables) {
        const std::string called = name(variable.name.word);
        const std::string of = name(variable.type.name.word);
        const bool elementary = of == "BOOL" || of == "DINT" || of == "INT" || of == "UDINT" || of == "TIME";
        if (made->values.contains(called) || made->blocks.contains(called))
            refuse("`" + called + "` is declared twice");
        if (!elementary) made->blocks[called] = instance(of);
        else made->values[called] = variable.initial.valid() ? evaluate(variable.initial, *made) : 0;
    }
    return made;
}

void SmallPlc::set(const std::string& variable, std::int64_t value) {
    const auto found = main_->values.find(st::capitals(variable));
    if (found == main_->values.end()) refuse("unknown variable `" + variable + "`");
    found->second = value;
}

bool SmallPlc::has(const std::string& variable) const { return main_->values.contains(st::capitals(variable)); }

std::int64_t SmallPlc::value(const std::string& variable) const {
    const auto found = main_->values.find(st::capitals(variable));
    if (found == main_->values.end()) refuse("unknown variable `" + variable + "`");
    return found->second;
}

void SmallPlc::call(std::int64_t now) {
    now_ = now;
    run(*main_);
}

/// Implements TON and TOF according to IEC 61131-3, Table 46.
void SmallPlc::run(Instance& instance) {
    if (instance.kind == Instance::Kind::Unit) {
        execute(instance.unit->body, instance);
        return;
    }
    const bool on = instance.kind == Instance::Kind::OnDelay;
    const bool runs = on == (instance.values["IN"] != 0);
    if (!runs) instance.since = -1;
    else if (instance.since < 0 && (on || instance.values["Q"] != 0)) instance.since = now_;
    const bool over = instance.since >= 0 && now_ - instance.since >= instance.values["PT"];
    if (on) instance.values["Q"] = runs && over ? 1 : 0;
    else instance.values["Q"] = !runs || (instance.values["Q"] != 0 && !over) ? 1 : 0;
}

SmallPlc::Flow SmallPlc::execute(const st::Block& block, Instance& instance) {
    for (const Id<st::Statement> statement : block)
        if (execute(file_.statements[statement], instance) == Flow::Return) return Flow::Return;
    return Flow::Next;
}

SmallPlc::Flow SmallPlc::execute(const st::Statement& statement, Instance& instance) {
    switch (statement.kind) {
    case st::StatementKind::Assign: {
        const st::Expr& target = file_.exprs[statement.target];
        const auto found = instance.values.find(name(target.word));
        if (target.op != st::Op::Name || found == instance.values.end()) refuse("nothing to assign to");
        found->second = evaluate(statement.value, instance);
        return Flow::Next;
    }
    case st::StatementKind::Call: call(statement.value, instance); return Flow::Next;
    case st::StatementKind::Return: return Flow::Return;
    case st::StatementKind::If:
    case st::StatementKind::Case: return choose(statement, instance);
    case st::StatementKind::While: return repeat(statement, instance);
    case st::StatementKind::For:
    case st::StatementKind::Repeat:  // MATIEC executes this statement incorrectly
    case st::StatementKind::Exit: break;
    }
    refuse("an unsupported statement");
}

SmallPlc::Flow SmallPlc::choose(const st::Statement& statement, Instance& instance) {
    const bool by_case = statement.kind == st::StatementKind::Case;
    const std::int64_t selector = by_case ? evaluate(statement.value, instance) : 1;
    for (const st::Branch& branch : statement.branches) {
        bool taken = branch.conditions.empty();
        for (const Id<st::Expr> condition : branch.conditions)
            taken = taken || evaluate(condition, instance) == selector;
        if (taken) return execute(branch.body, instance);
    }
    return Flow::Next;
}

SmallPlc::Flow SmallPlc::repeat(const st::Statement& statement, Instance& instance) {
    constexpr int most = 1'000'000;
    const st::Branch& loop = statement.branches.at(0);
    for (int count = 0; count < most; ++count) {
        if (evaluate(statement.value, instance) == 0) return Flow::Next;
        if (execute(loop.body, instance) == Flow::Return) return Flow::Return;
    }
    refuse("a loop without end");
}

void SmallPlc::call(Id<st::Expr> expression, Instance& instance) {
    const std::vector<Id<st::Expr>> parts = st::operands(file_, expression);
    const auto block = instance.blocks.find(name(file_.exprs[parts.at(0)].word));
    if (block == instance.blocks.end()) refuse("a call of a variable that is not a block");
    for (std::size_t k = 1; k < parts.size(); ++k) {
        const auto parameter = block->second->values.find(name(file_.exprs[parts[k]].word));
        if (file_.exprs[parts[k]].op != st::Op::Argument || parameter == block->second->values.end())
            refuse("unknown parameter");
        parameter->second = evaluate(file_.exprs[parts[k]].first, instance);
    }
    run(*block->second);
}

std::int64_t SmallPlc::evaluate(Id<st::Expr> expression, Instance& instance) const {
    const st::Expr& node = file_.exprs[expression];
    const std::vector<Id<st::Expr>> parts = st::operands(file_, expression);
    switch (node.op) {
    case st::Op::False: return 0;
    case st::Op::True: return 1;
    case st::Op::Integer:
    case st::Op::Time: return node.value;
    case st::Op::Name: {
        const auto found = instance.values.find(name(node.word));
        if (found == instance.values.end()) refuse("unknown variable `" + name(node.word) + "`");
        return found->second;
    }
    case st::Op::Member: {
        const auto block = instance.blocks.find(name(file_.exprs[parts.at(0)].word));
        if (block == instance.blocks.end()) refuse("unknown block `" + name(file_.exprs[parts.at(0)].word) + "`");
        const auto found = block->second->values.find(name(node.word));
        if (found == block->second->values.end()) refuse("unknown member `" + name(node.word) + "`");
        return found->second;
    }
    case st::Op::Call:
        if (name(file_.exprs[parts.at(0)].word) != "SEL" || parts.size() != 4) refuse("unknown function");
        return evaluate(parts[evaluate(parts[1], instance) != 0 ? 3 : 2], instance);
    case st::Op::Not: return evaluate(parts.at(0), instance) == 0 ? 1 : 0;
    case st::Op::Negate: return combine(st::Op::Minus, 0, evaluate(parts.at(0), instance));
    default: break;
    }
    if (parts.size() < 2) refuse("an operation of one operand");
    std::int64_t value = evaluate(parts[0], instance);
    for (std::size_t k = 1; k < parts.size(); ++k) value = combine(node.op, value, evaluate(parts[k], instance));
    return value;
}

/// Applies the operator to the values of both operands, which are always evaluated: a PLC need not short-circuit.
std::int64_t SmallPlc::combine(st::Op op, std::int64_t left, std::int64_t right) const {
    const auto within = [](std::int64_t value) {
        if (value < std::numeric_limits<std::int32_t>::min() || value > std::numeric_limits<std::int32_t>::max())
            refuse("a value outside 32 bits");
        return value;
    };
    switch (op) {
    case st::Op::Times: return within(left * right);
    case st::Op::Plus: return within(left + right);
    case st::Op::Minus: return within(left - right);
    case st::Op::Divide:
    case st::Op::Modulo:
        if (right == 0) refuse("a division by zero");
        return op == st::Op::Divide ? left / right : left % right;
    case st::Op::Less: return left < right;
    case st::Op::LessEqual: return left <= right;
    case st::Op::Greater: return left > right;
    case st::Op::GreaterEqual: return left >= right;
    case st::Op::Equal: return left == right;
    case st::Op::NotEqual: return left != right;
    case st::Op::And: return (left != 0 && right != 0) ? 1 : 0;
    case st::Op::Or: return (left != 0 || right != 0) ? 1 : 0;
    default: refuse("an unsupported operator");
    }
}

}  // namespace grafverif
