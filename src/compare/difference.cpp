// SPDX-License-Identifier: MIT
#include "compare/difference.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "compare/wording.hpp"

namespace grafverif {

namespace {

using comparing::Wording;
using Kind = ChartChange::Kind;
using Step = Id<Chart::Step>;
using Transition = Id<Chart::Transition>;

std::string sorted_text(std::vector<std::string> lines) {
    std::ranges::sort(lines);
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    return text;
}

/// Finds the corresponding steps of the two charts.
class StepMatching {
public:
    StepMatching(const Chart& a, const Chart& b) : charts_{&a, &b} {
        for (const std::size_t k : {0U, 1U}) of_[k].resize(charts_[k]->steps.size());
        std::map<std::string, Step> named;
        for (const Step step : b.steps.ids()) named.emplace(name_of(b, step).text(), step);
        for (const Step step : a.steps.ids())
            if (const auto found = named.find(name_of(a, step).text()); found != named.end()) pair(step, found->second);
        for (bool whole : {true, false})
            while (pair_by_looks(whole)) {
            }
    }

    /// Returns the step of the other chart that corresponds to `step` of chart `k`. The result is invalid if no step of
    /// the other chart corresponds to `step`.
    Step counterpart(std::size_t k, Step step) const { return of_[k][step.index]; }
    /// Returns the name of `step` in the first chart. If the first chart does not contain the step, returns its name in
    /// chart `k`.
    std::string common_name(std::size_t k, Step step) const {
        const Step other = of_[k][step.index];
        if (k == 0 || !other.valid()) return name_of(*charts_[k], step).text();
        return name_of(*charts_[0], other).text();
    }

private:
    void pair(Step of_a, Step of_b) {
        of_[0][of_a.index] = of_b;
        of_[1][of_b.index] = of_a;
    }

    /// Returns the features of an unmatched step as text. If `whole` is true, the features include the transitions of
    /// the step and the conditions of these transitions.
    std::string looks(std::size_t k, Step step, bool whole) const {
        const Wording words(*charts_[k], [&](Step each) {
            return each == step ? "@" : of_[k][each.index].valid() ? common_name(k, each) : std::string("?");
        });
        std::vector<std::string> lines = words.actions(step);
        if (whole)
            for (const Transition id : charts_[k]->transitions.ids()) {
                const Chart::Transition& transition = charts_[k]->transitions[id];
                const bool is_adjacent =
                    std::ranges::count(transition.from, step) > 0 || std::ranges::count(transition.to, step) > 0;
                if (is_adjacent) lines.push_back(words.endpoints(id) + ' ' + words.guard(id));
            }
        return words.head(step) + '\n' + sorted_text(std::move(lines));
    }

    /// Matches steps whose features are unique in both charts. Returns true if at least one pair of steps was matched.
    bool pair_by_looks(bool whole) {
        std::map<std::string, std::array<std::vector<Step>, 2>> alike;
        for (const std::size_t k : {0U, 1U})
            for (const Step step : charts_[k]->steps.ids())
                if (!of_[k][step.index].valid()) alike[looks(k, step, whole)][k].push_back(step);
        bool found = false;
        for (const auto& [text, steps] : alike) {
            if (steps[0].size() != 1 || steps[1].size() != 1) continue;
            pair(steps[0].front(), steps[1].front());
            found = true;
        }
        return found;
    }

    std::array<const Chart*, 2> charts_;
    std::array<std::vector<Step>, 2> of_ = {};
};

class Difference {
public:
    Difference(const Chart& a, const Chart& b) : charts_{&a, &b}, matching_(a, b) {}

    std::vector<ChartChange> changes() && {
        add_variables();
        add_lists("constraint", constraints(0), constraints(1));
        add_steps();
        add_transitions();
        return std::move(changes_);
    }

private:
    void add(Kind kind, std::string subject, std::string before, std::string after) {
        changes_.push_back({kind, std::move(subject), std::move(before), std::move(after)});
    }

    /// Returns a printer for elements of chart `k` with the step names of this chart.
    Wording own(std::size_t k) const {
        return {*charts_[k], [chart = charts_[k]](Step step) { return name_of(*chart, step).text(); }};
    }
    /// Returns a printer for elements of chart `k` with the step names of the first chart, for comparison.
    Wording common(std::size_t k) const {
        return {*charts_[k], [this, k](Step step) { return matching_.common_name(k, step); }};
    }

    static std::string word(Chart::VariableKind kind) {
        return kind == Chart::VariableKind::Input    ? "input"
               : kind == Chart::VariableKind::Output ? "output"
                                                     : "internal";
    }

    void add_variables() {
        std::map<std::string, const Chart::Variable*> there;
        for (const Chart::Variable& variable : charts_[1]->variables) there.emplace(variable.name, &variable);
        for (const Chart::Variable& variable : charts_[0]->variables) {
            const auto found = there.find(variable.name);
            const std::string before = own(0).variable(variable);
            if (found == there.end()) {
                add(Kind::Removed, word(variable.kind) + " " + variable.name, before, {});
                continue;
            }
            const Chart::Variable& now = *found->second;
            const std::string after = own(1).variable(now);
            if (before != after || now.kind != variable.kind)
                add(Kind::Changed, word(variable.kind) + " " + variable.name, word(variable.kind) + " " + before,
                    word(now.kind) + " " + after);
            there.erase(found);
        }
        for (const Chart::Variable& variable : charts_[1]->variables)
            if (there.contains(variable.name))
                add(Kind::Added, word(variable.kind) + " " + variable.name, {}, own(1).variable(variable));
    }

    struct Line {
        std::string common = {}, own = {};
    };
    std::vector<Line> constraints(std::size_t k) const {
        std::vector<Line> lines;
        for (const Chart::Constraint& constraint : charts_[k]->constraints)
            lines.push_back({common(k).term(constraint.condition), own(k).term(constraint.condition)});
        return lines;
    }
    std::vector<Line> actions(std::size_t k, Step step) const {
        const std::vector<std::string> common_texts = common(k).actions(step), own_texts = own(k).actions(step);
        std::vector<Line> lines;
        for (std::size_t i = 0; i < own_texts.size(); ++i) lines.push_back({common_texts[i], own_texts[i]});
        return lines;
    }

    /// Reports the entries that only one of the two lists contains. If an entry of `before` and an entry of `after`
    /// begin with the same word, they are reported as one changed entry.
    void add_lists(const std::string& subject, std::vector<Line> before, std::vector<Line> after) {
        for (auto line = before.begin(); line != before.end();) {
            const auto same = std::ranges::find(after, line->common, &Line::common);
            if (same == after.end()) ++line;
            else after.erase(same), line = before.erase(line);
        }
        const auto first_word = [](const Line& line) { return line.common.substr(0, line.common.find(' ')); };
        for (const Line& line : before) {
            const auto changed = std::ranges::find(after, first_word(line), first_word);
            add(changed == after.end() ? Kind::Removed : Kind::Changed, subject, line.own,
                changed == after.end() ? "" : changed->own);
            if (changed != after.end()) after.erase(changed);
        }
        for (const Line& line : after) add(Kind::Added, subject, {}, line.own);
    }

    std::string step_text(std::size_t k, Step step) const {
        std::string text = own(k).head(step);
        std::string list;
        for (const std::string& action : own(k).actions(step)) list += action + "; ";
        return list.empty() ? text : text + " { " + list + "}";
    }

    void add_steps() {
        for (const Step step : charts_[0]->steps.ids()) {
            const Step counterpart = matching_.counterpart(0, step);
            const std::string name = name_of(*charts_[0], step).text();
            if (!counterpart.valid()) {
                add(Kind::Removed, "step " + name, step_text(0, step), {});
                continue;
            }
            const std::string now = name_of(*charts_[1], counterpart).text();
            if (now != name) add(Kind::Renamed, "step " + name, name, now);
            if (common(0).head(step) != common(1).head(counterpart))
                add(Kind::Changed, "step " + name, own(0).head(step), own(1).head(counterpart));
            add_lists("action of step " + name, actions(0, step), actions(1, counterpart));
        }
        for (const Step step : charts_[1]->steps.ids())
            if (!matching_.counterpart(1, step).valid())
                add(Kind::Added, "step " + name_of(*charts_[1], step).text(), {}, step_text(1, step));
    }

    std::string transition_text(std::size_t k, Transition id) const {
        return own(k).endpoints(id) + ' ' + own(k).guard(id);
    }

    void add_transitions() {
        std::vector<Transition> before, after;
        for (const Transition id : charts_[0]->transitions.ids()) before.push_back(id);
        for (const Transition id : charts_[1]->transitions.ids()) after.push_back(id);
        const Wording a = common(0), b = common(1);
        const auto name = [&](std::size_t k, Transition id) { return charts_[k]->transitions[id].name; };
        using Alike = std::function<bool(Transition, Transition)>;
        const Alike same_name = [&](Transition x, Transition y) { return name(0, x) == name(1, y); };
        const Alike same_endpoints = [&](Transition x, Transition y) { return a.endpoints(x) == b.endpoints(y); };
        const Alike same = [&](Transition x, Transition y) { return same_endpoints(x, y) && a.guard(x) == b.guard(y); };
        const Alike wholly = [&](Transition x, Transition y) { return same_name(x, y) && same(x, y); };
        std::vector<std::pair<Transition, Transition>> changed;
        for (const Alike* alike : {&wholly, &same, &same_name, &same_endpoints})
            for (auto one = before.begin(); one != before.end();) {
                const auto counterpart =
                    std::ranges::find_if(after, [&](Transition other) { return (*alike)(*one, other); });
                if (counterpart == after.end()) {
                    ++one;
                    continue;
                }
                if (!same(*one, *counterpart)) changed.emplace_back(*one, *counterpart);
                after.erase(counterpart);
                one = before.erase(one);
            }
        std::ranges::sort(changed);
        for (const auto& [one, other] : changed)
            add(Kind::Changed, "transition " + name(0, one), transition_text(0, one), transition_text(1, other));
        for (const Transition id : before) add(Kind::Removed, "transition " + name(0, id), transition_text(0, id), {});
        for (const Transition id : after) add(Kind::Added, "transition " + name(1, id), {}, transition_text(1, id));
    }

    std::array<const Chart*, 2> charts_;
    StepMatching matching_;
    std::vector<ChartChange> changes_ = {};
};

}  // namespace

std::vector<ChartChange> difference(const Chart& a, const Chart& b) { return Difference(a, b).changes(); }

}  // namespace grafverif
