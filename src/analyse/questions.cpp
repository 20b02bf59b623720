// SPDX-License-Identifier: MIT
#include <algorithm>

#include "analyse/chart_analyzer.hpp"
#include "analyse/order.hpp"
#include "analyse/structure.hpp"

namespace grafverif::analysis {

namespace {

/// True if some term of the table contains arithmetic, so that its value may be undefined.
bool any_arithmetic(const Exprs& exprs) {
    for (std::uint32_t term = 0; term < exprs.size(); ++term)
        if (is_arithmetic(exprs[Id<Expr>{term}].op)) return true;
    return false;
}

}  // namespace

Queries::Queries(const Chart& chart, const Equations& equations, const AnalyseOptions& options) {
    const bool searching = options.mode == ExecutionMode::StabilitySearch;
    const bool computes = any_arithmetic(equations.exprs);
    if (searching) add("total-instability", 0, "");
    if (options.instability_only) return;
    if (computes) add("no-value", no_variable, "");
    for (const Equations::Stored& stored : equations.stored) {
        const Equations::Variable& variable = equations.variables[stored.variable];
        if (!is_false(equations.exprs, stored.race) || !is_false(equations.exprs, stored.first_race))
            add("action-race", stored.variable.index, variable.name);
        if (!variable.type.boolean) add("out-of-range", stored.variable.index, variable.name);
        if (computes) add("no-value", stored.variable.index, variable.name);
        if (variable.role != Equations::Role::Output) continue;
        add("output-never-set", stored.variable.index, variable.name);
        for (const std::size_t value : {0U, 1U})
            if (searching && variable.type.boolean)
                add("action-conflict", 2 * stored.variable.index + value, variable.name);
    }
    for (const Equations::Output& output : equations.outputs)
        add("output-never-set", output.variable.index, equations.variables[output.variable].name);
    const auto pairs = branches(chart);
    for (std::size_t k = 0; k < pairs.size(); ++k) add("branches-together", k, chart.transitions[pairs[k].first].name);
    for (const Id<Chart::Step> step : chart.steps.ids()) {
        const std::string name = step_variable(chart, step);
        add("step-reactivated", step.index, name);
        add("step-never-active", step.index, name);
        if (searching) add("step-never-stable", step.index, name);
    }
    for (const Id<Chart::Transition> id : chart.transitions.ids())
        for (const char* code : {"transition-never-fired", "transition-always-fired"})
            add(code, id.index, chart.transitions[id].name);
    for (const Id<Chart::Step> step : chart.steps.ids())
        add("step-never-again", step.index, step_variable(chart, step));
    for (const Id<Chart::Transition> id : chart.transitions.ids())
        add("transition-never-again", id.index, chart.transitions[id].name);
    const std::vector<bool> matters = variables_that_matter(equations);
    for (const Equations::Stored& stored : equations.stored)
        if (matters[stored.variable.index])
            add("value-sticks", stored.variable.index, equations.variables[stored.variable].name);
    add("region-never-left", 0, "");
    for (std::size_t k = 0; k < equations.conflicts.size(); ++k)
        add("forced-twice", k, conflict_subject(chart, equations, equations.conflicts[k]));
    const auto governed = orders_on_enclosed(chart);
    for (std::size_t k = 0; k < governed.size(); ++k)
        add("forced-and-enclosed", k, chart.partial_charts[chart.forcing[governed[k].first].forced].name);
}

void Queries::add(std::string_view code, std::size_t index, std::string subject) {
    if (places_.try_emplace({code, index}, all_.size()).second)
        all_.push_back({code, index, std::move(subject), false, false, 0, 0});
}

Query* Queries::open(std::string_view code, std::size_t index) {
    const auto found = places_.find({code, index});
    if (found == places_.end() || all_[found->second].decided) return nullptr;
    return &all_[found->second];
}

void Queries::trust_parts() {
    for (Query& question : all_) question.decided = question.decided || question.seen_in_part;
}

bool Queries::any_open() const {
    return std::ranges::any_of(all_, [](const Query& question) { return !question.decided; });
}

bool Queries::any_trap_open() const {
    return std::ranges::any_of(all_, [](const Query& question) { return !question.decided && is_trap(question.code); });
}

bool Queries::only_traps_open() const {
    return std::ranges::all_of(all_, [](const Query& question) { return question.decided || is_trap(question.code); });
}

void Queries::decide(std::string_view code, std::size_t index) {
    if (Query* const question = open(code, index)) question->decided = true;
}

}  // namespace grafverif::analysis
