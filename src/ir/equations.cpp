// SPDX-License-Identifier: MIT
#include "grafverif/ir/equations.hpp"

#include <algorithm>
#include <string_view>
#include <unordered_set>

#include "ir/sorts.hpp"

namespace grafverif {

namespace {

using Role = Equations::Role;

struct EquationsCheck {
    const Equations& equations;
    std::vector<std::string> faults = {};
    Sorts sorts{equations.exprs, [this](const Expr& leaf) {
                    return sort_of(equations.variables[{static_cast<std::uint32_t>(leaf.value)}].type);
                }};
    std::vector<bool> reads_firing = {};  ///< for each term: true if it contains a firing condition
    std::vector<int> defined = {};        ///< number of equations for each variable

    void fault(std::string text) { faults.push_back(std::move(text)); }

    bool known(Id<Equations::Variable> variable) const { return equations.variables.contains(variable); }

    std::string name(Id<Equations::Variable> variable) const { return "`" + equations.variables[variable].name + "`"; }

    void variables() {
        std::unordered_set<std::string_view> names;
        for (const Id<Equations::Variable> id : equations.variables.ids()) {
            const Equations::Variable& variable = equations.variables[id];
            if (!names.insert(variable.name).second) fault("two variables are named " + name(id));
            if (variable.initial < variable.type.low || variable.initial > variable.type.high)
                fault("the initial value of " + name(id) + " is outside its range");
        }
    }

    /// Checks all terms in one pass, because children precede parents. Returns false and stops at the first leaf that
    /// does not belong to the equations.
    bool terms() {
        const Exprs& exprs = equations.exprs;
        for (std::uint32_t index = 0; index < exprs.size(); ++index) {
            const Id<Expr> id{index};
            const Expr& node = exprs[id];
            bool reads = false;
            if (node.op == Op::Variable) {
                const Id<Equations::Variable> variable{static_cast<std::uint32_t>(node.value)};
                if (!known(variable)) return fault("a term reads a variable that does not exist"), false;
                reads = equations.variables[variable].role == Role::FiringCondition;
            }
            const bool foreign = is_leaf(node.op) && node.op != Op::Variable;
            if (foreign || node.op == Op::Rise || node.op == Op::Fall || node.op == Op::Duration)
                return fault("a term has an operator that equations do not have"), false;
            for (const Id<Expr> operand : exprs.operands(id)) reads = reads || reads_firing[operand.index];
            reads_firing.push_back(reads);
        }
        return true;
    }

    /// Records an equation `variable = term` and checks its term. `what` describes the equation in messages.
    void define(Id<Equations::Variable> variable, Id<Expr> term, std::string_view what) {
        if (!known(variable)) return fault(std::string(what) + " of a variable that does not exist");
        ++defined[variable.index];
        condition(term, sort_of(equations.variables[variable].type), std::string(what) + " of " + name(variable));
    }

    void role(Id<Equations::Variable> variable, Role expected) {
        if (known(variable) && equations.variables[variable].role != expected)
            fault(name(variable) + " has an equation of a type that its role does not permit");
    }

    void condition(Id<Expr> term, Sort sort, const std::string& what) { sorts.check(term, sort, what, faults); }

    void without_firings(Id<Expr> term, const std::string& what) {
        if (equations.exprs.contains(term) && reads_firing[term.index]) fault(what + " reads a firing condition");
    }

    void cycle() {
        for (const Equations::Firing& firing : equations.firings) {
            define(firing.variable, firing.condition, "the firing condition");
            role(firing.variable, Role::FiringCondition);
            without_firings(firing.condition, "the firing condition of `" + firing.transition + "`");
        }
        for (const Equations::StepActivity& step : equations.steps) {
            define(step.variable, step.next, "the activity");
            role(step.variable, Role::Step);
            condition(step.activated, Sort::Boolean, "the activation of `" + step.step.text() + "`");
            condition(step.deactivated, Sort::Boolean, "the deactivation of `" + step.step.text() + "`");
            if (step.first.valid()) condition(step.first, Sort::Boolean, "the first activity of a step");
        }
        for (const Equations::Conflict& of : equations.conflicts)
            for (const Id<Expr> term : {of.condition, of.first})
                if (term.valid()) condition(term, Sort::Boolean, "the condition of a conflict");
        for (const Equations::Stored& stored : equations.stored) store(stored);
        for (const Equations::Previous& previous : equations.previous) {
            define(previous.variable, previous.value, "the present value");
            role(previous.variable, Role::Previous);
            if (known(previous.variable))
                without_firings(previous.value, "the present value of " + name(previous.variable));
        }
        for (const Equations::ObservedTerm& watch : equations.watches) {
            define(watch.variable, watch.value, "the level");
            role(watch.variable, Role::Watched);
            if (known(watch.variable)) without_firings(watch.value, "the level of " + name(watch.variable));
        }
        for (const Equations::Timer& timer : equations.timers) time(timer);
        for (const Id<Equations::Timer> timer : equations.conditions)
            if (timer.valid() && timer.index >= equations.timers.size())
                fault("a time condition refers to a timer that does not exist");
        for (const Equations::Output& output : equations.outputs) {
            define(output.variable, output.value, "the value");
            role(output.variable, Role::Output);
            if (known(output.variable)) without_firings(output.value, "the value of " + name(output.variable));
        }
        condition(equations.stable, Sort::Boolean, "the condition `stable`");
        for (const Equations::Assumption& assumption : equations.assumptions) {
            condition(assumption.condition, Sort::Boolean, "an assumption");
            if (!equations.exprs.contains(assumption.condition)) continue;
            for (const Id<Expr> leaf : leaves(equations.exprs, assumption.condition))
                if (equations.variables[{static_cast<std::uint32_t>(equations.exprs[leaf].value)}].role != Role::Input)
                    fault("an assumption reads something other than an input");
        }
    }

    void time(const Equations::Timer& timer) {
        if (!known(timer.watched) || !known(timer.end))
            return fault("the timer `" + timer.name + "` refers to a variable that does not exist");
        const Role kind = equations.variables[timer.watched].role;
        if (kind != Role::Step && kind != Role::Watched)
            fault("the timer `" + timer.name + "` watches " + name(timer.watched) +
                  ", which is neither a step nor a watched term");
        role(timer.end, Role::TimerEnd);
        ++defined[timer.end.index];
        if (timer.rise_ms < 0 || timer.fall_ms < 0 || timer.rise_ms + timer.fall_ms == 0)
            fault("the timer `" + timer.name + "` has no duration");
    }

    void store(const Equations::Stored& stored) {
        define(stored.variable, stored.next, "the stored value");
        if (!known(stored.variable)) return;
        const Equations::Variable& variable = equations.variables[stored.variable];
        const bool is_time = equations.is_program && variable.role == Role::Previous;  // a timer, which reports omit
        if (variable.role != Role::Internal && variable.role != Role::Output && !is_time)
            fault(name(stored.variable) + " has an equation of a type that its role does not permit");
        condition(stored.race, Sort::Boolean, "the race condition of " + name(stored.variable));
        condition(stored.first, sort_of(variable.type), "the first value of " + name(stored.variable));
        condition(stored.first_race, Sort::Boolean, "the first race condition of " + name(stored.variable));
        without_firings(stored.first, "the first value of " + name(stored.variable));
        without_firings(stored.first_race, "the first race condition of " + name(stored.variable));
        for (const Equations::Write& write : stored.writes) {
            condition(write.trigger, Sort::Boolean, "a trigger of " + name(stored.variable));
            condition(write.value, sort_of(variable.type), "a value stored in " + name(stored.variable));
        }
    }

    void complete() {
        for (const Id<Equations::Variable> id : equations.variables.ids()) {
            const Role kind = equations.variables[id].role;
            const int count = defined[id.index];
            if (count > 1) fault(name(id) + " has more than one equation");
            if (count > 0 && kind == Role::Input) fault("the input " + name(id) + " has an equation");
            if (count == 0 && kind != Role::Input && kind != Role::Internal) fault(name(id) + " has no equation");
        }
    }
};

}  // namespace

std::vector<std::string> verify(const Equations& equations) {
    EquationsCheck check{equations};
    check.defined.resize(equations.variables.size());
    check.variables();
    if (!check.terms()) return check.faults;
    check.cycle();
    check.complete();
    return check.faults;
}

std::vector<Kept> kept(const Equations& equations) {
    std::vector<Kept> all;
    for (const Equations::Stored& stored : equations.stored) {
        const Expr& first = equations.exprs[stored.first];
        const bool stays = first.op == Op::Variable && first.value == stored.variable.index;
        all.push_back({stored.variable, stored.next, stays ? Id<Expr>{} : stored.first});
    }
    for (const Equations::Previous& previous : equations.previous)
        all.push_back({previous.variable, previous.value, previous.value});
    for (const Equations::StepActivity& step : equations.steps) all.push_back({step.variable, step.next, step.first});
    for (const Equations::ObservedTerm& watch : equations.watches)
        all.push_back({watch.variable, watch.value, watch.value, true});
    return all;
}

std::vector<Kept> remembered(const Equations& equations) {
    std::vector<Kept> all = kept(equations);
    std::erase_if(all, [&](const Kept& each) {
        const Role role = equations.variables[each.variable].role;
        return role != Role::Previous && role != Role::Watched;
    });
    return all;
}

std::vector<Fault> faults(const Equations& equations) {
    const Exprs& exprs = equations.exprs;
    std::vector<Fault> all;
    for (const Equations::Stored& stored : equations.stored)
        if (!is_false(exprs, stored.race) || !is_false(exprs, stored.first_race))
            all.push_back({stored.variable, stored.race, stored.first_race});
    for (const Equations::Conflict& conflict : equations.conflicts)
        all.push_back({{}, conflict.condition, conflict.first});
    return all;
}

bool acts_at_first(const Equations& equations) {
    return std::ranges::any_of(kept(equations),
                               [&](const Kept& each) {
                                   return each.first.valid() &&
                                          equations.variables[each.variable].role != Role::Previous && !each.after;
                               }) ||
           std::ranges::any_of(faults(equations), [&](const Fault& each) {
               return each.first.valid() && !is_false(equations.exprs, each.first);
           });
}

}  // namespace grafverif
