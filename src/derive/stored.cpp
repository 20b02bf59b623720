// SPDX-License-Identifier: MIT
// Derives the equations of stored actions (IEC 60848). Actions that store the same value in a variable form a group. A
// race occurs if two groups with different values are triggered in one cycle. For n groups with constant values, the
// race condition is built recursively and has the size O(n log n): there is a race if two groups in one half of the
// groups race, or if each half contains a triggered group.
#include <algorithm>
#include <array>

#include "derivation.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

struct Group {
    Id<Expr> value = {};
    Id<Expr> trigger = {};
    std::vector<Id<Expr>> triggers = {};
};

/// The writes of all actions on `variable`, in order. The list is incomplete after an error.
struct Writes {
    std::vector<Equations::Write> list = {};
    std::vector<Id<Expr>> first = {};  ///< values that actions of initial steps store in the first evolution
};

Writes writes(Derivation& derivation, Id<Chart::Variable> variable) {
    Writes result;
    const std::string what = "the value stored in `" + derivation.chart.variables[variable].name + "`";
    for (const Id<Chart::StoredAction> id : derivation.stored[variable.index]) {
        const Chart::StoredAction& action = derivation.chart.stored[id];
        const Id<Expr> value = over_equations(derivation, action.value, TermPosition::Before, action.origin, what);
        const Id<Expr> trigger = trigger_of(derivation, action);
        if (!value.valid() || !trigger.valid()) break;
        if (!afford(derivation, derivation.measures.size(derivation.equations.exprs, trigger))) break;
        const bool initial = action.on == Chart::StoredOn::Activation && is_initial(derivation, action.step);
        if (initial) {
            const Id<Expr> first = over_equations(derivation, action.value, TermPosition::First, action.origin, what);
            if (!first.valid()) break;
            result.first.push_back(first);
        }
        result.list.push_back({trigger, value, initial, action.origin});
    }
    return result;
}

/// Returns groups of writes with equal values, in the order of their first occurrence.
std::vector<Group> groups(Exprs& exprs, const std::vector<Equations::Write>& writes) {
    std::vector<Group> result;
    std::unordered_map<std::uint32_t, std::size_t> places;
    for (const Equations::Write& write : writes) {
        const auto [place, added] = places.emplace(write.value.index, result.size());
        if (added) result.push_back({write.value, {}, {}});
        result[place->second].triggers.push_back(write.trigger);
    }
    for (Group& group : result) group.trigger = exprs.disjunction(group.triggers);
    return result;
}

/// Returns the condition that two of the `groups` are triggered in one cycle. Requires that the groups have different
/// constant values.
Id<Expr> constant_race(Derivation& derivation, std::span<const Group> groups) {
    Exprs& exprs = derivation.equations.exprs;
    if (groups.size() < 2) return exprs.constant(false);
    const std::span<const Group> left = groups.first(groups.size() / 2);
    const std::span<const Group> right = groups.subspan(groups.size() / 2);
    const auto any = [&](std::span<const Group> half) {
        std::vector<Id<Expr>> triggers;
        for (const Group& group : half) triggers.push_back(group.trigger);
        return exprs.disjunction(triggers);
    };
    const Id<Expr> across = consistent(exprs, exprs.conjunction(any(left), any(right)));
    if (!afford(derivation, derivation.measures.size(exprs, across))) return exprs.constant(false);
    const Id<Expr> within_left = constant_race(derivation, left);
    return exprs.disjunction(std::array{within_left, constant_race(derivation, right), across});
}

/// Returns the condition that two groups with different values are triggered in one cycle.
Id<Expr> race(Derivation& derivation, const std::vector<Group>& groups) {
    Exprs& exprs = derivation.equations.exprs;
    std::vector<Group> constants;
    std::vector<Id<Expr>> terms;
    for (std::size_t k = 0; k < groups.size(); ++k) {
        if (is_constant(exprs[groups[k].value].op)) constants.push_back(groups[k]);
        for (std::size_t i = 0; i < k; ++i) {
            if (is_constant(exprs[groups[i].value].op) && is_constant(exprs[groups[k].value].op)) continue;
            const Id<Expr> together = consistent(exprs, exprs.conjunction(groups[i].trigger, groups[k].trigger));
            const Id<Expr> differ = exprs.apply(Op::NotEqual, groups[i].value, groups[k].value);
            terms.push_back(exprs.conjunction(together, differ));
            if (!afford(derivation, derivation.measures.size(exprs, terms.back()))) return exprs.constant(false);
        }
    }
    terms.insert(terms.begin(), constant_race(derivation, constants));
    return exprs.disjunction(terms);
}

/// Returns the value after the cycle: the value of the first triggered group, otherwise the value before the cycle. If
/// only true and false are stored, the value is `set or (v and not reset)`.
Id<Expr> next(Exprs& exprs, const std::vector<Group>& groups, Id<Expr> before) {
    const auto is_boolean_constant = [&](const Group& group) {
        return is_true(exprs, group.value) || is_false(exprs, group.value);
    };
    if (std::ranges::all_of(groups, is_boolean_constant)) {
        Id<Expr> set = exprs.constant(false);
        Id<Expr> kept = before;
        for (const Group& group : groups) {
            if (is_true(exprs, group.value)) set = group.trigger;
            else kept = exprs.conjunction(before, exprs.negation(group.trigger));
        }
        return exprs.disjunction(set, kept);
    }
    Id<Expr> value = before;
    for (std::size_t k = groups.size(); k-- > 0;) value = exprs.conditional(groups[k].trigger, groups[k].value, value);
    return value;
}

Equations::Stored stored_equation(Derivation& derivation, Id<Chart::Variable> variable) {
    Exprs& exprs = derivation.equations.exprs;
    Equations::Stored result;
    result.variable = Id<Equations::Variable>{variable.index};
    const Writes written = writes(derivation, variable);
    result.writes = written.list;
    const Id<Expr> before = variable_leaf(derivation, result.variable);
    const std::vector<Group> grouped = groups(exprs, result.writes);
    if (grouped.size() > stored_value_limit) {
        const Chart::Variable& entity = derivation.chart.variables[variable];
        derivation.diagnostics.add(messages::too_many_stored_values(entity.origin, entity.name, stored_value_limit));
        return result;
    }
    result.next = next(exprs, grouped, before);
    result.race = race(derivation, grouped);
    result.first = before;
    // Terms `value != result.first` for the values that actions of initial steps store.
    std::vector<Id<Expr>> differing;
    if (!written.first.empty()) result.first = written.first.front();
    for (const Id<Expr> value : written.first)
        if (value != result.first) differing.push_back(exprs.apply(Op::NotEqual, result.first, value));
    result.first_race = exprs.disjunction(differing);
    return result;
}

}  // namespace

Id<Expr> trigger_of(Derivation& derivation, const Chart::StoredAction& action) {
    const std::string& target = derivation.chart.variables[action.target].name;
    switch (action.on) {
    case Chart::StoredOn::Clearing: return derivation.firing_leaves[action.transition.index];
    case Chart::StoredOn::Activation: return derivation.equations.steps[action.step.index].activated;
    case Chart::StoredOn::Deactivation: return derivation.equations.steps[action.step.index].deactivated;
    case Chart::StoredOn::Event: break;
    }
    const Id<Expr> event = over_equations(derivation, action.event, TermPosition::Before, action.origin,
                                          "the event of an action on `" + target + "`");
    if (!event.valid()) return {};
    return derivation.equations.exprs.conjunction(derivation.step_leaves[action.step.index], event);
}

void derive_stored(Derivation& derivation) {
    for (const Id<Chart::Variable> variable : derivation.chart.variables.ids()) {
        if (derivation.stored[variable.index].empty()) continue;
        derivation.equations.stored.push_back(stored_equation(derivation, variable));
        if (derivation.diagnostics.full() || derivation.exhausted) return;
    }
}

}  // namespace grafverif
