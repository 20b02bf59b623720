// SPDX-License-Identifier: MIT
// Builds the module of one controller: translates the equations of a PLC cycle to a step of the system.
//
// First, the class Cycle declares a symbol for every variable of the equations, because an equation may read any
// variable. Then the equations define the values of the symbols: steps and stored variables, previous values, outputs,
// timers. Equations are evaluated at three times, which differ in the meaning of leaves:
//   now     in a cycle: variables before the cycle, and sampled inputs; for firing conditions and next values
//   after   after a cycle: activities and stored values after the cycle, and sampled inputs; for equation (13), in the
//           mode every_cycle
//   first   in the first evolution: initial values and sampled inputs, before any timer has expired
//
// State 0 is power-on. The first evolution is a separate step if it has a visible effect (a stored action, an output, a
// previous value), or if the module is executed scan by scan. `started` is false in this step and true in cycles;
// `started` selects between the effects of the first evolution and of a cycle. Otherwise the first step is the first
// cycle, and `started` is constantly true.
//
// A TransitionSystem must be total. Therefore a term that can divide by zero is replaced by a term that cannot
// (ranges.hpp), and a variable is unchanged if its new value would be outside its range. A division by zero and a value
// outside the range are faults, which set `out_of_range` permanently. A cycle reads the same values as the PLC: all
// right-hand sides are terms over the values before the step. In the terms `after`, the next values are substituted. A
// cycle reads an output with stored actions from its image (the internal copy of the output), because the output may
// not have been written to the plant yet. While `turn` is false, no variable changes.
#include "schedule/controller_module.hpp"

#include <algorithm>
#include <iterator>

#include "ir/literal.hpp"
#include "ir/words_of.hpp"
#include "schedule/ranges.hpp"

namespace grafverif::schedule {

namespace {

using Role = Equations::Role;
using Variable = Equations::Variable;

/// The faults of a step, which are collected while the module is built.
struct Faults {
    std::vector<Id<Expr>> conditions = {};
    std::vector<Id<Variable>> bounded = {};  ///< variables with assignments of values that may be outside their range
};

// -- symbols and readings ---------------------------------------------------------------------------------------------

/// Declares the symbols, in the order of the members, and translates the equations to terms over them. All symbols are
/// declared when the constructor returns.
class Cycle {
public:
    Cycle(const Equations& equations, const ControllerStyle& style, Draft& draft)
        : equations_(equations),
          style_(style),
          draft_(draft),
          read_(equations.variables.size()),
          shown_(equations.variables.size()) {
        for (const Variable& variable : equations.variables) draft.names.take(variable.name);
        for (const Equations::Stored& stored : equations.stored) stored_[stored.variable.index] = true;
        add_parameters();
        add_started();
        add_variables();
    }

    const Equations& equations() const { return equations_; }
    const ControllerStyle& style() const { return style_; }
    bool searches() const { return style_.mode == ExecutionMode::StabilitySearch; }
    const Variable& variable(Id<Variable> id) const { return equations_.variables[id]; }
    bool is_stored(Id<Variable> id) const { return stored_[id.index]; }

    Id<Symbol> read(Id<Variable> id) const { return read_[id.index]; }
    Id<Symbol> shown(Id<Variable> id) const { return shown_[id.index]; }
    bool has_image(Id<Variable> id) const { return shown_[id.index].valid() && read_[id.index] != shown_[id.index]; }
    Id<Symbol> started() const { return started_; }
    const std::vector<Id<Symbol>>& all_shown() const { return shown_; }
    const std::vector<Id<Variable>>& parameters() const { return parameters_; }
    Id<Expr> turn() const { return turn_.valid() ? draft_.leaf(turn_) : draft_.exprs.constant(true); }
    Id<Expr> elapses() const { return draft_.leaf(elapse_); }

    /// Returns the condition that the controller has executed the first evolution, so that the current step is a cycle.
    Id<Expr> in_cycles() const { return started_.valid() ? draft_.leaf(started_) : draft_.exprs.constant(true); }
    Id<Expr> initial(Id<Variable> id) const { return literal(draft_.exprs, variable(id).type, variable(id).initial); }
    Id<Expr> now(Id<Expr> term) { return now_(term); }
    Id<Expr> first(Id<Expr> term) { return first_(term); }
    /// Returns a copier of terms that translates leaves to values after the step. `next` contains the new value of each
    /// variable that changes.
    TermCopier after(const std::vector<Id<Expr>>& next) const {
        return {equations_.exprs, draft_.exprs, [this, &next](const Expr& node) {
                    const Id<Expr> changed = next[static_cast<std::size_t>(node.value)];
                    return changed.valid() ? changed : draft_.leaf(read(of(node)));
                }};
    }

    /// Sets the next value of a state variable, which is unchanged while `turn` is false.
    void set(Id<Symbol> symbol, Id<Expr> initial, Id<Expr> next) const {
        if (turn_.valid()) next = draft_.exprs.conditional(draft_.exprs.negation(turn()), draft_.leaf(symbol), next);
        draft_.set(symbol, TransitionSystem::StateSymbol{initial, next});
    }

    /// Returns a term with the value of `term`, or of `instead` if `term` divides by zero. Adds the condition under
    /// which `term` divides by zero to `faults`.
    Id<Expr> total(Id<Expr> term, Id<Expr> instead, std::vector<Id<Expr>>& faults) const {
        if (!divides_) return term;
        const auto [safe, undefined] = schedule::total(draft_.exprs, term, draft_.types());
        if (is_false(draft_.exprs, undefined)) return safe;
        faults.push_back(undefined);
        return draft_.exprs.conditional(undefined, instead, safe);
    }

private:
    static Id<Variable> of(const Expr& node) { return {static_cast<std::uint32_t>(node.value)}; }

    /// Declares a symbol for every variable with the role `role`. The symbol has the name of the variable.
    std::vector<Id<Variable>> declare(Role role, const char* section) {
        std::vector<Id<Variable>> found;
        for (const Id<Variable> id : equations_.variables.ids()) {
            if (variable(id).role != role) continue;
            read_[id.index] =
                draft_.module.symbols.add({variable(id).name, variable(id).type, TransitionSystem::ParameterSymbol{},
                                           section, variable(id).origin});
            found.push_back(id);
        }
        return found;
    }
    void show(const std::vector<Id<Variable>>& variables) {
        for (const Id<Variable> id : variables) shown_[id.index] = read_[id.index];
    }

    void add_parameters() {
        parameters_ = declare(Role::Input, "");
        if (!style_.with_plant) std::ranges::copy(declare(Role::TimerEnd, ""), std::back_inserter(parameters_));
        if (style_.turns) turn_ = draft_.add("turn", Type{}, TransitionSystem::ParameterSymbol{});
        if (!style_.with_plant || equations_.timers.empty()) return;
        elapse_ = draft_.add("elapse", Type{}, TransitionSystem::ParameterSymbol{});
        show(declare(Role::TimerEnd, "outputs of timers"));
    }

    /// True if the state after the first evolution is distinguishable from power-on.
    bool first_evolution_shows() {
        if (acts_at_first(equations_) || !equations_.previous.empty()) return true;
        return !searches() && std::ranges::any_of(equations_.outputs, [&](const Equations::Output& output) {
            return first(output.value) != initial(output.variable);
        });
    }

    /// Adds the symbol `started` if the first evolution is a separate step. In the first evolution, no timer has
    /// expired, because a timer expires only after the activation of its step.
    void add_started() {
        if (!style_.scans && !first_evolution_shows()) return;
        Exprs& exprs = draft_.exprs;
        started_ =
            draft_.add("started", Type{}, TransitionSystem::ParameterSymbol{}, "the first evolution has been executed");
        set(started_, exprs.constant(false), exprs.constant(true));
        if (style_.with_plant) return;
        for (const Equations::Timer& timer : equations_.timers)
            draft_.module.invariants.push_back(
                exprs.disjunction(in_cycles(), exprs.negation(draft_.leaf(read(timer.end)))));
    }

    void add_variables() {
        show(declare(Role::Step, "steps"));
        show(declare(Role::Internal, "internals"));
        for (const Id<Variable> id : equations_.variables.ids()) {
            if (variable(id).role == Role::Output) add_output(id);
        }
        show(declare(Role::Previous, "previous values, for edges"));
        if (style_.scans) show(declare(Role::Watched, "levels that timers observe"));
        show(declare(Role::FiringCondition, "firing conditions"));
    }

    void add_output(Id<Variable> id) {
        const auto& [name, role, type, initial, origin] = variable(id);
        read_[id.index] = shown_[id.index] =
            draft_.module.symbols.add({name, type, TransitionSystem::ParameterSymbol{}, "outputs", origin});
        if (searches() && is_stored(id))
            read_[id.index] = draft_.add(name + "_image", type, TransitionSystem::ParameterSymbol{},
                                         "outputs of stored actions, not yet written", origin);
    }

    /// True if some equation contains a division.
    static bool divides(const Exprs& exprs) {
        for (std::uint32_t term = 0; term < exprs.size(); ++term) {
            const Op op = exprs[Id<Expr>{term}].op;
            if (op == Op::Divide || op == Op::Modulo) return true;
        }
        return false;
    }

    const Equations& equations_;
    const ControllerStyle& style_;
    Draft& draft_;
    const bool divides_ = divides(equations_.exprs);
    std::vector<bool> stored_ =
        /// For each variable: true if stored actions write the variable.
        std::vector<bool>(equations_.variables.size());
    /// For each variable: the symbol that the cycle reads (`read_`), and the symbol that is visible outside the module
    /// (`shown_`). The two symbols differ only for an output with stored actions under stability search: the cycle
    /// reads the image of the output.
    std::vector<Id<Symbol>> read_, shown_;
    std::vector<Id<Variable>> parameters_ = {};
    Id<Symbol> turn_ = {}, elapse_ = {}, started_ = {};  ///< invalid if the module does not use the symbol
    TermCopier now_{equations_.exprs, draft_.exprs, [this](const Expr& node) { return draft_.leaf(read(of(node))); }};
    TermCopier first_{equations_.exprs, draft_.exprs, [this](const Expr& node) {
                          const Role role = variable(of(node)).role;
                          if (role == Role::TimerEnd) return draft_.exprs.constant(false);
                          return role == Role::Input ? draft_.leaf(read(of(node))) : initial(of(node));
                      }};
};

// -- values -----------------------------------------------------------------------------------------------------------

/// Returns a term with the value of `value` if this value is defined and in the range of the variable, otherwise with
/// the value of `kept`. Adds a definition for the fault.
Id<Expr> guarded(const Cycle& cycle, Draft& draft, Id<Variable> id, Id<Expr> value, Id<Expr> kept, bool at_first,
                 Faults& faults) {
    Exprs& exprs = draft.exprs;
    const Variable& variable = cycle.variable(id);
    const auto [safe, undefined] = total(exprs, value, draft.types());
    const Id<Expr> fault = exprs.disjunction(undefined, leaves_range(exprs, safe, variable.type, draft.types()));
    if (is_false(exprs, fault)) return safe;
    if (!variable.type.boolean) faults.bounded.push_back(id);
    const Id<Expr> when = at_first ? exprs.negation(cycle.in_cycles()) : cycle.in_cycles();
    if (is_true(exprs, fault)) {
        faults.conditions.push_back(when);
        return kept;
    }
    const std::string preferred = variable.name + (at_first ? "_leaves_range_at_first" : "_leaves_range");
    const Id<Symbol> symbol = draft.add(preferred, Type{}, TransitionSystem::DefineSymbol{fault},
                                        "assignments of values outside the range of the variable", variable.origin);
    faults.conditions.push_back(exprs.conjunction(when, draft.leaf(symbol)));
    return exprs.conditional(draft.leaf(symbol), kept, safe);
}

void set_firings(Cycle& cycle, Draft& draft, Faults& faults) {
    for (const Equations::Firing& firing : cycle.equations().firings) {
        const Id<Expr> condition = draft.exprs.conjunction(cycle.in_cycles(), cycle.now(firing.condition));
        draft.set(cycle.read(firing.variable), TransitionSystem::DefineSymbol{cycle.total(
                                                   condition, draft.exprs.constant(false), faults.conditions)});
    }
}

/// Sets step activities and stored variables. Returns, for each variable that changes, the value after the step.
std::vector<Id<Expr>> set_next_values(Cycle& cycle, Draft& draft, Faults& faults) {
    std::vector<Id<Expr>> next(cycle.equations().variables.size());
    for (const Equations::StepActivity& step : cycle.equations().steps) {
        next[step.variable.index] = cycle.now(step.next);
        cycle.set(cycle.read(step.variable), cycle.initial(step.variable), next[step.variable.index]);
    }
    for (const Equations::Stored& stored : cycle.equations().stored) {
        const Id<Variable> id = stored.variable;
        const Id<Expr> kept = draft.leaf(cycle.read(id)), initial = cycle.initial(id);
        Id<Expr> value = guarded(cycle, draft, id, cycle.now(stored.next), kept, false, faults);
        if (cycle.started().valid()) {
            const Id<Expr> first = guarded(cycle, draft, id, cycle.first(stored.first), initial, true, faults);
            value = draft.exprs.conditional(cycle.in_cycles(), value, first == initial ? kept : first);
        }
        next[id.index] = value;
        cycle.set(cycle.read(id), initial, value);
    }
    return next;
}

/// Sets the previous values of the terms whose rising or falling edges are observed. A division by zero in one of these
/// terms is a fault.
void set_previous(Cycle& cycle, Draft& draft, Faults& faults) {
    const Id<Expr> off = draft.exprs.constant(false);
    for (const Equations::Previous& previous : cycle.equations().previous)
        cycle.set(cycle.read(previous.variable), off, cycle.total(cycle.now(previous.value), off, faults.conditions));
}

/// Sets the next values of the levels (Boolean terms) that timers observe.
void set_watched(Cycle& cycle, Draft& draft, const std::vector<Id<Expr>>& next, Faults& faults) {
    if (!cycle.style().scans) return;
    const Id<Expr> off = draft.exprs.constant(false);
    TermCopier after = cycle.after(next);
    for (const Equations::ObservedTerm& watch : cycle.equations().watches)
        cycle.set(cycle.read(watch.variable), off, cycle.total(after(watch.value), off, faults.conditions));
}

/// True if the equation of the output always has the initial value of the output.
bool is_unwritten(Cycle& cycle, const Equations::Output& output) {
    return cycle.now(output.value) == cycle.initial(output.variable);
}

/// Sets the values of variables that are never written.
void set_constants(Cycle& cycle, Draft& draft) {
    const Equations& equations = cycle.equations();
    std::vector<bool> written(equations.variables.size());
    for (const Equations::Output& output : equations.outputs)
        written[output.variable.index] = !is_unwritten(cycle, output);
    for (const Id<Variable> id : equations.variables.ids()) {
        const Role role = cycle.variable(id).role;
        if ((role == Role::Internal || role == Role::Output) && !cycle.is_stored(id) && !written[id.index])
            draft.set(cycle.read(id), TransitionSystem::DefineSymbol{cycle.initial(id)});
    }
}

Id<Symbol> add_stable(Cycle& cycle, Draft& draft, Faults& faults) {
    const Id<Expr> value = draft.exprs.conjunction(cycle.in_cycles(), cycle.now(cycle.equations().stable));
    const Id<Expr> total = cycle.total(value, draft.exprs.constant(false), faults.conditions);
    return draft.define("stable", total, "stability: one more cycle would change no step and no stored variable");
}

/// Adds an output that the controller writes only when the situation is stable. `now` is the value to write. Returns
/// the condition that the output already has this value.
Id<Expr> written_when_stable(const Cycle& cycle, Draft& draft, Id<Variable> id, Id<Expr> stable, Id<Expr> now) {
    const Id<Expr> kept = draft.leaf(cycle.shown(id));
    cycle.set(cycle.shown(id), cycle.initial(id), draft.exprs.conditional(stable, now, kept));
    return draft.exprs.apply(Op::Equal, kept, now);
}

Id<Expr> add_now(const Cycle& cycle, Draft& draft, Id<Variable> id, Id<Expr> value, const char* section) {
    const Variable& variable = cycle.variable(id);
    return draft.leaf(draft.add(variable.name + "_now", variable.type, TransitionSystem::DefineSymbol{value}, section,
                                variable.origin));
}

/// Adds the output of equation (13) under stability search. Returns the condition that the output already has the value
/// to write.
Id<Expr> set_searching_output(Cycle& cycle, Draft& draft, const Equations::Output& output, Id<Expr> stable,
                              Faults& faults) {
    Exprs& exprs = draft.exprs;
    std::vector<Id<Expr>> found;
    Id<Expr> value = cycle.total(cycle.now(output.value), exprs.constant(false), found);
    for (const Id<Expr> fault : found) faults.conditions.push_back(exprs.conjunction(stable, fault));
    if (!is_constant(exprs[value].op))
        value = add_now(cycle, draft, output.variable, value, "outputs by equation (13) of Perin and Faure (2013)");
    return written_when_stable(cycle, draft, output.variable, stable, value);
}

/// True if the value of `term` after a cycle depends on a sampled input or timer output, and not only on the state
/// after the cycle.
bool reads_inputs(const Equations& equations, Id<Expr> term) {
    return std::ranges::any_of(leaves(equations.exprs, term), [&](Id<Expr> leaf) {
        const Role role = equations.variables[{static_cast<std::uint32_t>(equations.exprs[leaf].value)}].role;
        return role == Role::Input || role == Role::TimerEnd;
    });
}

/// Adds the output of equation (13) in the mode every_cycle, including its value after the first evolution. Returns the
/// condition that the output already has the value to write.
Id<Expr> set_cyclic_output(Cycle& cycle, Draft& draft, const Equations::Output& output, TermCopier& after,
                           Faults& faults) {
    Exprs& exprs = draft.exprs;
    const Id<Symbol> symbol = cycle.shown(output.variable);
    const Id<Expr> off = exprs.constant(false), initial = cycle.initial(output.variable);
    const Id<Expr> then = cycle.total(after(output.value), off, faults.conditions);
    if (!reads_inputs(cycle.equations(), output.value)) {
        Id<Expr> value = cycle.now(output.value);
        if (cycle.first(output.value) != initial)
            value = is_false(exprs, initial) ? exprs.conjunction(cycle.in_cycles(), value)
                                             : exprs.conditional(cycle.in_cycles(), value, initial);
        std::vector<Id<Expr>> seen_before;  // faults that the previous cycle has already recorded
        draft.set(symbol, TransitionSystem::DefineSymbol{cycle.total(value, off, seen_before)});
        return exprs.constant(true);
    }
    const Id<Expr> now = add_now(
        cycle, draft, output.variable, then,
        "outputs by equation (13) of Perin and Faure (2013), computed from the steps that are active after the cycle");
    cycle.set(symbol, initial, now);
    return exprs.apply(Op::Equal, draft.leaf(symbol), now);
}

/// Sets all outputs, including outputs with images. Returns the symbol `settled`.
Id<Symbol> set_outputs(Cycle& cycle, Draft& draft, Id<Symbol> stable, const std::vector<Id<Expr>>& next,
                       Faults& faults) {
    TermCopier after = cycle.after(next);
    std::vector<Id<Expr>> settled{draft.leaf(stable)};
    for (const Equations::Output& output : cycle.equations().outputs)
        if (!is_unwritten(cycle, output))
            settled.push_back(cycle.searches() ? set_searching_output(cycle, draft, output, settled.front(), faults)
                                               : set_cyclic_output(cycle, draft, output, after, faults));
    for (const Id<Variable> id : cycle.equations().variables.ids())
        if (cycle.has_image(id))
            settled.push_back(written_when_stable(cycle, draft, id, settled.front(), draft.leaf(cycle.read(id))));
    return draft.define("settled", draft.exprs.conjunction(settled),
                        "quiescent: another cycle with the same inputs would change nothing");
}

/// Sets the timers. A timer of a step may expire while its step is active, at any time that `elapse` permits. The timer
/// is reset when the step is deactivated or activated again. All other timers have a second duration or observe another
/// term; their outputs are free.
void set_timers(Cycle& cycle, Draft& draft, const std::vector<Id<Expr>>& next) {
    if (!cycle.style().with_plant) return;
    Exprs& exprs = draft.exprs;
    const Equations& equations = cycle.equations();
    for (const Equations::Timer& timer : equations.timers) {
        const Id<Symbol> end = cycle.read(timer.end);
        const Id<Expr> now = draft.leaf(draft.add(timer.name + "_elapses", Type{}, TransitionSystem::ChoiceSymbol{},
                                                  "timers that expire in a step"));
        const Id<Expr> ended = exprs.disjunction(draft.leaf(end), exprs.conjunction(cycle.elapses(), now));
        Id<Expr> value = exprs.conjunction(cycle.in_cycles(), now);
        if (const auto step = watched_step(equations, timer); step && timer.fall_ms == 0) {
            const Id<Expr> reactivated = cycle.now(equations.steps[*step].activated);
            const Id<Expr> stays = exprs.conjunction(next[timer.watched.index], exprs.negation(reactivated));
            value = exprs.conjunction(std::vector{cycle.in_cycles(), stays, ended});
            const Id<Expr> active = draft.leaf(cycle.read(timer.watched));
            value = exprs.conditional(cycle.turn(), value, exprs.conjunction(active, ended));
        }
        draft.set(end, TransitionSystem::StateSymbol{exprs.constant(false), value});
    }
}

/// Adds a flag that remains set after one of `faults`. The result is invalid if `faults` is empty.
Id<Symbol> add_flag(const Cycle& cycle, Draft& draft, const char* preferred, const std::vector<Id<Expr>>& faults) {
    Exprs& exprs = draft.exprs;
    const Id<Expr> fault = exprs.disjunction(faults);
    if (is_false(exprs, fault)) return {};
    const Id<Symbol> flag = draft.add(preferred, Type{}, TransitionSystem::ParameterSymbol{},
                                      "faults; a fault remains true after it occurs");
    cycle.set(flag, exprs.constant(false), exprs.disjunction(draft.leaf(flag), fault));
    return flag;
}

/// Returns the conditions under which stored actions race. Adds divisions by zero in these conditions to `found`.
std::vector<Id<Expr>> races(Cycle& cycle, Draft& draft, Faults& found) {
    Exprs& exprs = draft.exprs;
    const Id<Expr> off = exprs.constant(false), at_start = exprs.negation(cycle.in_cycles());
    std::vector<Id<Expr>> races;
    for (const Fault& fault : faults(cycle.equations())) {
        if (fault.first.valid())
            races.push_back(cycle.total(exprs.conjunction(at_start, cycle.first(fault.first)), off, found.conditions));
        races.push_back(
            cycle.total(exprs.conjunction(cycle.in_cycles(), cycle.now(fault.condition)), off, found.conditions));
    }
    return races;
}

}  // namespace

ControllerModule controller_module(const Equations& equations, const ControllerStyle& style, Exprs& exprs) {
    Draft draft{exprs};
    draft.module.name = "controller_" + equations.name;
    Cycle cycle(equations, style, draft);
    Faults faults;
    set_firings(cycle, draft, faults);
    const std::vector<Id<Expr>> next = set_next_values(cycle, draft, faults);
    set_previous(cycle, draft, faults);
    set_watched(cycle, draft, next, faults);
    set_constants(cycle, draft);
    const Id<Symbol> stable = add_stable(cycle, draft, faults);
    const Id<Symbol> settled = set_outputs(cycle, draft, stable, next, faults);
    set_timers(cycle, draft, next);
    const std::vector<Id<Expr>> racing = races(cycle, draft, faults);
    const Id<Symbol> race = add_flag(cycle, draft, "race", racing);
    const Id<Symbol> out_of_range = add_flag(cycle, draft, "out_of_range", faults.conditions);
    std::ranges::sort(faults.bounded);
    const auto repeated = std::ranges::unique(faults.bounded);
    faults.bounded.erase(repeated.begin(), repeated.end());
    Id<Symbol> faulting;
    if (style.scans && (race.valid() || out_of_range.valid())) {
        const Id<Expr> any = exprs.disjunction(exprs.disjunction(racing), exprs.disjunction(faults.conditions));
        faulting = draft.define("faulting", any, "causes of faults");
    }
    return {std::move(draft.module),
            cycle.parameters(),
            cycle.all_shown(),
            cycle.started(),
            settled,
            race,
            out_of_range,
            std::move(faults.bounded),
            faulting};
}

}  // namespace grafverif::schedule
