// SPDX-License-Identifier: MIT
// Converts Sequential Function Charts of CODESYS to statements. Source: the pages "Processing Order in SFC", "SFC
// Element: Action", "Qualifiers for Actions in SFC", "SFC Flags" and "Implicit Variables" of the CODESYS Online Help. A
// step has three variables: X is true if the step is active in this execution, and _X if it is active in the next
// execution; t is the time since the activation of the step. Only transitions of the same chart can read t. Each
// execution of a chart:
//   1. copies _X to X; executes exit actions of deactivated steps, then entry actions of activated steps, then actions
//      of active steps, each in the order of the file, which is the order of the drawing;
//   2. executes the actions of action blocks in alphabetical order: first the actions that end, then the actions whose
//      Q (see ACTION_CONTROL) is true. If the action is a Boolean variable, the variable becomes false when the action
//      ends, and is true while Q is true;
//   3. evaluates the transitions of active steps, which determine _X; if several transitions after one step are
//      enabled, the leftmost transition is cleared.
//
// If the documentation does not define the behaviour, grafverif chooses an interpretation and reports a warning:
//   - S and R of a Boolean variable set and reset one stored value per instance of the unit; all charts of the instance
//     use this value; while R is active, the variable is false;
//   - SFCReset sets _X of the initial step and resets the stored values of S and R; exit actions are not executed, and
//     actions in action blocks end;
//   - if the file does not contain the settings of the chart, a variable with the name of a flag acts as this flag.
#include <algorithm>
#include <utility>

#include "read/program/scope.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"

namespace grafverif::program {

namespace {

using Op = Program::Op;
constexpr std::uint32_t next_offset = 1, since_offset = 2;  // offsets of _X and t in the cells of a step

bool names(const std::vector<st::Name>& list, Id<st::Word> step) {
    return std::ranges::find(list, step, &st::Name::word) != list.end();
}

}  // namespace

// -- declarations -----------------------------------------------------------------------------------------------------

Id<Type> Reader::codesys_step_type(bool initial) {
    Id<Type>& type = codesys_steps_[initial ? 1 : 0];
    if (type.valid()) return type;
    Unit unit;
    unit.kind = Unit::Kind::FunctionBlock;
    unit.name = "STEP";
    unit.size = 3;
    unit.running = 0;
    unit.elapsed = since_offset;
    Variable active, next, time;
    active.name = "X";
    active.section = next.section = time.section = Variable::Section::Output;
    time.name = "t";
    time.type = time_;
    time.offset = since_offset;
    active.type = next.type = bool_;
    next.name = "_X";
    next.offset = next_offset;
    next.initial = initial ? 1 : 0;
    unit.variables = {active, next, time};
    const Id<Unit> id = program.units.add(std::move(unit));
    scopes_.emplace_back();
    scopes_.back().variables = {{file_->intern("X").index, 0}, {file_->intern("_X").index, 1}};
    calls_.emplace_back();
    chart_units_.insert(id.index);
    return type = program.types.add({Type::Kind::Block, "STEP", 0, 0, {}, id, {}});
}

/// Declares the variables of a chart. `prefix` precedes the names of the steps; it is empty for the chart in the body
/// of the unit.
void Reader::declare_codesys(std::size_t index, Chart& chart, const st::Network& network, const std::string& prefix) {
    const Id<Unit> id = declared_[index];
    for (const auto& [name, used] : {std::pair("SFCReset", network.flags.reset), {"SFCPause", network.flags.pause}}) {
        const std::uint32_t word = file_->intern(name).index;
        if (!used || scopes_[id.index].variables.contains(word)) continue;
        scopes_[id.index].variables[word] = static_cast<std::uint32_t>(program.units[id].variables.size());
        add_cells(id, name, bool_, network.where);
    }
    for (const st::Step& step : network.steps) {
        const auto variable = static_cast<std::uint32_t>(program.units[id].variables.size());
        for (const std::string_view member : {"X", "_X"}) {
            const auto [known, fresh] =
                scopes_[id.index].members.try_emplace({step.name.word.index, file_->intern(member).index}, variable);
            if (!fresh) known->second = ambiguous_member;
        }
        const Id<Type> type = codesys_step_type(step.initial);
        chart.variables.push_back(variable);
        chart.steps.push_back(add_cells(id, prefix + text(step.name.word), type, step.where));
        chart.before.push_back(
            add_cells(id, prefix + text(step.name.word) + " before", bool_, step.where, Variable::Section::Temporary));
    }
    for (ChartAction& action : chart.actions) {
        const std::string name = prefix + "action " + action.label;
        if (action.controlled) {
            declare(action.control);
            const Id<Unit> control = declared_[action.control];
            chart_units_.insert(control.index);
            action.cell =
                add_cells(id, name, program.types.add({Type::Kind::Block, "ACTION_CONTROL", 0, 0, {}, control, {}}),
                          action.where);
        }
        action.value = add_cells(id, name + " active", bool_, action.where, Variable::Section::Temporary);
        action.resets = add_cells(id, name + " reset", bool_, action.where, Variable::Section::Temporary);
        action.before = add_cells(id, name + " before", bool_, action.where);
        const bool stores = action.steps.contains("S") || action.steps.contains("R");
        const auto known = scopes_[id.index].stored.find(action.label);
        if (known != scopes_[id.index].stored.end()) {
            if (stores)
                warn_once("the effect of S and R on one Boolean variable in several charts of a block",
                          "all charts of an instance are assumed to set and reset the same stored value", action.where);
            action.stored = known->second;
        } else {
            action.stored = add_cells(id, "action " + action.label + " stored", bool_, action.where);
            scopes_[id.index].stored[action.label] = action.stored;
        }
    }
    for (std::size_t i = 0; i < network.transitions.size(); ++i)
        chart.cleared.push_back(add_cells(id, prefix + "transition " + std::to_string(i + 1), bool_,
                                          network.transitions[i].where, Variable::Section::Temporary));
}

// -- statements -------------------------------------------------------------------------------------------------------

/// Returns the variable of a flag, such as SFCReset. The result is empty if the chart does not use the flag.
std::optional<Reader::Found> Reader::flag_of(std::string_view name, bool stated, bool used, Span where) {
    const auto known = scopes_[unit_.index].variables.find(file_->intern(name).index);
    if (known == scopes_[unit_.index].variables.end() || (stated && !used)) return {};
    if (!stated)
        warn_once(
            "the effect of a declared variable `" + std::string(name) + "` if the file has no settings of the chart",
            "the variable is assumed to act as a flag", where);
    return found_in(unit_, known->second);
}

Program::Body Reader::codesys_chart(Chart& chart, const st::Network& network) {
    if (!chart.valid) return {};
    Program::Body body, run;
    const st::ChartFlags& flags = network.flags;
    if (const auto flag = flag_of("SFCReset", flags.stated, flags.reset, network.where)) {
        Program::Arm arm{value_at(*flag, network.where)->node, {}, {}};
        reset(chart, network, arm.body);
        add_if({std::move(arm)}, network.where, run);
    }
    execute_steps(chart, network, run);
    std::vector<Id<st::Word>> steps;
    for (const st::Step& step : network.steps) steps.push_back(step.name.word);
    for (std::size_t i = 0; i < chart.actions.size(); ++i) control_codesys(i, steps, chart, run);
    execute_actions(chart, run);
    evaluate_transitions(chart, network, run);
    const auto pause = flag_of("SFCPause", flags.stated, flags.pause, network.where);
    if (!pause) return run;
    const Id<Node> runs = add(Op::Not, bool_, {value_at(*pause, network.where)->node}, network.where);
    add_if({Program::Arm{runs, {}, std::move(run)}}, network.where, body);
    return body;
}

void Reader::reset(const Chart& chart, const st::Network& network, Program::Body& body) {
    const bool has_exit = std::ranges::any_of(network.steps, [](const st::Step& step) { return step.exit.valid(); });
    if (has_exit || !chart.actions.empty())
        warn_once("the effect of `SFCReset` on exit actions and action blocks",
                  "exit actions are assumed not to be executed, and actions in action blocks are assumed to end",
                  network.where);
    for (std::size_t i = 0; i < network.steps.size(); ++i) {
        const st::Step& step = network.steps[i];
        store(chart.steps[i], bool_, number(0, bool_, step.where), step.where, body);
        store(chart.steps[i] + next_offset, bool_, number(step.initial ? 1 : 0, bool_, step.where), step.where, body);
    }
    for (const ChartAction& action : chart.actions)
        store(action.stored, bool_, number(0, bool_, action.where), action.where, body);
}

/// Adds the call of an action of this unit or of an instance.
void Reader::execute_action(Id<st::Expr> path, Program::Body& body) {
    const Span where = file_->exprs[path].where;
    const std::size_t errors = diagnostics->errors();
    const auto found = action(path);
    if (!found) {
        if (diagnostics->errors() == errors)
            diagnostics->add(messages::unknown(where, "action", path_text(*file_, path), ""));
        return;
    }
    calls_[body_.index].push_back(found->body.index);
    Statement made;
    made.kind = Statement::Kind::Invoke;
    made.place = found->place;
    made.unit = found->body;
    made.origin = where;
    body.push_back(program.statements.add(std::move(made)));
}

void Reader::execute_steps(const Chart& chart, const st::Network& network, Program::Body& body) {
    const auto flag_at = [&](std::uint32_t cell, Span where) { return read(cell, bool_, where); };
    const auto execute = [&](Id<st::Expr> path, std::vector<Id<Node>> conditions, Span where) {
        Program::Arm arm{all(Op::And, std::move(conditions), where), {}, {}};
        execute_action(path, arm.body);
        add_if({std::move(arm)}, where, body);
    };
    for (std::size_t i = 0; i < network.steps.size(); ++i) {
        const Span where = network.steps[i].where;
        store(chart.before[i], bool_, flag_at(chart.steps[i], where), where, body);
        store(chart.steps[i], bool_, flag_at(chart.steps[i] + next_offset, where), where, body);
    }
    for (std::size_t i = 0; i < network.steps.size(); ++i) {
        const Span where = network.steps[i].where;
        const Id<Node> old = add(Op::Not, bool_, {flag_at(chart.before[i], where)}, where);
        Program::Arm fresh{all(Op::And, {flag_at(chart.steps[i], where), old}, where), {}, {}};
        store(chart.steps[i] + since_offset, time_, number(0, time_, where), where, fresh.body);
        add_if({std::move(fresh)}, where, body);
    }
    for (std::size_t i = 0; i < network.steps.size(); ++i) {
        const st::Step& step = network.steps[i];
        if (!step.exit.valid()) continue;
        const Id<Node> left = add(Op::Not, bool_, {flag_at(chart.steps[i], step.where)}, step.where);
        execute(step.exit, {flag_at(chart.before[i], step.where), left}, step.where);
    }
    for (std::size_t i = 0; i < network.steps.size(); ++i) {
        const st::Step& step = network.steps[i];
        if (!step.entry.valid()) continue;
        const Id<Node> fresh = add(Op::Not, bool_, {flag_at(chart.before[i], step.where)}, step.where);
        execute(step.entry, {flag_at(chart.steps[i], step.where), fresh}, step.where);
    }
    for (std::size_t i = 0; i < network.steps.size(); ++i) {
        const st::Step& step = network.steps[i];
        if (step.active.valid()) execute(step.active, {flag_at(chart.steps[i], step.where)}, step.where);
    }
}

/// Returns the memory cell of a variable in the ACTION_CONTROL instance of an action.
std::uint32_t Reader::control_cell(const ChartAction& one, std::string_view name) {
    const Id<Unit> block = declared_[one.control];
    const std::uint32_t index = scopes_[block.index].variables.at(file_->intern(name).index);
    return one.cell + program.units[block].variables[index].offset;
}

/// Adds the statements that compute Q of an action from its action blocks.
void Reader::control_codesys(std::size_t index, const std::vector<Id<st::Word>>& steps, const Chart& chart,
                             Program::Body& body) {
    const ChartAction& one = chart.actions[index];
    const Span where = one.where;
    const auto any_of = [&](const std::vector<Id<st::Word>>& of) {
        std::vector<Id<Node>> any;
        for (const Id<st::Word> step : of) {
            const auto at = static_cast<std::size_t>(std::ranges::find(steps, step) - steps.begin());
            any.push_back(read(chart.steps[at], bool_, where));
        }
        return all(Op::Or, std::move(any), where);
    };
    const auto active = [&](std::string_view qualifier) {
        const auto named = one.steps.find(std::string(qualifier));
        return any_of(named == one.steps.end() ? std::vector<Id<st::Word>>() : named->second);
    };
    store(one.resets, bool_, active("R"), where, body);
    Program::Arm reset{read(one.resets, bool_, where), {}, {}}, set{active("S"), {}, {}};
    store(one.stored, bool_, number(0, bool_, where), where, reset.body);
    store(one.stored, bool_, number(1, bool_, where), where, set.body);
    if (one.steps.contains("R") || one.steps.contains("S")) add_if({std::move(reset), std::move(set)}, where, body);
    std::vector<Id<Node>> value = {active("N"), read(one.stored, bool_, where)};
    if (one.controlled) {
        const auto cell = [&](std::string_view name) { return control_cell(one, name); };
        for (const auto& [qualifier, ignored] : one.steps) {
            const bool own = qualifier == "N" || qualifier == "S";
            store(cell(qualifier), bool_, own ? number(0, bool_, where) : active(qualifier), where, body);
        }
        std::vector<Id<Node>> durations;
        for (const std::vector<Id<st::Word>>& of : one.durations) durations.push_back(any_of(of));
        for (std::size_t i = 0; i < durations.size(); ++i)
            store(cell("TIME_" + std::to_string(i + 1)), bool_, durations[i], where, body);
        check_durations(chart, index, durations, body);
        if (one.time.valid()) {
            const auto time = expression(one.time);
            const Span at = file_->exprs[one.time].where;
            const auto node = time ? converted(*time, time_, at, "the duration") : std::nullopt;
            if (node) store(cell("T"), time_, *node, at, body);
        }
        Statement made;
        made.kind = Statement::Kind::Invoke;
        made.place = {false, one.cell, {}};
        made.unit = declared_[one.control];
        made.generated = true;
        made.origin = where;
        body.push_back(program.statements.add(std::move(made)));
        value.push_back(read(cell("Q"), bool_, where));
    }
    const Id<Node> no_reset = add(Op::Not, bool_, {read(one.resets, bool_, where)}, where);
    store(one.value, bool_, all(Op::And, {no_reset, all(Op::Or, std::move(value), where)}, where), where, body);
}

void Reader::execute_actions(const Chart& chart, Program::Body& body) {
    for (const bool ending : {true, false}) {
        for (const ChartAction& one : chart.actions) {
            const Span where = one.where;
            const Id<Node> value = read(one.value, bool_, where);
            const std::size_t errors = diagnostics->errors();
            const auto called = action(one.path);
            if (!called && diagnostics->errors() != errors) continue;
            std::vector<Id<Node>> any = {read(one.before, bool_, where)};
            if (one.controlled) any.push_back(read(control_cell(one, "A"), bool_, where));
            if (!called) any.push_back(read(one.resets, bool_, where));
            if (!called && ending && (one.steps.contains("P0") || one.steps.contains("P1")))
                reject(where, "the qualifier `P0` or `P1` for a Boolean variable", "use the qualifier `P`");
            const Id<Node> ends =
                all(Op::And, {all(Op::Or, std::move(any), where), add(Op::Not, bool_, {value}, where)}, where);
            Program::Arm arm{ending ? ends : value, {}, {}};
            if (called) {
                execute_action(one.path, arm.body);
            } else if (const auto cell = target(one.path)) {
                assign(*cell, {number(ending ? 0 : 1, bool_, where), false}, where, arm.body);
            }
            add_if({std::move(arm)}, where, body);
        }
    }
    for (const ChartAction& one : chart.actions)
        store(one.before, bool_, read(one.value, bool_, one.where), one.where, body);
}

/// Resolves the variable X, _X or t of a step in the chart whose transitions are being read. The result is empty for
/// other paths.
std::optional<Reader::Found> Reader::step_of_chart(Id<st::Expr> path) {
    const st::Expr member = file_->exprs[path];
    const st::Expr owner = file_->exprs[member.first];
    if (transitions_ == nullptr || owner.op != st::Op::Name) return {};
    const auto step = std::ranges::find(*transitions_, owner.word, &std::pair<Id<st::Word>, std::uint32_t>::first);
    if (step == transitions_->end()) return {};
    Variable& element = program.units[unit_].variables[step->second];
    const Id<Unit> block = program.types[element.type].unit;
    const std::string name = capitals(member.word);
    const std::uint32_t offset = name == "X" ? 0 : name == "_X" ? next_offset : since_offset;
    if (offset == since_offset && name != "T") return {};
    Found made;
    made.place = {false, element.offset + offset, {}};
    made.variable = &program.units[block].variables[offset];
    made.type = made.variable->type;
    made.instance = &element;
    made.block = block;
    made.inside = made.locked = true;
    return made;
}

void Reader::evaluate_transitions(const Chart& chart, const st::Network& network, Program::Body& body) {
    std::vector<std::pair<Id<st::Word>, std::uint32_t>> own;
    for (std::size_t i = 0; i < network.steps.size(); ++i)
        own.emplace_back(network.steps[i].name.word, chart.variables[i]);
    transitions_ = &own;
    const auto index = [&](Id<st::Word> step) {
        const auto found = std::ranges::find(network.steps, step, [](const st::Step& one) { return one.name.word; });
        return static_cast<std::size_t>(found - network.steps.begin());
    };
    Program::Sequence sequence = sequence_of(network, chart.steps);
    for (std::size_t i = 0; i < chart.order.size(); ++i) {
        const st::Transition& transition = network.transitions[chart.order[i]];
        const Span where = transition.where;
        std::vector<Id<Node>> enabled;
        for (const st::Name& step : transition.from)
            enabled.push_back(read(chart.steps[index(step.word)], bool_, step.where));
        for (std::size_t j = 0; j < i; ++j) {
            const auto& earlier = network.transitions[chart.order[j]].from;
            if (std::ranges::any_of(earlier, [&](const st::Name& step) { return names(transition.from, step.word); }))
                enabled.push_back(add(Op::Not, bool_, {read(chart.cleared[chart.order[j]], bool_, where)}, where));
        }
        store(chart.cleared[chart.order[i]], bool_, number(0, bool_, where), where, body);
        const Span at = file_->exprs[transition.condition].where;
        const auto condition = condition_of(transition.condition);
        if (!condition) continue;
        Program::Arm arm{all(Op::And, std::move(enabled), where), {}, {}};
        store(chart.cleared[chart.order[i]], bool_, *condition, at, arm.body);
        sequence.transitions[chart.order[i]].test = arm.body.back();
        add_if({std::move(arm)}, where, body);
    }
    program.units[unit_].sequences.push_back(std::move(sequence));
    transitions_ = nullptr;
    check_transitions(network, chart, chart.steps, body);
    for (std::size_t k = 0; k < network.steps.size(); ++k) {
        const st::Step& step = network.steps[k];
        std::vector<Id<Node>> activating, deactivating;
        for (std::size_t i = 0; i < network.transitions.size(); ++i) {
            const auto cleared = [&] { return read(chart.cleared[i], bool_, network.transitions[i].where); };
            if (names(network.transitions[i].to, step.name.word)) activating.push_back(cleared());
            else if (names(network.transitions[i].from, step.name.word)) deactivating.push_back(cleared());
        }
        Program::Arm on{all(Op::Or, std::move(activating), step.where), {}, {}},
            off{all(Op::Or, std::move(deactivating), step.where), {}, {}};
        store(chart.steps[k] + next_offset, bool_, number(1, bool_, step.where), step.where, on.body);
        store(chart.steps[k] + next_offset, bool_, number(0, bool_, step.where), step.where, off.body);
        add_if({std::move(on), std::move(off)}, step.where, body);
    }
}

}  // namespace grafverif::program
