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

constexpr std::string_view origin = "// steps of ";

/// Returns the name of the chart or partial chart that contains an element, such as `g.P`.
std::string name_of_list(const tree::File& file, const Element& element) {
    std::string name(file.text(element.chart->name));
    for (const tree::ChartItem& item : element.chart->items)
        if (const auto* partial = std::get_if<tree::Partial>(&item);
            partial != nullptr && &partial->items == element.items)
            name.append(1, '.').append(file.text(partial->name));
    return name;
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
        for (const tree::Transition* const transition : transitions)
            for (const tree::Name& name : own(transition->from)) leaving_[name.word].push_back(transition);
        if (!file_.comments.empty() && file_.comments.front().text.starts_with(origin))
            list = file_.comments.front().text.substr(origin.size());
    }
    Fragment(const Fragment&) = delete;
    Fragment& operator=(const Fragment&) = delete;

    std::string_view text(std::uint32_t begin, std::uint32_t end) const { return text_.substr(begin, end - begin); }
    /// Returns the text of a transition that follows its last step.
    std::string_view rest(const tree::Transition& transition) const {
        const Layout layout(text_, file_);
        const std::uint32_t begin =
            transition.to.empty() ? layout.arrow(transition.where) + 2 : layout.whole(transition.to.back()).end;
        return text(begin, transition.where.end);
    }
    std::string name(const tree::Step& step) const { return std::string(file_.text(step.name)); }
    /// Returns those steps of `names` that are copied.
    std::vector<tree::Name> own(std::vector<tree::Name> names) const {
        std::erase_if(names, [&](const tree::Name& each) { return each.index.valid() || !own_.contains(each.word); });
        return names;
    }
    std::string_view name(const tree::Name& name) const { return file_.text(name); }
    const Table<tree::Word>& words() const { return file_.words; }

    /// Returns copied steps from which all copied steps are reachable, and at which the copied branch begins; empty if
    /// there are no such steps. The candidates are the targets of the first transition from a step that is not copied,
    /// then initial steps, then each step.
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

    std::vector<const tree::Step*> steps = {};  ///< the copied steps; empty if the text is not a copy
    std::vector<const tree::Transition*> transitions = {};
    std::string list = {};  ///< chart or partial chart of the originals; empty if the text does not contain it

private:
    bool reaches_all(const std::vector<tree::Name>& first) const {
        Words reached;
        std::vector<Id<tree::Word>> queue;
        std::set<const tree::Transition*> used;
        const auto reach = [&](const std::vector<tree::Name>& names) {
            for (const tree::Name& name : names)
                if (reached.insert(name.word).second) queue.push_back(name.word);
        };
        reach(first);
        for (std::size_t next = 0; next < queue.size(); ++next)
            if (const auto found = leaving_.find(queue[next]); found != leaving_.end())
                for (const tree::Transition* const each : found->second)
                    if (used.insert(each).second) reach(own(each->to));
        return !first.empty() && reached.size() == own_.size();
    }

    Sources sources_ = {};
    tree::File file_ = {};
    std::string_view text_ = {};
    Words own_ = {};
    std::map<Id<tree::Word>, Transitions> leaving_ = {};  ///< transitions that begin at each step
};

/// The names of the copies by the names of the original steps, and the variables of steps that are not copied but occur
/// in the copied text.
struct Renaming {
    std::map<std::string, std::string, std::less<>> fresh = {};
    std::string owner = {};  ///< chart or partial chart of the originals, without the chart of the partial chart
    std::set<std::string> others = {};

    /// Returns `text` with renamed variables of copied steps, such as `X1` or `P.X1`. Collects the variables of all
    /// other steps.
    std::string operator()(std::string_view text) {
        std::vector<lsp::Word> words = lsp::words_of(text);
        std::erase_if(words, [](const lsp::Word& word) { return word.kind == lsp::Word::Kind::Comment; });
        const auto bytes = [&](std::size_t k) { return text.substr(words[k].begin, words[k].end - words[k].begin); };
        std::vector<TextEdit> edits;
        for (std::size_t k = 0; k < words.size(); ++k) {
            if (words[k].kind != lsp::Word::Kind::Name || !bytes(k).starts_with('X')) continue;
            const bool is_member = k >= 2 && bytes(k - 1) == ".";
            const auto step = fresh.find(bytes(k).substr(1));
            const std::uint32_t begin = words[is_member ? k - 2 : k].begin;
            if (step != fresh.end() && (!is_member || bytes(k - 2) == owner))
                edits.push_back({begin, words[k].end, 'X' + step->second});
            else others.insert((is_member ? std::string(bytes(k - 2)) + '.' : std::string()).append(bytes(k)));
        }
        return applied(text, edits);
    }
};

}  // namespace

Copy copied(std::string_view text, const tree::File& file, const Elements& elements,
            const std::vector<std::uint32_t>& at) {
    if (at.empty()) return {"no step is selected; select or mark the steps", {}};
    if (at.size() > most_copied) return {fmt::format("at most {} steps can be copied", most_copied), {}};
    const Layout layout(text, file);
    const Element* first = nullptr;
    std::vector<const tree::Step*> steps;
    Words own;
    for (const std::uint32_t each : at) {
        const Element* const element = elements.at(each);
        if (element == nullptr || !element->is_step()) return {"only steps can be copied", {}};
        if (element->repeated) return {"a step is declared in a repeated declaration (`for`); copy its text", {}};
        if (first == nullptr) first = element;
        if (element->items != first->items)
            return {"the steps belong to different charts or partial charts; copy them separately", {}};
        if (own.insert(element->step->name.word).second) steps.push_back(element->step);
    }
    const Connections connections(file, layout, *first);
    Copy copy{{}, fmt::format("{}{}\n", origin, name_of_list(file, *first))};
    for (const tree::Step* const step : steps) {
        if (std::string obstacle = connections.obstacle(step->name); !obstacle.empty()) return {obstacle, {}};
        copy.text.append(layout.text(step->where)).append(1, '\n');
    }
    const auto is_copied = [&](const tree::Name& name) { return !name.index.valid() && own.contains(name.word); };
    for (const tree::Transition* const transition : connections.transitions()) {
        const auto begins = std::ranges::count_if(transition->from, is_copied);
        const auto ends = std::ranges::count_if(transition->to, is_copied);
        if (begins + ends == 0) continue;
        for (const auto& [names, count, verb] :
             {std::tuple(&transition->from, begins, "begins at"), std::tuple(&transition->to, ends, "leads to")})
            if (const auto other = std::ranges::find_if_not(*names, is_copied); count > 0 && other != names->end())
                return {fmt::format("{} also {} step `{}`; copy this step too", connections.title(*transition), verb,
                                    layout.text(layout.whole(*other))),
                        {}};
        copy.text.append(layout.text(transition->where)).append(1, '\n');
    }
    return copy;
}

/// Adds the copied steps as a branch. The branch begins with a new transition that is an alternative to the selected
/// transition. Copies of transitions that led to steps outside the copy lead to the steps after the selected
/// transition.
void Planner::paste(const std::string& copied) {
    const Fragment fragment(copied);
    if (fragment.steps.empty()) {
        obstacle_ = "the copied text does not consist of steps and their transitions";
        return;
    }
    if (fragment.steps.size() > most_copied || fragment.transitions.size() > 2 * most_copied) {
        obstacle_ = fmt::format("at most {} steps and {} transitions can be pasted", most_copied, 2 * most_copied);
        return;
    }
    const std::vector<tree::Name> entries = fragment.entries();
    if (entries.empty()) {
        obstacle_ =
            "the copied steps are not connected; copy a branch in which all steps can be reached from its first steps";
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
    const std::string here = name_of_list(file_, element_), original = fragment.list.empty() ? here : fragment.list;
    Renaming renamed{.owner = original.substr(original.find('.') + 1)};
    // The variable of a new step must not be equal to a step variable that a condition of the copied text reads.
    for (const tree::Word& word : fragment.words())
        if (word.text.starts_with('X')) used().insert(word.text);
    for (const tree::Step* const step : fragment.steps)
        renamed.fresh[fragment.name(*step)] = fresh_step(fragment.name(*step));
    for (const tree::Step* const step : fragment.steps) {
        const std::string kind = step->kind == tree::StepKind::Macro       ? "macro "
                                 : step->kind == tree::StepKind::Enclosing ? "enclosing "
                                                                           : "";
        const std::string declaration = kind + "step " + renamed.fresh[fragment.name(*step)] +
                                        renamed(fragment.text(step->name.where.end, step->where.end));
        const TextEdit edit = layout_.added_after(near != nullptr ? near->where : element_.where, declaration);
        if (step->name.word == entries.front().word) select(edit, declaration);
        else add(edit);
    }

    const auto names = [&](const std::vector<tree::Name>& steps) {
        std::vector<std::string> list;
        for (const tree::Name& step : steps) list.push_back(renamed.fresh.at(std::string(fragment.name(step))));
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
                               to.empty() ? "" : " ", to, renamed(fragment.rest(*each)))));
    }
    if (fragment.list != here) reject_other_steps(renamed.others, original.substr(0, original.find('.')));
}

void Planner::reject_other_steps(const std::set<std::string>& variables, std::string_view chart) {
    std::set<std::string_view> steps;
    for (const Element& each : elements_.all())
        if (each.is_step()) steps.insert(file_.text(each.step->name));
    for (const std::string& variable : variables) {
        const std::size_t dot = variable.rfind('.');
        if (dot != std::string::npos && chart == file_.text(element_.chart->name)) continue;
        const std::string name = variable.substr(dot == std::string::npos ? 1 : dot + 2);
        if (steps.contains(name))
            obstacle_ = fmt::format(
                "the copied text contains `{}`, which may refer to another step here; copy step `{}` too, or edit the "
                "text",
                variable, name);
    }
}

}  // namespace grafverif::edit
