// SPDX-License-Identifier: MIT
#include "emit/controller/code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "emit/controller/names.hpp"
#include "ir/interval.hpp"

namespace grafverif::controller {

namespace {

using Kind = Statement::Kind;
using Role = Equations::Role;
using Variable = Id<Equations::Variable>;

struct Assignment {
    Variable target = {};
    Id<Expr> value = {};
};

class Builder {
public:
    Builder(const Equations& equations, const Options& options, Names names)
        : equations_(equations), names_(std::move(names)), options_(options) {
        code_.name = names_.block;
        code_.exprs = equations.exprs;
    }

    Code build() {
        code_.comment = comment();
        add_cells();
        write_body();
        declare();
        return std::move(code_);
    }

private:
    Exprs& exprs() { return code_.exprs; }
    bool searches() const { return options_.mode == ExecutionMode::StabilitySearch; }

    // -- cells --

    Id<Cell> add(Section section, const std::string& name, Word word, std::int64_t initial, std::string comment = {}) {
        return code_.cells.add({section, name, word, initial, true, std::move(comment), {}});
    }

    /// Adds the cells. The first cells store the variables of the equations and have the same indices as these
    /// variables, so that the terms of the equations are terms over cells.
    void add_cells() {
        for (const Variable id : equations_.variables.ids()) {
            const Equations::Variable& variable = equations_.variables[id];
            const bool image = names_.storage[id.index] != names_.variables[id.index];
            const Section section = variable.role == Role::Input              ? Section::Input
                                    : variable.role == Role::Output && !image ? Section::Output
                                                                              : Section::Local;
            add(section, names_.storage[id.index], word(variable.type), variable.initial,
                image ? "image of " + names_.variables[id.index] : range_text(variable));
        }
        interface_.resize(equations_.variables.size());
        fresh_.resize(equations_.variables.size());
        for (const Variable id : equations_.variables.ids()) {
            const Equations::Variable& variable = equations_.variables[id];
            interface_[id.index] = Id<Cell>{id.index};
            if (names_.storage[id.index] != names_.variables[id.index])
                interface_[id.index] = add(Section::Output, names_.variables[id.index], word(variable.type),
                                           variable.initial, range_text(variable));
        }
        for (std::size_t k = 0; k < equations_.timers.size(); ++k) add_timer(k);
        fault_ = add(Section::Output, names_.fault, Word::Int16, 0, "reason of the stop; 0 while running");
        started_ = add(Section::Local, names_.started, Word::Bool, 0, "the first evolution has been executed");
        if (!searches()) return;
        stable_ = add(Section::Local, names_.stable, Word::Bool, 0, "the situation is stable");
        evolutions_ = add(Section::Local, names_.evolutions, Word::Unsigned32, 0, "evolutions in this cycle");
        limit_ = add(Section::Constant, names_.limit, Word::Unsigned32, options_.max_evolutions,
                     "maximum number of evolutions per cycle; if it is exceeded, total instability is reported");
    }

    struct Times {
        Id<Timer> on = {}, off = {};  ///< `on` is invalid without a rise time, `off` is invalid without a fall time
        Id<Cell> lasted = {};         ///< condition that the rise time has elapsed; valid only if both timers exist
    };

    void add_timer(std::size_t k) {
        const Equations::Timer& timer = equations_.timers[k];
        const TimerNames& names = names_.timers[k];
        Times times;
        const auto add_one = [&](const std::string& name, bool off, Id<Cell> input, std::int64_t preset) {
            const Id<Timer> made = code_.timers.add({name, off, input, preset, {}});
            code_.timers[made].output = code_.cells.add({Section::Local, "Q", Word::Bool, 0, true, "", made});
            return made;
        };
        const Id<Cell> watched{timer.watched.index};
        if (!names.on.empty()) times.on = add_one(names.on, false, watched, timer.rise_ms);
        if (!names.lasted.empty()) times.lasted = add(Section::Local, names.lasted, Word::Bool, 0);
        const Id<Cell> input = times.lasted.valid() ? times.lasted : watched;
        if (!names.off.empty()) times.off = add_one(names.off, true, input, timer.fall_ms);
        times_.push_back(times);
    }

    static Word word(const Type& type) { return type.boolean ? Word::Bool : Word::Int32; }

    static std::string range_text(const Equations::Variable& variable) {
        if (variable.type.boolean || variable.role == Role::TimerEnd) return {};
        return fmt::format("{} to {}", variable.type.low, variable.type.high);
    }

    void declare() {
        auto& all = code_.declarations;
        for (const Variable id : equations_.variables.ids()) {
            const Id<Cell> storage{id.index};
            all.emplace_back(interface_[id.index]);
            if (interface_[id.index] != storage) all.emplace_back(storage);
            if (fresh_[id.index].valid()) all.emplace_back(fresh_[id.index]);
        }
        for (const Times& times : times_) {
            if (times.on.valid()) all.emplace_back(times.on);
            if (times.lasted.valid()) all.emplace_back(times.lasted);
            if (times.off.valid()) all.emplace_back(times.off);
        }
        for (const Id<Cell> cell : {fault_, started_, stable_, evolutions_, limit_})
            if (cell.valid()) all.emplace_back(cell);
    }

    std::string comment() const {
        std::string text =
            fmt::format("{}: controller written by grafverif from the equations of the chart\n", equations_.name);
        text +=
            "One call is one PLC cycle: call it once per cycle of its task, with inputs that do not change during the "
            "call.\n";
        text += searches() ? "With stability search: a call executes evolutions until the situation is stable, and "
                             "then writes the outputs.\n"
                           : "Without stability search: a call executes one evolution and writes the outputs.\n";
        text += fmt::format(
            "{} is the reason of a stop: {}2 race of stored actions, 3 value outside its range{}. After a stop, the "
            "outputs do not change.\n",
            names_.fault, searches() ? "1 no stable situation, " : "",
            equations_.conflicts.empty() ? "" : ", 4 forcing orders in conflict");
        for (const Renaming& renaming : names_.changed)
            text += fmt::format("{} is {}\n", renaming.name, renaming.legal);
        return text;
    }

    // -- statements --

    Id<Expr> leaf(Id<Cell> cell) { return exprs().leaf(Op::Variable, cell.index); }
    Id<Expr> compared(Op op, Id<Cell> cell, std::int64_t value) {
        return exprs().apply(op, leaf(cell), exprs().integer(value));
    }

    void heading(std::string_view text) { code_.body.push_back({Kind::Comment, {}, {}, {}, {}, std::string(text)}); }
    void assign(Id<Cell> target, Id<Expr> value) { code_.body.push_back({Kind::Assign, target, value, {}, {}, {}}); }
    void call(Id<Timer> timer) { code_.body.push_back({Kind::Call, {}, {}, {}, timer, {}}); }
    void block(Kind kind, Id<Expr> condition = {}) { code_.body.push_back({kind, {}, {}, condition, {}, {}}); }
    void guard(Id<Expr> condition, Id<Cell> target, Id<Expr> value) {
        code_.body.push_back({Kind::Guard, target, value, condition, {}, {}});
    }
    void stop_with(int fault, Id<Expr> condition) { guard(condition, fault_, exprs().integer(fault)); }

    void write_body() {
        block(Kind::Stop, compared(Op::NotEqual, fault_, 0));
        if (!times_.empty()) heading("time, sampled once per cycle");
        for (std::size_t k = 0; k < times_.size(); ++k) sample(k);
        if (searches()) begin_search();
        cycle();
        if (searches()) end_search();
        write_outputs();
        if (!times_.empty()) heading("each timer is called with the current value of its input");
        for (std::size_t k = 0; k < times_.size(); ++k) call_timers(k);
    }

    // -- time --

    Id<Expr> output(Id<Timer> timer) { return leaf(code_.timers[timer].output); }
    Id<Cell> end(std::size_t k) const { return Id<Cell>{equations_.timers[k].end.index}; }
    Id<Expr> watched(std::size_t k) { return leaf(Id<Cell>{equations_.timers[k].watched.index}); }

    void sample(std::size_t k) {
        const Times& times = times_[k];
        if (times.on.valid()) call(times.on);
        if (times.lasted.valid()) assign(times.lasted, output(times.on));
        if (times.off.valid()) call(times.off);
        assign(end(k), output(times.off.valid() ? times.off : times.on));
    }

    /// Adds the update of the timer after an evolution within the cycle.
    void follow(std::size_t k) {
        call_timers(k);
        const Times& times = times_[k];
        const Id<Expr> lasted = times.lasted.valid() ? leaf(times.lasted) : watched(k);
        assign(end(k), times.off.valid() ? exprs().disjunction(leaf(end(k)), lasted)
                                         : exprs().conjunction(leaf(end(k)), lasted));
    }

    void call_timers(std::size_t k) {
        const Times& times = times_[k];
        if (times.on.valid()) call(times.on);
        if (times.lasted.valid()) assign(times.lasted, exprs().conjunction(leaf(times.lasted), watched(k)));
        if (times.off.valid()) call(times.off);
    }

    // -- evolutions --

    void begin_search() {
        assign(evolutions_, exprs().integer(0));
        const Id<Expr> continues =
            exprs().conjunction(std::vector{exprs().negation(leaf(stable_)), compared(Op::Equal, fault_, 0),
                                            exprs().apply(Op::Less, leaf(evolutions_), leaf(limit_))});
        block(Kind::While, exprs().disjunction(compared(Op::Equal, evolutions_, 0), continues));
    }

    void end_search() {
        for (std::size_t k = 0; k < times_.size(); ++k) follow(k);
        assign(evolutions_, exprs().apply(Op::Plus, leaf(evolutions_), exprs().integer(1)));
        block(Kind::EndWhile);
        stop_with(1, exprs().conjunction(exprs().negation(leaf(stable_)), compared(Op::Equal, fault_, 0)));
    }

    void cycle() {
        block(Kind::If, exprs().negation(leaf(started_)));
        heading("the first evolution activates the initial steps");
        first_evolution();
        block(Kind::Else);
        evolution();
        block(Kind::EndIf);
    }

    void first_evolution() {
        assign(started_, exprs().constant(true));
        if (searches()) assign(stable_, exprs().constant(false));
        change(&Fault::first, &Kept::first, {});
    }

    void evolution() {
        if (!equations_.firings.empty()) heading("firing conditions");
        for (const Equations::Firing& firing : equations_.firings)
            assign(Id<Cell>{firing.variable.index}, firing.condition);
        if (searches()) assign(stable_, equations_.stable);
        change(&Fault::condition, &Kept::next, "steps and stored values");
    }

    /// Adds the assignments of faults and stored values after an evolution. The member pointers select the terms that
    /// are assigned. `title` is the comment before the stored values.
    void change(Id<Expr> Fault::*condition, Id<Expr> Kept::*value, std::string_view title) {
        for (const Fault& fault : faults(equations_))
            if ((fault.*condition).valid() && !is_false(exprs(), fault.*condition))
                stop_with(fault.variable.valid() ? 2 : 4, fault.*condition);
        std::vector<Assignment> updates;
        const std::vector<Kept> all = kept(equations_);
        for (const Kept& each : all)
            if (!each.after && (each.*value).valid()) updates.push_back({each.variable, each.*value});
        if (!updates.empty() && !title.empty()) heading(title);
        assign_at_once(std::move(updates));
        keep_ranges();
        for (const Kept& each : all)
            if (each.after) assign(Id<Cell>{each.variable.index}, each.*value);
    }

    /// Adds simultaneous assignments. If the value of a later assignment reads a target, the new value of this target
    /// is first stored in a temporary cell.
    void assign_at_once(std::vector<Assignment> updates) {
        std::erase_if(updates, [&](const Assignment& update) {
            const Expr& value = equations_.exprs[update.value];
            return value.op == Op::Variable && value.value == update.target.index;
        });
        std::vector<std::size_t> last_reader(equations_.variables.size(), 0);
        for (std::size_t k = 0; k < updates.size(); ++k)
            for (const Id<Expr> leaf : leaves(equations_.exprs, updates[k].value))
                last_reader[static_cast<std::size_t>(equations_.exprs[leaf].value)] = k;
        std::vector<Variable> waiting;
        for (std::size_t k = 0; k < updates.size(); ++k) {
            const Variable target = updates[k].target;
            const bool waits = last_reader[target.index] > k;
            if (waits) waiting.push_back(target);
            assign_cases(waits ? fresh(target) : Id<Cell>{target.index}, updates[k].value);
        }
        for (const Variable target : waiting) assign(Id<Cell>{target.index}, leaf(fresh(target)));
    }

    /// Returns the temporary cell for the new value of a variable.
    Id<Cell> fresh(Variable id) {
        Id<Cell>& cell = fresh_[id.index];
        if (cell.valid()) return cell;
        cell = add(Section::Local, names_.fresh[id.index], word(equations_.variables[id].type), 0,
                   "next value of " + names_.storage[id.index]);
        code_.cells[cell].initialized = false;
        return cell;
    }

    /// Assigns a value. A value with several cases becomes one statement per case.
    void assign_cases(Id<Cell> target, Id<Expr> value) {
        const Kind kind = exprs()[value].op == Op::Conditional ? Kind::Cases : Kind::Assign;
        code_.body.push_back({kind, target, value, {}, {}, {}});
    }

    bool stays_within(Id<Expr> value, const Type& type) const {
        const Interval values = interval(equations_.exprs, value, [&](const Expr& leaf) {
            return equations_.variables[Variable{static_cast<std::uint32_t>(leaf.value)}].type;
        });
        return values.low >= type.low && values.high <= type.high;
    }

    void keep_ranges() {
        for (const Equations::Stored& stored : equations_.stored) {
            const Type type = equations_.variables[stored.variable].type;
            if (type.boolean || (stays_within(stored.next, type) && stays_within(stored.first, type))) continue;
            const Id<Cell> cell{stored.variable.index};
            stop_with(3,
                      exprs().disjunction(compared(Op::Less, cell, type.low), compared(Op::Greater, cell, type.high)));
        }
    }

    // -- outputs --

    /// Adds the assignments of the outputs. Without outputs, no statement is added, because compilers of Structured
    /// Text reject an empty `IF`.
    void write_outputs() {
        std::vector<std::pair<Id<Cell>, Id<Expr>>> values;
        for (const Equations::Output& output : equations_.outputs)
            values.emplace_back(interface_[output.variable.index], output.value);
        for (const Equations::Stored& stored : equations_.stored)
            if (equations_.variables[stored.variable].role == Role::Output)
                values.emplace_back(interface_[stored.variable.index], leaf(Id<Cell>{stored.variable.index}));
        if (values.empty()) return;
        block(Kind::If, compared(Op::Equal, fault_, 0));
        heading("outputs");
        for (const auto& [cell, value] : values) assign(cell, value);
        block(Kind::EndIf);
    }

    const Equations& equations_;
    const Names names_;
    const Options options_;
    Code code_ = {};
    std::vector<Id<Cell>> interface_ = {};  ///< for each variable: the cell that the user of the block sees
    std::vector<Id<Cell>> fresh_ = {};      ///< for each variable: its temporary cell, if it needs one
    std::vector<Times> times_ = {};
    Id<Cell> fault_ = {}, started_ = {}, stable_ = {}, evolutions_ = {}, limit_ = {};
};

}  // namespace

Code code_of(const Equations& equations, const Options& options, Target target,
             std::span<const std::string_view> reserved) {
    return Builder(equations, options, names_of(equations, target, reserved)).build();
}

}  // namespace grafverif::controller
