// SPDX-License-Identifier: MIT
// Creates the state variables of the equations: previous values of terms whose edges are read, values that timers
// observe, and timers (IEC 60848; CEP13 Fig. 33b). A variable is created on first use, so that values that no equation
// reads are not stored.
#include "derivation.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

/// Returns a name with the prefix `prefix`: `P_START` if `term` is the variable `START`, or `P_1` with the number 1 if
/// `term` is not a variable.
std::string name_for(Derivation& derivation, const std::string& prefix, Id<Expr> term, std::size_t number) {
    const Expr& node = derivation.equations.exprs[term];
    if (node.op != Op::Variable) return derivation.names.fresh(prefix + std::to_string(number));
    const Id<Equations::Variable> variable{static_cast<std::uint32_t>(node.value)};
    return derivation.names.fresh(prefix + derivation.equations.variables[variable].name);
}

/// Returns `X2` or `G_X2` for the variable of a step. For any other variable, returns its name without the prefix `V_`.
std::string watched_name(const Derivation& derivation, Id<Equations::Variable> watched) {
    const Equations::Variable& variable = derivation.equations.variables[watched];
    if (variable.role != Equations::Role::Step) return variable.name.substr(2);
    const Id<Chart::Step> step{watched.index - derivation.steps.front().index};
    const StepName name = name_of(derivation.chart, step);
    return qualifier(name) + "X" + name.step;
}

}  // namespace

Id<Expr> previous_value(Derivation& derivation, Id<Expr> term, Span where) {
    Equations& equations = derivation.equations;
    const auto [known, fresh] = derivation.previous.try_emplace(term.index);
    if (fresh) {
        const std::string name = name_for(derivation, "P_", term, equations.previous.size() + 1);
        known->second = equations.variables.add({name, Equations::Role::Previous, {}, 0, where});
        equations.previous.push_back({known->second, term, where});
    }
    return variable_leaf(derivation, known->second);
}

Id<Equations::Variable> level(Derivation& derivation, Id<Expr> term, Span where) {
    Equations& equations = derivation.equations;
    const Expr& node = equations.exprs[term];
    const Id<Equations::Variable> itself{static_cast<std::uint32_t>(node.value)};
    if (node.op == Op::Variable && equations.variables[itself].role == Equations::Role::Step) return itself;
    const auto [known, fresh] = derivation.watched.try_emplace(term.index);
    if (fresh) {
        const std::string name = name_for(derivation, "V_", term, equations.watches.size() + 1);
        known->second = equations.variables.add({name, Equations::Role::Watched, {}, 0, where});
        equations.watches.push_back({known->second, term, where});
    }
    return known->second;
}

Id<Equations::Timer> timer(Derivation& derivation, Id<Equations::Variable> watched, std::int64_t rise_ms,
                           std::int64_t fall_ms, Span where) {
    Equations& equations = derivation.equations;
    const auto [known, fresh] = derivation.timers.try_emplace({watched, rise_ms, fall_ms});
    if (!fresh) return known->second;
    std::string name = "T_" + watched_name(derivation, watched) + "_" + duration_text(rise_ms);
    if (fall_ms > 0) name += "_" + duration_text(fall_ms);
    name = derivation.names.fresh(name);
    const Id<Equations::Variable> end =
        equations.variables.add({derivation.names.fresh(name + "_Q"), Equations::Role::TimerEnd, {}, 0, where});
    known->second = Id<Equations::Timer>{static_cast<std::uint32_t>(equations.timers.size())};
    equations.timers.push_back({name, watched, end, rise_ms, fall_ms, where});
    return known->second;
}

Id<Expr> end_leaf(Derivation& derivation, Id<Equations::Timer> timer) {
    return variable_leaf(derivation, derivation.equations.timers[timer.index].end);
}

}  // namespace grafverif
