// SPDX-License-Identifier: MIT
// The body of a function block: one PLC cycle.
//
//   every-cycle mode:                         with stability search:
//     sample the timers                         sample the timers
//     one evolution                             one evolution and an update of the timers, repeated until stable
//     outputs                                   outputs
//     update the timers                         update the timers
//
// Time is constant within a cycle, as in the equations: the output of a timer is sampled once, at the start of the
// cycle, and later changes only as a consequence of evolutions. A TON whose input becomes FALSE and TRUE again within
// one cycle restarts.
//
// REPEAT is not used, because a published version of MATIEC compiles `UNTIL c` as `while (c)`, without the negation.
#include "emit/structured_text/body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ir/interval.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif::structured_text {

namespace {

using Variable = Id<Equations::Variable>;

struct Assignment {
    Variable target = {};
    Id<Expr> value = {};
};

class Writer {
public:
    Writer(const Equations& equations, const Names& names, const Options& options)
        : equations_(equations), names_(names), options_(options) {
        result_.waits.resize(equations.variables.size());
        leaf_ = [this](std::ostream& out, const Expr& leaf) {
            out << names_.storage[static_cast<std::size_t>(leaf.value)];
        };
    }

    Body write() {
        const bool search = options_.mode == ExecutionMode::StabilitySearch;
        line("IF {} <> 0 THEN RETURN; END_IF;", names_.fault);
        if (!equations_.timers.empty()) heading("time, sampled once per cycle");
        for (std::size_t k = 0; k < equations_.timers.size(); ++k) sample(k);
        if (search) begin_search();
        cycle();
        if (search) end_search();
        write_outputs();
        if (!equations_.timers.empty()) heading("each timer starts and stops with its observed term");
        for (std::size_t k = 0; k < equations_.timers.size(); ++k) call_timer(k);
        return std::move(result_);
    }

private:
    template <class... Arguments>
    void line(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
        result_.text += std::string(4 * depth_, ' ') + fmt::format(text, std::forward<Arguments>(arguments)...) + '\n';
    }
    void heading(std::string_view text) { line("(* {} *)", text); }

    std::string text(Id<Expr> term) const { return expr_text(equations_.exprs, term, structured_text_spelling, leaf_); }
    const std::string& stored_in(Variable variable) const { return names_.storage[variable.index]; }

    // -- time --

    void sample(std::size_t k) {
        const Equations::Timer& times = equations_.timers[k];
        const TimerNames& timer = names_.timers[k];
        const std::string& end = stored_in(equations_.timers[k].end);
        if (!timer.on.empty())
            line("{}(IN := {}, PT := {});", timer.on, stored_in(times.watched), time_literal(times.rise_ms));
        if (!timer.lasted.empty()) line("{} := {}.Q;", timer.lasted, timer.on);
        if (!timer.off.empty()) line("{}(IN := {}, PT := {});", timer.off, lasted(k), time_literal(times.fall_ms));
        line("{} := {}.Q;", end, timer.off.empty() ? timer.on : timer.off);
    }

    /// Returns the condition that the observed term has lasted for the rise time.
    const std::string& lasted(std::size_t k) const {
        const TimerNames& timer = names_.timers[k];
        return timer.lasted.empty() ? stored_in(equations_.timers[k].watched) : timer.lasted;
    }

    /// Prints the update of the timer after an evolution within the cycle.
    void follow(std::size_t k) {
        call_timer(k);
        const std::string& end = stored_in(equations_.timers[k].end);
        if (names_.timers[k].off.empty()) line("{} := {} AND {};", end, end, lasted(k));
        else line("{} := {} OR {};", end, end, lasted(k));
    }

    void call_timer(std::size_t k) {
        const Equations::Timer& times = equations_.timers[k];
        const TimerNames& timer = names_.timers[k];
        if (!timer.on.empty())
            line("{}(IN := {}, PT := {});", timer.on, stored_in(times.watched), time_literal(times.rise_ms));
        if (!timer.lasted.empty()) line("{} := {} AND {};", timer.lasted, timer.lasted, stored_in(times.watched));
        if (!timer.off.empty()) line("{}(IN := {}, PT := {});", timer.off, lasted(k), time_literal(times.fall_ms));
    }

    // -- evolutions --

    void begin_search() {
        line("{} := 0;", names_.evolutions);
        line("WHILE {0} = 0 OR (NOT {1} AND {2} = 0 AND {0} < {3}) DO", names_.evolutions, names_.stable, names_.fault,
             names_.limit);
        ++depth_;
    }

    void end_search() {
        for (std::size_t k = 0; k < equations_.timers.size(); ++k) follow(k);
        line("{} := {} + 1;", names_.evolutions, names_.evolutions);
        --depth_;
        line("END_WHILE;");
        line("IF NOT {} AND {} = 0 THEN {} := 1; END_IF;", names_.stable, names_.fault, names_.fault);
    }

    void cycle() {
        line("IF NOT {} THEN", names_.started);
        ++depth_;
        heading("the first evolution activates the initial steps");
        first_evolution();
        --depth_;
        line("ELSE");
        ++depth_;
        evolution();
        --depth_;
        line("END_IF;");
    }

    void first_evolution() {
        line("{} := TRUE;", names_.started);
        if (options_.mode == ExecutionMode::StabilitySearch) line("{} := FALSE;", names_.stable);
        change(&Fault::first, &Kept::first, {});
    }

    /// Prints the assignments of the faults and values after the evolution. The member pointers select the terms, and
    /// `title` precedes the values.
    void change(Id<Expr> Fault::*condition, Id<Expr> Kept::*value, std::string_view title) {
        for (const Fault& fault : faults(equations_))
            if ((fault.*condition).valid()) refuse(fault.*condition, fault.variable.valid() ? 2 : 4);
        std::vector<Assignment> updates;
        const std::vector<Kept> all = kept(equations_);
        for (const Kept& each : all)
            if (!each.after && (each.*value).valid()) updates.push_back({each.variable, each.*value});
        if (!updates.empty() && !title.empty()) heading(title);
        assign_at_once(std::move(updates));
        keep_ranges();
        for (const Kept& each : all)
            if (each.after) line("{} := {};", stored_in(each.variable), text(each.*value));
    }

    void evolution() {
        if (!equations_.firings.empty()) heading("firing conditions");
        for (const Equations::Firing& firing : equations_.firings)
            line("{} := {};", stored_in(firing.variable), text(firing.condition));
        if (options_.mode == ExecutionMode::StabilitySearch) line("{} := {};", names_.stable, text(equations_.stable));
        change(&Fault::condition, &Kept::next, "steps and stored values");
    }

    /// Prints a statement that sets the fault if `condition` holds.
    void refuse(Id<Expr> condition, int fault) {
        if (!is_false(equations_.exprs, condition))
            line("IF {} THEN {} := {}; END_IF;", text(condition), names_.fault, fault);
    }

    /// Prints simultaneous assignments: if a later value reads a target, the new value of the target is first stored in
    /// a temporary variable.
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
            if (waits) {
                result_.waits[target.index] = true;
                waiting.push_back(target);
            }
            assign(waits ? names_.fresh[target.index] : stored_in(target), updates[k].value);
        }
        for (const Variable target : waiting) line("{} := {};", stored_in(target), names_.fresh[target.index]);
    }

    /// Assigns a value. A value with several cases becomes one statement per case.
    void assign(const std::string& target, Id<Expr> value) {
        const Exprs& exprs = equations_.exprs;
        if (exprs[value].op != Op::Conditional) return line("{} := {};", target, text(value));
        const char* keyword = "IF";
        for (; exprs[value].op == Op::Conditional; value = exprs.operands(value)[2]) {
            line("{} {} THEN {} := {};", keyword, text(exprs.operands(value)[0]), target,
                 text(exprs.operands(value)[1]));
            keyword = "ELSIF";
        }
        line("ELSE {} := {};", target, text(value));
        line("END_IF;");
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
            const std::string& name = stored_in(stored.variable);
            line("IF {} < {} OR {} > {} THEN {} := 3; END_IF;", name, type.low, name, type.high, names_.fault);
        }
    }

    // -- outputs --

    /// Prints the assignments of the outputs. Without outputs, no statement is printed, because compilers reject an
    /// empty `IF`.
    void write_outputs() {
        std::vector<std::string> lines;
        for (const Equations::Output& output : equations_.outputs)
            lines.push_back(names_.variables[output.variable.index] + " := " + text(output.value));
        for (const Equations::Stored& stored : equations_.stored)
            if (equations_.variables[stored.variable].role == Equations::Role::Output)
                lines.push_back(names_.variables[stored.variable.index] + " := " + stored_in(stored.variable));
        if (lines.empty()) return;
        line("IF {} = 0 THEN", names_.fault);
        ++depth_;
        heading("outputs");
        for (const std::string& one : lines) line("{};", one);
        --depth_;
        line("END_IF;");
    }

    const Equations& equations_;
    const Names& names_;
    const Options& options_;
    Body result_ = {};
    LeafPrinter leaf_ = {};
    std::size_t depth_ = 0;
};

}  // namespace

std::string time_literal(std::int64_t milliseconds) { return "T#" + duration_text(milliseconds); }

Body body_of(const Equations& equations, const Names& names, const Options& options) {
    return Writer(equations, names, options).write();
}

}  // namespace grafverif::structured_text
