// SPDX-License-Identifier: MIT
// Classifies the variables of a unit: variables that the chart only reads are inputs, variables that its actions assign
// are outputs, and all other variables are internal.
#include <algorithm>
#include <array>

#include "grafverif/ir/type.hpp"
#include "read/integer_ranges.hpp"
#include "read/sfc/sfc.hpp"
#include "read/xml.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

struct IntegerType {
    std::string_view name = {};
    std::int64_t low = 0, high = 0;
};
constexpr std::int64_t huge = std::int64_t{1} << 31U;
constexpr std::array<IntegerType, 13> integer_types = {{{"SINT", -128, 127},
                                                        {"INT", -32768, 32767},
                                                        {"DINT", -huge, huge},
                                                        {"LINT", -huge, huge},
                                                        {"USINT", 0, 255},
                                                        {"UINT", 0, 65535},
                                                        {"UDINT", 0, huge},
                                                        {"ULINT", 0, huge},
                                                        {"BYTE", 0, 255},
                                                        {"WORD", 0, 65535},
                                                        {"DWORD", 0, huge},
                                                        {"LWORD", 0, huge},
                                                        {"ANY_INT", -huge, huge}}};

std::optional<std::int64_t> constant_of(const st::File& file, Id<st::Expr> expr) {
    if (!expr.valid()) return {};
    const st::Expr& node = file.exprs[expr];
    switch (node.op) {
    case st::Op::Integer:
    case st::Op::Time: return node.value;
    case st::Op::True: return 1;
    case st::Op::False: return 0;
    case st::Op::Negate: {
        const auto inner = constant_of(file, node.first);
        return inner ? std::optional(-*inner) : std::nullopt;
    }
    default: return {};
    }
}

void set_type(Sfc& sfc, SfcVariable& variable, const st::Variable& declared) {
    const std::string type = declared.type.composite ? "?" : st::capitals(sfc.file.text(declared.type.name));
    const auto initial = constant_of(sfc.file, declared.initial);
    variable.initial = initial.value_or(0);
    variable.kind = SfcKind::Bad;
    if (type == "BOOL") variable.kind = SfcKind::Boolean;
    if (type == "TIME" || type == "LTIME") variable.kind = SfcKind::Time;
    for (const IntegerType& known : integer_types) {
        if (known.name != type) continue;
        variable.kind = SfcKind::Integer;
        variable.low = std::max(known.low, least_integer);
        variable.high = std::min(known.high, greatest_integer);
        variable.wide = known.low < least_integer || known.high > greatest_integer;
        const auto low = constant_of(sfc.file, declared.type.low), high = constant_of(sfc.file, declared.type.high);
        if (!low || !high) continue;
        variable.low = *low;
        variable.high = *high;
        variable.wide = false;
        variable.narrow = true;
        if (!declared.initial.valid()) variable.initial = *low;
    }
}

/// Collects the names of variables that the statements of `block` assign, in upper case.
void collect_written(const st::File& file, const st::Block& block, std::unordered_set<std::string>& written) {
    std::vector<const st::Block*> work = {&block};
    while (!work.empty()) {
        const st::Block& at = *work.back();
        work.pop_back();
        for (const Id<st::Statement> id : at) {
            const st::Statement& statement = file.statements[id];
            if (statement.target.valid()) written.insert(st::capitals(path_of(file, statement.target)));
            for (const st::Branch& branch : statement.branches) work.push_back(&branch.body);
        }
    }
}

struct WrittenVariables {
    std::unordered_set<std::string> stored = {}, acted = {};
};

WrittenVariables written_in(const Sfc& sfc) {
    WrittenVariables written;
    std::unordered_set<Id<st::Word>> actions;
    for (const st::Action& action : sfc.unit.actions) {
        actions.insert(action.name.word);
        collect_written(sfc.file, action.body, written.stored);
    }
    for (const st::Network& network : sfc.unit.networks)
        for (const st::Step& step : network.steps)
            for (const st::Association& one : step.actions) {
                collect_written(sfc.file, one.body, written.stored);
                if (one.action.valid() && !actions.contains(one.action.word))
                    written.acted.insert(st::capitals(sfc.file.text(one.action)));
            }
    return written;
}

/// Determines the role of a variable from its section and use.
void set_role(Sfc& sfc, SfcVariable& variable, const st::Variable& declared, bool stored, bool acted) {
    using Role = tree::VariableKind;
    const bool input = declared.section == st::Section::Input || declared.address.starts_with("%I") ||
                       declared.address.starts_with("%i");
    const bool output = declared.section == st::Section::Output || declared.address.starts_with("%Q") ||
                        declared.address.starts_with("%q");
    if (input) variable.role = Role::Input;
    else if (output || acted) variable.role = Role::Output;
    else if (stored)
        variable.role = declared.section == st::Section::Local || declared.section == st::Section::Temporary
                            ? Role::Internal
                            : Role::Output;
    else variable.role = Role::Input;
    const bool fixed = !stored && !acted && !input && (declared.constant || variable.kind == SfcKind::Time);
    variable.constant = fixed && declared.initial.valid();
    if (variable.role == Role::Input && !input && !variable.constant && variable.kind != SfcKind::Bad)
        variable.comment += variable.comment.empty() ? "not assigned in the chart" : "; not assigned in the chart";
    const bool wants_start = variable.initial != (variable.kind == SfcKind::Integer ? variable.low : 0);
    if (variable.role == Role::Output && stored && wants_start) {
        variable.role = Role::Internal;
        if (output)
            sfc.diagnostics().add(messages::chosen_kind(declared.name.where, sfc.file.text(declared.name),
                                                        "internal variable",
                                                        "an output cannot be declared with an initial value"));
    }
}

}  // namespace

std::string path_of(const st::File& file, Id<st::Expr> expr) {
    const st::Expr& node = file.exprs[expr];
    if (node.op == st::Op::Name || node.op == st::Op::Address) return std::string(file.text(node.word));
    if (node.op != st::Op::Member) return {};
    const std::string owner = path_of(file, node.first);  // the parser limits the depth of expressions
    return owner.empty() ? std::string() : owner + '.' + std::string(file.text(node.word));
}

void classify_variables(Sfc& sfc) {
    const WrittenVariables written = written_in(sfc);
    std::vector<const st::Variable*> declared;
    for (const st::Variable& one : sfc.unit.variables) declared.push_back(&one);
    for (const st::Variable& one : sfc.file.globals) declared.push_back(&one);
    for (const st::Variable* one : declared) {
        const std::string key = st::capitals(sfc.file.text(one->name));
        const auto known = sfc.by_name.find(key);
        if (known != sfc.by_name.end()) {  // VAR_EXTERNAL repeats a global variable without its value
            SfcVariable& first = sfc.variables[known->second];
            if (one->section == st::Section::Global && one->constant && one->initial.valid() &&
                first.role == tree::VariableKind::Input) {
                first.constant = true;
                first.initial = constant_of(sfc.file, one->initial).value_or(0);
            }
            continue;
        }
        SfcVariable variable;
        variable.name = sfc.names.make(sfc.file.text(one->name), one->name.where);
        variable.where = one->name.where;
        variable.comment = one->comment;
        set_type(sfc, variable, *one);
        set_role(sfc, variable, *one, written.stored.contains(key), written.acted.contains(key));
        sfc.by_name.emplace(key, sfc.variables.size());
        if (!one->address.empty()) sfc.by_name.emplace(st::capitals(one->address), sfc.variables.size());
        sfc.variables.push_back(std::move(variable));
    }
}

SfcVariable& variable_of(Sfc& sfc, const std::string& path, Span where, SfcKind expected, bool written) {
    const auto [known, fresh] = sfc.by_name.try_emplace(st::capitals(path), sfc.variables.size());
    if (!fresh) {
        sfc.variables[known->second].used = true;
        return sfc.variables[known->second];
    }
    SfcVariable variable;
    std::string preferred = path;
    std::ranges::replace(preferred, '.', '_');
    variable.name = sfc.names.invent(preferred);
    variable.where = where;
    variable.kind = expected;
    variable.role = written ? tree::VariableKind::Output : tree::VariableKind::Input;
    variable.low = least_integer;
    variable.high = greatest_integer;
    variable.used = true;
    if (expected != SfcKind::Integer) variable.low = 0, variable.high = 1;
    variable.comment = path + ", declared elsewhere";
    sfc.diagnostics().add(
        messages::chosen_kind(where, path, written ? "output" : "input", "the file does not declare it"));
    sfc.variables.push_back(std::move(variable));
    return sfc.variables.back();
}

std::vector<tree::ChartItem> declarations_of(Sfc& sfc) {
    std::vector<tree::ChartItem> items;
    for (SfcVariable& variable : sfc.variables) {
        if (variable.constant || variable.kind == SfcKind::Bad || variable.kind == SfcKind::Time) continue;
        if (!variable.used && variable.role == tree::VariableKind::Input && variable.comment.ends_with("in the chart"))
            continue;
        tree::Variable written;
        written.name = sfc.draft.name(variable.name, variable.where);
        written.where = variable.where;
        if (variable.kind == SfcKind::Integer) written.type = tree::TypeWord::Int;
        else if (variable.role == tree::VariableKind::Internal && variable.initial != 0)
            written.value = sfc.draft.constant(true, variable.where);
        std::string comment;
        for (const std::string& line : comment_lines(variable.comment))
            comment += comment.empty() ? line : ' ' + line.substr(3);
        if (!comment.empty()) sfc.draft.comment(variable.where, comment, true);
        items.emplace_back(tree::Variables{variable.role, {std::move(written)}, variable.where});
    }
    return items;
}

}  // namespace grafverif
