// SPDX-License-Identifier: MIT
#include "read/agrafe/agrafe.hpp"

#include <algorithm>
#include <charconv>
#include <string>
#include <unordered_set>

#include "grafverif/ir/type.hpp"
#include "read/agrafe/reader.hpp"
#include "read/mixed_actions.hpp"
#include "support/messages.hpp"

namespace grafverif {

using Kind = AgrafeEntity::Kind;

std::optional<std::size_t> AgrafeReader::reference(pugi::xml_node node, std::string_view attribute,
                                                   std::string_view what, bool (*accepts)(Kind)) {
    const std::string path = value(node, attribute);
    if (path.empty()) {
        diagnostics().add(messages::missing_part(xml.where(node), '`' + std::string(local_name(node.name())) + '`',
                                                 '`' + std::string(attribute) + '`'));
        return {};
    }
    const auto found = index.find(path);
    if (found && accepts(index[*found].kind)) return found;
    diagnostics().add(messages::dangling_reference(xml.where(node, attribute), path, what));
    return {};
}

std::vector<std::size_t> AgrafeReader::references(pugi::xml_node node, std::string_view attribute,
                                                  std::string_view what, bool (*accepts)(Kind)) {
    std::vector<std::size_t> all;
    const std::string paths = value(node, attribute);
    for (std::size_t at = 0; at < paths.size();) {
        const std::size_t end = std::min(paths.find(' ', at), paths.size());
        const std::string path = paths.substr(at, end - at);
        at = end + 1;
        if (path.empty()) continue;
        const auto found = index.find(path);
        if (found && accepts(index[*found].kind)) all.push_back(*found);
        else diagnostics().add(messages::dangling_reference(xml.where(node, attribute), path, what));
    }
    return all;
}

std::int64_t AgrafeReader::number(pugi::xml_node node, std::string_view attribute, std::int64_t otherwise) {
    const std::string text = value(node, attribute);
    if (text.empty()) return otherwise;
    std::int64_t result = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), result);
    constexpr std::int64_t bound = std::int64_t{1} << 31U;
    if (failure == std::errc() && end == text.data() + text.size() && result >= -bound && result < bound) return result;
    diagnostics().add(
        messages::bad_value(xml.where(node, attribute), '`' + std::string(attribute) + '`', text, "a whole number"));
    return otherwise;
}

namespace {

bool is_expansion(Kind kind) { return kind == Kind::Expansion; }
bool is_plain(Kind kind) { return kind == Kind::Partial; }
bool is_enclosing(Kind kind) { return kind == Kind::Enclosing; }

// -- names ------------------------------------------------------------------------------------------------------------

/// Returns the preferred name of a step, according to the numbering of IEC 60848: `2` for an ordinary step, `M2` for a
/// macro-step, `E2` and `S2` for the entry and exit step of an expansion.
std::string preferred_name(const AgrafeEntity& step) {
    const std::string id = attribute(step.node, "id") ? value(step.node, "id") : "0";
    switch (step.kind) {
    case Kind::Macro: return 'M' + id;
    case Kind::Entry: return 'E' + id;
    case Kind::Exit: return 'S' + id;
    default: return id;
    }
}

void name_partials(AgrafeReader& reader) {
    LegalNames names(LegalNames::Kind::Chart, reader.draft);
    names.reserve(reader.chart);
    std::size_t number = 0;
    for (AgrafeEntity& one : reader.index.all()) {
        if (one.kind != Kind::Partial && one.kind != Kind::Expansion) continue;
        ++number;
        const std::string given = value(one.node, "name");
        one.name = names.make(given.empty() ? 'G' + std::to_string(number) : given, reader.xml.where(one.node, "name"));
    }
}

void name_steps(AgrafeReader& reader) {
    std::vector<std::unordered_map<std::string, std::size_t>> taken(reader.index.all().size());
    std::vector<LegalNames> names(taken.size(), LegalNames(LegalNames::Kind::Label, reader.draft));
    for (std::size_t i = 0; i < taken.size(); ++i) {
        AgrafeEntity& step = reader.index[i];
        if (!is_step(step.kind)) continue;
        const std::string preferred = preferred_name(step);
        const auto [first, fresh] = taken[step.partial].try_emplace(preferred, i);
        if (!fresh)
            reader.diagnostics().add(
                messages::duplicate_name(reader.xml.where(step.node, "id"), "step", preferred,
                                         reader.xml.where(reader.index[first->second].node, "id")));
        step.name = fresh ? names[step.partial].make(preferred, reader.xml.where(step.node, "id"))
                          : names[step.partial].invent(preferred);
        ++reader.namesakes[step.name];
    }
}

/// Gives each transition with an id a name such as `t7`. If another partial chart also has a transition with this id,
/// the name of the partial chart precedes the name of the transition.
void name_transitions(AgrafeReader& reader) {
    std::unordered_map<std::string, std::size_t> taken;
    LegalNames names(LegalNames::Kind::Chart, reader.draft);
    for (AgrafeEntity& one : reader.index.all()) {
        if (one.kind != Kind::Transition || !attribute(one.node, "id")) continue;
        std::string preferred = 't' + value(one.node, "id");
        const auto [first, fresh] = taken.try_emplace(preferred, one.partial);
        if (!fresh && first->second != one.partial && !reader.index[one.partial].name.empty())
            preferred = reader.index[one.partial].name + '_' + preferred;
        one.name = names.make(preferred, reader.xml.where(one.node, "id"));
    }
}

// -- declarations -----------------------------------------------------------------------------------------------------

tree::VariableKind kind_of(AgrafeReader& reader, pugi::xml_node declaration) {
    const std::string type = value(declaration, "variableDeclarationType");
    if (type == "output") return tree::VariableKind::Output;
    if (type == "internal") return tree::VariableKind::Internal;
    if (!type.empty() && type != "input")
        reader.diagnostics().add(messages::bad_value(reader.xml.where(declaration, "variableDeclarationType"),
                                                     "type of this declaration", type,
                                                     "`input`, `output`, `internal` or `step`"));
    return tree::VariableKind::Input;
}

/// Returns one declaration for each variable that is not a step variable.
std::vector<tree::ChartItem> declarations(AgrafeReader& reader) {
    std::vector<tree::ChartItem> items;
    LegalNames names(LegalNames::Kind::Variable, reader.draft);
    for (AgrafeEntity& one : reader.index.all()) {
        if (one.kind != Kind::Declaration || value(one.node, "variableDeclarationType") == "step") continue;
        const Span where = reader.xml.where(one.node, "name");
        const pugi::xml_node sort = child(one.node, "sort");
        const std::string_view type = local_name(attribute(sort, "type").value());
        if (!attribute(one.node, "name"))
            reader.diagnostics().add(messages::missing_part(where, "this variable declaration", "`name`"));
        if (type != "Bool" && type != "Integer")
            reader.diagnostics().add(
                sort ? messages::bad_value(reader.xml.where(sort, "type"), "sort", type, "`Bool` or `Integer`")
                     : messages::missing_part(where, "this variable declaration", "`sort`"));
        one.name = names.make(value(one.node, "name"), where);
        tree::Variables written{kind_of(reader, one.node), {}, reader.xml.where(one.node)};
        tree::Variable variable;
        variable.name = reader.draft.name(one.name, where);
        variable.where = where;
        if (!attribute(one.node, "variableDeclarationType")) reader.without_kind.insert(variable.name.word);
        if (type == "Integer") {
            variable.type = tree::TypeWord::Int;
            reader.integers.push_back(
                {variable.name.word, written.kind == tree::VariableKind::Input, 0, least_integer, greatest_integer});
        }
        written.variables.push_back(std::move(variable));
        items.emplace_back(std::move(written));
    }
    return items;
}

// -- steps and transitions --------------------------------------------------------------------------------------------

tree::Step step_of(AgrafeReader& reader, std::size_t entity, std::vector<tree::Action> actions) {
    const AgrafeEntity& one = reader.index[entity];
    tree::Step step;
    step.where = reader.xml.where(one.node);
    step.name = reader.draft.name(one.name, reader.xml.where(one.node, "id"));
    step.initial = reader.flag(one.node, "initial");
    step.linked = reader.flag(one.node, "activationLink");
    step.entry = one.kind == Kind::Entry;
    step.exit = one.kind == Kind::Exit;
    step.actions = std::move(actions);
    const auto content = [&](std::size_t partial, std::string_view attribute) {
        step.contents.push_back(reader.draft.name(reader.index[partial].name, reader.xml.where(one.node, attribute)));
    };
    if (one.kind == Kind::Macro) {
        step.kind = tree::StepKind::Macro;
        if (const auto expansion = reader.reference(one.node, "expansion", "expansion of a macro-step", is_expansion))
            content(*expansion, "expansion");
    }
    if (one.kind == Kind::Enclosing) {
        const auto enclosed = reader.references(one.node, "partialGrafcets", "partial grafcet", is_plain);
        for (const std::size_t partial : enclosed) content(partial, "partialGrafcets");
        if (!enclosed.empty()) step.kind = tree::StepKind::Enclosing;
        else if (value(one.node, "partialGrafcets").empty())
            reader.diagnostics().add(messages::without_effect(step.where,
                                                              "an enclosing step without an enclosed grafcet",
                                                              "list the enclosed grafcets in `partialGrafcets`"));
    }
    return step;
}

/// Returns a transition, or nullopt if the transition has no links and therefore no effect.
std::optional<tree::Transition> transition_of(AgrafeReader& reader, std::size_t entity) {
    const AgrafeEntity& one = reader.index[entity];
    tree::Transition transition;
    transition.where = reader.xml.where(one.node);
    if (!one.name.empty()) transition.name = reader.draft.name(one.name, reader.xml.where(one.node, "id"));
    for (const std::size_t step : linked_steps(reader, entity, true))
        transition.from.push_back(reader.draft.name(reader.index[step].name, transition.where));
    for (const std::size_t step : linked_steps(reader, entity, false))
        transition.to.push_back(reader.draft.name(reader.index[step].name, transition.where));
    if (transition.from.empty() && transition.to.empty()) {
        reader.diagnostics().add(
            messages::without_effect(transition.where, "a transition without steps", "link it to steps, or remove it"));
        return {};
    }
    const pugi::xml_node term = child(one.node, "term");
    const AgrafeTime time = agrafe_time(reader, one.node);
    if (!term) {
        reader.diagnostics().add(
            messages::missing_part(transition.where, "this transition", "`term` for its condition"));
        transition.condition =
            reader.draft.constant(false, transition.where);  // the missing or invalid term has been reported
        return transition;
    }
    const std::size_t errors = reader.diagnostics().errors();
    transition.condition = agrafe_term(reader, term);
    if (time.kind == AgrafeTime::Kind::Limited)
        reader.draft.refuse(reader.xml.where(one.node, "timeConditionType"), "a time-limited transition",
                            "write the time in the condition, because IEC 60848 defines time limits only for actions");
    else if (time.kind != AgrafeTime::Kind::None && transition.condition.valid())
        transition.condition = timed(reader, time, transition.condition, reader.xml.where(one.node, "delayTime"));
    if (!transition.condition.valid() && reader.diagnostics().errors() != errors)
        transition.condition =
            reader.draft.constant(false, transition.where);  // the missing or invalid term has been reported
    return transition;
}

/// Checks the attribute `enclosingStep` of a partial grafcet: the step that the attribute names must list this partial
/// grafcet.
void check_enclosure(AgrafeReader& reader, std::size_t entity) {
    const AgrafeEntity& partial = reader.index[entity];
    if (!attribute(partial.node, "enclosingStep")) return;
    const auto step = reader.reference(partial.node, "enclosingStep", "enclosing step", is_enclosing);
    if (!step) return;
    const auto enclosed = reader.references(reader.index[*step].node, "partialGrafcets", "partial grafcet", is_plain);
    if (std::ranges::find(enclosed, entity) == enclosed.end())
        reader.diagnostics().add(
            messages::misplaced_link(reader.xml.where(partial.node, "enclosingStep"),
                                     "the step that `enclosingStep` names does not enclose this partial grafcet",
                                     "list the partial grafcet in `partialGrafcets` of the step"));
}

// -- the chart --------------------------------------------------------------------------------------------------------

/// Attaches each comment to the element that follows the comment.
void keep_comments(AgrafeReader& reader, pugi::xml_node root) {
    for (pugi::xml_node node = root.first_child(); node;) {
        if (node.type() == pugi::node_comment) {
            pugi::xml_node about = node.next_sibling();
            while (about && about.type() != pugi::node_element) about = about.next_sibling();
            const Span where = reader.xml.where(about ? about : node.parent());
            for (std::string& line : comment_lines(node.value())) reader.draft.comment(where, std::move(line));
        }
        if (node.first_child()) {
            node = node.first_child();
            continue;
        }
        while (node != root && !node.next_sibling()) node = node.parent();
        node = node == root ? pugi::xml_node() : node.next_sibling();
    }
}

/// Converts each Boolean variable that continuous actions assign to an output, if the file declares the variable as
/// internal or without a type. The conversion preserves the meaning: a condition that reads an output depends on the
/// steps whose actions assign it.
void drive_outputs(AgrafeReader& reader, const tree::File& file, tree::Chart& chart,
                   const std::vector<std::vector<tree::Action>>& actions) {
    std::unordered_set<Id<tree::Word>> driven;
    for (const std::vector<tree::Action>& of_step : actions)
        for (const tree::Action& action : of_step)
            if (const auto* one = std::get_if<tree::ContinuousAction>(&action)) driven.insert(one->output.word);
    for (tree::ChartItem& item : chart.items) {
        auto& variables = std::get<tree::Variables>(item);
        const tree::Variable& variable = variables.variables.front();
        const bool open =
            variables.kind == tree::VariableKind::Internal || reader.without_kind.contains(variable.name.word);
        if (!open || variable.type != tree::TypeWord::None || !driven.contains(variable.name.word)) continue;
        variables.kind = tree::VariableKind::Output;
        reader.diagnostics().add(messages::chosen_kind(
            variable.where, file.text(variable.name), "output",
            "continuous actions assign it; a condition that reads it depends on the steps of these actions"));
    }
}

void fill_ranges(AgrafeReader& reader, const tree::File& file, tree::Chart& chart) {
    const std::vector<FoundRange> found = ranges_of(file, chart, reader.integers);
    std::size_t next = 0;
    for (tree::ChartItem& item : chart.items) {
        auto* variables = std::get_if<tree::Variables>(&item);
        if (variables == nullptr) continue;
        tree::Variable& variable = variables->variables.front();
        if (variable.type != tree::TypeWord::Int) continue;
        const FoundRange range = found[next++];
        if (!range.exact)
            reader.diagnostics().add(messages::chosen_range(
                variable.where, file.text(variable.name), range.low, range.high,
                "AGRAFE defines no ranges, and the chart does not only compare the variable with constants"));
        if (variables->kind == tree::VariableKind::Output && range.low < 0) {
            variables->kind = tree::VariableKind::Internal;
            reader.diagnostics().add(
                messages::chosen_kind(variable.where, file.text(variable.name), "internal variable",
                                      "an output would have the minimum of its range as initial value, not 0"));
        }
        variable.range = tree::Range{reader.draft.number(range.low, variable.where),
                                     reader.draft.number(range.high, variable.where)};
        if (variables->kind == tree::VariableKind::Internal) variable.value = reader.draft.number(0, variable.where);
    }
}

}  // namespace

tree::File read_agrafe(const Xml& xml, std::string_view name, bool lossy, Diagnostics& diagnostics) {
    Draft draft(xml.source(), lossy, diagnostics);
    AgrafeReader reader{xml, AgrafeIndex(xml.root()), draft};
    const std::string given = value(xml.root(), "name");
    LegalNames names(LegalNames::Kind::Chart, draft);
    reader.chart = given.empty() ? names.invent(name) : names.make(given, xml.where(xml.root(), "name"));
    name_partials(reader);
    name_steps(reader);
    name_transitions(reader);
    read_arcs(reader);
    keep_comments(reader, xml.root());

    tree::Chart chart;
    chart.name = draft.name(reader.chart, xml.where(xml.root(), "name"));
    chart.where = xml.where(xml.root());
    chart.items = declarations(reader);
    std::vector<std::vector<tree::Action>> actions = agrafe_actions(reader);
    drive_outputs(reader, draft.file(), chart, actions);
    std::vector<std::vector<tree::ChartItem>> contents(actions.size());
    for (std::size_t i = 0; i < actions.size(); ++i) {
        const AgrafeEntity& one = reader.index[i];
        if (one.kind == Kind::Partial) check_enclosure(reader, i);
        if (is_step(one.kind)) contents[one.partial].emplace_back(step_of(reader, i, std::move(actions[i])));
    }
    for (std::size_t i = 0; i < actions.size(); ++i)
        if (reader.index[i].kind == Kind::Transition)
            if (auto transition = transition_of(reader, i))
                contents[reader.index[i].partial].emplace_back(std::move(*transition));
    for (std::size_t i = 0; i < actions.size(); ++i) {
        const AgrafeEntity& one = reader.index[i];
        if (one.kind == Kind::Main) std::ranges::move(contents[i], std::back_inserter(chart.items));
        if (one.kind != Kind::Partial && one.kind != Kind::Expansion) continue;
        chart.items.emplace_back(tree::Partial{
            one.kind == Kind::Expansion ? tree::PartialKind::Expansion : tree::PartialKind::Partial,
            draft.name(one.name, xml.where(one.node, "name")), std::move(contents[i]), xml.where(one.node)});
    }
    fill_ranges(reader, draft.file(), chart);
    split_mixed_actions(draft, chart);
    draft.group_variables(chart);
    draft.declare(std::move(chart));
    return draft.take();
}

}  // namespace grafverif
