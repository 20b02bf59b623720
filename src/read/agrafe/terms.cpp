// SPDX-License-Identifier: MIT
// Converts the terms and times of an AGRAFE document.
#include <string>

#include "read/agrafe/reader.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

using Kind = AgrafeEntity::Kind;

struct Operator {
    std::string_view type = {};
    tree::Op op = tree::Op::And;
    std::size_t least = 2, most = 2;
};
constexpr std::size_t any = 1'000'000'000;
constexpr Operator operators[] = {
    {"And", tree::Op::And, 1, any},
    {"Or", tree::Op::Or, 1, any},
    {"Not", tree::Op::Not, 1, 1},
    {"RisingEdge", tree::Op::Rise, 1, 1},
    {"FallingEdge", tree::Op::Fall, 1, 1},
    {"Equality", tree::Op::Equal, 2, 2},
    {"GreaterThan", tree::Op::Greater, 2, 2},
    {"LessThan", tree::Op::Less, 2, 2},
    {"Addition", tree::Op::Plus, 2, 2},
    {"Substraction", tree::Op::Minus, 2, 2},
    {"Subtraction", tree::Op::Minus, 2, 2},
};

/// Returns the step variable of a step, such as `X2`; if other partial charts also have a step 2, returns the qualified
/// name, such as `G2.X2`.
Id<tree::Expr> step_variable(AgrafeReader& reader, const AgrafeEntity& step, Span where) {
    const std::string name = 'X' + step.name;
    if (reader.namesakes[step.name] == 1) return reader.draft.variable(name, where);
    const AgrafeEntity& partial = reader.index[step.partial];
    return reader.draft.member(partial.kind == Kind::Main ? reader.chart : partial.name, name, where);
}

Id<tree::Expr> variable(AgrafeReader& reader, pugi::xml_node term) {
    const auto found = reader.reference(term, "variableDeclaration", "variable declaration", is_declaration);
    if (!found) return {};
    const AgrafeEntity& declaration = reader.index[*found];
    const Span where = reader.xml.where(term, "variableDeclaration");
    if (value(declaration.node, "variableDeclarationType") != "step")
        return reader.draft.variable(declaration.name, where);
    const auto step = reader.reference(declaration.node, "step", "step", is_step);
    return step ? step_variable(reader, reader.index[*step], where) : Id<tree::Expr>{};
}

Id<tree::Expr> applied(AgrafeReader& reader, const Operator& known, pugi::xml_node term) {
    const std::vector<pugi::xml_node> inner = children(term, "subterm");
    if (inner.size() < known.least || inner.size() > known.most) {
        const std::string wanted = known.least == known.most ? std::to_string(known.least) : "at least one";
        reader.diagnostics().add(messages::bad_value(reader.xml.where(term, "type"),
                                                     "number of subterms of `" + std::string(known.type) + '`',
                                                     std::to_string(inner.size()), wanted));
        return {};
    }
    std::vector<Id<tree::Expr>> operands;
    for (const pugi::xml_node& one : inner) operands.push_back(agrafe_term(reader, one));
    if (operands.size() == 1 && known.most == any) return operands.front();
    return reader.draft.node(known.op, operands, reader.xml.where(term, "type"));
}

}  // namespace

/// Converts a term. The nesting depth of an XML document is at most 1,000, which limits the recursion depth.
Id<tree::Expr> agrafe_term(AgrafeReader& reader, pugi::xml_node term) {
    const std::string_view type = local_name(attribute(term, "type").value());
    if (type == "Variable") return variable(reader, term);
    if (type == "BooleanConstant")
        return reader.draft.constant(reader.flag(term, "value"), reader.xml.where(term, "value"));
    if (type == "IntegerConstant")
        return reader.draft.number(reader.number(term, "value", 0), reader.xml.where(term, "value"));
    for (const Operator& known : operators)
        if (known.type == type) return applied(reader, known, term);
    if (type.empty())
        reader.diagnostics().add(messages::missing_part(reader.xml.where(term), "this term", "`xsi:type`"));
    else
        reader.diagnostics().add(messages::bad_value(reader.xml.where(term, "type"), "type of this term", type,
                                                     "a class of terms of the AGRAFE meta-model, such as `And`"));
    return {};
}

AgrafeTime agrafe_time(AgrafeReader& reader, pugi::xml_node node) {
    AgrafeTime time;
    const std::string type = value(node, "timeConditionType"), unit = value(node, "unit");
    const std::int64_t delay = reader.number(node, "delayTime", 0), reset = reader.number(node, "resetTime", 0);
    if (type.empty() || type == "none") {
        if (delay != 0 || reset != 0)
            reader.diagnostics().add(messages::without_effect(
                reader.xml.where(node, delay != 0 ? "delayTime" : "resetTime"), "a time without `timeConditionType`",
                "write `timeConditionType=\"timeDependent\"`, or remove the time"));
        return time;
    }
    if (type == "timeDependent") time.kind = AgrafeTime::Kind::Dependent;
    else if (type == "timeDelayed") time.kind = AgrafeTime::Kind::Delayed;
    else if (type == "timeLimited") time.kind = AgrafeTime::Kind::Limited;
    else
        reader.diagnostics().add(messages::bad_value(reader.xml.where(node, "timeConditionType"), "type of this time",
                                                     type, "`timeDependent`, `timeDelayed` or `timeLimited`"));
    if (!unit.empty() && unit != "s" && unit != "second" && unit != "ms" && unit != "millisecond")
        reader.diagnostics().add(messages::bad_value(reader.xml.where(node, "unit"), "unit", unit, "`s` or `ms`"));
    const std::int64_t factor = unit == "ms" || unit == "millisecond" ? 1 : 1000;
    for (const auto& [attribute, length] :
         {std::pair<std::string_view, std::int64_t>("delayTime", delay), {"resetTime", reset}})
        if (length < 0)
            reader.diagnostics().add(messages::bad_value(reader.xml.where(node, attribute), std::string(attribute),
                                                         value(node, attribute), "a time that is not negative"));
    time.rise_ms = std::max<std::int64_t>(delay, 0) * factor;
    time.fall_ms = std::max<std::int64_t>(reset, 0) * factor;
    if (time.kind != AgrafeTime::Kind::Dependent && time.fall_ms != 0)
        reader.diagnostics().add(messages::without_effect(reader.xml.where(node, "resetTime"), "this reset time",
                                                          "remove it, because only `timeDependent` has a reset time"));
    return time;
}

Id<tree::Expr> timed(AgrafeReader& reader, const AgrafeTime& time, Id<tree::Expr> term, Span where) {
    Draft& draft = reader.draft;
    if (time.rise_ms > 0) term = draft.node(tree::Op::Divide, {draft.duration(time.rise_ms, where), term}, where);
    if (time.fall_ms > 0) term = draft.node(tree::Op::Divide, {term, draft.duration(time.fall_ms, where)}, where);
    return term;
}

}  // namespace grafverif
