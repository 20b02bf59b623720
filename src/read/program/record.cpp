// SPDX-License-Identifier: MIT
// Records the declarations of a program and the references in its charts, for editors. Name resolution records all
// other references.
#include <algorithm>
#include <utility>

#include "read/program/scope.hpp"

namespace grafverif::program {

namespace {

std::string_view section_text(st::Section section) {
    switch (section) {
    case st::Section::Input: return "VAR_INPUT";
    case st::Section::Output: return "VAR_OUTPUT";
    case st::Section::InOut: return "VAR_IN_OUT";
    case st::Section::External: return "VAR_EXTERNAL";
    case st::Section::Global: return "VAR_GLOBAL";
    case st::Section::Temporary: return "VAR_TEMP";
    case st::Section::Local: break;
    }
    return "VAR";
}

std::string_view unit_text(st::UnitKind kind) {
    switch (kind) {
    case st::UnitKind::Program: return "PROGRAM ";
    case st::UnitKind::FunctionBlock: return "FUNCTION_BLOCK ";
    case st::UnitKind::Function: break;
    }
    return "FUNCTION ";
}

}  // namespace

void Reader::record_unit(const st::Unit& from) const {
    if (!record_.is_recording()) return;
    const std::string name = text(from.name.word);
    const bool function = from.kind == st::UnitKind::Function && from.result.name.valid();
    record_.declare(DeclarationKind::Unit, name, from.name.where, from.where, {},
                    std::string(unit_text(from.kind)) + name + (function ? " : " + text(from.result.name.word) : ""));
    record_type_name(from.result);
    for (const st::Action& action : from.actions)
        record_.declare(DeclarationKind::Action, text(action.name.word), action.name.where,
                        action.whole.source.valid() ? action.whole : action.where, from.name.where,
                        "ACTION " + text(action.name.word));
}

/// Records the values of an enumeration. Their owner is the declaration of the type `name` or, if the type has no name,
/// of the program unit that contains the variable.
void Reader::record_values(std::string_view name, const st::Type& type) const {
    if (!record_.is_recording()) return;
    const auto declared = type_declarations_.find(file_->intern(name).index);
    const Span owner =
        declared != type_declarations_.end() ? file_->types[declared->second].name.where : program.units[unit_].origin;
    for (std::size_t i = 0; i < type.values.size(); ++i)
        record_.declare(DeclarationKind::EnumerationValue, text(type.values[i].word), type.values[i].where,
                        type.values[i].where, owner,
                        text(type.values[i].word) + " = " + std::to_string(i) + ", of " + std::string(name));
}

void Reader::record_type_name(const st::Type& type) const {
    if (!type.name.valid() || !type.values.empty()) return;
    if (const auto known = type_declarations_.find(type.name.word.index); known != type_declarations_.end())
        record_.refer(type.name.where, file_->types[known->second].name.where);
    else if (const auto unit = units_.find(type.name.word.index); unit != units_.end())
        record_.refer(type.name.where, file_->units[unit->second].name.where);
}

/// Records the declaration of a variable. `type` is empty if the type of the variable has an error.
void Reader::record_variable(Id<Unit> unit, const st::Variable& from, std::optional<Id<Type>> type) const {
    if (!record_.is_recording()) return;
    const Unit& owner = program.units[unit];
    const bool instance = type && program.types[*type].kind == Type::Kind::Block &&
                          program.units[program.types[*type].unit].kind == Unit::Kind::FunctionBlock;
    const DeclarationKind kind = from.constant                         ? DeclarationKind::Constant
                                 : from.section == st::Section::Input  ? DeclarationKind::Input
                                 : from.section == st::Section::Output ? DeclarationKind::Output
                                 : instance                            ? DeclarationKind::Instance
                                                                       : DeclarationKind::Internal;
    std::string shown = owner.kind == Unit::Kind::Structure ? "" : std::string(section_text(from.section)) + " ";
    if (from.constant) shown += "CONSTANT ";
    shown += text(from.name.word);
    if (!from.address.empty()) shown += " AT " + from.address;
    if (type) shown += " : " + program.types[*type].name;
    else if (from.type.name.valid()) shown += " : " + text(from.type.name.word);
    if (from.initial.valid()) {
        const Span where = file_->exprs[from.initial].where;
        shown += " := " + (*sources_)[where.source].text.substr(where.begin, where.end - where.begin);
    }
    record_.declare(kind, text(from.name.word), from.name.where, from.where, owner.origin, std::move(shown));
    record_type_name(from.type);
}

void Reader::refer(const st::Expr& use, Span declaration, bool writes) const {
    record_.refer(use.name.source.valid() ? use.name : use.where, declaration, writes);
}

/// Records the reference of a statement that assigns the variable at the end of `path`.
void Reader::refer_target(Id<st::Expr> path, Span declaration) const {
    while (file_->exprs[path].op == st::Op::Index) path = file_->exprs[path].first;
    refer(file_->exprs[path], declaration, true);
}

/// Records the steps and transitions of a chart and the names in them. If the chart has errors and is not translated,
/// resolves its conditions and actions only to record the names.
void Reader::record_chart(std::size_t index) {
    const st::Unit& from = file_->units[index];
    if (!record_.is_recording() || from.networks.empty() || file_->dialect != st::Dialect::Standard) return;
    const st::Network& network = from.networks.front();
    for (const st::Step& step : network.steps)
        record_.declare(DeclarationKind::Step, text(step.name.word), step.name.where,
                        step.whole.source.valid() ? step.whole : step.where, from.name.where,
                        (step.initial ? "INITIAL_STEP " : "STEP ") + text(step.name.word));
    const auto refer_to_steps = [&](const std::vector<st::Name>& names) {
        for (const st::Name& name : names)
            if (const auto step =
                    std::ranges::find(network.steps, name.word, [](const st::Step& each) { return each.name.word; });
                step != network.steps.end())
                record_.refer(name.where, step->name.where);
    };
    for (const st::Transition& transition : network.transitions) {
        if (transition.name.valid())
            record_.declare(DeclarationKind::Transition, text(transition.name.word), transition.name.where,
                            transition.where, from.name.where);
        refer_to_steps(transition.from);
        refer_to_steps(transition.to);
    }
    for (const st::Step& step : network.steps)
        for (const st::Association& association : step.actions) record_association(from, association);
    if (charts_[index].body.valid) return;
    Diagnostics ignored;
    Diagnostics* const all = std::exchange(diagnostics, &ignored);
    for (const st::Transition& transition : network.transitions)
        if (transition.condition.valid()) expression(transition.condition);
    for (const st::Action& action : from.actions) block(action.body);
    diagnostics = all;
}

void Reader::record_association(const st::Unit& unit, const st::Association& association) const {
    const auto action =
        std::ranges::find(unit.actions, association.action.word, [](const st::Action& each) { return each.name.word; });
    if (action != unit.actions.end()) return record_.refer(association.action.where, action->name.where);
    for (const Id<Unit> id : {unit_, program.globals})
        if (const auto known = scopes_[id.index].variables.find(association.action.word.index);
            known != scopes_[id.index].variables.end())
            return record_.refer(association.action.where, program.units[id].variables[known->second].origin, true);
}

}  // namespace grafverif::program
