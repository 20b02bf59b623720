// SPDX-License-Identifier: MIT
// Reads call statements. A call of a function block or action becomes assignments to its inputs, the call, and
// assignments of its outputs. A variable passed as VAR_IN_OUT is copied before and after the call. The copies are
// equivalent to a reference, because the block has no other access to the variable.
#include <algorithm>
#include <string>
#include <utility>

#include "read/program/scope.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"

namespace grafverif::program {

/// Returns the action that `path` denotes: an action of this unit or of an instance. The result is empty if `path`
/// denotes no action.
std::optional<Reader::Callee> Reader::action(Id<st::Expr> path) {
    const st::Expr from = file_->exprs[path];
    if (from.op == st::Op::Name) {
        const auto known = scopes_[unit_.index].actions.find(from.word.index);
        if (known == scopes_[unit_.index].actions.end()) return {};
        refer(from, program.units[known->second].origin);
        return Callee{{}, known->second, unit_, nullptr};
    }
    const auto declares = [&](const Scope& scope) { return scope.actions.contains(from.word.index); };
    if (from.op != st::Op::Member || std::ranges::none_of(scopes_, declares)) return {};
    const st::Expr owner = file_->exprs[from.first];
    const bool variable_owner =
        owner.op == st::Op::Name && (scopes_[unit_.index].variables.contains(owner.word.index) ||
                                     scopes_[program.globals.index].variables.contains(owner.word.index));
    if (owner.op == st::Op::Name && !variable_owner && is_open() && is_main(owner.word)) {
        const auto known = scopes_[program.main.index].actions.find(from.word.index);
        if (known == scopes_[program.main.index].actions.end()) return {};
        const Program::Place place = unit_ == program.main ? Program::Place{} : main_place(0);
        return Callee{place, known->second, program.main, nullptr};
    }
    const auto found = variable(from.first);
    if (!found || program.types[found->type].kind != Type::Kind::Block) return {};
    const Id<Unit> block = program.types[found->type].unit;
    const auto known = scopes_[block.index].actions.find(from.word.index);
    if (known == scopes_[block.index].actions.end()) return {};
    refer(from, program.units[known->second].origin);
    return Callee{found->place, known->second, block, found->variable};
}

std::optional<Reader::Callee> Reader::callee(Id<st::Expr> path) {
    const std::size_t errors = diagnostics->errors();
    if (const auto found = action(path)) return found;
    if (diagnostics->errors() != errors) return {};
    const st::Expr from = file_->exprs[path];
    if (from.op == st::Op::Name) {
        if (const auto unit = units_.find(from.word.index);
            unit != units_.end() && !scopes_[unit_.index].variables.contains(from.word.index)) {
            const bool function = file_->units[unit->second].kind == st::UnitKind::Function;
            reject(
                from.where, function ? "a function call as a statement" : "a call of a type",
                function ? "assign its value to a variable" : "declare an instance of the type, and call the instance");
            return {};
        }
        if (scopes_[unit_.index].members.contains({from.word.index, file_->intern("A").index}))
            return reject(from.where, "a call of an action of the chart", "associate the action with a step"),
                   std::nullopt;
    }
    const auto found = variable(path);
    if (!found) return {};
    const Type& type = program.types[found->type];
    if (type.kind != Type::Kind::Block || program.units[type.unit].kind != Unit::Kind::FunctionBlock) {
        diagnostics->add(messages::program_type_mismatch(from.where, "the callee", "an instance of a function block",
                                                         "`" + type.name + "`"));
        return {};
    }
    if (chart_units_.contains(type.unit.index))
        return reject(from.where, "a call of a step or action control", "write transitions or action blocks"),
               std::nullopt;
    return Callee{found->place, type.unit, type.unit, found->variable};
}

/// Adds the statements that copy a variable to the VAR_IN_OUT variable `formal` and back. Returns the copied variable;
/// empty after an error.
std::optional<Reader::Found> Reader::pass_in_out(const Found& formal, Id<st::Expr> actual, Program::Body& before,
                                                 Program::Body& after) {
    const Span where = file_->exprs[actual].where;
    const auto to = target(actual);
    if (!to) return {};
    const bool named_elsewhere = to->place.global || (unit_ == program.main && is_open());
    if (named_elsewhere || to->inside || !to->place.indices.empty() ||
        (!is_elementary(to->type) && !is_composite(to->type))) {
        reject(where, "this variable as VAR_IN_OUT",
               "pass a whole variable of this unit that no other unit can access");
        return {};
    }
    copy(formal, *to, where, before);
    copy(*to, formal, where, after);
    return to;
}

void Reader::invoke(Id<st::Expr> call, Program::Body& body) {
    const st::Expr from = file_->exprs[call];
    const auto found = callee(from.first);
    if (!found) return;
    calls_[body_.index].push_back(found->body.index);
    const Id<Unit> block = found->block;
    const bool codesys = file_->dialect == st::Dialect::Codesys;
    const std::vector<Id<st::Expr>> parts = st::operands(*file_, call);
    Program::Body results, after;
    std::vector<std::size_t> inputs, shared;
    for (std::size_t i = 0; i < program.units[block].variables.size(); ++i) {
        if (program.units[block].variables[i].section == Variable::Section::Input) inputs.push_back(i);
        if (program.units[block].variables[i].section == Variable::Section::InOut) shared.push_back(i);
    }
    std::vector<std::uint32_t> assigned;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> passed;  // [begin, end) of cells passed as VAR_IN_OUT
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const st::Expr part = file_->exprs[parts[i]];
        const bool named_one = part.op == st::Op::Argument || part.op == st::Op::Result;
        std::optional<std::size_t> index;
        if (named_one) {
            const auto known = scopes_[block.index].variables.find(part.word.index);
            if (known != scopes_[block.index].variables.end()) index = known->second;
            if (index) refer(part, program.units[block].variables[*index].origin, part.op == st::Op::Argument);
        } else if (i - 1 < inputs.size() && shared.empty()) index = inputs[i - 1];
        using Section = Variable::Section;
        const Section section = index ? program.units[block].variables[*index].section : Section::Local;
        const bool flag = codesys && part.op == st::Op::Argument && index && capitals(part.word).starts_with("SFC");
        const bool accepted = part.op == st::Op::Result
                                  ? section == Section::Output
                                  : section == Section::Input || section == Section::InOut || flag;
        if (!index || !accepted) {
            if (named_one && !index) diagnostics->add(messages::unknown(part.where, "variable", text(part.word), ""));
            else reject(part.where, "this argument", "name an input with `:=` or an output with `=>`");
            continue;
        }
        Found cell = found_in(block, static_cast<std::uint32_t>(*index));
        cell.place = shifted(found->place, cell.variable->offset);
        cell.instance = found->instance;
        cell.block = block;
        cell.inside = true;
        if (part.op == st::Op::Result) {
            const auto to = target(part.first);
            if (!to) continue;
            if (is_composite(cell.type)) {
                copy(*to, cell, part.where, results);
            } else if (const auto read = value_at(cell, part.where)) assign(*to, *read, part.where, results);
            continue;
        }
        if (std::ranges::find(assigned, cell.variable->offset) != assigned.end()) {
            reject(part.where, "a second value for this input", "pass one value for each input");
            continue;
        }
        assigned.push_back(cell.variable->offset);
        const Id<st::Expr> actual = named_one ? part.first : parts[i];
        if (section == Section::InOut) {
            const auto to = pass_in_out(cell, actual, body, after);
            if (!to) continue;
            const std::uint32_t begin = to->place.offset, end = begin + size_of(program, to->type);
            for (const auto& [first, last] : passed)
                if (begin < last && first < end)
                    reject(part.where, "a variable passed twice as VAR_IN_OUT", "pass two different variables");
            passed.emplace_back(begin, end);
        } else if (is_composite(cell.type)) {
            if (const auto whole = variable(actual)) copy(cell, *whole, part.where, body);
        } else if (const auto value = expression(actual)) {
            assign(cell, *value, part.where, body);
        }
    }
    const bool whole = found->body == block;
    if (!whole && !shared.empty() && block != unit_)
        reject(from.where, "a call of an action of a block with VAR_IN_OUT", "call the block");
    for (const std::size_t one : shared)
        if (whole && std::ranges::find(assigned, program.units[block].variables[one].offset) == assigned.end())
            reject(from.where, "a call without a variable for `" + program.units[block].variables[one].name + "`",
                   "pass a variable");
    Statement made;
    made.kind = Statement::Kind::Invoke;
    made.place = found->place;
    made.unit = found->body;
    made.origin = from.where;
    body.push_back(program.statements.add(std::move(made)));
    body.insert(body.end(), after.begin(), after.end());
    body.insert(body.end(), results.begin(), results.end());
}

}  // namespace grafverif::program
