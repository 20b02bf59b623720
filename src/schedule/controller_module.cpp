// SPDX-License-Identifier: MIT
// The module of one controller. Three readings of the equations meet in it, and they differ in what a leaf stands for:
//   in a cycle     variables before the cycle and the inputs it samples: firing conditions, next values
//   after a cycle  activities and internals after it, the inputs it sampled: equation (13), every_cycle mode
//   at first       initial values and the inputs that the first evolution samples; no timer has ended
// State 0 is power-on. Where the first evolution shows (a stored action, an output, a previous value), it is a step of
// its own, which `started` tells from the cycles; else the first step is the first cycle.
#include "schedule/controller_module.hpp"

#include <algorithm>

#include "schedule/ranges.hpp"
#include "support/unique_names.hpp"

namespace grafverif::schedule {

namespace {

using Role = Equations::Role;
using Variable = Equations::Variable;

struct Builder {
    const Equations& equations;
    const ControllerStyle style;
    Exprs& exprs;
    const ExecutionMode mode = style.mode;
    ControllerModule result = {};
    UniqueNames names = {};
    Id<Symbol> turn = {}, elapse = {};
    /// Per variable: the symbol that the cycle reads (of an output with stored actions, its image), and the stored
    /// equation.
    std::vector<Id<Symbol>> read = {};
    std::vector<const Equations::Stored*> stored = {};
    std::vector<Id<Expr>> next = {};   ///< per variable, where it changes: its value after the step at hand
    std::vector<Id<Expr>> faults = {};
    Id<Symbol> stable = {};
    bool divides = false;   ///< some equation does

    const Variable& variable(std::size_t index) const {
        return equations.variables[{static_cast<std::uint32_t>(index)}];
    }

    Id<Expr> leaf(Id<Symbol> symbol) { return exprs.leaf(Op::Variable, symbol.index); }

    Id<Expr> constant(Type type, std::int64_t value) {
        return type.boolean ? exprs.constant(value != 0) : exprs.integer(value);
    }

    Id<Symbol> add(const std::string& wish, Type type, const char* section, Span origin = {}) {
        return result.module.symbols.add(
            {names.fresh(wish), type, TransitionSystem::ParameterSymbol{}, section, origin});
    }

    void define(Id<Symbol> symbol, Id<Expr> value) {
        result.module.symbols[symbol].kind = TransitionSystem::DefineSymbol{value};
    }

    /// A state variable; nothing happens to it out of turn.
    void state(Id<Symbol> symbol, Id<Expr> initial, Id<Expr> value) {
        if (turn.valid()) value = exprs.conditional(exprs.negation(leaf(turn)), leaf(symbol), value);
        result.module.symbols[symbol].kind = TransitionSystem::StateSymbol{initial, value};
    }

    TermCopier in_cycle{equations.exprs, exprs, [this](const Expr& node) { return leaf(read[static_cast<std::size_t>(node.value)]); }};
    TermCopier after_cycle{equations.exprs, exprs, [this](const Expr& node) {
        const auto index = static_cast<std::size_t>(node.value);
        return next[index].valid() ? next[index] : leaf(read[index]);
    }};
    /// Over the initial values: as the first evolution reads a term.
    TermCopier at_first{equations.exprs, exprs, [this](const Expr& node) {
        const auto index = static_cast<std::size_t>(node.value);
        const Role role = variable(index).role;
        return role == Role::TimerEnd ? exprs.constant(false) : role == Role::Input ? leaf(read[index]) : initial(index);
    }};

    Id<Expr> initial(std::size_t index) { return constant(variable(index).type, variable(index).initial); }

    /// The first evolution has been made: the step at hand is a cycle.
    Id<Expr> in_cycles() { return result.started.valid() ? leaf(result.started) : exprs.constant(true); }

    TypeOf types() const {
        return [this](const Expr& node) {
            return result.module.symbols[{static_cast<std::uint32_t>(node.value)}].type;
        };
    }
};

bool is_image(const Builder& builder, std::size_t index) {
    return builder.mode == ExecutionMode::StabilitySearch && builder.stored[index] != nullptr &&
           builder.variable(index).role == Role::Output;
}

/// Whether what `term` says after a cycle depends on more than the state after it: on an input sampled in the cycle.
bool reads_inputs(const Equations& equations, Id<Expr> term) {
    return std::ranges::any_of(leaves(equations.exprs, term), [&](Id<Expr> leaf) {
        const auto index = static_cast<std::uint32_t>(equations.exprs[leaf].value);
        const Role role = equations.variables[{index}].role;
        return role == Role::Input || role == Role::TimerEnd;
    });
}

// -- symbols, in the order in which they are declared -----------------------------------------------------------------

void add_parameters(Builder& builder) {
    const auto add = [&builder](Role role, std::string_view section, bool parameter) {
        for (const Id<Variable> id : builder.equations.variables.ids()) {
            const Variable& variable = builder.equations.variables[id];
            if (variable.role != role) continue;
            builder.read[id.index] = builder.result.module.symbols.add({variable.name, variable.type,
                                                                        TransitionSystem::ParameterSymbol{},
                                                                        std::string(section), variable.origin});
            if (parameter) builder.result.parameters.push_back(id);
            else builder.result.symbols[id.index] = builder.read[id.index];
        }
    };
    add(Role::Input, "", true);
    if (!builder.style.with_plant) add(Role::TimerEnd, "", true);
    if (builder.style.turns) builder.turn = builder.add("turn", {}, "");
    if (!builder.style.with_plant || builder.equations.timers.empty()) return;
    builder.elapse = builder.add("elapse", {}, "");
    add(Role::TimerEnd, "ends of timers", false);
}

/// The end of a timer over a step comes at any moment that `elapse` allows while the step is active, and goes when the
/// step is left or activated anew. Other timers (with a second duration, over another term) are left free.
void set_timers(Builder& builder) {
    if (!builder.style.with_plant) return;
    Exprs& exprs = builder.exprs;
    for (const Equations::Timer& timer : builder.equations.timers) {
        const Id<Symbol> end = builder.read[timer.end.index];
        const auto step =
            std::ranges::find(builder.equations.steps, timer.watched, &Equations::StepActivity::variable);
        const Id<Symbol> now = builder.add(timer.name + "_elapses", {}, "timers that end in a step");
        builder.result.module.symbols[now].kind = TransitionSystem::ChoiceSymbol{};
        const Id<Expr> ended = exprs.disjunction(
            builder.leaf(end), exprs.conjunction(builder.leaf(builder.elapse), builder.leaf(now)));
        Id<Expr> next = exprs.conjunction(builder.in_cycles(), builder.leaf(now));
        if (step != builder.equations.steps.end() && timer.fall_ms == 0) {
            const Id<Expr> stays = exprs.conjunction(builder.next[timer.watched.index],
                                                     exprs.negation(builder.in_cycle(step->activated)));
            next = exprs.conjunction(std::vector{builder.in_cycles(), stays, ended});
            if (builder.turn.valid())
                next = exprs.conditional(builder.leaf(builder.turn), next,
                                         exprs.conjunction(builder.leaf(builder.read[timer.watched.index]), ended));
        }
        builder.result.module.symbols[end].kind = TransitionSystem::StateSymbol{exprs.constant(false), next};
    }
}

/// Whether anybody can tell the state after the first evolution from power-on.
bool first_evolution_shows(Builder& builder) {
    const Equations& equations = builder.equations;
    if (acts_at_first(equations) || !equations.previous.empty()) return true;
    return builder.mode == ExecutionMode::EveryCycle &&
           std::ranges::any_of(equations.outputs, [&](const Equations::Output& output) {
               return builder.at_first(output.value) != builder.initial(output.variable.index);
           });
}

/// The end of a timer comes after the activation that it counts from, and the first is the first evolution's.
void add_started(Builder& builder) {
    if (!first_evolution_shows(builder)) return;
    Exprs& exprs = builder.exprs;
    builder.result.started = builder.add("started", {}, "the first evolution has been made");
    builder.state(builder.result.started, exprs.constant(false), exprs.constant(true));
    if (builder.style.with_plant) return;
    for (const Equations::Timer& timer : builder.equations.timers)
        builder.result.module.invariants.push_back(exprs.disjunction(
            builder.leaf(builder.result.started), exprs.negation(builder.leaf(builder.read[timer.end.index]))));
}

void add_states(Builder& builder) {
    const auto add_role = [&](Role role, const char* section) {
        for (const Id<Variable> id : builder.equations.variables.ids()) {
            const Variable& variable = builder.equations.variables[id];
            if (variable.role != role) continue;
            const Id<Symbol> symbol = builder.result.module.symbols.add(
                {variable.name, variable.type, TransitionSystem::ParameterSymbol{}, section, variable.origin});
            builder.read[id.index] = builder.result.symbols[id.index] = symbol;
            if (is_image(builder, id.index))
                builder.read[id.index] = builder.add(variable.name + "_image", variable.type,
                                                     "outputs of stored actions, not yet written", variable.origin);
        }
    };
    add_role(Role::Step, "steps");
    add_role(Role::Internal, "internals");
    add_role(Role::Output, "outputs");
    add_role(Role::Previous, "previous values, for edges");
    add_role(Role::FiringCondition, "firing conditions");
}

// -- their values
// -------------------------------------------------------------------------------------------------------

/// `term`, or `instead` where it divides by zero, which is a fault.
Id<Expr> total(Builder& builder, Id<Expr> term, Id<Expr> instead, std::vector<Id<Expr>>& faults) {
    Exprs& exprs = builder.exprs;
    if (!builder.divides) return term;
    const Id<Expr> raw = divides_by_zero(exprs, term, builder.types());
    if (is_false(exprs, raw)) return term;
    const Id<Expr> fault = with_safe_divisors(exprs, raw, builder.types());
    faults.push_back(fault);
    return exprs.conditional(fault, instead, with_safe_divisors(exprs, term, builder.types()));
}

void set_steps(Builder& builder) {
    for (const Equations::Firing& firing : builder.equations.firings) {
        const Id<Expr> condition = builder.exprs.conjunction(builder.in_cycles(), builder.in_cycle(firing.condition));
        builder.define(builder.read[firing.variable.index],
                       total(builder, condition, builder.exprs.constant(false), builder.faults));
    }
    for (const Equations::StepActivity& step : builder.equations.steps) {
        const std::uint32_t index = step.variable.index;
        builder.next[index] = builder.in_cycle(step.next);
        builder.state(builder.read[index], builder.initial(index), builder.next[index]);
    }
}

/// `value` where it exists and lies in the range of the variable, else `kept`; a definition names the fault.
Id<Expr> guarded(Builder& builder, std::size_t index, Id<Expr> value, Id<Expr> kept, bool at_first) {
    Exprs& exprs = builder.exprs;
    const Variable& variable = builder.variable(index);
    const Id<Expr> raw = divides_by_zero(exprs, value, builder.types());
    const Id<Expr> undefined = with_safe_divisors(exprs, raw, builder.types());
    value = with_safe_divisors(exprs, value, builder.types());
    const Id<Expr> outside = variable.type.boolean ? exprs.constant(false)
                                                   : leaves_range(exprs, value, variable.type, builder.types());
    const Id<Expr> fault = exprs.disjunction(undefined, outside);
    if (is_false(exprs, fault)) return value;
    if (!variable.type.boolean) builder.result.bounded.push_back({static_cast<std::uint32_t>(index)});
    const Id<Expr> when = at_first ? exprs.negation(builder.in_cycles()) : builder.in_cycles();
    if (is_true(exprs, fault)) {
        builder.faults.push_back(when);
        return kept;
    }
    const std::string wish = variable.name + (at_first ? "_leaves_range_at_first" : "_leaves_range");
    const Id<Symbol> symbol = builder.add(wish, {}, "assignments that would leave the range of their variable",
                                          variable.origin);
    builder.define(symbol, fault);
    builder.faults.push_back(exprs.conjunction(when, builder.leaf(symbol)));
    return exprs.conditional(builder.leaf(symbol), kept, value);
}

void set_stored(Builder& builder) {
    for (const Equations::Stored& stored : builder.equations.stored) {
        const std::uint32_t index = stored.variable.index;
        const Id<Symbol> symbol = builder.read[index];
        const Id<Expr> kept = builder.leaf(symbol);
        Id<Expr> next = guarded(builder, index, builder.in_cycle(stored.next), kept, false);
        if (builder.result.started.valid()) {
            const Id<Expr> initial = builder.initial(index);
            const Id<Expr> first = guarded(builder, index, builder.at_first(stored.first), initial, true);
            next = builder.exprs.conditional(builder.in_cycles(), next, first == initial ? kept : first);
        }
        builder.next[index] = next;
        builder.state(symbol, builder.initial(index), next);
    }
}

/// What edges compare with. A term that divides by zero is a fault.
void set_previous(Builder& builder) {
    for (const Equations::Previous& previous : builder.equations.previous) {
        const Id<Expr> off = builder.exprs.constant(false);
        builder.state(builder.read[previous.variable.index], off,
                      total(builder, builder.in_cycle(previous.value), off, builder.faults));
    }
}

/// Whether the output always has its initial value.
bool is_unwritten(Builder& builder, const Equations::Output& output) {
    return builder.in_cycle(output.value) == builder.initial(output.variable.index);
}

/// Variables that nothing writes.
void set_constants(Builder& builder) {
    std::vector<bool> written(builder.equations.variables.size());
    for (const Equations::Output& output : builder.equations.outputs)
        written[output.variable.index] = !is_unwritten(builder, output);
    for (const Id<Variable> id : builder.equations.variables.ids()) {
        const Role role = builder.equations.variables[id].role;
        const bool candidate = role == Role::Internal || role == Role::Output;
        if (candidate && builder.stored[id.index] == nullptr && !written[id.index])
            builder.define(builder.read[id.index], builder.initial(id.index));
    }
}

void set_stable(Builder& builder) {
    const Id<Expr> value = builder.exprs.conjunction(builder.in_cycles(), builder.in_cycle(builder.equations.stable));
    builder.stable = builder.add("stable", {}, "stability: one more cycle would change no step and no stored variable");
    builder.define(builder.stable, total(builder, value, builder.exprs.constant(false), builder.faults));
}

/// Written when stable: `now` is what would be written.
Id<Expr> written_when_stable(Builder& builder, std::uint32_t index, Id<Expr> now) {
    const Id<Symbol> symbol = builder.result.symbols[index];
    const Id<Expr> kept = builder.leaf(symbol);
    builder.state(symbol, builder.initial(index), builder.exprs.conditional(builder.leaf(builder.stable), now, kept));
    return builder.exprs.apply(Op::Equal, kept, now);
}

/// Equation (13) in stability search; returns when the output is up to date.
Id<Expr> set_searching_output(Builder& builder, const Equations::Output& output) {
    const std::uint32_t index = output.variable.index;
    const Variable& variable = builder.variable(index);
    std::vector<Id<Expr>> faults;
    const Id<Expr> value = total(builder, builder.in_cycle(output.value), builder.exprs.constant(false), faults);
    for (const Id<Expr> fault : faults)
        builder.faults.push_back(builder.exprs.conjunction(builder.leaf(builder.stable), fault));
    if (is_constant(builder.exprs[value].op)) return written_when_stable(builder, index, value);
    const Id<Symbol> now =
        builder.add(variable.name + "_now", variable.type, "outputs by equation (13)", variable.origin);
    builder.define(now, value);
    return written_when_stable(builder, index, builder.leaf(now));
}

/// Equation (13) in every cycle, the first evolution included; returns when the output is up to date.
Id<Expr> set_cyclic_output(Builder& builder, const Equations::Output& output) {
    Exprs& exprs = builder.exprs;
    const std::uint32_t index = output.variable.index;
    const Id<Symbol> symbol = builder.result.symbols[index];
    const Id<Expr> off = exprs.constant(false), initial = builder.initial(index);
    const Id<Expr> after = total(builder, builder.after_cycle(output.value), off, builder.faults);
    if (!reads_inputs(builder.equations, output.value)) {
        Id<Expr> value = builder.in_cycle(output.value);
        if (builder.at_first(output.value) != initial)
            value = is_false(exprs, initial) ? exprs.conjunction(builder.in_cycles(), value)
                                             : exprs.conditional(builder.in_cycles(), value, initial);
        std::vector<Id<Expr>> seen_before;   // in the cycle that led here
        builder.define(symbol, total(builder, value, off, seen_before));
        return exprs.constant(true);
    }
    const Variable& variable = builder.variable(index);
    const Id<Symbol> now = builder.add(variable.name + "_now", variable.type,
                                       "outputs by equation (13), of the steps after the cycle", variable.origin);
    builder.define(now, after);
    builder.state(symbol, initial, builder.leaf(now));
    return exprs.apply(Op::Equal, builder.leaf(symbol), builder.leaf(now));
}

void set_outputs(Builder& builder) {
    std::vector<Id<Expr>> settled{builder.leaf(builder.stable)};
    for (const Equations::Output& output : builder.equations.outputs)
        if (!is_unwritten(builder, output))
            settled.push_back(builder.mode == ExecutionMode::StabilitySearch ? set_searching_output(builder, output)
                                                                             : set_cyclic_output(builder, output));
    for (const Id<Variable> id : builder.equations.variables.ids())
        if (is_image(builder, id.index))
            settled.push_back(written_when_stable(builder, id.index, builder.leaf(builder.read[id.index])));
    builder.result.settled =
        builder.add("settled", {}, "settled: one more cycle with the same inputs would change nothing");
    builder.define(builder.result.settled, builder.exprs.conjunction(settled));
}

/// A flag that stays set once `fault` sets it; not valid where it never can.
Id<Symbol> sticky(Builder& builder, const char* wish, Id<Expr> fault) {
    Exprs& exprs = builder.exprs;
    if (is_false(exprs, fault)) return {};
    const Id<Symbol> flag = builder.add(wish, {}, "faults, once and for ever");
    builder.state(flag, exprs.constant(false), exprs.disjunction(builder.leaf(flag), fault));
    return flag;
}

void set_flags(Builder& builder) {
    Exprs& exprs = builder.exprs;
    const Id<Expr> off = exprs.constant(false), in_cycles = builder.in_cycles(), at_start = exprs.negation(in_cycles);
    std::vector<Id<Expr>> races;
    for (const Fault& fault : faults(builder.equations)) {
        if (fault.first.valid())
            races.push_back(total(builder, exprs.conjunction(at_start, builder.at_first(fault.first)), off, builder.faults));
        races.push_back(total(builder, exprs.conjunction(in_cycles, builder.in_cycle(fault.condition)), off, builder.faults));
    }
    builder.result.race = sticky(builder, "race", exprs.disjunction(races));
    builder.result.out_of_range = sticky(builder, "out_of_range", exprs.disjunction(builder.faults));
    std::ranges::sort(builder.result.bounded);
    const auto repeated = std::ranges::unique(builder.result.bounded);
    builder.result.bounded.erase(repeated.begin(), repeated.end());
}

}  // namespace

ControllerModule controller_module(const Equations& equations, const ControllerStyle& style, Exprs& exprs) {
    const std::size_t size = equations.variables.size();
    Builder builder{equations, style, exprs};
    for (const Variable& variable : equations.variables) builder.names.fresh(variable.name);
    for (std::uint32_t term = 0; term < equations.exprs.size(); ++term) {
        const Op op = equations.exprs[Id<Expr>{term}].op;
        builder.divides = builder.divides || op == Op::Divide || op == Op::Modulo;
    }
    builder.read.resize(size);
    builder.stored.resize(size);
    builder.next.resize(size);
    builder.result.symbols.resize(size);
    builder.result.module.name = "controller_" + equations.name;
    for (const Equations::Stored& stored : equations.stored) builder.stored[stored.variable.index] = &stored;

    add_parameters(builder);
    add_started(builder);
    add_states(builder);
    set_steps(builder);
    set_stored(builder);
    set_previous(builder);
    set_constants(builder);
    set_stable(builder);
    set_outputs(builder);
    set_timers(builder);
    set_flags(builder);
    return std::move(builder.result);
}

}  // namespace grafverif::schedule
