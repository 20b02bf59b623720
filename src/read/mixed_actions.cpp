// SPDX-License-Identifier: MIT
#include "read/mixed_actions.hpp"

#include <iterator>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "support/messages.hpp"
#include "support/unique_names.hpp"

namespace grafverif {

namespace {

/// Visits the steps and transitions of the chart and its partial charts.
template <class OnStep, class OnTransition>
void each(std::vector<tree::ChartItem>& items, const OnStep& on_step, const OnTransition& on_transition) {
    for (tree::ChartItem& item : items) {
        if (auto* step = std::get_if<tree::Step>(&item)) on_step(*step);
        if (auto* transition = std::get_if<tree::Transition>(&item)) on_transition(*transition);
        if (auto* partial = std::get_if<tree::Partial>(&item)) each(partial->items, on_step, on_transition);
    }
}

struct Mixed {
    tree::Name output = {};
    std::string stored = {};
};

}  // namespace

void split_mixed_actions(Draft& draft, tree::Chart& chart) {
    std::unordered_set<Id<tree::Word>> continuous;
    UniqueNames names;
    std::vector<tree::Assignment*> assignments;
    for (const tree::ChartItem& item : chart.items) {
        if (const auto* variables = std::get_if<tree::Variables>(&item))
            for (const tree::Variable& one : variables->variables) names.take(std::string(draft.text(one.name)));
        if (const auto* partial = std::get_if<tree::Partial>(&item)) names.take(std::string(draft.text(partial->name)));
    }
    each(
        chart.items,
        [&](tree::Step& step) {
            names.take(std::string(draft.text(step.name)));
            for (tree::Action& action : step.actions) {
                if (const auto* one = std::get_if<tree::ContinuousAction>(&action)) continuous.insert(one->output.word);
                if (auto* one = std::get_if<tree::StoredAction>(&action)) assignments.push_back(&one->assignment);
            }
        },
        [&](tree::Transition& transition) {
            for (tree::Assignment& one : transition.assignments) assignments.push_back(&one);
        });
    std::unordered_map<Id<tree::Word>, std::size_t> known;
    std::vector<Mixed> mixed;
    for (tree::Assignment* one : assignments) {
        if (!continuous.contains(one->target.word)) continue;
        const auto [at, first] = known.try_emplace(one->target.word, mixed.size());
        if (first) {
            const std::string output(draft.text(one->target));
            mixed.push_back({one->target, names.fresh(output + "_stored")});
            draft.diagnostics().add(messages::mixed_actions(one->target.where, output, mixed.back().stored));
        }
        one->target = draft.name(mixed[at->second].stored, one->target.where);
    }
    if (mixed.empty()) return;
    tree::Step always;
    always.initial = true;
    always.where = chart.where;
    always.name = draft.name(names.fresh("outputs_stored"), chart.where);
    std::size_t last = 0;
    for (std::size_t i = 0; i < chart.items.size(); ++i)
        if (std::holds_alternative<tree::Variables>(chart.items[i])) last = i + 1;
    decltype(chart.items) declared;
    for (const Mixed& one : mixed) {
        const Span where = one.output.where;
        tree::Variable variable;
        variable.name = draft.name(one.stored, where);
        variable.where = where;
        declared.emplace_back(tree::Variables{tree::VariableKind::Internal, {variable}, where});
        always.actions.emplace_back(
            tree::ContinuousAction{one.output, draft.variable(one.stored, where), {}, {}, where});
    }
    chart.items.insert(chart.items.begin() + static_cast<std::ptrdiff_t>(last),
                       std::make_move_iterator(declared.begin()), std::make_move_iterator(declared.end()));
    tree::Partial partial{
        tree::PartialKind::Partial, draft.name(names.fresh("stored_outputs"), chart.where), {}, chart.where};
    partial.items.emplace_back(std::move(always));
    chart.items.emplace_back(std::move(partial));
}

}  // namespace grafverif
