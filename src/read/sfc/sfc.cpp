// SPDX-License-Identifier: MIT
#include "read/sfc/sfc.hpp"

#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "grafverif/ir/type.hpp"
#include "read/integer_ranges.hpp"
#include "read/mixed_actions.hpp"
#include "read/sfc/parts.hpp"
#include "read/xml.hpp"
#include "support/messages.hpp"
#include "syntax/language/format.hpp"

namespace grafverif {

void Sfc::differs(Span where, std::string_view what) { diagnostics().add(messages::differs_from_sfc(where, what)); }

namespace {

void name_steps(Sfc& sfc) {
    LegalNames labels(LegalNames::Kind::Label, sfc.draft);
    std::unordered_map<Id<st::Word>, Span> places;
    for (const st::Network& network : sfc.unit.networks) {
        for (const st::Step& step : network.steps) {
            const auto [known, fresh] = sfc.steps.try_emplace(step.name.word);
            const Span first = places.try_emplace(step.name.word, step.name.where).first->second;
            if (!fresh) {
                sfc.diagnostics().add(
                    messages::duplicate_name(step.name.where, "step", sfc.file.text(step.name), first));
                continue;
            }
            known->second = labels.make(sfc.file.text(step.name), step.name.where);
            sfc.names.reserve('X' + known->second);  // name of the step variable
        }
    }
}

/// Returns a new input that replaces a condition that could not be imported. The value of the input is arbitrary at any
/// time.
Id<tree::Expr> unknown_condition(Sfc& sfc, Span where) {
    SfcVariable variable;
    variable.name = sfc.names.invent("unknown_condition");
    variable.where = where;
    variable.used = true;
    variable.comment = "replaces an omitted condition";
    sfc.variables.push_back(variable);
    return sfc.draft.variable(variable.name, where);
}

std::vector<SfcBranch> branches_of(Sfc& sfc, const st::Network& network) {
    std::vector<SfcBranch> branches;
    for (const st::Transition& written : network.transitions) {
        SfcBranch branch;
        branch.written = &written;
        const std::size_t errors = sfc.diagnostics().errors();
        if (written.condition.valid()) branch.condition = boolean_of(sfc, {written.from}, written.condition);
        if (!branch.condition.valid() && sfc.diagnostics().errors() == errors && sfc.draft.lossy())
            branch.condition = unknown_condition(sfc, written.where);
        // The error in the condition has been reported.
        if (!branch.condition.valid()) branch.condition = sfc.draft.constant(false, written.where);
        branches.push_back(branch);
    }
    exclude_by_priority(sfc, branches);
    return branches;
}

void comment(Sfc& sfc, Span where, const std::string& text) {
    for (std::string& line : comment_lines(text)) sfc.draft.comment(where, std::move(line));
}

/// Marks the ends of an expansion of a macro-step: the only step without predecessors becomes the entry step, and the
/// only step without successors becomes the exit step.
void mark_ends(Sfc& sfc, const st::Network& network, std::vector<tree::ChartItem>& items) {
    std::unordered_set<Id<st::Word>> reached, left;
    for (const st::Transition& transition : network.transitions) {
        for (const st::Name& to : transition.to) reached.insert(to.word);
        for (const st::Name& from : transition.from) left.insert(from.word);
    }
    std::vector<std::size_t> entries, exits;
    for (std::size_t i = 0; i < network.steps.size(); ++i) {
        const st::Step& step = network.steps[i];
        if (step.initial || !reached.contains(step.name.word)) entries.push_back(i);
        if (!left.contains(step.name.word)) exits.push_back(i);
    }
    if (entries.size() != 1 || exits.size() != 1) {
        sfc.draft.refuse(network.where, "a macro-step without exactly one first and one last step",
                         "give it exactly one first and one last step");
        return;
    }
    for (std::size_t i = 0; i < network.steps.size(); ++i) {
        auto& step = std::get<tree::Step>(items[i]);
        step.initial = false;
        step.entry = i == entries.front();
        step.exit = i == exits.front();
    }
}

/// Returns the steps of a network. If several steps have the same name, which has already been reported, the first of
/// these steps gets the actions.
std::vector<tree::ChartItem> steps_of(Sfc& sfc, const st::Network& network, SfcActions& actions,
                                      const std::unordered_map<Id<st::Word>, std::string>& expansions) {
    std::vector<tree::ChartItem> items;
    for (const st::Step& written : network.steps) {
        tree::Step step;
        step.where = written.where;
        step.initial = written.initial;
        const std::string& name = sfc.steps.at(written.name.word);
        step.name = sfc.draft.name(name, written.name.where);
        step.actions = std::exchange(actions.of_steps[name], {});
        if (const auto expansion = expansions.find(written.name.word); expansion != expansions.end()) {
            step.kind = tree::StepKind::Macro;
            step.contents.push_back(sfc.draft.name(expansion->second, written.name.where));
        }
        comment(sfc, written.where, written.comment);
        items.emplace_back(std::move(step));
    }
    if (network.macro_step.valid()) mark_ends(sfc, network, items);
    return items;
}

std::vector<tree::Name> labels_of(Sfc& sfc, const std::vector<st::Name>& steps) {
    std::vector<tree::Name> labels;
    for (const st::Name& step : steps) {
        const auto known = sfc.steps.find(step.word);
        labels.push_back(
            sfc.draft.name(known == sfc.steps.end() ? std::string(sfc.file.text(step)) : known->second, step.where));
    }
    return labels;
}

std::vector<tree::ChartItem> transitions_of(Sfc& sfc, const st::Network& network) {
    std::vector<tree::ChartItem> items;
    LegalNames names(LegalNames::Kind::Chart, sfc.draft);
    for (const SfcBranch& branch : branches_of(sfc, network)) {
        const st::Transition& written = *branch.written;
        tree::Transition transition;
        transition.where = written.where;
        transition.condition = branch.condition;
        if (written.name.valid())
            transition.name =
                sfc.draft.name(names.make(sfc.file.text(written.name), written.name.where), written.name.where);
        transition.from = labels_of(sfc, written.from);
        transition.to = labels_of(sfc, written.to);
        comment(sfc, transition.where, written.comment);
        if (transition.from.empty() || transition.to.empty()) {
            sfc.diagnostics().add(messages::missing_part(transition.where, "this transition",
                                                         transition.from.empty() ? "step before it" : "step after it"));
            continue;
        }
        for (const st::Name& from : written.from)
            if (std::ranges::find(written.to, from.word, &st::Name::word) != written.to.end())
                sfc.differs(transition.where, "this transition leads back to the step `" +
                                                  std::string(sfc.file.text(from)) +
                                                  "`; in the imported chart, the step stays active, so that its timers "
                                                  "and actions do not restart");
        items.emplace_back(std::move(transition));
    }
    return items;
}

void add_ranges(Sfc& sfc, tree::Chart& chart) {
    std::vector<OpenInteger> open;
    std::unordered_map<std::string, const SfcVariable*> by_name;
    for (const SfcVariable& variable : sfc.variables) by_name.emplace(variable.name, &variable);
    std::vector<std::pair<tree::Variables*, const SfcVariable*>> integers;
    for (tree::ChartItem& item : chart.items) {
        auto* declared = std::get_if<tree::Variables>(&item);
        if (declared == nullptr || declared->variables.front().type != tree::TypeWord::Int) continue;
        const tree::Name name = declared->variables.front().name;
        const SfcVariable* variable = by_name.at(std::string(sfc.draft.text(name)));
        open.push_back(
            {name.word, declared->kind == tree::VariableKind::Input, variable->initial, variable->low, variable->high});
        integers.emplace_back(declared, variable);
    }
    const std::vector<FoundRange> found = ranges_of(sfc.draft.file(), chart, open);
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto& [declared, variable] = integers[i];
        tree::Variable& one = declared->variables.front();
        const bool output = variable->role == tree::VariableKind::Output;
        FoundRange range = found[i];
        if (variable->narrow) range = {variable->low, variable->high, true};
        if (output) range.low = std::min(range.low, variable->initial);
        one.range = tree::Range{sfc.draft.number(range.low, one.where), sfc.draft.number(range.high, one.where)};
        if (!range.exact && variable->wide)
            sfc.diagnostics().add(
                messages::chosen_range(one.where, sfc.draft.text(one.name), range.low, range.high,
                                       "the range of its type exceeds the range of integers in charts"));
        if (output && range.low != variable->initial) {
            declared->kind = tree::VariableKind::Internal;
            sfc.diagnostics().add(messages::chosen_kind(one.where, sfc.draft.text(one.name), "internal variable",
                                                        "an output would have the minimum of its range as initial "
                                                        "value, not the initial value of the variable"));
        }
        if (declared->kind == tree::VariableKind::Internal) one.value = sfc.draft.number(variable->initial, one.where);
    }
}

/// Adds a partial chart with one step that is always active. The step has the actions that belong to no other step.
void add_always(Sfc& sfc, SfcActions& actions, tree::Chart& chart) {
    for (const std::string& latch : actions.latches) {
        tree::Variable variable;
        variable.name = sfc.draft.name(latch, chart.where);
        variable.where = chart.where;
        chart.items.emplace_back(tree::Variables{tree::VariableKind::Internal, {std::move(variable)}, chart.where});
    }
    if (actions.always.empty()) return;
    tree::Step step;
    step.initial = true;
    step.name = sfc.draft.name(sfc.names.invent("always"), chart.where);
    step.where = chart.where;
    step.actions = std::move(actions.always);
    tree::Partial partial{
        tree::PartialKind::Partial, sfc.draft.name(sfc.names.invent("action_control"), chart.where), {}, chart.where};
    partial.items.emplace_back(std::move(step));
    chart.items.emplace_back(std::move(partial));
}

void convert(const st::File& file, const st::Unit& unit, LegalNames& charts, Draft& draft) {
    Sfc sfc{file, unit, draft, {}, {}, {}, LegalNames(LegalNames::Kind::Variable, draft)};
    tree::Chart chart;
    chart.where = unit.where;
    chart.name = draft.name(charts.make(file.text(unit.name), unit.name.where), unit.name.where);
    comment(sfc, chart.where, unit.comment);
    if (!unit.body.empty())
        draft.refuse(file.statements[unit.body.front()].where, "statements outside the chart",
                     "move them to an action");
    name_steps(sfc);
    classify_variables(sfc);
    SfcActions actions = actions_of(sfc);
    std::unordered_map<Id<st::Word>, std::string> expansions;
    LegalNames names(LegalNames::Kind::Chart, draft);
    names.reserve(draft.text(chart.name));
    for (const st::Network& network : unit.networks)
        if (network.macro_step.valid())
            expansions.emplace(network.macro_step.word, names.invent('E' + sfc.steps.at(network.macro_step.word)));
    std::vector<tree::ChartItem> items;
    for (const st::Network& network : unit.networks) {
        std::vector<tree::ChartItem> own = steps_of(sfc, network, actions, expansions);
        std::ranges::move(transitions_of(sfc, network), std::back_inserter(own));
        if (!network.macro_step.valid()) {
            std::ranges::move(own, std::back_inserter(items));
            continue;
        }
        items.emplace_back(tree::Partial{tree::PartialKind::Expansion,
                                         draft.name(expansions.at(network.macro_step.word), network.macro_step.where),
                                         std::move(own), network.where});
    }
    chart.items = declarations_of(sfc);
    std::ranges::move(items, std::back_inserter(chart.items));
    add_always(sfc, actions, chart);
    add_ranges(sfc, chart);
    split_mixed_actions(draft, chart);
    draft.group_variables(chart);
    draft.comment(
        chart.where,
        "// A Sequential Function Chart makes one evolution per scan: check this chart with `--mode every-cycle`.");
    draft.declare(std::move(chart));
}

}  // namespace

void convert_charts(const st::File& file, Draft& draft) {
    LegalNames charts(LegalNames::Kind::Chart, draft);
    bool any = false;
    for (const st::Unit& unit : file.units) {
        if (unit.networks.empty()) continue;
        any = true;
        convert(file, unit, charts, draft);
    }
    if (any) return;
    if (file.units.empty())
        draft.diagnostics().add(messages::nothing_to_import({file.source, 0, 0}, "Sequential Function Chart"));
    else
        draft.diagnostics().add(
            messages::program_is_no_chart(file.units.front().where, file.text(file.units.front().name)));
}

}  // namespace grafverif
