// SPDX-License-Identifier: MIT
// Converts Sequential Function Charts to statements. A step becomes an instance with the outputs X (activity) and T
// (time since activation). An action becomes an instance of an ACTION_CONTROL block. In each execution of the body:
//   - the conditions of enabled transitions are evaluated, by priority; a transition is not cleared if a previous
//     transition that leaves the same step is cleared. The first execution, in which the initial step is active, clears
//     no transition, because the effects of the activation of a step precede the test of its downstream transitions;
//   - all cleared transitions deactivate and activate their steps;
//   - all action controls are evaluated; then, in the order of the actions of the chart, each action is executed, or
//     assigned if it is a Boolean variable.
#include <algorithm>
#include <utility>

#include "read/program/scope.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif::program {

namespace {

using Op = Program::Op;
constexpr std::uint32_t time_offset = 1;  // offset of T in the cells of a step; X is at offset 0

}  // namespace

// -- declarations -----------------------------------------------------------------------------------------------------

Id<Type> Reader::step_type(bool initial) {
    Id<Type>& type = step_types_[initial ? 1 : 0];
    if (type.valid()) return type;
    Unit unit;
    unit.kind = Unit::Kind::FunctionBlock;
    unit.name = "STEP";
    unit.size = 2;
    unit.running = 0;
    unit.elapsed = time_offset;
    Variable active, time;
    active.name = "X";
    active.section = time.section = Variable::Section::Output;
    active.type = bool_;
    active.initial = initial ? 1 : 0;
    time.name = "T";
    time.type = time_;
    time.offset = time_offset;
    unit.variables = {active, time};
    const Id<Unit> id = program.units.add(std::move(unit));
    scopes_.push_back({{{file_->intern("X").index, 0}, {file_->intern("T").index, 1}}, {}});
    calls_.emplace_back();
    chart_units_.insert(id.index);
    return type = program.types.add({Type::Kind::Block, "STEP", 0, 0, {}, id});
}

/// Adds a variable that statements of the program cannot access. Returns the first memory cell of the variable.
std::uint32_t Reader::add_cells(Id<Unit> id, std::string shown, Id<Type> type, Span where, Variable::Section section) {
    Unit& unit = program.units[id];
    Variable made;
    made.name = std::move(shown);
    made.type = type;
    made.section = section;
    made.offset = unit.size;
    made.origin = where;
    const Type& of = program.types[type];
    unit.size += of.kind == Type::Kind::Block ? program.units[of.unit].size : 1;
    unit.variables.push_back(std::move(made));
    return unit.variables.back().offset;
}

/// Adds the variable of a step or an action. Statements of the program can access the two members of the variable,
/// whose names are `members`. A step may have the same name as an elementary variable; an action with the name of a
/// variable is an error.
std::uint32_t Reader::add_cells(Id<Unit> id, st::Name name, std::array<std::string_view, 2> members, Id<Type> type) {
    Scope& scope = scopes_[id.index];
    const auto old = scope.variables.find(name.word.index);
    const Unit& unit = program.units[id];
    if (old != scope.variables.end() &&
        (members[0] != "X" || program.types[unit.variables[old->second].type].kind == Type::Kind::Block))
        diagnostics->add(
            messages::duplicate_name(name.where, "variable", text(name.word), unit.variables[old->second].origin));
    for (const std::string_view member : members)
        scope.members[{name.word.index, file_->intern(member).index}] =
            static_cast<std::uint32_t>(unit.variables.size());
    return add_cells(id, text(name.word), type, name.where);
}

/// Resolves a path such as `Step.X`, `Step.T` or `Action.Q` in this unit or in an instance that the expression is
/// allowed to read.
std::optional<Reader::Found> Reader::chart_member(Id<st::Expr> path) {
    const st::Expr member = file_->exprs[path];
    const st::Expr owner = file_->exprs[member.first];
    Found instance;
    Id<Unit> unit = unit_;
    if (owner.op == st::Op::Member && is_open()) {
        const bool known = std::ranges::any_of(scopes_, [&](const Scope& scope) {
            return scope.members.contains({owner.word.index, member.word.index});
        });
        if (!known) return {};
        const auto found = variable(owner.first);
        if (!found || program.types[found->type].kind != Type::Kind::Block) return {};
        instance = *found;
        unit = program.types[found->type].unit;
    } else if (owner.op != st::Op::Name) return {};
    const auto known = scopes_[unit.index].members.find({owner.word.index, member.word.index});
    if (known == scopes_[unit.index].members.end() || known->second == ambiguous_member) return {};
    Variable& element = program.units[unit].variables[known->second];
    const Id<Unit> block = program.types[element.type].unit;
    Variable& cell = program.units[block].variables[scopes_[block.index].variables.at(member.word.index)];
    refer(owner, element.origin);
    Found made;
    made.place = shifted(instance.place, element.offset + cell.offset);
    made.type = cell.type;
    made.variable = &cell;
    made.instance = &element;
    made.block = block;
    made.inside = made.locked = true;
    return made;
}

void Reader::declare_chart(std::size_t index) {
    const Id<Unit> id = declared_[index];
    const st::Unit& from = file_->units[index];
    Chart& chart = charts_[index].body;
    for (const st::Step& step : from.networks.front().steps)
        add_cells(id, step.name, {"X", "T"}, step_type(step.initial));
    for (ChartAction& action : chart.actions) {
        declare(action.control);
        const Id<Unit> control = declared_[action.control];
        chart_units_.insert(control.index);
        const Id<Type> type = program.types.add({Type::Kind::Block, "ACTION_CONTROL", 0, 0, {}, control});
        const bool named = action.name.valid() && !action.variable;
        action.cell = named ? add_cells(id, action.name, {"Q", "A"}, type)
                            : add_cells(id, "action " + action.label, type, action.where);
    }
    chart.started = add_cells(id, "chart started", bool_, from.networks.front().where);
    for (const st::Transition& transition : from.networks.front().transitions)
        chart.cleared.push_back(add_cells(id, "transition " + std::to_string(chart.cleared.size() + 1), bool_,
                                          transition.where, Variable::Section::Temporary));
}

// -- terms and checks -------------------------------------------------------------------------------------------------

/// Returns the memory cell of the variable X of a step.
std::uint32_t Reader::cell_of(Id<st::Word> step) const {
    const std::uint32_t index = scopes_[unit_.index].members.at({step.index, file_->intern("X").index});
    return program.units[unit_].variables[index].offset;
}

Id<Node> Reader::read(std::uint32_t cell, Id<Type> type, Span where) {
    const Id<Node> node = add(Op::Read, type, {}, where);
    program.nodes[node].place = {false, cell, {}};
    return node;
}

Id<Node> Reader::all(Op op, std::vector<Id<Node>> operands, Span where) {
    if (operands.empty()) return number(op == Op::And ? 1 : 0, bool_, where);
    return operands.size() == 1 ? operands.front() : add(op, bool_, std::move(operands), where);
}

void Reader::store(std::uint32_t cell, Id<Type> type, Id<Node> value, Span where, Program::Body& body) {
    Statement made;
    made.kind = Statement::Kind::Assign;
    made.place = {false, cell, {}};
    made.type = type;
    made.value = value;
    made.generated = true;
    made.origin = where;
    body.push_back(program.statements.add(std::move(made)));
}

void Reader::add_if(std::vector<Program::Arm> arms, Span where, Program::Body& body) {
    Statement made;
    made.kind = Statement::Kind::If;
    made.arms = std::move(arms);
    made.generated = true;
    made.origin = where;
    body.push_back(program.statements.add(std::move(made)));
}

void Reader::check(Id<Node> fault, Span where, Program::Body& body) {
    Statement made;
    made.kind = Statement::Kind::Check;
    made.value = fault;
    made.generated = true;
    made.origin = where;
    body.push_back(program.statements.add(std::move(made)));
}

/// Adds a run-time check for each transition that may activate an active step according to the structure of the chart.
/// `steps` contains the memory cell of X for each step.
void Reader::check_transitions(const st::Network& network, const Chart& chart, const std::vector<std::uint32_t>& steps,
                               Program::Body& body) {
    const auto names = [](const std::vector<st::Name>& list, Id<st::Word> step) {
        return std::ranges::find(list, step, &st::Name::word) != list.end();
    };
    constexpr std::size_t most_pairs = 200'000;
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < network.transitions.size(); ++i) {
        if (!chart.checked[i]) continue;
        if (pairs > most_pairs) {
            diagnostics->add(messages::program_too_large(
                network.transitions[i].where, "pairs of transitions that activate the same step", most_pairs));
            return;
        }
        const st::Transition& transition = network.transitions[i];
        const auto cleared = [&](std::size_t of) { return read(chart.cleared[of], bool_, transition.where); };
        std::vector<Id<Node>> faults;
        for (std::size_t k = 0; k < network.steps.size(); ++k) {
            const Id<st::Word> step = network.steps[k].name.word;
            if (!names(transition.to, step)) continue;
            if (!names(transition.from, step)) faults.push_back(read(steps[k], bool_, transition.where));
            for (std::size_t j = 0; j < network.transitions.size(); ++j)
                if (j != i && names(network.transitions[j].to, step)) {
                    faults.push_back(cleared(j));
                    ++pairs;
                }
        }
        const Id<Node> any = all(Op::Or, std::move(faults), transition.where);
        check(all(Op::And, {cleared(i), any}, transition.where), transition.where, body);
    }
}

/// Adds run-time checks: no two action blocks with different durations of the same action may be active at the same
/// time. `active` contains, for each duration, the condition that an action block with this duration is active.
void Reader::check_durations(const Chart& chart, std::size_t index, const std::vector<Id<Node>>& active,
                             Program::Body& body) {
    if (!chart.checked_actions[index]) return;
    const Span where = chart.actions[index].where;
    for (std::size_t i = 0; i < active.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) check(all(Op::And, {active[i], active[j]}, where), where, body);
}

/// Returns the structure of a chart, without the statements that evaluate its transitions. `cells` contains, for each
/// step, the memory cell that is true while the step is active.
Program::Sequence Reader::sequence_of(const st::Network& network, const std::vector<std::uint32_t>& cells) const {
    Program::Sequence sequence;
    const auto cells_of = [&](const std::vector<st::Name>& steps) {
        std::vector<std::uint32_t> found;
        for (const st::Name& step : steps)
            for (std::size_t k = 0; k < cells.size(); ++k)
                if (network.steps[k].name.word == step.word) found.push_back(cells[k]);
        return found;
    };
    for (const st::Transition& transition : network.transitions)
        sequence.transitions.push_back({transition.name.valid() ? text(transition.name.word) : "",
                                        cells_of(transition.from),
                                        cells_of(transition.to),
                                        {}});
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const st::Step& step = network.steps[k];
        if (step.initial) sequence.initial.push_back(cells[k]);
        for (const st::Association& association : step.actions) {
            std::string label = association.qualifier;
            if (association.time.valid()) {
                const st::Expr& time = file_->exprs[association.time];
                label += " " + (time.op == st::Op::Time ? "T#" + duration_text(time.value)
                                                        : path_text(*file_, association.time));
            }
            if (association.action.valid()) label += " " + text(association.action.word);
            else if (association.path.valid()) label += " " + path_text(*file_, association.path);
            sequence.actions.push_back({cells[k], std::move(label)});
        }
        for (const auto& [when, path] :
             {std::pair("entry", step.entry), std::pair("active", step.active), std::pair("exit", step.exit)})
            if (path.valid()) sequence.actions.push_back({cells[k], when + (" " + path_text(*file_, path))});
    }
    return sequence;
}

// -- the chart --------------------------------------------------------------------------------------------------------

Program::Body Reader::chart(std::size_t index) {
    const st::Network& network = file_->units[index].networks.front();
    const Chart& chart = charts_[index].body;
    if (!chart.valid) return {};
    Program::Body body;
    Program::Arm later{read(chart.started, bool_, network.where), {}, {}}, first;
    evolve(network, chart, later.body);
    store(chart.started, bool_, number(1, bool_, network.where), network.where, first.body);
    for (const st::Step& step : network.steps)
        if (step.initial)
            store(cell_of(step.name.word) + time_offset, time_, number(0, time_, step.where), step.where, first.body);
    add_if({std::move(later), std::move(first)}, network.where, body);
    for (std::size_t i = 0; i < chart.actions.size(); ++i) control(chart, i, body);
    for (const ChartAction& action : chart.actions) execute(action, body);
    return body;
}

/// Returns the condition of a transition. If the condition is an integer, which some tools accept, compares the integer
/// with zero and adds a warning.
std::optional<Id<Node>> Reader::condition_of(Id<st::Expr> root) {
    const Span where = file_->exprs[root].where;
    const auto value = expression(root);
    if (!value) return {};
    if (value->literal || type(*value).kind != Type::Kind::Integer)
        return converted(*value, bool_, where, "the condition");
    diagnostics->add(
        messages::not_standard(where, "an integer as a condition", "the condition that the integer is not zero"));
    return add(Op::IsNonzero, bool_, {value->node}, where);
}

void Reader::evolve(const st::Network& network, const Chart& chart, Program::Body& body) {
    const auto names = [](const std::vector<st::Name>& list, Id<st::Word> step) {
        return std::ranges::find(list, step, &st::Name::word) != list.end();
    };
    std::vector<std::uint32_t> cells;
    for (const st::Step& step : network.steps) cells.push_back(cell_of(step.name.word));
    Program::Sequence sequence = sequence_of(network, cells);
    for (std::size_t i = 0; i < chart.order.size(); ++i) {
        const st::Transition& transition = network.transitions[chart.order[i]];
        const Span where = transition.where;
        std::vector<Id<Node>> enabled;
        for (const st::Name& step : transition.from) enabled.push_back(flag(step.word, step.where));
        for (std::size_t j = 0; j < i; ++j) {
            const bool shares =
                std::ranges::any_of(network.transitions[chart.order[j]].from,
                                    [&](const st::Name& step) { return names(transition.from, step.word); });
            if (shares)
                enabled.push_back(add(Op::Not, bool_, {read(chart.cleared[chart.order[j]], bool_, where)}, where));
        }
        const Span at = file_->exprs[transition.condition].where;
        const auto condition = condition_of(transition.condition);
        if (!condition) continue;
        Program::Arm arm{all(Op::And, std::move(enabled), where), {}, {}};
        store(chart.cleared[chart.order[i]], bool_, *condition, at, arm.body);
        sequence.transitions[chart.order[i]].test = arm.body.back();
        add_if({std::move(arm)}, where, body);
    }
    program.units[unit_].sequences.push_back(std::move(sequence));
    check_transitions(network, chart, cells, body);
    for (const st::Step& step : network.steps) {
        std::vector<Id<Node>> activating, deactivating;
        for (std::size_t i = 0; i < network.transitions.size(); ++i) {
            const auto cleared = [&] { return read(chart.cleared[i], bool_, network.transitions[i].where); };
            if (names(network.transitions[i].to, step.name.word)) activating.push_back(cleared());
            else if (names(network.transitions[i].from, step.name.word)) deactivating.push_back(cleared());
        }
        const std::uint32_t cell = cell_of(step.name.word);
        Program::Arm on{all(Op::Or, std::move(activating), step.where), {}, {}},
            off{all(Op::Or, std::move(deactivating), step.where), {}, {}};
        store(cell, bool_, number(1, bool_, step.where), step.where, on.body);
        store(cell + time_offset, time_, number(0, time_, step.where), step.where, on.body);
        store(cell, bool_, number(0, bool_, step.where), step.where, off.body);
        add_if({std::move(on), std::move(off)}, step.where, body);
    }
}

void Reader::control(const Chart& chart, std::size_t index, Program::Body& body) {
    const ChartAction& action = chart.actions[index];
    const Id<Unit> block = declared_[action.control];
    const auto input = [&](std::string_view name) {
        const Scope& scope = scopes_[block.index];
        return action.cell + program.units[block].variables[scope.variables.at(file_->intern(name).index)].offset;
    };
    for (const auto& [qualifier, steps] : action.steps) {
        std::vector<Id<Node>> active;
        for (const Id<st::Word> step : steps) active.push_back(flag(step, action.where));
        store(input(qualifier), bool_, all(Op::Or, std::move(active), action.where), action.where, body);
    }
    std::vector<Id<Node>> durations;
    for (std::size_t i = 0; i < action.durations.size(); ++i) {
        std::vector<Id<Node>> active;
        for (const Id<st::Word> step : action.durations[i]) active.push_back(flag(step, action.where));
        durations.push_back(all(Op::Or, std::move(active), action.where));
        store(input("TIME_" + std::to_string(i + 1)), bool_, durations.back(), action.where, body);
    }
    check_durations(chart, index, durations, body);
    if (action.time.valid()) {
        const auto value = expression(action.time);
        const Span where = file_->exprs[action.time].where;
        const auto node = value ? converted(*value, time_, where, "the duration") : std::nullopt;
        if (node) store(input("T"), time_, *node, where, body);
    }
    Statement made;
    made.kind = Statement::Kind::Invoke;
    made.place = {false, action.cell, {}};
    made.unit = block;
    made.generated = true;
    made.origin = action.where;
    body.push_back(program.statements.add(std::move(made)));
}

void Reader::execute(const ChartAction& action, Program::Body& body) {
    const auto output = [&](std::string_view name) {
        const Id<Unit> block = declared_[action.control];
        const std::uint32_t index = scopes_[block.index].variables.at(file_->intern(name).index);
        return read(action.cell + program.units[block].variables[index].offset, bool_, action.where);
    };
    if (action.variable) {
        if (const auto variable = named(action.name.word, action.name.where)) {
            if (variable->constant)
                reject(action.name.where, "an assignment to a constant", "declare it without CONSTANT");
            assign(*variable, {output("Q"), false}, action.name.where, body);
        }
        return;
    }
    Program::Arm arm{output("A"), {}, {}};
    action_ = true;
    arm.body = block(action.body);
    action_ = false;
    add_if({std::move(arm)}, action.where, body);
}

// -- step times -------------------------------------------------------------------------------------------------------

/// Returns the operands of a comparison. If the time T of a step is compared with a constant, records the constant: T
/// can saturate above the greatest constant, because larger values do not change the result.
std::array<Reader::MaybeTyped, 2> Reader::compared(const std::vector<Id<st::Expr>>& sides) {
    const auto is_member = [&](std::size_t side) { return file_->exprs[sides[side]].op == st::Op::Member; };
    std::array<MaybeTyped, 2> values;
    for (const std::size_t i : {std::size_t{is_member(0) ? 1U : 0U}, std::size_t{is_member(0) ? 0U : 1U}}) {
        const MaybeTyped& other = values[1 - i];
        if (other && type(*other).kind == Type::Kind::Time && is_member(i))
            if (const auto known = value_of(other->node)) compared_time_ = std::min(*known, type(*other).high - 1) + 1;
        values[i] = expression(sides[i]);
        compared_time_.reset();
    }
    return values;
}

void Reader::limit_step_time(const Found& read) {
    if (read.instance == nullptr || program.types[read.type].kind != Type::Kind::Time) return;
    if (!chart_units_.contains(read.block.index)) return;
    read.instance->longest = std::max(read.instance->longest, compared_time_.value_or(program.types[time_].high));
}

}  // namespace grafverif::program
