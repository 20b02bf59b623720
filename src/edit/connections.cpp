// SPDX-License-Identifier: MIT
#include "edit/connections.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace grafverif::edit {

namespace {

const std::vector<tree::Name>& ends(const tree::Transition& transition, End end) {
    return end == End::From ? transition.from : transition.to;
}

bool is(const tree::Name& one, const tree::Name& other) { return one.word == other.word && !one.index.valid(); }

bool has(const std::vector<tree::Name>& names, const tree::Name& name) {
    return std::ranges::any_of(names, [&](const tree::Name& each) { return is(each, name); });
}

/// True if a transition in a replication (`for`) in the list begins or ends at the step `name`.
bool repeats(const std::vector<tree::ChartItem>& items, const tree::Name& name, bool repeated) {
    return std::ranges::any_of(items, [&](const tree::ChartItem& item) {
        if (const auto* replicated = std::get_if<tree::ReplicatedChartItems>(&item))
            return repeats(replicated->items, name, true);
        const auto* transition = std::get_if<tree::Transition>(&item);
        return repeated && transition != nullptr && (has(transition->from, name) || has(transition->to, name));
    });
}

void append(std::vector<TextEdit>& edits, std::vector<TextEdit> more) {
    for (TextEdit& edit : more) edits.push_back(std::move(edit));
}

}  // namespace

std::string list_of(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

Connections::Connections(const tree::File& file, const Layout& layout, const Element& element)
    : file_(file), layout_(layout), items_(*element.items) {
    for (const tree::ChartItem& item : items_)
        if (const auto* transition = std::get_if<tree::Transition>(&item)) transitions_.push_back(transition);
}

Transitions Connections::with(const tree::Name& name, End end) const {
    Transitions found;
    for (const tree::Transition* const transition : transitions_)
        if (has(ends(*transition, end), name)) found.push_back(transition);
    return found;
}

const tree::Step* Connections::step(const tree::Name& name) const {
    for (const tree::ChartItem& item : items_)
        if (const auto* step = std::get_if<tree::Step>(&item); step != nullptr && is(step->name, name)) return step;
    return nullptr;
}

std::string Connections::obstacle(const tree::Name& name) const {
    if (!name.index.valid() && !repeats(items_, name, false)) return {};
    return fmt::format("step `{}` is declared or used in a repeated declaration (`for`); edit the text",
                       file_.text(name));
}

std::vector<std::string> Connections::names(const tree::Transition& transition, End end) const {
    std::vector<std::string> texts;
    for (const tree::Name& name : ends(transition, end)) texts.emplace_back(layout_.text(layout_.whole(name)));
    return texts;
}

std::string Connections::written(const tree::Transition& transition, End end) const {
    const std::vector<tree::Name>& present = ends(transition, end);
    if (present.empty()) return {};
    const Span last = layout_.whole(present.back());
    return std::string(layout_.text({last.source, present.front().where.begin, last.end}));
}

std::string Connections::title(const tree::Transition& transition) const {
    if (transition.name.valid()) return fmt::format("transition `{}`", file_.text(transition.name));
    return fmt::format("the transition from {} to {}", list_of(names(transition, End::From)),
                       list_of(names(transition, End::To)));
}

std::vector<TextEdit> Connections::replaced(const tree::Transition& transition, End end, const tree::Name& name,
                                            const std::vector<std::string>& names) const {
    const std::vector<tree::Name>& present = ends(transition, end);
    std::vector<Span> places;
    for (const tree::Name& each : present) places.push_back(layout_.whole(each));
    const auto index = static_cast<std::size_t>(
        std::ranges::find_if(present, [&](const tree::Name& each) { return is(each, name); }) - present.begin());
    const std::vector<std::string> known = this->names(transition, end);
    std::vector<std::string> fresh;
    for (const std::string& each : names)
        if (std::ranges::find(known, each) == known.end()) fresh.push_back(each);
    if (fresh.empty()) return layout_.removed_name(places, index);
    return {{places[index].begin, places[index].end, list_of(fresh)}};
}

TextEdit Connections::replaced_all(const tree::Transition& transition, End end, const std::string& names) const {
    const std::vector<tree::Name>& present = ends(transition, end);
    if (!present.empty()) return {present.front().where.begin, layout_.whole(present.back()).end, names};
    const std::uint32_t arrow = layout_.arrow(transition.where);
    return end == End::From ? TextEdit{arrow, arrow, names + ' '} : TextEdit{arrow + 2, arrow + 2, ' ' + names};
}

TextEdit Connections::added(const tree::Transition& transition, End end, const std::string& name) const {
    const std::vector<tree::Name>& present = ends(transition, end);
    if (present.empty()) return replaced_all(transition, end, name);
    const std::uint32_t last = layout_.whole(present.back()).end;
    return {last, last, ", " + name};
}

std::vector<TextEdit> Connections::without_transition(const tree::Transition& transition, std::string& obstacle) const {
    for (const tree::Name& name : transition.to) {
        const tree::Step* const target = step(name);
        if (target == nullptr || target->initial || target->linked || target->entry || has(transition.from, name) ||
            incoming(name).size() > 1)
            continue;
        obstacle = fmt::format(
            "without {}, no transition leads to step `{}`; delete the step, or add another transition to it",
            title(transition), file_.text(name));
        return {};
    }
    return {layout_.removed(transition.where)};
}

std::vector<TextEdit> Connections::without_step(const tree::Step& step, std::string& obstacle) const {
    const tree::Name& name = step.name;
    std::vector<TextEdit> edits = {layout_.removed(step.where)};
    Transitions before, after;
    for (const tree::Transition* const each : transitions_) {
        const bool is_before = has(each->to, name), is_after = has(each->from, name);
        if (is_before && is_after && each->to.size() == 1 && each->from.size() == 1) {
            edits.push_back(layout_.removed(each->where));  // a transition from the step to itself is removed
            continue;
        }
        if (is_before && is_after) {
            obstacle = fmt::format("{} begins and ends at step `{}` and at other steps; change the transition first",
                                   title(*each), file_.text(name));
            return {};
        }
        if (is_before) before.push_back(each);
        if (is_after) after.push_back(each);
    }
    const auto only = [&](const Transitions& list, End end) {
        return std::ranges::count_if(list, [&](const tree::Transition* each) { return ends(*each, end).size() == 1; });
    };
    const auto only_before = only(before, End::To), only_after = only(after, End::From);
    const auto lose = [&](const tree::Transition& transition) {
        if (!transition.assignments.empty())
            obstacle = fmt::format("{} would be deleted with its actions; move the actions first", title(transition));
        edits.push_back(layout_.removed(transition.where));
    };
    if (only_before == 0 && only_after == 0) {  // the step is a branch of a parallel structure, or isolated
        for (const tree::Transition* const each : before) append(edits, replaced(*each, End::To, name, {}));
        for (const tree::Transition* const each : after) append(edits, replaced(*each, End::From, name, {}));
    } else if (before.empty() || after.empty()) {  // the step is the beginning or the end of a sequence
        for (const tree::Transition* const each : before)
            if (each->to.size() == 1) lose(*each);
            else append(edits, replaced(*each, End::To, name, {}));
        for (const tree::Transition* const each : after)
            if (each->from.size() == 1) lose(*each);
            else append(edits, replaced(*each, End::From, name, {}));
    } else if (after.size() == 1 && only_after == 1) {  // the transitions to the step lead to the next steps
        for (const tree::Transition* const each : before)
            append(edits, replaced(*each, End::To, name, names(*after[0], End::To)));
        lose(*after[0]);
    } else if (before.size() == 1 && only_before == 1) {  // the transitions from the step begin at the previous steps
        for (const tree::Transition* const each : after)
            append(edits, replaced(*each, End::From, name, names(*before[0], End::From)));
        lose(*before[0]);
    } else {
        obstacle = fmt::format(
            "step `{}` has several transitions before it and after it, which cannot be reconnected unambiguously; "
            "delete or redirect some of them first",
            file_.text(name));
    }
    return edits;
}

}  // namespace grafverif::edit
