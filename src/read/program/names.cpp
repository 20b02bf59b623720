// SPDX-License-Identifier: MIT
// Resolves the names of variables: variables of the unit, global variables, members of instances and structures, and
// array elements. In the dialect of CODESYS, variables can be qualified by the name of a global variable list or of the
// program. Statements can access the inputs and outputs of an instance and, in the dialect of CODESYS, all other
// variables of the instance except VAR_TEMP and VAR_IN_OUT.
#include <algorithm>
#include <string>

#include "read/program/scope.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif::program {

Reader::Found Reader::found_in(Id<Unit> unit, std::uint32_t index) {
    Variable& variable = program.units[unit].variables[index];
    Found made;
    made.place = {unit == program.globals, variable.offset, {}};
    made.type = variable.type;
    made.variable = &variable;
    made.constant = variable.constant;
    return made;
}

/// Returns the Place with which other units access the memory cell at `offset` of the program instance.
Program::Place Reader::main_place(std::uint32_t offset) const {
    return {true, program.units[program.globals].size + offset, {}};
}

bool Reader::is_main(Id<st::Word> word) const {
    const auto unit = units_.find(word.index);
    return unit != units_.end() && declared_[unit->second] == program.main;
}

std::optional<Reader::Found> Reader::named(Id<st::Word> word, Span where) {
    for (const Id<Unit> id : {unit_, program.globals}) {
        const auto known = scopes_[id.index].variables.find(word.index);
        if (known == scopes_[id.index].variables.end()) continue;
        const Found found = found_in(id, known->second);
        const bool action = body_.valid() && program.units[body_].kind == Unit::Kind::Action;
        if (action && found.variable->section == Variable::Section::Temporary)
            return reject(where, "a temporary variable in an action", "declare it in VAR"), std::nullopt;
        return found;
    }
    std::vector<std::string> candidates;
    for (const Id<Unit> id : {unit_, program.globals})
        for (const Variable& variable : program.units[id].variables) candidates.push_back(variable.name);
    diagnostics->add(messages::unknown(where, "variable", written(word, where), nearest_of(text(word), candidates)));
    return {};
}

std::string Reader::written(Id<st::Word> word, Span where) const {
    const std::string first = text(word);
    if (where.source.index >= sources_->size()) return first;
    std::string here = (*sources_)[where.source].text.substr(where.begin, where.end - where.begin);
    return st::capitals(here) == st::capitals(first) ? here : first;
}

std::optional<Reader::Found> Reader::variable(Id<st::Expr> path) {
    const st::Expr& from = file_->exprs[path];
    switch (from.op) {
    case st::Op::Name: {
        const auto found = named(from.word, from.where);
        if (found) refer(from, found->variable->origin);
        return found;
    }
    case st::Op::Member: return member(path);
    case st::Op::Index: return element(path);
    case st::Op::Address:
        return reject(from.where, "a direct address in a statement", "declare a variable `AT` this address"),
               std::nullopt;
    case st::Op::Dereference: return reject(from.where, "a pointer", "use the variable itself"), std::nullopt;
    default:
        return reject(from.where, "this expression in place of a variable",
                      "use a variable or an output of an instance"),
               std::nullopt;
    }
}

/// Resolves a variable that is qualified by the name of its global variable list or of the program. The result is empty
/// for other paths.
std::optional<std::optional<Reader::Found>> Reader::qualified(Id<st::Expr> path) {
    const st::Expr from = file_->exprs[path];
    const st::Expr owner = file_->exprs[from.first];
    if (!is_open() || owner.op != st::Op::Name) return {};
    for (const Id<Unit> id : {unit_, program.globals})
        if (scopes_[id.index].variables.contains(owner.word.index)) return {};
    const bool own = st::capitals(text(owner.word)) == st::capitals(program.units[unit_].name);
    if (any_member_ && own) return named(from.word, from.where);
    const bool list = std::ranges::find(file_->global_lists, owner.word, &st::Name::word) != file_->global_lists.end();
    if (!list && !is_main(owner.word)) return {};
    const Id<Unit> unit = list ? program.globals : program.main;
    const auto known = scopes_[unit.index].variables.find(from.word.index);
    if (known == scopes_[unit.index].variables.end()) {
        diagnostics->add(messages::unknown(from.where, "variable", text(from.word), ""));
        return std::optional<Found>();
    }
    Found found = found_in(unit, known->second);
    refer(from, found.variable->origin);
    if (!list) refer(owner, program.units[unit].origin);
    if (list || unit == unit_) return found;
    if (found.variable->section == Variable::Section::Temporary)
        return reject(from.where, "a temporary variable of another unit", "declare it in VAR"), std::optional<Found>();
    found.place = main_place(found.variable->offset);
    return found;
}

std::optional<Reader::Found> Reader::member(Id<st::Expr> path) {
    const st::Expr from = file_->exprs[path];
    if (const auto found = step_of_chart(path)) return found;
    if (const auto found = chart_member(path)) return found;
    if (const auto found = qualified(path)) return *found;
    const st::Expr& owner_expr = file_->exprs[from.first];
    const auto owner = variable(from.first);
    if (!owner) return {};
    const Type& type = program.types[owner->type];
    if (type.kind != Type::Kind::Block) {
        diagnostics->add(messages::program_type_mismatch(owner_expr.where, "the variable before `.`",
                                                         "an instance of a function block or a structure",
                                                         "`" + type.name + "`"));
        return {};
    }
    const auto known = scopes_[type.unit.index].variables.find(from.word.index);
    Variable* found = known == scopes_[type.unit.index].variables.end()
                          ? nullptr
                          : &program.units[type.unit].variables[known->second];
    const bool structure = program.units[type.unit].kind == Unit::Kind::Structure;
    const bool chart = chart_units_.contains(type.unit.index);
    const bool codesys =
        file_->dialect == st::Dialect::Codesys && program.units[type.unit].origin.source == file_->source;
    const bool readable = (any_member_ || codesys) && found && found->section != Variable::Section::Temporary &&
                          found->section != Variable::Section::InOut;
    const bool input = found && found->section == Variable::Section::Input && !chart;
    const bool visible = found && (structure || readable || input || found->section == Variable::Section::Output);
    if (!visible) {
        std::vector<std::string> candidates;
        for (const Variable& variable : program.units[type.unit].variables)
            if (structure || variable.section == Variable::Section::Input ||
                variable.section == Variable::Section::Output)
                candidates.push_back(variable.name);
        diagnostics->add(messages::unknown(from.where, "variable", written(from.word, from.name),
                                           nearest_of(text(from.word), candidates)));
        return {};
    }
    refer(from, found->origin);
    Found made = *owner;
    made.place.offset += found->offset;
    made.type = found->type;
    made.variable = found;
    if (structure) return made;
    made.instance = owner->variable;
    made.block = type.unit;
    made.inside = true;
    made.constant = found->constant;
    made.locked = chart || (!input && !codesys);
    return made;
}

std::optional<Reader::Found> Reader::element(Id<st::Expr> path) {
    const std::vector<Id<st::Expr>> parts = st::operands(*file_, path);
    auto found = variable(parts.front());
    if (!found) return {};
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const Type array = program.types[found->type];
        const Span where = file_->exprs[parts[i]].where;
        if (array.kind != Type::Kind::Array) {
            diagnostics->add(messages::program_type_mismatch(file_->exprs[parts.front()].where, "the indexed variable",
                                                             "an array", "`" + array.name + "`"));
            return {};
        }
        const auto value = expression(parts[i]);
        if (!value) return {};
        if (type(*value).kind != Type::Kind::Integer) {
            diagnostics->add(messages::program_type_mismatch(where, "the index", "an integer", described(*value)));
            return {};
        }
        const std::uint32_t stride = size_of(program, array.element);
        if (const auto known = value_of(value->node)) {
            if (*known < array.low || *known > array.high)
                return reject(where, "an index outside of its array",
                              "use an index from " + std::to_string(array.low) + " to " + std::to_string(array.high)),
                       std::nullopt;
            found->place.offset += static_cast<std::uint32_t>(*known - array.low) * stride;
        } else {
            found->place.indices.push_back({value->node, array.low, array.high, stride});
        }
        found->type = array.element;
    }
    return found;
}

std::optional<Id<Node>> Reader::condition(Id<st::Expr> root) {
    unit_ = program.main;
    body_ = {};
    any_member_ = true;
    const auto value = expression(root);
    any_member_ = false;
    if (!value) return {};
    return converted(*value, bool_, file_->exprs[root].where, "the expression");
}

}  // namespace grafverif::program
