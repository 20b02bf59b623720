// SPDX-License-Identifier: MIT
#include "schedule/product.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "schedule/controller_module.hpp"
#include "schedule/main.hpp"
#include "schedule/program/scan_module.hpp"

namespace grafverif {

namespace {

using namespace schedule;
using Role = Equations::Role;

class PairBuilder {
public:
    PairBuilder(const ProductSide& a, const ProductSide& b, const ProductOptions& options)
        : sides_{a, b}, equations_{a.equations, b.equations}, options_(options), main_(a.equations->name) {}

    ProductMachine build() && {
        for (const Equations* chart : equations_)
            for (const Equations::Variable& variable : chart->variables)
                if (variable.role == Role::Input) main_.draft.names.take(variable.name);
        waits_ =
            main_.draft.add("waits", Type{}, TransitionSystem::StateSymbol{}, "both charts have completed the scan");
        const Id<Symbol> turn = main_.draft.define("turn", exprs().negation(waits()));
        add_inputs();
        add_passed();
        const Id<Symbol> first_turn = add_first_turn(turn);
        for (const std::size_t k : {0U, 1U}) add_module(k);
        for (const std::size_t k : {0U, 1U}) wire(k, is_program(k) && !options_.settles ? first_turn : turn);
        add_waits();
        assume();
        keep_twins_together();
        add_properties();
        return {main_.finish(), std::move(inputs_), waits_, passed_};
    }

private:
    Exprs& exprs() { return main_.system.exprs; }
    Id<Expr> waits() { return main_.draft.leaf(waits_); }
    Id<Expr> inner(std::size_t k, Id<Symbol> symbol) { return main_.inner(instances_[k], symbol); }
    Id<Expr> inner(std::size_t k, Id<Equations::Variable> id) { return inner(k, modules_[k].symbols[id.index]); }

    bool is_program(std::size_t k) const { return sides_[k].scan != nullptr; }
    bool searches() const { return options_.mode == ExecutionMode::StabilitySearch; }
    bool is_elapsed(std::size_t k, Id<Equations::Variable> id) const {
        return is_program(k) && sides_[k].scan->elapsed == id;
    }

    /// Returns the inputs of the first side: for a chart in the order of its variables, for a program in the order of
    /// its memory cells.
    std::vector<Id<Equations::Variable>> first_inputs() const {
        std::vector<Id<Equations::Variable>> found;
        const auto add = [&](Id<Equations::Variable> id) {
            if (id.valid() && equations_[0]->variables[id].role == Role::Input) found.push_back(id);
        };
        if (is_program(0))
            for (const Id<Equations::Variable> id : sides_[0].scan->variables) add(id);
        else
            for (const Id<Equations::Variable> id : equations_[0]->variables.ids()) add(id);
        return found;
    }

    /// Returns the symbol of the first chart's input with this name.
    Id<Symbol> input(const std::string& name) const {
        std::size_t place = 0;
        for (const Id<Equations::Variable> id : first_inputs())
            if (equations_[0]->variables[id].name == name) break;
            else ++place;
        return inputs_[place];
    }

    /// Adds the inputs, which are chosen freely for each scan.
    void add_inputs() {
        for (const Id<Equations::Variable> id : first_inputs()) {
            const Equations::Variable& variable = equations_[0]->variables[id];
            const Id<Symbol> chosen = main_.draft.add(variable.name + "_next", variable.type,
                                                      TransitionSystem::ChoiceSymbol{}, "inputs of the next scan");
            const Id<Symbol> now = main_.draft.module.symbols.add(
                {variable.name, variable.type, TransitionSystem::StateSymbol{}, "inputs", variable.origin, {}});
            main_.draft.set(now,
                            TransitionSystem::StateSymbol{
                                {}, exprs().conditional(waits(), main_.draft.leaf(chosen), main_.draft.leaf(now))});
            inputs_.push_back(now);
        }
    }

    void add_passed() {
        std::int64_t most = 0;
        for (const Equations* chart : equations_)
            for (const Equations::Timer& timer : chart->timers) most = std::max({most, timer.rise_ms, timer.fall_ms});
        for (const ProductSide& side : sides_)
            if (side.scan != nullptr) most = std::max(most, side.scan->layout.longest);
        if (most == 0 || options_.interval_ms) return;
        passed_ = main_.draft.add("passed", integer_type(0, (most + options_.unit_ms - 1) / options_.unit_ms),
                                  TransitionSystem::ChoiceSymbol{}, "time until the next scan");
    }

    /// Returns the time until the next scan, in units of `unit_ms`.
    Id<Expr> passed_units() {
        return passed_.valid() ? main_.draft.leaf(passed_)
                               : exprs().integer(options_.interval_ms.value_or(0) / options_.unit_ms);
    }

    /// Returns the argument for the parameter `turn` of a program. Under stability search without `settles`, the
    /// argument is true only in the first step of a scan, so that the program executes one scan.
    Id<Symbol> add_first_turn(Id<Symbol> turn) {
        if (!searches() || options_.settles || (!is_program(0) && !is_program(1))) return turn;
        fresh_ = main_.draft.add("fresh", Type{}, TransitionSystem::StateSymbol{exprs().constant(true), waits()},
                                 "programs have not yet executed the scan");
        return main_.draft.define("first_turn", exprs().conjunction(main_.draft.leaf(turn), main_.draft.leaf(fresh_)));
    }

    /// Adds a variable for the time that passed before the scan, for a program that reads this time. The variable is 0
    /// in repetitions of the scan.
    Id<Symbol> add_elapsed(std::size_t k) {
        const Type type = equations_[k]->variables[sides_[k].scan->elapsed].type;
        const Id<Expr> most = exprs().integer(type.high);
        const Id<Expr> passed = exprs().apply(Op::Times, passed_units(), exprs().integer(options_.unit_ms));
        const Id<Expr> capped = exprs().conditional(exprs().apply(Op::Less, passed, most), passed, most);
        elapsed_[k] = main_.draft.add(
            k == 0 ? "a_elapsed" : "b_elapsed", type,
            TransitionSystem::StateSymbol{exprs().integer(std::min(options_.interval_ms.value_or(0), type.high)),
                                          exprs().conditional(waits(), capped, exprs().integer(0))},
            "time since the previous scan");
        return elapsed_[k];
    }

    void add_module(std::size_t k) {
        if (is_program(k)) {
            modules_[k] = schedule::scan_module(*sides_[k].scan, sides_[k].stop, options_.settles, exprs());
            instances_[k] = main_.add_instance(k == 0 ? "a" : "b", main_.add_module(modules_[k].module));
            return;
        }
        const ControllerStyle style{.mode = options_.mode, .turns = true, .scans = true};
        modules_[k] = controller_module(*equations_[k], style, exprs());
        instances_[k] = main_.add_instance(k == 0 ? "a" : "b", main_.add_module(modules_[k].module));
    }

    void wire(std::size_t k, Id<Symbol> turn) {
        std::vector<Id<Symbol>> arguments;
        for (const Id<Equations::Variable> id : modules_[k].parameters) {
            const Equations::Variable& variable = equations_[k]->variables[id];
            arguments.push_back(is_elapsed(k, id)              ? add_elapsed(k)
                                : variable.role == Role::Input ? input(variable.name)
                                                               : end_of(k, id));
        }
        arguments.push_back(turn);
        main_.system.instances[instances_[k]].arguments = std::move(arguments);
    }

    /// Returns a term for the next value of a counter: `count` minus the time until the next scan, at least 0, in a
    /// step with `waits`; otherwise `count`.
    Id<Expr> counted_down(Id<Expr> count) {
        const Id<Expr> passed = passed_units();
        const Id<Expr> rest = exprs().conditional(exprs().apply(Op::Greater, count, passed),
                                                  exprs().apply(Op::Minus, count, passed), exprs().integer(0));
        return exprs().conditional(waits(), rest, count);
    }
    Id<Expr> is_zero(Id<Expr> count) { return exprs().apply(Op::Equal, count, exprs().integer(0)); }

    Id<Symbol> add_count(const std::string& preferred, std::int64_t most) {
        return main_.draft.add(preferred, integer_type(0, most), TransitionSystem::StateSymbol{},
                               "remaining time units of timers");
    }

    /// Adds the output of a timer. The timer observes a step or a Boolean term (level) after the last evolution. While
    /// the level is false, the remaining time is equal to the rise time t1. `lasted` is true if, in the previous state,
    /// the level was true and t1 had elapsed.
    Id<Symbol> end_of(std::size_t k, Id<Equations::Variable> id) {
        const auto timer = std::ranges::find(equations_[k]->timers, id, &Equations::Timer::end);
        const std::string name = (k == 0 ? "a_" : "b_") + timer->name;
        const std::int64_t rise = timer->rise_ms / options_.unit_ms, fall = timer->fall_ms / options_.unit_ms;
        const Id<Expr> level = inner(k, timer->watched), none = exprs().integer(0);
        Id<Expr> over = level, over_next = level;
        if (rise > 0) {
            const Id<Symbol> left = add_count(name + "_left", rise);
            const Id<Expr> next =
                exprs().conditional(level, counted_down(main_.draft.leaf(left)), exprs().integer(rise));
            main_.draft.set(left, TransitionSystem::StateSymbol{exprs().integer(rise), next});
            over = exprs().conjunction(level, is_zero(main_.draft.leaf(left)));
            over_next = exprs().conjunction(level, is_zero(next));
        }
        if (fall > 0) {
            const Id<Symbol> lasted = main_.draft.add(name + "_lasted", Type{},
                                                      TransitionSystem::StateSymbol{exprs().constant(false), over_next},
                                                      "time conditions whose duration has elapsed");
            const Id<Expr> fell = exprs().conjunction(main_.draft.leaf(lasted), exprs().negation(level));
            const Id<Symbol> left = add_count(name + "_rest", fall);
            const Id<Expr> rest = main_.draft.leaf(left);
            main_.draft.set(left, TransitionSystem::StateSymbol{
                                      none, counted_down(exprs().conditional(fell, exprs().integer(fall), rest))});
            over = exprs().disjunction(std::vector{over, fell, exprs().apply(Op::Greater, rest, none)});
        }
        return main_.draft.define(name, exprs().conjunction(inner(k, modules_[k].started), over), "outputs of timers");
    }

    Id<Expr> fault(std::size_t k) {
        std::vector<Id<Expr>> faults;
        for (const Id<Symbol> flag : {modules_[k].race, modules_[k].out_of_range})
            if (flag.valid()) faults.push_back(inner(k, flag));
        return exprs().disjunction(faults);
    }

    /// Returns the condition that the chart is quiescent and that the current evolution causes no fault. The second
    /// condition is necessary, because an output that divides by zero has no value to write.
    Id<Expr> settled(std::size_t k) {
        Id<Expr> settled = inner(k, modules_[k].settled);
        if (elapsed_[k].valid()) settled = exprs().conjunction(settled, is_zero(main_.draft.leaf(elapsed_[k])));
        const Id<Symbol> faulting = modules_[k].faulting;
        return faulting.valid() ? exprs().conjunction(settled, exprs().negation(inner(k, faulting))) : settled;
    }

    void add_waits() {
        Id<Expr> done = exprs().constant(true);
        for (const std::size_t k : {0U, 1U}) {
            const bool once = is_program(k) && !options_.settles;
            const Id<Expr> answered = !searches() ? exprs().constant(true)
                                      : once      ? exprs().negation(main_.draft.leaf(fresh_))
                                                  : exprs().disjunction(settled(k), fault(k));
            answered_[k] = main_.draft.leaf(main_.draft.define(k == 0 ? "a_answered" : "b_answered", answered,
                                                               "charts that have completed the scan"));
            done = exprs().conjunction(done, answered_[k]);
        }
        main_.draft.set(waits_, TransitionSystem::StateSymbol{exprs().constant(false),
                                                              exprs().conjunction(exprs().negation(waits()), done)});
    }

    /// Adds the constraints of both charts as assumptions.
    void assume() {
        for (const Equations* chart : equations_)
            for (const Equations::Assumption& assumption : chart->assumptions)
                main_.draft.module.invariants.push_back(
                    translate(chart->exprs, assumption.condition, exprs(), [&](const Expr& leaf) {
                        const Id<Equations::Variable> id{static_cast<std::uint32_t>(leaf.value)};
                        return main_.draft.leaf(input(chart->variables[id].name));
                    }));
    }

    /// Adds a tautology that relates variables of the same name in both charts. The tautology affects only the variable
    /// order of decision diagrams: variables of one term are placed close together. This order reduces the size of the
    /// diagrams, because variables of the same name are usually equal.
    void keep_twins_together() {
        for (const Id<Equations::Variable> of_a : equations_[0]->variables.ids())
            for (const Id<Equations::Variable> of_b : equations_[1]->variables.ids()) {
                const Equations::Variable& one = equations_[0]->variables[of_a];
                const Equations::Variable& other = equations_[1]->variables[of_b];
                const bool plugs = one.role == Role::Input || one.role == Role::TimerEnd;
                const bool mixed = is_program(0) != is_program(1);
                if (plugs || other.role == Role::Input || other.role == Role::TimerEnd) continue;
                if ((one.role != other.role && !mixed) || one.name != other.name || one.type != other.type) continue;
                if (!modules_[0].symbols[of_a.index].valid() || !modules_[1].symbols[of_b.index].valid()) continue;
                const Id<Expr> same = exprs().apply(Op::Equal, inner(0, of_a), inner(1, of_b));
                main_.draft.module.transitions.push_back(exprs().disjunction(same, exprs().negation(same)));
            }
    }

    /// Returns the condition that at least one compared output has different values in the two charts.
    Id<Expr> differing() {
        std::vector<Id<Expr>> pairs;
        for (const Id<Equations::Variable> of_a : equations_[0]->variables.ids())
            for (const Id<Equations::Variable> of_b : equations_[1]->variables.ids()) {
                const Equations::Variable& one = equations_[0]->variables[of_a];
                const Equations::Variable& other = equations_[1]->variables[of_b];
                if (one.role != Role::Output || other.role != Role::Output || one.name != other.name) continue;
                if (std::ranges::find(options_.outputs, one.name) == options_.outputs.end()) continue;
                pairs.push_back(exprs().apply(Op::NotEqual, inner(0, of_a), inner(1, of_b)));
            }
        return exprs().disjunction(pairs);
    }

    /// Returns the condition that both charts have completed fewer than `than` scans.
    Id<Expr> scans_are_fewer(std::int64_t than) {
        const Id<Symbol> scans = main_.draft.add("scans", integer_type(0, than), TransitionSystem::StateSymbol{},
                                                 "number of scans begun after the first");
        const Id<Expr> now = main_.draft.leaf(scans), most = exprs().integer(than);
        const Id<Expr> more = exprs().conjunction(waits(), exprs().apply(Op::Less, now, most));
        main_.draft.set(scans, TransitionSystem::StateSymbol{
                                   exprs().integer(0),
                                   exprs().conditional(more, exprs().apply(Op::Plus, now, exprs().integer(1)), now)});
        return exprs().apply(Op::Less, now, exprs().integer(than - 1));
    }

    void add_properties() {
        const Id<Expr> of_a = fault(0), of_b = fault(1);
        const Id<Expr> sound = exprs().conjunction(exprs().negation(of_a), exprs().negation(of_b));
        add_fault_property();
        const Id<Expr> one_breaks = exprs().apply(Op::NotEqual, of_a, of_b);
        Id<Expr> apart = exprs().disjunction(one_breaks, exprs().conjunction(sound, differing()));
        if (options_.fewer_scans) apart = exprs().conjunction(apart, scans_are_fewer(*options_.fewer_scans));
        const Id<Expr> differ = exprs().conjunction(waits(), apart);
        main_.system.properties.add({.name = "same", .pattern = Pattern::Never, .operands = {differ}});
        main_.system.properties.add(
            {.name = "possible", .pattern = Pattern::Reachable, .operands = {exprs().constant(true)}});
        main_.system.properties.add(
            {.name = "continues", .pattern = Pattern::Reachable, .operands = {exprs().conjunction(waits(), sound)}});
        if (!searches()) return;
        const auto with_outputs = [&](std::size_t k, Id<Expr> fault) {
            return exprs().conjunction(answered_[k], exprs().negation(fault));
        };
        main_.system.properties.add(
            {.name = "a_follows", .pattern = Pattern::LeadsTo, .operands = {with_outputs(1, of_b), answered_[0]}});
        main_.system.properties.add(
            {.name = "b_follows", .pattern = Pattern::LeadsTo, .operands = {with_outputs(0, of_a), answered_[1]}});
        if (!options_.settles) return;
        for (const std::size_t k : {0U, 1U})
            main_.system.properties.add(
                {.name = k == 0 ? "b_settles_after_stop" : "a_settles_after_stop",
                 .pattern = Pattern::LeadsTo,
                 .operands = {exprs().conjunction(answered_[k], k == 0 ? of_a : of_b), answered_[1 - k]}});
        main_.system.properties.add(
            {.name = "one_follows",
             .pattern = Pattern::LeadsTo,
             .operands = {exprs().constant(true), exprs().disjunction(answered_[0], answered_[1])}});
    }

    void add_fault_property() {
        std::vector<Id<Expr>> run_time;
        for (const std::size_t k : {0U, 1U})
            if (is_program(k) && modules_[k].race.valid()) run_time.push_back(inner(k, modules_[k].race));
        main_.system.properties.add(
            {.name = "run_time_fault", .pattern = Pattern::Never, .operands = {exprs().disjunction(run_time)}});
    }

    const std::array<ProductSide, 2> sides_;
    const std::array<const Equations*, 2> equations_;
    const ProductOptions& options_;
    Main main_;
    std::array<ControllerModule, 2> modules_ = {};
    std::array<Id<TransitionSystem::Instance>, 2> instances_ = {};
    std::array<Id<Expr>, 2> answered_ = {};
    std::vector<Id<Symbol>> inputs_ = {};
    Id<Symbol> waits_ = {}, passed_ = {}, fresh_ = {};
    std::array<Id<Symbol>, 2> elapsed_ = {};
};

}  // namespace

ProductMachine schedule_both(const ProductSide& a, const ProductSide& b, const ProductOptions& options) {
    return PairBuilder(a, b, options).build();
}

}  // namespace grafverif
