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

}  // namespace

Reader::Reader(st::File& file, const Sources& sources, Diagnostics& sink, std::vector<UnitCharts> charts,
               const Recorder& record)
    : diagnostics(&sink), file_(&file), sources_(&sources), record_(record), charts_(std::move(charts)) {
    for (const Elementary& one : elementary_types) {
        const Id<Type> id = program.types.add({one.kind, one.name, one.low, one.high, {}, {}, {}});
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
    program.globals = program.units.add({});
    program.units[program.globals].kind = Unit::Kind::Globals;
    scopes_.emplace_back();
    calls_.emplace_back();
    unit_ = body_ = program.globals;
    main_block_ = main_block(user);
    index_types();
    declare_names(user);
    declare_types();
    declare_units();
    choose_main(user);
    for (std::size_t index = 0; index < file_->units.size(); ++index) read_body(index);
    check_calls();
    record_ = {};
}

void Reader::read_body(std::size_t index) {
    const st::Unit& from = file_->units[index];
    const bool codesys = file_->dialect == st::Dialect::Codesys;
    unit_ = body_ = declared_[index];
    record_chart(index);
    Program::Body body;
    if (from.networks.empty()) body = block(from.body);
    else body = codesys ? codesys_chart(charts_[index].body, from.networks.front()) : chart(index);
    program.units[unit_].body = std::move(body);
    for (std::size_t i = 0; i < from.actions.size(); ++i) {
        const st::Action& action = from.actions[i];
        const auto known = scopes_[unit_.index].actions.find(action.name.word.index);
        if (known == scopes_[unit_.index].actions.end()) continue;
        body_ = known->second;
        body = action.networks.empty() ? block(action.body)
                                       : codesys_chart(charts_[index].actions[i], action.networks.front());
        program.units[body_].body = std::move(body);
    }
}

/// Returns the function block to execute as the program: the only function block that no unit instantiates. The result
/// is empty if this block is not unique, or if the file has programs or program instances.
std::optional<std::size_t> Reader::main_block(std::size_t user) const {
    if (!file_->instances.empty()) return {};
    std::set<std::uint32_t> instantiated;
    for (std::size_t index = 0; index < user; ++index)
        for (const st::Variable& variable : file_->units[index].variables)
            instantiated.insert(variable.type.name.word.index);
    std::optional<std::size_t> found;
    for (std::size_t index = 0; index < user; ++index) {
        const st::Unit& unit = file_->units[index];
        if (unit.kind == st::UnitKind::Program) return {};
        if (unit.kind != st::UnitKind::FunctionBlock || instantiated.contains(unit.name.word.index)) continue;
        if (found) return {};
        found = index;
    }
    return found;
}

void Reader::warn_once(std::string_view what, std::string_view reading, Span where) {
    if (warned_.insert(std::string(reading)).second) diagnostics->add(messages::undocumented(where, what, reading));
}

// -- units ------------------------------------------------------------------------------------------------------------

/// Adds all units of the file without their contents, because declarations can refer to later units.
void Reader::declare_names(std::size_t user) {
    for (std::size_t index = 0; index < file_->units.size(); ++index) {
        const st::Unit& from = file_->units[index];
        const auto [place, fresh] = units_.try_emplace(from.name.word.index, index);
        if (!fresh)
            diagnostics->add(
                messages::duplicate_name(index < user ? from.name.where : file_->units[place->second].name.where,
                                         "unit", text(from.name.word), file_->units[place->second].name.where));
        else if (index < user &&
                 (types_.contains(from.name.word.index) || type_declarations_.contains(from.name.word.index)))
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
}

void Reader::declare_units() {
    for (const st::Unit& from : file_->units) record_unit(from);
    declare_variables(program.globals, file_->globals, true);
    for (std::size_t index = 0; index < file_->units.size(); ++index) declare(index);
}

void Reader::declare(std::size_t index) {
    if (states_[index] != State::New) return;
    states_[index] = State::Open;
    const st::Unit& from = file_->units[index];
    const Id<Unit> id = declared_[index];
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
    declare_variables(id, from.variables, from.kind == st::UnitKind::Program || index == main_block_);
    if (!from.networks.empty() && file_->dialect == st::Dialect::Standard) declare_chart(index);
    else declare_actions(index);
    Unit& unit = program.units[id];
    if (unit.size == 0) {  // one cell per instance, so that the limit of cells limits the instances
        unit.size = 1;
        unit.variables.push_back({"_", Variable::Section::Local, bool_, 0, 0, false, false, false, 0, from.name.where});
    }
    for (const Variable& variable : unit.variables) {
        if (variable.section == Variable::Section::Input) unit.inputs.push_back(variable.offset);
        const bool standard = from.where.source != file_->source;
        const std::string name = st::capitals(variable.name);  // names are not case-sensitive
        if (standard && name == "RUNNING") unit.running = variable.offset;
        if (standard && name == "ELAPSED") unit.elapsed = variable.offset;
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
        record_variable(id, from, {});
        return;
    }
    if (from.section == st::Section::External) {
        scope.externals[word] = from.name.where;
        const auto known = scopes_[program.globals.index].variables.find(word);
        if (known != scopes_[program.globals.index].variables.end())
            record_.refer(from.name.where, program.units[program.globals].variables[known->second].origin);
        if (known == scopes_[program.globals.index].variables.end())
            diagnostics->add(messages::unknown(from.name.where, "variable", text(from.name.word), ""));
        else if (const auto type = type_of(from.type, from.where);
                 type && *type != program.units[program.globals].variables[known->second].type)
            reject(from.name.where, "an external variable of another type",
                   "declare it with the type of the global variable");
        return;
    }
    unit_ = body_ = id;  // bounds of types can name constants of this unit
    const auto type = type_of(from.type, from.where);
    record_variable(id, from, type);
    if (!type) return;
    if (!is_allowed(program.units[id], from, *type, is_program)) return;
    Unit& target = program.units[id];  // type_of may have reallocated the units
    Variable made;
    made.name = text(from.name.word);
    made.type = *type;
    made.offset = target.size;
    made.constant = from.constant;
    made.origin = from.name.where;
    made.initialized = from.initial.valid();
    program.retains = program.retains || from.retain;
    switch (from.section) {
    case st::Section::Input: made.section = Variable::Section::Input; break;
    case st::Section::Output: made.section = Variable::Section::Output; break;
    case st::Section::InOut: made.section = Variable::Section::InOut; break;
    case st::Section::Temporary: made.section = Variable::Section::Temporary; break;
    default: break;
    }
    const std::string address = st::capitals(from.address);
    const bool global = target.kind == Unit::Kind::Globals;
    const Type of = program.types[*type];
    const bool instance = of.kind == Type::Kind::Block && program.units[of.unit].kind != Unit::Kind::Structure;
    made.input =
        !instance && ((is_program && !global && from.section == st::Section::Input) || address.starts_with("%I"));
    made.output =
        !instance && ((is_program && !global && from.section == st::Section::Output) || address.starts_with("%Q"));
    if (made.constant && made.input) made.input = false;
    if (made.input && file_->dialect == st::Dialect::Codesys && capitals(from.name.word) == "SFCINIT")
        reject(from.name.where, "`SFCInit` as an input of the program", "remove it");
    if (of.kind == Type::Kind::Integer && of.element.valid()) made.initial = of.low <= 0 && of.high >= 0 ? 0 : of.low;
    if (from.initial.valid() && of.kind != Type::Kind::Unsupported) {
        unit_ = body_ = id;
        if (const auto value = constant(from.initial, *type)) made.initial = *value;
    }
    Unit& last = program.units[id];
    last.size += size_of(program, *type);
    scopes_[id.index].variables[word] = static_cast<std::uint32_t>(last.variables.size());
    last.variables.push_back(std::move(made));
}

/// True if the unit is allowed to have this variable. Otherwise, reports the variable.
bool Reader::is_allowed(const Unit& unit, const st::Variable& from, Id<Type> type, bool is_program) {
    const Span where = from.name.where;
    const Type& of = program.types[type];
    const bool composite = of.kind == Type::Kind::Block || of.kind == Type::Kind::Array;
    const bool instances = composite && !is_composite(type);
    const bool function = unit.kind == Unit::Kind::Function;
    const bool codesys = file_->dialect == st::Dialect::Codesys;
    const bool own_section = from.section == st::Section::Local || from.section == st::Section::Global;
    const bool incomplete = from.address.ends_with('*') && unit.kind == Unit::Kind::FunctionBlock;
    std::string_view what, hint;
    if (from.section == st::Section::InOut && (unit.kind != Unit::Kind::FunctionBlock || is_program || instances)) {
        what = "this variable in VAR_IN_OUT";
        hint = "use VAR_IN_OUT only in function blocks, and only for variables that contain no function block instance";
    } else if (instances && unit.kind != Unit::Kind::Structure && (function || (!own_section && !codesys))) {
        what = "a function block instance in this section";
        hint = "declare it in VAR of a program or function block";
    } else if (instances && from.section == st::Section::Temporary) {
        what = "a function block instance in this section";
        hint = "declare it in VAR of a program or function block";
    } else if (function && from.section == st::Section::Output) {
        what = "an output of a function";
        hint = "use a function block";
    } else if (function && from.section == st::Section::Input && !is_elementary(type)) {
        what = "a function input of this type";
        hint = "use a function block";
    } else if (composite && from.initial.valid()) {
        what = of.kind == Type::Kind::Array ? "an initial value of an array" : "an initial value of an instance";
        hint = "assign its elements or members in a statement";
    } else if (!from.address.empty() && ((!is_program && !incomplete) || function || composite)) {
        what = "an address of this variable";
        hint =
            "use addresses only for elementary variables of a program or VAR_GLOBAL, or `AT %I*` in a function block";
    }
    if (!what.empty()) reject(where, what, hint);
    return what.empty();
}

/// Declares the actions of a unit that statements can call, and in CODESYS also the cells of its charts.
void Reader::declare_actions(std::size_t index) {
    const Id<Unit> id = declared_[index];
    const st::Unit& from = file_->units[index];
    for (std::size_t i = 0; i < from.actions.size(); ++i) {
        const st::Action& action = from.actions[i];
        if (from.kind == st::UnitKind::Function)
            reject(action.where, "an action of a function", "write its statements into the body");
        if (action.opaque) reject(action.where, "an action in this language", "write it in Structured Text");
        Unit unit;
        unit.kind = Unit::Kind::Action;
        unit.name = text(action.name.word);
        unit.owner = id;
        unit.origin = action.name.where;
        const auto [known, fresh] = scopes_[id.index].actions.try_emplace(action.name.word.index);
        if (!fresh) {
            diagnostics->add(messages::duplicate_name(action.name.where, "action", text(action.name.word),
                                                      program.units[known->second].origin));
            continue;
        }
        if (const auto variable = scopes_[id.index].variables.find(action.name.word.index);
            variable != scopes_[id.index].variables.end())
            diagnostics->add(messages::duplicate_name(action.name.where, "variable", text(action.name.word),
                                                      program.units[id].variables[variable->second].origin));
        known->second = program.units.add(std::move(unit));
        scopes_.emplace_back();
        calls_.emplace_back();
        if (!action.networks.empty())
            declare_codesys(index, charts_[index].actions[i], action.networks.front(), text(action.name.word) + ".");
    }
    if (!from.networks.empty()) declare_codesys(index, charts_[index].body, from.networks.front(), "");
}

/// Rejects several variables with the same address: in the PLC they share one value, but in a Program each memory cell
/// has a separate value.
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
    // A bit can be part of a word in the same memory area (I, Q or M). The addresses in an area are known to be
    // disjoint only if all of them have the same size.
    std::map<char, char> sizes;
    for (const st::Variable* variable : located) {
        const std::string address = st::capitals(variable->address);
        if (address.size() < 3) continue;
        const char size =
            address[2] == 'B' || address[2] == 'W' || address[2] == 'D' || address[2] == 'L' ? address[2] : 'X';
        const auto [place, fresh] = sizes.try_emplace(address[1], size);
        if (!fresh && place->second != size && !address.ends_with('*')) {
            place->second = size;
            reject(variable->name.where, "an address whose size differs from that of another address in its area",
                   "remove the addresses, or use one size in each area");
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
        record_.refer(instance.type.where, file_->units[unit->second].name.where);
        if (!instance.arguments.empty())
            reject(instance.where, "an argument of a program instance",
                   "declare each variable with its address in the program, as in `Go AT %IX0.0 : BOOL;`");
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
        if (!chosen) chosen = main_block_;
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
            } else reject(node.where, "this parameter of a task", "use only `PRIORITY` and a duration as `INTERVAL`");
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
