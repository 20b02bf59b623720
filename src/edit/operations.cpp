// SPDX-License-Identifier: MIT
#include "edit/operations.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "edit/planner.hpp"
#include "edit/written.hpp"
#include "lsp/scan.hpp"

namespace grafverif::edit {

Plan Planner::plan(const Operation& operation) {
    const bool is_textual = operation.kind == OperationKind::Replace || operation.kind == OperationKind::Action ||
                            operation.kind == OperationKind::Declare || operation.kind == OperationKind::Partial ||
                            (operation.kind == OperationKind::Delete && !element_.is_step());
    if (element_.repeated && !is_textual)
        return {{}, "the element is declared in a repeated declaration (`for`); edit the text"};
    if (!is_textual && element_.step != nullptr) obstacle_ = connections_.obstacle(element_.step->name);
    if (obstacle_.empty()) execute(operation);
    return finished();
}

void Planner::execute(const Operation& operation) {
    switch (operation.kind) {
    case OperationKind::StepAfter: return add_neighbour(End::To);
    case OperationKind::StepBefore: return add_neighbour(End::From);
    case OperationKind::Transition: return add_transition();
    case OperationKind::Alternative: return add_alternative();
    case OperationKind::Parallel: return add_parallel();
    case OperationKind::Jump: return add_jump(operation);
    case OperationKind::Action: return add_action(trimmed(operation.text));
    case OperationKind::Replace: return replace(trimmed(operation.text));
    case OperationKind::Delete: return remove();
    case OperationKind::Paste: return paste(operation.text);
    case OperationKind::Declare: return declare(trimmed(operation.text));
    case OperationKind::Partial: return add_partial(trimmed(operation.text));
    case OperationKind::Macro: return add_macro();
    case OperationKind::Enclosing: return add_enclosing(trimmed(operation.text));
    case OperationKind::Rename:
        obstacle_ = "the name cannot be changed in this text alone, because other files may use the name";
        return;
    }
}

void Planner::add_neighbour(End side, const std::string& words, const std::string& contents) {
    const bool forward = side == End::To;
    if (element_.is_transition()) {
        const tree::Transition& transition = *element_.transition;
        if (!forward)
            for (const tree::Name& name : transition.from) reject_readers({&transition}, name);
        const std::string fresh = fresh_step(transition.from.empty() ? transition.to : transition.from);
        const std::string others = connections_.written(transition, side);
        add_step(fresh, transition.from, words, contents);
        add(connections_.replaced_all(transition, side, fresh));
        add_link(transition.where, forward ? fresh : others, forward ? others : fresh, "true");
        return;
    }
    const tree::Step& step = *element_.step;
    if (forward ? step.exit : step.entry) return reject_end_of_expansion(step);
    const std::string fresh = fresh_step({step.name}), name(layout_.text(step.name.where));
    const Transitions links = forward ? connections_.outgoing(step.name) : connections_.incoming(step.name);
    if (forward) reject_readers(links, step.name);
    select(layout_.added_after(step.where, words + fresh + contents + ';'), words);
    for (const tree::Transition* const link : links)
        add(connections_.replaced(*link, forward ? End::From : End::To, step.name, {fresh}));
    const Span place =
        place_of_link(links, forward ? connections_.incoming(step.name) : connections_.outgoing(step.name));
    add_link(place, forward ? name : fresh, forward ? fresh : name, "true");
}

void Planner::reject_readers(const Transitions& links, const tree::Name& step) {
    const std::string variable = 'X' + std::string(file_.text(step));
    for (const tree::Transition* const link : links) {
        const std::string_view condition = layout_.text(layout_.condition(*link));
        for (const lsp::Word& word : lsp::words_of(condition))
            if (condition.substr(word.begin, word.end - word.begin) == variable)
                obstacle_ = fmt::format(
                    "{} reads `{}`, which would no longer be true; add the step after this "
                    "transition instead",
                    connections_.title(*link), variable);
    }
}

void Planner::add_transition() {
    if (!element_.is_step()) return add_alternative();
    const tree::Step& step = *element_.step;
    const Transitions links = connections_.outgoing(step.name);
    const std::string fresh = fresh_step({step.name});
    select(layout_.added_after(step.where, "step " + fresh + ';'), "step ");
    add_link(place_of_link(links, connections_.incoming(step.name)), std::string(layout_.text(step.name.where)), fresh,
             exclusive(links));
}

Transitions Planner::alternatives_to(const tree::Transition& transition) {
    Transitions found;
    for (const tree::Name& name : transition.from)
        if (obstacle_ = connections_.obstacle(name); !obstacle_.empty()) return found;
    for (const tree::Transition* const each : connections_.transitions())
        if (each == &transition || std::ranges::any_of(transition.from, [&](const tree::Name& name) {
                return std::ranges::find(each->from, name.word, &tree::Name::word) != each->from.end();
            }))
            found.push_back(each);
    return found;
}

void Planner::add_alternative() {
    const tree::Transition* transition = element_.transition;
    if (element_.is_step()) {
        const Transitions links = connections_.outgoing(element_.step->name);
        if (links.empty()) return add_transition();
        transition = links.front();
    }
    const Transitions siblings = alternatives_to(*transition);
    if (!obstacle_.empty()) return;
    const std::string fresh = fresh_step(transition->from.empty() ? transition->to : transition->from);
    add_step(fresh, transition->from);
    const Span place = siblings.back()->where;
    add_link(place, list_of(connections_.names(*transition, End::From)), fresh, exclusive(siblings));
    add_link(place, fresh, list_of(connections_.names(*transition, End::To)), "true");
}

void Planner::add_parallel() {
    const tree::Step* step = element_.step;
    if (element_.is_transition())
        step = element_.transition->to.empty() ? nullptr : connections_.step(element_.transition->to.front());
    if (step == nullptr) {
        obstacle_ = "no step follows the transition; add a step after it first";
        return;
    }
    if (step->entry || step->exit) return reject_end_of_expansion(*step);
    if (obstacle_ = connections_.obstacle(step->name); !obstacle_.empty()) return;
    const std::string fresh = fresh_step({step->name});
    const std::string words = std::string(step->linked ? "linked " : "") + (step->initial ? "initial " : "") + "step ";
    select(layout_.added_after(step->where, words + fresh + ';'), words);
    for (const tree::Transition* const link : connections_.incoming(step->name))
        add(connections_.added(*link, End::To, fresh));
    for (const tree::Transition* const link : connections_.outgoing(step->name))
        add(connections_.added(*link, End::From, fresh));
}

void Planner::reject_end_of_expansion(const tree::Step& step) {
    obstacle_ = fmt::format("step `{}` is the entry step or the exit step of an expansion; edit the text",
                            file_.text(step.name));
}

void Planner::add_jump(const Operation& operation) {
    const Element* const target = operation.target ? elements_.at(*operation.target) : nullptr;
    if (target == nullptr || !target->is_step() || target->repeated) obstacle_ = "the target of a jump must be a step";
    else if (target->items != element_.items)
        obstacle_ = fmt::format("step `{}` belongs to another chart or partial chart", file_.text(target->step->name));
    if (!obstacle_.empty()) return;
    const std::string name(layout_.text(target->step->name.where));
    if (element_.is_transition()) {
        const tree::Transition& transition = *element_.transition;
        if (connections_.names(transition, End::To) == std::vector{name}) {
            obstacle_ = fmt::format("{} already leads to step `{}`", connections_.title(transition), name);
            return;
        }
        if (transition.to.size() > 1) {
            obstacle_ = fmt::format("{} leads to several steps, so its target cannot be replaced here; edit the text",
                                    connections_.title(transition));
            return;
        }
        add(connections_.replaced_all(transition, End::To, name));
        selected_ = transition.where.begin;
        return;
    }
    const tree::Step& step = *element_.step;
    const Transitions links = connections_.outgoing(step.name);
    add_link(place_of_link(links, connections_.incoming(step.name)), std::string(layout_.text(step.name.where)), name,
             exclusive(links));
    select_last("transition");
}

void Planner::add_action(const std::string& action) {
    if (element_.is_transition()) {
        const tree::Transition& transition = *element_.transition;
        if (obstacle_ = fault_of_assignment(action); !obstacle_.empty()) return;
        const bool first = transition.assignments.empty();
        const std::uint32_t end = first ? transition.where.end - 1 : transition.assignments.back().where.end;
        add({end, end, (first ? " do " : ", ") + action});
        selected_ = transition.where.begin;
        return;
    }
    const tree::Step& step = *element_.step;
    if (obstacle_ = fault_of_action(action); !obstacle_.empty()) return;
    if (!step.actions.empty()) add(layout_.added_after(declared(step.actions.back()), action + ';'));
    else if (text_[step.where.end - 1] == ';') add({step.where.end - 1, step.where.end, " { " + action + "; }"});
    else if (layout_.has_comment(step.name.where.end, step.where.end))
        add({step.where.end - 1, step.where.end - 1, action + "; "});
    else {
        const auto open = static_cast<std::uint32_t>(text_.find('{', step.name.where.end));
        add({open, step.where.end, "{ " + action + "; }"});
    }
    selected_ = step.where.begin;
}

void Planner::replace(const std::string& written) {
    if (element_.action != nullptr) {
        obstacle_ = fault_of_action(written);
        add({element_.where.begin, element_.where.end, written});
    } else if (element_.assignment != nullptr) {
        obstacle_ = fault_of_assignment(written);
        add({element_.where.begin, element_.where.end, written});
    } else if (element_.is_transition()) {
        obstacle_ = fault_of_condition(written);
        const Span place = layout_.condition(*element_.transition);
        add({place.begin, place.end, written});
    } else {
        obstacle_ = "a step has no condition; rename it, or edit one of its actions";
    }
    selected_ = element_.where.begin;
}

void Planner::remove() {
    if (element_.action != nullptr) return remove_action();
    if (element_.assignment != nullptr) return remove_assignment();
    add(element_.is_step() ? connections_.without_step(*element_.step, obstacle_)
                           : connections_.without_transition(*element_.transition, obstacle_));
}

void Planner::remove_action() {
    const tree::Step& step = *element_.step;
    selected_ = step.where.begin;
    if (step.actions.size() == 1 && !layout_.has_comment(step.name.where.end, step.where.end)) {
        auto open = static_cast<std::uint32_t>(text_.rfind('{', element_.where.begin));
        while (text_[open - 1] == ' ') --open;
        add({open, step.where.end, ";"});
    } else {
        add(layout_.removed(declared(*element_.action)));
    }
}

void Planner::remove_assignment() {
    const tree::Transition& transition = *element_.transition;
    selected_ = transition.where.begin;
    std::vector<Span> places;
    for (const tree::Assignment& each : transition.assignments) places.push_back(each.where);
    const auto index = static_cast<std::size_t>(element_.assignment - transition.assignments.data());
    if (places.size() > 1) return add(layout_.removed_name(places, index));
    const std::uint32_t after = layout_.condition(transition).end;  // end of the condition, without closing brackets
    std::uint32_t begin = after;
    for (const lsp::Word& word : lsp::words_of(text_.substr(after, places[0].begin - after)))
        if (text_.substr(after + word.begin, word.end - word.begin) == "do") begin = after + word.begin;
    if (layout_.has_comment(begin, places[0].begin))
        obstacle_ = "a comment precedes the action and would be deleted; edit the text";
    while (text_[begin - 1] == ' ') --begin;
    add({begin, places[0].end, ""});
}

Plan plan_of(std::string_view text, const tree::File& file, const Elements& elements, const Operation& operation) {
    const Element* const element = elements.at(operation.at);
    if (element == nullptr) return {{}, "the element is not in this text"};
    if ((element->action != nullptr || element->assignment != nullptr) && operation.kind != OperationKind::Replace &&
        operation.kind != OperationKind::Delete)
        return {{}, "select a step or a transition"};
    return Planner(text, file, elements, *element).plan(operation);
}

TextEdit naming(const tree::Transition& transition, const std::string& name) {
    if (transition.name.valid()) return {transition.name.where.begin, transition.name.where.end, name};
    const auto end = transition.where.begin + static_cast<std::uint32_t>(std::string_view("transition").size());
    return {end, end, ' ' + name + ':'};
}

}  // namespace grafverif::edit
