// SPDX-License-Identifier: MIT
#include "edit/operations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "edit/connections.hpp"
#include "edit/layout.hpp"
#include "lsp/scan.hpp"
#include "support/wording.hpp"
#include "syntax/language/format.hpp"
#include "syntax/language/parse.hpp"

namespace grafverif::edit {

namespace {

bool is_number(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

/// Returns `text` without white space at both ends and without the `;` at its end.
std::string trimmed(std::string_view text) {
    const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && (is_space(text.back()) || text.back() == ';')) text.remove_suffix(1);
    return std::string(text);
}

/// Parses a chart with a part that a user wrote. Returns the reason for rejection, or an empty string if `accepts` is
/// true for the only declaration of the chart.
template <class Item, class Accepts>
std::string fault_of(const std::string& written, std::string_view what, const std::string& before,
                     const Accepts& accepts) {
    Sources sources;
    const Id<Source> source = sources.add({"", before + written + ";" + (before.ends_with("{ ") ? " } }" : " }")});
    Diagnostics diagnostics;
    const tree::File file = parse_file(source, sources, diagnostics);
    if (file.broken || file.incomplete)
        return fmt::format("`{}` is not {}: {}", messages::clipped(written), what,
                           diagnostics.all().empty() ? "syntax error" : diagnostics.all().front().message);
    const auto* chart = file.declarations.size() == 1 ? std::get_if<tree::Chart>(&file.declarations[0]) : nullptr;
    const auto* item = chart != nullptr && chart->items.size() == 1 ? std::get_if<Item>(&chart->items[0]) : nullptr;
    if (item != nullptr && accepts(*item)) return {};
    return fmt::format("`{}` is not {}", messages::clipped(written), what);
}

std::string fault_of_condition(const std::string& text) {
    return fault_of<tree::Transition>(
        text, "a condition", "grafcet g { transition t: a -> b when ",
        [](const tree::Transition& t) { return t.condition.valid() && t.assignments.empty(); });
}

std::string fault_of_action(const std::string& text) {
    return fault_of<tree::Step>(text, "one action", "grafcet g { step s { ",
                                [](const tree::Step& step) { return step.actions.size() == 1; });
}

std::string fault_of_assignment(const std::string& text) {
    return fault_of<tree::Transition>(text, "one assignment", "grafcet g { transition t: a -> b when c do ",
                                      [](const tree::Transition& t) { return t.assignments.size() == 1; });
}

class Planner {
public:
    Planner(std::string_view text, const tree::File& file, const Elements& elements, const Element& element)
        : text_(text),
          file_(file),
          elements_(elements),
          element_(element),
          layout_(text, file),
          connections_(file, layout_, element) {}

    Plan plan(const Operation& operation) {
        const bool is_textual = operation.kind == OperationKind::Replace || operation.kind == OperationKind::Action ||
                                (operation.kind == OperationKind::Delete && !element_.is_step());
        if (element_.repeated && !is_textual)
            return {{}, "the element is declared in a repeated declaration (`for`); edit the text"};
        if (!is_textual && element_.step != nullptr) obstacle_ = connections_.obstacle(element_.step->name);
        if (obstacle_.empty()) execute(operation);
        return finished();
    }

private:
    void execute(const Operation& operation) {
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
        case OperationKind::Rename: obstacle_ = "renaming needs all files"; return;
        }
    }

    // -- additions --------------------------------------------------------------------------------------------------------

    /// Adds a step between an element and the elements after it (To) or before it (From).
    void add_neighbour(End side) {
        const bool forward = side == End::To;
        if (element_.is_transition()) {
            const tree::Transition& transition = *element_.transition;
            if (!forward)
                for (const tree::Name& name : transition.from) reject_readers({&transition}, name);
            const std::string fresh = fresh_step(transition.from.empty() ? transition.to : transition.from);
            const std::string others = connections_.written(transition, side);
            add_step(fresh, transition.from);
            add(connections_.replaced_all(transition, side, fresh));
            add_link(transition.where, forward ? fresh : others, forward ? others : fresh, "true");
            return;
        }
        const tree::Step& step = *element_.step;
        if (forward ? step.exit : step.entry) return reject_end_of_expansion(step);
        const std::string fresh = fresh_step({step.name}), name(layout_.text(step.name.where));
        const Transitions links = forward ? connections_.outgoing(step.name) : connections_.incoming(step.name);
        if (forward) reject_readers(links, step.name);
        select(layout_.added_after(step.where, "step " + fresh + ';'), "step ");
        for (const tree::Transition* const link : links)
            add(connections_.replaced(*link, forward ? End::From : End::To, step.name, {fresh}));
        const Span place =
            place_of_link(links, forward ? connections_.incoming(step.name) : connections_.outgoing(step.name));
        add_link(place, forward ? name : fresh, forward ? fresh : name, "true");
    }

    /// Rejects the operation if one of `links`, which will no longer begin at `step`, reads its step variable: the
    /// condition `3s/X1` would never be true.
    void reject_readers(const Transitions& links, const tree::Name& step) {
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

    void add_transition() {
        if (!element_.is_step()) return add_alternative();
        const tree::Step& step = *element_.step;
        const Transitions links = connections_.outgoing(step.name);
        const std::string fresh = fresh_step({step.name});
        select(layout_.added_after(step.where, "step " + fresh + ';'), "step ");
        add_link(place_of_link(links, connections_.incoming(step.name)), std::string(layout_.text(step.name.where)),
                 fresh, exclusive(links));
    }

    void add_alternative() {
        const tree::Transition* transition = element_.transition;
        if (element_.is_step()) {
            const Transitions links = connections_.outgoing(element_.step->name);
            if (links.empty()) return add_transition();
            transition = links.front();
        }
        for (const tree::Name& name : transition->from)
            if (obstacle_ = connections_.obstacle(name); !obstacle_.empty()) return;
        Transitions siblings;
        for (const tree::Transition* const each : connections_.transitions())
            if (each == transition || std::ranges::any_of(transition->from, [&](const tree::Name& name) {
                    return std::ranges::find(each->from, name.word, &tree::Name::word) != each->from.end();
                }))
                siblings.push_back(each);
        const std::string fresh = fresh_step(transition->from.empty() ? transition->to : transition->from);
        add_step(fresh, transition->from);
        const Span place = siblings.back()->where;
        add_link(place, list_of(connections_.names(*transition, End::From)), fresh, exclusive(siblings));
        add_link(place, fresh, list_of(connections_.names(*transition, End::To)), "true");
    }

    void add_parallel() {
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
        const std::string words =
            std::string(step->linked ? "linked " : "") + (step->initial ? "initial " : "") + "step ";
        select(layout_.added_after(step->where, words + fresh + ';'), words);
        for (const tree::Transition* const link : connections_.incoming(step->name))
            add(connections_.added(*link, End::To, fresh));
        for (const tree::Transition* const link : connections_.outgoing(step->name))
            add(connections_.added(*link, End::From, fresh));
    }

    void reject_end_of_expansion(const tree::Step& step) {
        obstacle_ = fmt::format("step `{}` is the entry step or the exit step of an expansion; edit the text",
                                file_.text(step.name));
    }

    void add_jump(const Operation& operation) {
        const Element* const target = operation.target ? elements_.at(*operation.target) : nullptr;
        if (target == nullptr || !target->is_step() || target->repeated)
            obstacle_ = "the target of a jump must be a step";
        else if (target->items != element_.items)
            obstacle_ =
                fmt::format("step `{}` belongs to another chart or partial chart", file_.text(target->step->name));
        if (!obstacle_.empty()) return;
        const std::string name(layout_.text(target->step->name.where));
        if (element_.is_transition()) {
            const tree::Transition& transition = *element_.transition;
            if (connections_.names(transition, End::To) == std::vector{name}) {
                obstacle_ = fmt::format("{} already leads to step `{}`", connections_.title(transition), name);
                return;
            }
            if (transition.to.size() > 1) {
                obstacle_ = fmt::format("{} leads to several steps; edit the text", connections_.title(transition));
                return;
            }
            add(connections_.replaced_all(transition, End::To, name));
            selected_ = transition.where.begin;
            return;
        }
        const tree::Step& step = *element_.step;
        const Transitions links = connections_.outgoing(step.name);
        add_link(place_of_link(links, connections_.incoming(step.name)), std::string(layout_.text(step.name.where)),
                 name, exclusive(links));
        selected_in_ = edits_.size() - 1;
        selected_at_ = edits_.back().replacement.find("transition");
    }

    void add_action(const std::string& action) {
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

    // -- changes and deletions --------------------------------------------------------------------------------------------

    void replace(const std::string& written) {
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

    void remove() {
        if (element_.action != nullptr) return remove_action();
        if (element_.assignment != nullptr) return remove_assignment();
        append(element_.is_step() ? connections_.without_step(*element_.step, obstacle_)
                                  : connections_.without_transition(*element_.transition, obstacle_));
    }

    void remove_action() {
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

    void remove_assignment() {
        const tree::Transition& transition = *element_.transition;
        selected_ = transition.where.begin;
        std::vector<Span> places;
        for (const tree::Assignment& each : transition.assignments) places.push_back(each.where);
        const auto index = static_cast<std::size_t>(element_.assignment - transition.assignments.data());
        if (places.size() > 1) return append(layout_.removed_name(places, index));
        const std::uint32_t after = layout_.condition(transition).end;  // without brackets
        std::uint32_t begin = after;
        for (const lsp::Word& word : lsp::words_of(text_.substr(after, places[0].begin - after)))
            if (text_.substr(after + word.begin, word.end - word.begin) == "do") begin = after + word.begin;
        if (layout_.has_comment(begin, places[0].begin))
            obstacle_ = "a comment is in front of the action; edit the text";
        while (text_[begin - 1] == ' ') --begin;
        add({begin, places[0].end, ""});
    }

    // -- parts --------------------------------------------------------------------------------------------------------------

    /// Returns the position of an action with its `;`.
    static Span declared(const tree::Action& action) {
        const Span place = where(action);
        return {place.source, place.begin, place.end + 1};
    }

    /// Adds a step after the declaration of the first of `neighbours`; if it is not in the list, after the last step.
    void add_step(const std::string& fresh, const std::vector<tree::Name>& neighbours) {
        const tree::Step* near = neighbours.empty() ? nullptr : connections_.step(neighbours.front());
        if (near == nullptr) near = last_step();
        const Span place = near != nullptr ? near->where : element_.where;
        select(layout_.added_after(place, "step " + fresh + ';'), "step ");
    }

    const tree::Step* last_step() const {
        const tree::Step* last = nullptr;
        for (const tree::ChartItem& item : *element_.items)
            if (const auto* step = std::get_if<tree::Step>(&item)) last = step;
        return last;
    }

    /// Returns the declaration after which a new transition is added: the last of `near`, otherwise the last of `next`,
    /// otherwise the last transition of the list, otherwise its last step.
    Span place_of_link(const Transitions& near, const Transitions& next) const {
        for (const Transitions* const list : {&near, &next, &connections_.transitions()})
            if (!list->empty()) return list->back()->where;
        return last_step() != nullptr ? last_step()->where : element_.where;
    }

    void add_link(Span place, const std::string& from, const std::string& to, const std::string& condition) {
        const std::string name = fresh_transition();
        add(layout_.added_after(place,
                                fmt::format("transition{} {}->{}{} when {};", name.empty() ? "" : ' ' + name + ':',
                                            from.empty() ? "" : from + ' ', to.empty() ? "" : " ", to, condition)));
    }

    /// Returns the conjunction of the negated conditions of `links`.
    std::string exclusive(const Transitions& links) const {
        std::string all;
        for (const tree::Transition* const link : links) {
            if (!link->condition.valid()) continue;
            const std::string term = negation(link->condition);
            if (term == "false") return term;
            if (term != "true") all += (all.empty() ? "" : " && ") + term;
        }
        return all.empty() ? "true" : all;
    }

    std::string negation(Id<tree::Expr> condition) const {
        const tree::Expr& expr = file_.exprs[condition];
        const auto is_simple = [&](Id<tree::Expr> term) {
            const tree::Op op = file_.exprs[term].op;
            return op == tree::Op::Name || op == tree::Op::Member || op == tree::Op::Rise || op == tree::Op::Fall;
        };
        if (expr.op == tree::Op::True) return "false";
        if (expr.op == tree::Op::False) return "true";
        if (expr.op == tree::Op::Not && is_simple(expr.first)) return formatted(file_, expr.first);
        const std::string term = formatted(file_, condition);
        return is_simple(condition) ? '!' + term : "!(" + term + ')';
    }

    /// Returns the name of a new step: the next free number, or the name of the neighbour with the next free number.
    std::string fresh_step(const std::vector<tree::Name>& neighbours) {
        std::set<std::string_view> words;
        for (const tree::Word& word : file_.words) words.insert(word.text);
        std::string stem(neighbours.empty() ? "0" : file_.text(neighbours.front()));
        std::uint64_t next = 2;
        if (is_number(stem)) {
            next = 0;
            stem.clear();
            for (const Element& each : elements_.all()) {
                if (each.items != element_.items || !each.is_step()) continue;
                const std::string_view name = file_.text(each.step->name);
                std::uint64_t number = 0;
                if (is_number(name) && name.size() < 10)
                    std::from_chars(name.data(), name.data() + name.size(), number);
                if (is_number(name)) next = std::max(next, number + 1);
            }
        } else {
            const std::size_t digits = stem.find_last_not_of("0123456789") + 1;
            if (digits < stem.size() && stem.size() - digits < 10) {
                std::from_chars(stem.data() + digits, stem.data() + stem.size(), next);
                ++next;
                stem.resize(digits);
            }
        }
        const auto taken = [&](const std::string& name) {
            return words.contains(name) || words.contains('X' + name) ||
                   std::ranges::find(names_, name) != names_.end();
        };
        std::string name = stem + std::to_string(next);
        while (taken(name)) name = stem + std::to_string(++next);
        return names_.emplace_back(name);
    }

    /// Returns the name of a new transition; empty if a transition of the chart has no name.
    std::string fresh_transition() {
        std::set<std::string_view> words;
        for (const tree::Word& word : file_.words) words.insert(word.text);
        std::uint64_t next = 1;
        for (const Element& each : elements_.all()) {
            if (each.chart != element_.chart || !each.is_transition()) continue;
            if (!each.transition->name.valid()) return {};
            ++next;
        }
        std::string name = fmt::format("t{}", next);
        while (words.contains(name) || std::ranges::find(names_, name) != names_.end())
            name = fmt::format("t{}", ++next);
        return names_.emplace_back(name);
    }

    // -- the result ---------------------------------------------------------------------------------------------------------

    void add(TextEdit edit) { edits_.push_back(std::move(edit)); }
    void add(std::vector<TextEdit> edits) { append(std::move(edits)); }
    void append(std::vector<TextEdit> edits) {
        for (TextEdit& edit : edits) edits_.push_back(std::move(edit));
    }
    /// Adds an edit, and selects the declaration in its replacement that begins with `words`.
    void select(TextEdit edit, std::string_view words) {
        selected_in_ = edits_.size();
        selected_at_ = edit.replacement.find(words);
        edits_.push_back(std::move(edit));
    }

    Plan finished() {
        if (!obstacle_.empty()) return {{}, obstacle_};
        Plan plan;
        std::vector<std::size_t> order(edits_.size());
        for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
        std::ranges::stable_sort(order, {}, [&](std::size_t k) { return std::pair(edits_[k].begin, edits_[k].end); });
        std::uint32_t grown = 0;
        for (const std::size_t k : order) {
            TextEdit& edit = edits_[k];
            if (selected_in_ == k) plan.selected = edit.begin + grown + static_cast<std::uint32_t>(selected_at_);
            if (!plan.edits.empty() && edit.begin < plan.edits.back().end) {  // two deletions that overlap
                plan.edits.back().end = std::max(plan.edits.back().end, edit.end);
                continue;
            }
            grown += static_cast<std::uint32_t>(edit.replacement.size()) - (edit.end - edit.begin);
            plan.edits.push_back(std::move(edit));
        }
        if (selected_) {
            plan.selected = *selected_;
            for (const TextEdit& edit : plan.edits)
                if (edit.end <= *selected_)
                    *plan.selected += static_cast<std::uint32_t>(edit.replacement.size()) - (edit.end - edit.begin);
        }
        return plan;
    }

    std::string_view text_;
    const tree::File& file_;
    const Elements& elements_;
    const Element& element_;
    Layout layout_;
    Connections connections_;
    std::vector<TextEdit> edits_ = {};
    std::string obstacle_ = {};
    std::vector<std::string> names_ = {};          ///< new names
    std::optional<std::size_t> selected_in_ = {};  ///< index of the edit that adds the selected element
    std::size_t selected_at_ = 0;                  ///< offset of this element in the replacement
    std::optional<std::uint32_t> selected_ = {};   ///< position of a selected element before the edits
};

}  // namespace

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
