// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "edit/planner.hpp"
#include "lsp/scan.hpp"
#include "syntax/language/parse.hpp"

namespace grafverif::edit {

namespace {

using Words = std::set<Id<tree::Word>>;

Words words(const std::vector<tree::Name>& names) {
    Words found;
    for (const tree::Name& name : names) found.insert(name.word);
    return found;
}

/// The copied steps and the transitions that begin or end at them.
class Fragment {
public:
    explicit Fragment(const std::string& copied) {
        const std::string before = "grafcet g {\n";
        const Id<Source> source = sources_.add({"", before + copied + "\n}"});
        text_ = sources_[source].text;
        Diagnostics diagnostics;
        file_ = parse_file(source, sources_, diagnostics);
        if (file_.broken || file_.incomplete || file_.declarations.size() != 1) return;
        bool is_copy = true;
        for (const tree::ChartItem& item : std::get<tree::Chart>(file_.declarations[0]).items) {
            const auto* const step = std::get_if<tree::Step>(&item);
            const auto* const transition = std::get_if<tree::Transition>(&item);
            is_copy &= step != nullptr || transition != nullptr;
            if (step != nullptr) steps.push_back(step), own_.insert(step->name.word);
            else if (transition != nullptr) transitions.push_back(transition);
        }
        if (!is_copy) steps.clear();
    }
    Fragment(const Fragment&) = delete;
    Fragment& operator=(const Fragment&) = delete;

    std::string_view text(std::uint32_t begin, std::uint32_t end) const { return text_.substr(begin, end - begin); }
    /// Returns the text of a transition after its last step.
    std::string_view rest(const tree::Transition& transition) const {
        const Layout layout(text_, file_);
        const std::uint32_t begin =
            transition.to.empty() ? layout.arrow(transition.where) + 2 : layout.whole(transition.to.back()).end;
        return text(begin, transition.where.end);
    }
    std::string name(const tree::Step& step) const { return std::string(file_.text(step.name)); }
    /// Returns the copied steps in a list.
    std::vector<tree::Name> own(std::vector<tree::Name> names) const {
        std::erase_if(names, [&](const tree::Name& each) { return each.index.valid() || !own_.contains(each.word); });
        return names;
    }
    std::string_view name(const tree::Name& name) const { return file_.text(name); }

    /// Returns the copied steps at which a copy is entered, so that links lead from them to all copied steps; empty if
    /// there are none. Considers the steps to which the first transitions from other steps lead, then initial steps, then
    /// each step.
    std::vector<tree::Name> entries() const {
        std::vector<std::vector<tree::Name>> choices;
        for (const tree::Transition* const each : transitions)
            if (own(each->from).empty()) choices.push_back(own(each->to));
        choices.emplace_back();
        for (const tree::Step* const step : steps)
            if (step->initial) choices.back().push_back(step->name);
        for (const tree::Step* const step : steps) choices.push_back({step->name});
        const auto found = std::ranges::find_if(choices, [&](const auto& choice) { return reaches_all(choice); });
        return found == choices.end() ? std::vector<tree::Name>() : *found;
    }

    std::vector<const tree::Step*> steps = {};  ///< empty if the text is not a copy
    std::vector<const tree::Transition*> transitions = {};

private:
    bool reaches_all(const std::vector<tree::Name>& first) const {
        Words reached = words(first);
        for (std::size_t known = 0; known != reached.size();) {
            known = reached.size();
            for (const tree::Transition* const each : transitions)
                if (std::ranges::any_of(own(each->from), [&](const auto& name) { return reached.contains(name.word); }))
                    reached.merge(words(own(each->to)));
        }
        return !first.empty() && reached.size() == own_.size();
    }

    Sources sources_ = {};
    tree::File file_ = {};
    std::string_view text_ = {};
    Words own_ = {};
};

/// Returns `text` with the variables of the steps in `fresh`, such as `X1`, renamed.
std::string renamed(std::string_view text, const std::map<std::string, std::string, std::less<>>& fresh) {
    std::vector<TextEdit> edits;
    std::string_view last;
    for (const lsp::Word& word : lsp::words_of(text)) {
        const std::string_view bytes = text.substr(word.begin, word.end - word.begin);
        const auto step = bytes.starts_with('X') && last != "." ? fresh.find(bytes.substr(1)) : fresh.end();
        if (step != fresh.end() && word.kind == lsp::Word::Kind::Name)
            edits.push_back({word.begin, word.end, 'X' + step->second});
        last = bytes;
    }
    return applied(text, edits);
}

}  // namespace

Copy copied(std::string_view text, const Elements& elements, const std::vector<std::uint32_t>& at) {
    const auto bytes = [&](Span where) { return std::string(text.substr(where.begin, where.end - where.begin)); };
    Copy copy;
    Words own;
    const std::vector<tree::ChartItem>* items = nullptr;
    for (const std::uint32_t each : at) {
        const Element* const element = elements.at(each);
        if (element == nullptr || !element->is_step()) return {"only steps can be copied", {}};
        if (element->repeated) return {"a step is declared in a repeated declaration (`for`); copy its text", {}};
        if (items != nullptr && element->items != items)
            return {"the steps belong to different charts or partial charts; copy them separately", {}};
        items = element->items;
        if (own.insert(element->step->name.word).second) copy.text += bytes(element->where) + '\n';
    }
    if (items == nullptr) return {"select the steps first", {}};
    const auto touches = [&](const std::vector<tree::Name>& names) {
        return std::ranges::any_of(names, [&](const tree::Name& name) { return own.contains(name.word); });
    };
    for (const tree::ChartItem& item : *items)
        if (const auto* transition = std::get_if<tree::Transition>(&item);
            transition != nullptr && (touches(transition->from) || touches(transition->to)))
            copy.text += bytes(transition->where) + '\n';
    return copy;
}

/// Adds the copied steps as a branch. The transition to the first copied step is an alternative to the transition.
/// Transitions that led from the copied steps to other steps lead to the steps after the transition.
void Planner::paste(const std::string& copied) {
    const Fragment fragment(copied);
    if (fragment.steps.empty()) {
        obstacle_ = "the copied text does not consist of steps and their transitions";
        return;
    }
    const std::vector<tree::Name> entries = fragment.entries();
    if (entries.empty()) {
        obstacle_ = "the copied steps are not connected; copy steps to which links lead from one of them";
        return;
    }
    const tree::Transition* transition = element_.transition;
    if (element_.is_step()) {
        const Transitions links = connections_.outgoing(element_.step->name);
        transition = links.empty() ? nullptr : links.front();
    }
    const Transitions siblings = transition == nullptr ? Transitions() : alternatives_to(*transition);
    if (!obstacle_.empty()) return;

    const std::vector<tree::Name> from = transition != nullptr ? transition->from : std::vector{element_.step->name};
    const tree::Step* near = from.empty() ? nullptr : connections_.step(from.front());
    if (near == nullptr) near = last_step();
    std::map<std::string, std::string, std::less<>> fresh;
    for (const tree::Step* const step : fragment.steps) fresh[fragment.name(*step)] = fresh_step(fragment.name(*step));
    for (const tree::Step* const step : fragment.steps) {
        const std::string kind = step->kind == tree::StepKind::Macro       ? "macro "
                                 : step->kind == tree::StepKind::Enclosing ? "enclosing "
                                                                           : "";
        const std::string declaration = kind + "step " + fresh[fragment.name(*step)] +
                                        renamed(fragment.text(step->name.where.end, step->where.end), fresh);
        const TextEdit edit = layout_.added_after(near != nullptr ? near->where : element_.where, declaration);
        if (step->name.word == entries.front().word) select(edit, declaration);
        else add(edit);
    }

    const auto names = [&](const std::vector<tree::Name>& steps) {
        std::vector<std::string> list;
        for (const tree::Name& step : steps) list.push_back(fresh.at(std::string(fragment.name(step))));
        return list_of(list);
    };
    const Span place =
        siblings.empty()
            ? place_of_link({}, element_.is_step() ? connections_.incoming(element_.step->name) : Transitions())
            : siblings.back()->where;
    const std::string targets =
        transition != nullptr ? list_of(connections_.names(*transition, End::To)) : std::string();
    const std::string sources = transition != nullptr ? list_of(connections_.names(*transition, End::From))
                                                      : std::string(layout_.text(element_.step->name.where));
    add_link(place, sources, names(entries), exclusive(siblings));
    for (const tree::Transition* const each : fragment.transitions) {
        const std::vector<tree::Name> begins = fragment.own(each->from), ends = fragment.own(each->to);
        const bool leaves = ends.empty() && !each->to.empty();
        if (begins.empty() || (leaves && transition == nullptr)) continue;
        const std::string name = fresh_transition(), to = leaves ? targets : names(ends);
        add(layout_.added_after(
            place, fmt::format("transition{} {} ->{}{}{}", name.empty() ? "" : ' ' + name + ':', names(begins),
                               to.empty() ? "" : " ", to, renamed(fragment.rest(*each), fresh))));
    }
}

}  // namespace grafverif::edit
