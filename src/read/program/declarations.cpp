// SPDX-License-Identifier: MIT
// Reads declarations: types, units with their variables, and the configuration.
#include <algorithm>
#include <array>
#include <utility>

#include "read/program/scope.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"

namespace grafverif::program {

namespace {

struct Elementary {
    const char* name = "";
    Type::Kind kind = Type::Kind::Integer;
    std::int64_t low = 0, high = 0;
};
constexpr std::array elementary_types = {
    Elementary{"BOOL", Type::Kind::Boolean, 0, 1},
    Elementary{"INT", Type::Kind::Integer, -32768, 32767},
    Elementary{"DINT", Type::Kind::Integer, -2147483648LL, 2147483647LL},
    Elementary{"TIME", Type::Kind::Time, 0, 2147483647LL},
    Elementary{"SINT", Type::Kind::Integer, -128, 127},
    Elementary{"USINT", Type::Kind::Integer, 0, 255},
    Elementary{"UINT", Type::Kind::Integer, 0, 65535},
    Elementary{"UDINT", Type::Kind::Integer, 0, 4294967295LL},
    Elementary{"BYTE", Type::Kind::Bits, 0, 255},
    Elementary{"WORD", Type::Kind::Bits, 0, 65535},
    Elementary{"DWORD", Type::Kind::Bits, 0, 4294967295LL},
};

constexpr std::uint32_t most_cells = 100'000;

std::string quoted(std::string_view text) { return "`" + std::string(text) + "`"; }

}  // namespace

Reader::Reader(st::File& file, const Sources& sources, Diagnostics& sink, std::vector<Chart> charts)
    : diagnostics(&sink), file_(&file), sources_(&sources), charts_(std::move(charts)) {
    for (const Elementary& one : elementary_types) {
        const Id<Type> id = program.types.add({one.kind, one.name, one.low, one.high, {}, {}});
        types_[file.intern(one.name).index] = id;
    }
    bool_ = {0};
    int_ = {1};
    dint_ = {2};
    time_ = {3};
}

void Reader::reject(Span where, std::string_view what, std::string_view hint) {
    diagnostics->add(messages::not_in_program(where, what, hint));
}

void Reader::read(std::size_t user) {
    declare_types();
    declare_units(user);
    for (std::size_t index = 0; index < file_->units.size(); ++index) {
        unit_ = declared_[index];
        const bool has_chart = !file_->units[index].networks.empty();
        Program::Body body = has_chart ? chart(index) : block(file_->units[index].body);
        program.units[unit_].body = std::move(body);
    }
    check_calls();
    choose_main(user);
}

// -- types ------------------------------------------------------------------------------------------------------------

void Reader::declare_types() {
    for (const st::TypeDeclaration& declaration : file_->types) {
        const std::uint32_t word = declaration.name.word.index;
        if (types_.contains(word)) {
            diagnostics->add(messages::duplicate_name(declaration.name.where, "type", text(declaration.name.word),
                                                      declaration.name.where));
            continue;
        }
        if (declaration.structure) {
            reject(declaration.name.where, "a structure", "declare its members as variables");
            continue;
        }
        if (declaration.initial.valid())
            reject(file_->exprs[declaration.initial].where, "an initial value of a type", "write it at the variables");
        const auto type = declaration.type.values.empty()
                              ? type_of(declaration.type, declaration.where)
                              : enumeration(text(declaration.name.word), declaration.type, declaration.where);
        if (type) types_[word] = *type;
    }
}

std::optional<Id<Type>> Reader::enumeration(std::string_view name, const st::Type& type, Span /*where*/) {
    Type made{Type::Kind::Enumeration, std::string(name), 0, static_cast<std::int64_t>(type.values.size()) - 1, {}, {}};
    const Id<Type> id{static_cast<std::uint32_t>(program.types.size())};
    for (const st::Name value : type.values) {
        const auto [place, fresh] =
            values_.try_emplace(value.word.index, id, static_cast<std::int64_t>(made.values.size()));
        if (!fresh) diagnostics->add(messages::duplicate_name(value.where, "value", text(value.word), value.where));
        made.values.push_back(text(value.word));
    }
    return program.types.add(std::move(made));
}

std::optional<Id<Type>> Reader::type_of(const st::Type& type, Span where) {
    if (!type.values.empty()) return enumeration("enumeration", type, where);
    if (type.composite)
        return reject(where, "an array, pointer or qualified type", "use elementary types"), std::nullopt;
    if (type.low.valid()) return reject(where, "a subrange", "declare the complete type"), std::nullopt;
    if (const auto known = types_.find(type.name.word.index); known != types_.end()) return known->second;
    if (const auto unit = units_.find(type.name.word.index); unit != units_.end()) {
        if (file_->units[unit->second].kind != st::UnitKind::FunctionBlock)
            return reject(type.name.where, "an instance of " + quoted(text(type.name.word)),
                          "instantiate function blocks only"),
                   std::nullopt;
        declare(unit->second);
        if (states_[unit->second] == State::Open) {
            diagnostics->add(messages::recursive_unit(type.name.where, text(type.name.word)));
            return {};
        }
        const Id<Type> id =
            program.types.add({Type::Kind::Block, text(type.name.word), 0, 0, {}, declared_[unit->second]});
        types_[type.name.word.index] = id;
        return id;
    }
    static constexpr std::array known_elsewhere = {"REAL",  "LREAL",       "STRING",       "WSTRING", "LINT",
                                                   "ULINT", "LWORD",       "LTIME",        "DATE",    "TOD",
                                                   "DT",    "TIME_OF_DAY", "DATE_AND_TIME"};
    const std::string name = capitals(type.name.word);
    if (std::ranges::find(known_elsewhere, name) != known_elsewhere.end())
        reject(type.name.where, "the type " + quoted(name), "use BOOL, TIME or an integer of at most 32 bits");
    else diagnostics->add(messages::unknown(type.name.where, "type", text(type.name.word), ""));
    return {};
}

// -- units ------------------------------------------------------------------------------------------------------------

void Reader::declare_units(std::size_t user) {
    program.globals = program.units.add({});
    program.units[program.globals].kind = Unit::Kind::Globals;
    scopes_.emplace_back();
    calls_.emplace_back();
    for (std::size_t index = 0; index < file_->units.size(); ++index) {
        const st::Unit& from = file_->units[index];
        const auto [place, fresh] = units_.try_emplace(from.name.word.index, index);
        if (!fresh)
            diagnostics->add(
                messages::duplicate_name(index < user ? from.name.where : file_->units[place->second].name.where,
                                         "unit", text(from.name.word), file_->units[place->second].name.where));
        else if (index < user && types_.contains(from.name.word.index))
            diagnostics->add(messages::duplicate_name(from.name.where, "type", text(from.name.word), from.name.where));
        Unit unit;
        unit.name = text(from.name.word);
        unit.origin = from.name.where;
        unit.kind = from.kind == st::UnitKind::Program         ? Unit::Kind::Program
                    : from.kind == st::UnitKind::FunctionBlock ? Unit::Kind::FunctionBlock
                                                               : Unit::Kind::Function;
        declared_.push_back(program.units.add(std::move(unit)));
        states_.push_back(State::New);
        scopes_.emplace_back();
        calls_.emplace_back();
    }
    declare_variables(program.globals, file_->globals, true);
    for (std::size_t index = 0; index < file_->units.size(); ++index) declare(index);
}

void Reader::declare(std::size_t index) {
    if (states_[index] != State::New) return;
    states_[index] = State::Open;
    const st::Unit& from = file_->units[index];
    const Id<Unit> id = declared_[index];
    if (from.networks.empty())
        for (const st::Action& action : from.actions)
            reject(action.where, "an action without a Sequential Function Chart", "move its statements to the body");
    if (from.kind == st::UnitKind::Function) {
        const auto type = type_of(from.result, from.result.name.where);
        if (type && program.types[*type].kind == Type::Kind::Block)
            reject(from.result.name.where, "a function block as the value of a function", "use an elementary type");
        Unit& unit = program.units[id];
        unit.result = 0;
        unit.size = 1;
        unit.variables.push_back(
            {unit.name, Variable::Section::Local, type.value_or(bool_), 0, 0, false, false, false, 0, from.name.where});
        scopes_[id.index].variables[from.name.word.index] = 0;
    }
    declare_variables(id, from.variables, from.kind == st::UnitKind::Program);
    if (!from.networks.empty()) declare_chart(index);
    Unit& unit = program.units[id];
    if (unit.size == 0) {  // every instance has at least one cell, which bounds the number of instances
        unit.size = 1;
        unit.variables.push_back({"_", Variable::Section::Local, bool_, 0, 0, false, false, false, 0, from.name.where});
    }
    for (const Variable& variable : unit.variables) {
        if (variable.section == Variable::Section::Input) unit.inputs.push_back(variable.offset);
        const bool standard = from.where.source != file_->source;
        if (standard && variable.name == "RUNNING") unit.running = variable.offset;
        if (standard && variable.name == "ELAPSED") unit.elapsed = variable.offset;
    }
    states_[index] = State::Done;
}

void Reader::declare_variables(Id<Unit> unit, const std::vector<st::Variable>& variables, bool is_program) {
    std::vector<const st::Variable*> located;
    for (const st::Variable& variable : variables) {
        declare(unit, variable, is_program);
        if (!variable.address.empty()) located.push_back(&variable);
        if (program.units[unit].size > most_cells) {
            diagnostics->add(messages::program_too_large(variable.where, "variables", most_cells));
            break;
        }
    }
    check_addresses(located);
}

void Reader::declare(Id<Unit> id, const st::Variable& from, bool is_program) {
    Unit& unit = program.units[id];
    Scope& scope = scopes_[id.index];
    const std::uint32_t word = from.name.word.index;
    if (const auto old = scope.variables.find(word); old != scope.variables.end() || scope.externals.contains(word)) {
        const Span first = old != scope.variables.end() ? unit.variables[old->second].origin : scope.externals.at(word);
        diagnostics->add(messages::duplicate_name(from.name.where, "variable", text(from.name.word), first));
        return;
    }
    if (from.section == st::Section::External) {
        scope.externals[word] = from.name.where;
        const auto known = scopes_[program.globals.index].variables.find(word);
        if (known == scopes_[program.globals.index].variables.end())
            diagnostics->add(messages::unknown(from.name.where, "variable", text(from.name.word), ""));
        else if (const auto type = type_of(from.type, from.where);
                 type && *type != program.units[program.globals].variables[known->second].type)
            reject(from.name.where, "an external variable of another type",
                   "declare it with the type of the global one");
        return;
    }
    if (from.section == st::Section::InOut)
        return reject(from.name.where, "VAR_IN_OUT", "pass the value in and assign it back");
    const auto type = type_of(from.type, from.where);
    if (!type) return;
    Unit& target = program.units[id];  // read again, because type_of may have added units' variables
    Variable made;
    made.name = text(from.name.word);
    made.type = *type;
    made.offset = target.size;
    made.constant = from.constant;
    made.origin = from.name.where;
    const bool block = program.types[*type].kind == Type::Kind::Block;
    const bool function = target.kind == Unit::Kind::Function;
    if (block && (function || from.section != st::Section::Local) && from.section != st::Section::Global)
        return reject(from.name.where, "an instance in this section",
                      "declare it in VAR of a program or function block");
    if (function && from.section == st::Section::Output)
        return reject(from.name.where, "an output of a function", "use a function block");
    if (block && from.initial.valid())
        return reject(file_->exprs[from.initial].where, "an initial value of an instance", "assign its inputs");
    if (!from.address.empty() && (!is_program || function || block))
        return reject(from.name.where, "an address here", "declare it in a program or in VAR_GLOBAL");
    switch (from.section) {
    case st::Section::Input: made.section = Variable::Section::Input; break;
    case st::Section::Output: made.section = Variable::Section::Output; break;
    case st::Section::Temporary: made.section = Variable::Section::Temporary; break;
    default: break;
    }
    const std::string address = st::capitals(from.address);
    const bool global = target.kind == Unit::Kind::Globals;
    made.input = is_program && ((!global && from.section == st::Section::Input) || address.starts_with("%I"));
    made.output = is_program && ((!global && from.section == st::Section::Output) || address.starts_with("%Q"));
    if (made.constant && made.input) made.input = false;
    if (from.initial.valid()) {
        unit_ = id;
        if (const auto value = constant(from.initial, *type)) made.initial = *value;
    }
    Unit& last = program.units[id];
    last.size += block ? program.units[program.types[*type].unit].size : 1;
    scopes_[id.index].variables[word] = static_cast<std::uint32_t>(last.variables.size());
    last.variables.push_back(std::move(made));
}

/// Reports variables at one address: they share their value, but cells do not.
void Reader::check_addresses(const std::vector<const st::Variable*>& located) {
    std::map<std::string, const st::Variable*> seen;
    for (const st::Variable* variable : located) {
        std::string address = st::capitals(variable->address);
        if (address.ends_with('*')) continue;
        const bool bit = address.size() > 2 && (address[2] == 'X' || (address[2] >= '0' && address[2] <= '9'));
        if (bit && address[2] == 'X') address.erase(2, 1);
        const auto [place, fresh] = seen.try_emplace(address, variable);
        if (!fresh)
            reject(variable->name.where, "a second variable at " + quoted(variable->address),
                   "use one variable for each address");
    }
    // A bit lies in a word of the same area. Only areas with elements of equal size are known to be disjoint.
    std::map<char, char> sizes;
    for (const st::Variable* variable : located) {
        const std::string address = st::capitals(variable->address);
        if (address.size() < 3) continue;
        const char size =
            address[2] == 'B' || address[2] == 'W' || address[2] == 'D' || address[2] == 'L' ? address[2] : 'X';
        const auto [place, fresh] = sizes.try_emplace(address[1], size);
        if (!fresh && place->second != size && !address.ends_with('*')) {
            place->second = size;
            reject(variable->name.where, "an address of another size in the same area",
                   "leave out the addresses, or use one size per area");
        }
    }
}

std::optional<std::int64_t> Reader::constant(Id<st::Expr> expr, Id<Type> type) {
    const auto value = expression(expr);
    if (!value) return {};
    const auto node = converted(*value, type, file_->exprs[expr].where, "the initial value");
    if (!node) return {};
    const auto known = value_of(*node);
    if (!known) diagnostics->add(messages::not_constant(file_->exprs[expr].where, "the initial value"));
    return known;
}

// -- the program ------------------------------------------------------------------------------------------------------

void Reader::choose_main(std::size_t user) {
    std::optional<std::size_t> chosen;
    for (const st::Instance& instance : file_->instances) {
        if (chosen) {
            reject(instance.where, "a second program instance", "check each program separately");
            continue;
        }
        const auto unit = units_.find(instance.type.word.index);
        if (unit == units_.end() || file_->units[unit->second].kind != st::UnitKind::Program) {
            diagnostics->add(messages::unknown(instance.type.where, "program", text(instance.type.word), ""));
            continue;
        }
        if (!instance.arguments.empty())
            reject(instance.where, "a connection of a program instance", "declare addresses at its variables");
        chosen = unit->second;
        task_of(instance);
    }
    if (!chosen && file_->instances.empty()) {
        for (std::size_t index = 0; index < user; ++index) {
            if (file_->units[index].kind != st::UnitKind::Program) continue;
            if (chosen)
                diagnostics->add(
                    messages::several_programs(file_->units[index].name.where, text(file_->units[index].name.word)));
            else chosen = index;
        }
        if (!chosen) diagnostics->add(messages::no_program({file_->source, 0, 0}));
    }
    program.main = chosen ? declared_[*chosen] : program.globals;
}

void Reader::task_of(const st::Instance& instance) {
    if (!instance.task.valid()) return;
    for (const st::Task& task : file_->tasks) {
        if (task.name.word != instance.task.word) continue;
        for (const Id<st::Expr> argument : task.arguments) {
            const st::Expr& node = file_->exprs[argument];
            const std::string name = node.op == st::Op::Argument ? capitals(node.word) : "";
            if (name == "PRIORITY") continue;
            const st::Expr& value = file_->exprs[node.first.valid() ? node.first : argument];
            if (name == "INTERVAL" && value.op == st::Op::Time) {
                if (value.value > 0) program.interval_ms = value.value;
            } else reject(node.where, "this parameter of a task", "give `INTERVAL` as a duration");
        }
        return;
    }
    diagnostics->add(messages::unknown(instance.task.where, "task", text(instance.task.word), ""));
}

/// Checks that no function calls itself directly or indirectly.
void Reader::check_calls() {
    enum class Mark { White, Grey, Black };
    std::vector<Mark> marks(program.units.size(), Mark::White);
    std::vector<char> reported(marks.size());
    struct Frame {
        std::uint32_t unit = 0;
        std::size_t next = 0;
    };
    for (std::uint32_t root = 0; root < marks.size(); ++root) {
        if (marks[root] != Mark::White) continue;
        std::vector<Frame> stack = {{root, 0}};
        marks[root] = Mark::Grey;
        while (!stack.empty()) {
            Frame& top = stack.back();
            if (top.next == calls_[top.unit].size()) {
                marks[top.unit] = Mark::Black;
                stack.pop_back();
                continue;
            }
            const std::uint32_t callee = calls_[top.unit][top.next++];
            if (marks[callee] == Mark::Grey) {
                const Unit& unit = program.units[{callee}];
                if (std::exchange(reported[callee], char{1}) != 0) continue;
                diagnostics->add(messages::recursive_unit(unit.origin, unit.name));
            } else if (marks[callee] == Mark::White) {
                marks[callee] = Mark::Grey;
                stack.push_back({callee, 0});
            }
        }
    }
}

}  // namespace grafverif::program
