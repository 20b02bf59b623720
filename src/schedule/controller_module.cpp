// SPDX-License-Identifier: MIT
// The module of one controller. Three readings of the equations meet in it, and they differ in what a leaf stands for:
//   in a cycle     variables before the cycle and the inputs it samples: firing conditions, next values
//   after a cycle  activities and internals after it, the inputs it sampled: equation (13), every_cycle mode
//   at first       initial values and the inputs of the first evolution; no timer has ended
#include "schedule/controller_module.hpp"

#include <algorithm>

#include "schedule/first_inputs.hpp"
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
    /// Per variable: the symbol that the cycle reads (of an output with stored actions, its image), the one that holds
    /// the input of the first evolution, and the stored equation.
    std::vector<Id<Symbol>> read = {}, first = {};
    std::vector<const Equations::Stored*> stored = {};
    /// Per variable, where it changes: its value after the cycle at hand, and after the first evolution.
    std::vector<Id<Expr>> next = {}, initially = {};
    std::vector<Id<Expr>> faults = {}, first_faults = {};
    Id<Symbol> stable = {};
    std::vector<Id<Expr>> copies_in_cycle = {}, copies_after_cycle = {};
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

    /// A copy of `term`, each shared subterm copied once for all terms; `leaf_of` says what variable `index` becomes.
    template <class LeafOf>
    Id<Expr> copied(Id<Expr> term, std::vector<Id<Expr>>& copies, const LeafOf& leaf_of) {
        if (copies[term.index].valid()) return copies[term.index];
        const Expr& node = equations.exprs[term];
        if (node.op == Op::Variable) return copies[term.index] = leaf_of(static_cast<std::size_t>(node.value));
        if (node.op == Op::Integer) return copies[term.index] = exprs.integer(node.value);
        if (is_constant(node.op)) return copies[term.index] = exprs.constant(node.op == Op::True);
        std::vector<Id<Expr>> operands;
        operands.reserve(node.count);
        for (const Id<Expr> operand : equations.exprs.operands(term))
            operands.push_back(copied(operand, copies, leaf_of));
        return copies[term.index] = exprs.apply(node.op, operands);
    }

    Id<Expr> in_cycle(Id<Expr> term) {
        return copied(term, copies_in_cycle, [&](std::size_t index) { return leaf(read[index]); });
    }

    Id<Expr> after_cycle(Id<Expr> term) {
        return copied(term, copies_after_cycle,
                      [&](std::size_t index) { return next[index].valid() ? next[index] : leaf(read[index]); });
    }

    /// `inner`: what a variable stands for that is neither input nor timer end.
    template <class Inner>
    Id<Expr> at_first(Id<Expr> term, const Inner& inner) {
        return translate(equations.exprs, term, exprs, [&](const Expr& node) {
            const auto index = static_cast<std::size_t>(node.value);
            const Variable& read_there = variable(index);
            if (read_there.role == Role::TimerEnd) return exprs.constant(false);
            if (read_there.role == Role::Input)   // where the term loses it again, any leaf will do
                return leaf(first[index].valid() ? first[index] : read[index]);
            return inner(index);
        });
    }
    Id<Expr> before_first(Id<Expr> term) {
        return at_first(term, [&](std::size_t i) { return constant(variable(i).type, variable(i).initial); });
    }
    Id<Expr> after_first(Id<Expr> term) {
        return at_first(term, [&](std::size_t i) {
            return initially[i].valid() ? initially[i] : constant(variable(i).type, variable(i).initial);
        });
    }

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
        Id<Expr> next = builder.leaf(now);
        if (step != builder.equations.steps.end() && timer.fall_ms == 0) {
            const Id<Expr> runs = exprs.conjunction(builder.next[timer.watched.index],
                                                    exprs.negation(builder.in_cycle(step->activated)));
            next = exprs.conjunction(runs, ended);
            if (builder.turn.valid())
                next = exprs.conditional(builder.leaf(builder.turn), next,
                                         exprs.conjunction(builder.leaf(builder.read[timer.watched.index]), ended));
        }
        builder.result.module.symbols[end].kind = TransitionSystem::StateSymbol{exprs.constant(false), next};
    }
}

/// A variable for each input that the first evolution reads.
void add_first_inputs(Builder& builder) {
    const std::vector<bool> read = read_at_first(builder.equations, builder.mode);
    for (const Id<Variable> id : builder.equations.variables.ids()) {
        const Variable& variable = builder.equations.variables[id];
        if (variable.role == Role::Input && read[id.index])
            builder.first[id.index] = builder.add(variable.name + "_first", variable.type,
                                                  "inputs as the first evolution reads them", variable.origin);
    }
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
        const Id<Expr> condition = builder.in_cycle(firing.condition);
        builder.define(builder.read[firing.variable.index],
                       total(builder, condition, builder.exprs.constant(false), builder.faults));
    }
    for (const Equations::StepActivity& step : builder.equations.steps) {
        const std::uint32_t index = step.variable.index;
        const Id<Expr> initial = builder.exprs.constant(builder.variable(index).initial != 0);
        builder.next[index] = builder.in_cycle(step.next);
        builder.initially[index] = initial;
        builder.state(builder.read[index], initial, builder.next[index]);
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
    if (is_true(exprs, fault)) {
        (at_first ? builder.first_faults : builder.faults).push_back(fault);
        return kept;
    }
    const std::string wish = variable.name + (at_first ? "_leaves_range_at_first" : "_leaves_range");
    const Id<Symbol> symbol = builder.add(wish, {}, "assignments that would leave the range of their variable",
                                          variable.origin);
    builder.define(symbol, fault);
    (at_first ? builder.first_faults : builder.faults).push_back(builder.leaf(symbol));
    return exprs.conditional(builder.leaf(symbol), kept, value);
}

void set_stored(Builder& builder) {
    for (const Equations::Stored& stored : builder.equations.stored) {
        const std::uint32_t index = stored.variable.index;
        const Variable& variable = builder.variable(index);
        const Id<Symbol> symbol = builder.read[index];
        const Id<Expr> initial = builder.constant(variable.type, variable.initial);
        builder.initially[index] = guarded(builder, index, builder.before_first(stored.first), initial, true);
        builder.next[index] = guarded(builder, index, builder.in_cycle(stored.next), builder.leaf(symbol), false);
        builder.state(symbol, builder.initially[index], builder.next[index]);
    }
}

/// What edges compare with. A term that divides by zero is a fault.
void set_previous(Builder& builder) {
    for (const Equations::Previous& previous : builder.equations.previous) {
        const std::uint32_t index = previous.variable.index;
        const Id<Expr> off = builder.exprs.constant(false);
        const Id<Expr> first = total(builder, builder.before_first(previous.value), off, builder.first_faults);
        const Id<Expr> next = total(builder, builder.in_cycle(previous.value), off, builder.faults);
        builder.state(builder.read[index], first, next);
    }
}

/// Whether the output always has its initial value.
bool is_unwritten(Builder& builder, const Equations::Output& output) {
    const Variable& variable = builder.equations.variables[output.variable];
    return builder.in_cycle(output.value) == builder.constant(variable.type, variable.initial);
}

/// Variables that nothing writes.
void set_constants(Builder& builder) {
    std::vector<bool> written(builder.equations.variables.size());
    for (const Equations::Output& output : builder.equations.outputs)
        written[output.variable.index] = !is_unwritten(builder, output);
    for (const Id<Variable> id : builder.equations.variables.ids()) {
        const Variable& variable = builder.equations.variables[id];
        const bool candidate = variable.role == Role::Internal || variable.role == Role::Output;
        if (candidate && builder.stored[id.index] == nullptr && !written[id.index])
            builder.define(builder.read[id.index], builder.constant(variable.type, variable.initial));
    }
}

void set_stable(Builder& builder) {
    const Id<Expr> value = builder.in_cycle(builder.equations.stable);
    builder.stable = builder.add("stable", {}, "stability: one more cycle would change no step and no stored variable");
    builder.define(builder.stable, total(builder, value, builder.exprs.constant(false), builder.faults));
}

/// Written when stable: `now` is what would be written.
Id<Expr> written_when_stable(Builder& builder, std::uint32_t index, Id<Expr> now) {
    const Variable& variable = builder.variable(index);
    const Id<Symbol> symbol = builder.result.symbols[index];
    const Id<Expr> kept = builder.leaf(symbol);
    builder.state(symbol, builder.constant(variable.type, variable.initial),
                  builder.exprs.conditional(builder.leaf(builder.stable), now, kept));
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

/// Equation (13) in every cycle; returns when the output is up to date.
Id<Expr> set_cyclic_output(Builder& builder, const Equations::Output& output) {
    const std::uint32_t index = output.variable.index;
    const Id<Symbol> symbol = builder.result.symbols[index];
    const Id<Expr> off = builder.exprs.constant(false);
    const Id<Expr> initial = total(builder, builder.after_first(output.value), off, builder.first_faults);
    const Id<Expr> after = total(builder, builder.after_cycle(output.value), off, builder.faults);
    if (!reads_inputs(builder.equations, output.value)) {
        std::vector<Id<Expr>> seen_before;   // in the cycle that led here
        builder.define(symbol, total(builder, builder.in_cycle(output.value), off, seen_before));
        return builder.exprs.constant(true);
    }
    const Variable& variable = builder.variable(index);
    const Id<Symbol> now = builder.add(variable.name + "_now", variable.type,
                                       "outputs by equation (13), of the steps after the cycle", variable.origin);
    builder.define(now, after);
    builder.state(symbol, initial, builder.leaf(now));
    return builder.exprs.apply(Op::Equal, builder.leaf(symbol), builder.leaf(now));
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

/// A flag that stays set once `faults` set it; not valid where they never can.
Id<Symbol> sticky(Builder& builder, const char* wish, Id<Expr> at_first, Id<Expr> in_cycle) {
    Exprs& exprs = builder.exprs;
    if (is_false(exprs, at_first) && is_false(exprs, in_cycle)) return {};
    const Id<Symbol> flag = builder.add(wish, {}, "faults, once and for ever");
    builder.state(flag, at_first, exprs.disjunction(builder.leaf(flag), in_cycle));
    return flag;
}

void set_flags(Builder& builder) {
    std::vector<Id<Expr>> first_races, races;
    for (const Equations::Stored& stored : builder.equations.stored) {
        const Id<Expr> off = builder.exprs.constant(false);
        first_races.push_back(total(builder, builder.before_first(stored.first_race), off, builder.first_faults));
        races.push_back(total(builder, builder.in_cycle(stored.race), off, builder.faults));
    }
    for (const Equations::Conflict& conflict : builder.equations.conflicts)
        races.push_back(builder.in_cycle(conflict.condition));
    Exprs& exprs = builder.exprs;
    builder.result.race = sticky(builder, "race", exprs.disjunction(first_races), exprs.disjunction(races));
    builder.result.out_of_range = sticky(builder, "out_of_range", exprs.disjunction(builder.first_faults),
                                         exprs.disjunction(builder.faults));
    std::ranges::sort(builder.result.bounded);
    const auto repeated = std::ranges::unique(builder.result.bounded);
    builder.result.bounded.erase(repeated.begin(), repeated.end());
}

/// The input of the first evolution is forgotten after it, so that it adds no states. A plant does not move between it
/// and the first state.
void set_first_inputs(Builder& builder) {
    for (const Id<Variable> id : builder.equations.variables.ids()) {
        const Variable& variable = builder.equations.variables[id];
        if (!builder.first[id.index].valid()) continue;
        std::optional<Id<Expr>> read;
        if (builder.style.with_plant) read = builder.leaf(builder.read[id.index]);
        builder.result.module.symbols[builder.first[id.index]].kind =
            TransitionSystem::StateSymbol{read, builder.constant(variable.type, variable.type.low)};
    }
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
    builder.copies_in_cycle.resize(equations.exprs.size());
    builder.copies_after_cycle.resize(equations.exprs.size());
    builder.read.resize(size);
    builder.first.resize(size);
    builder.stored.resize(size);
    builder.next.resize(size);
    builder.initially.resize(size);
    builder.result.symbols.resize(size);
    builder.result.module.name = "controller_" + equations.name;
    for (const Equations::Stored& stored : equations.stored) builder.stored[stored.variable.index] = &stored;

    add_parameters(builder);
    add_first_inputs(builder);
    add_states(builder);
    set_steps(builder);
    set_stored(builder);
    set_previous(builder);
    set_constants(builder);
    set_stable(builder);
    set_outputs(builder);
    set_timers(builder);
    set_flags(builder);
    set_first_inputs(builder);
    builder.result.first = builder.first;
    return std::move(builder.result);
}

}  // namespace grafverif::schedule
