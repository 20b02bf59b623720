// SPDX-License-Identifier: MIT
#include "compare/mutants.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <utility>

#include "syntax/language/format.hpp"
#include "syntax/language/format_items.hpp"

namespace grafverif {

namespace {

using Items = std::vector<tree::ChartItem>;

/// Collects the lists of items of a chart, of its partial charts and of its replications, at any depth.
void collect_lists(Items& items, std::vector<Items*>& lists) {
    lists.push_back(&items);
    for (tree::ChartItem& item : items)
        if (auto* partial = std::get_if<tree::Partial>(&item)) collect_lists(partial->items, lists);
        else if (auto* copies = std::get_if<tree::ReplicatedChartItems>(&item)) collect_lists(copies->items, lists);
}

/// The position of an item, or of an action of a step, in the lists of a chart. The position denotes the same item in
/// every copy of the file.
struct At {
    std::size_t list = 0, item = 0, action = 0;
};

class Maker {
public:
    Maker(const tree::File& file, std::string_view chart) : file_(file), chart_(chart), original_(formatted(file)) {}

    std::vector<Mutant> make() && {
        tree::File file = file_;
        const std::vector<Items*> lists = lists_of(file);
        for (std::size_t list = 0; list < lists.size(); ++list)
            for (std::size_t item = 0; item < lists[list]->size(); ++item) {
                const tree::ChartItem& written = (*lists[list])[item];
                if (const auto* step = std::get_if<tree::Step>(&written))
                    change_step({list, item}, *step, *lists[list]);
                if (const auto* transition = std::get_if<tree::Transition>(&written))
                    change_transition({list, item}, *transition, *lists[list]);
            }
        return std::move(mutants_);
    }

private:
    std::vector<Items*> lists_of(tree::File& file) const {
        std::vector<Items*> lists;
        for (tree::Declaration& declaration : file.declarations)
            if (auto* chart = std::get_if<tree::Chart>(&declaration); chart && file.text(chart->name) == chart_)
                collect_lists(chart->items, lists);
        return lists;
    }

    static std::string one_line(const Lines& lines) {
        std::string text;
        for (const std::string& line : lines)
            text += (text.empty() ? "" : " ") + line.substr(line.find_first_not_of(' '));
        return text;
    }
    static std::string text_of(const tree::File& file, const tree::ChartItem& item) {
        if (const auto* transition = std::get_if<tree::Transition>(&item))
            return one_line(item_lines(file, *transition, 0));
        const auto& step = std::get<tree::Step>(item);
        std::string text = step_head(file, step);
        if (step.actions.empty()) return text + ";";
        text += " {";
        for (const tree::Action& action : step.actions)
            text +=
                ' ' + std::visit([&](const auto& written) { return one_line(item_lines(file, written, 0)); }, action);
        return text + " }";
    }
    static std::string subject_of(const tree::File& file, const tree::ChartItem& item) {
        if (const auto* step = std::get_if<tree::Step>(&item)) return "step " + formatted(file, step->name);
        const auto& transition = std::get<tree::Transition>(item);
        if (transition.name.valid()) return "transition " + formatted(file, transition.name);
        return "transition " +
               one_line(item_lines(file, tree::Transition{.from = transition.from, .to = transition.to}, 0))
                   .substr(std::string("transition ").size());
    }

    /// Adds a mutant if its text differs from the original and from all other mutants. The mutant is a copy of the file
    /// in which `change` is applied to the item at `at` and to the list that contains this item.
    template <class Change>
    void add(const char* kind, At at, const Change& change) {
        tree::File file = file_;
        Items& list = *lists_of(file)[at.list];
        tree::ChartItem& item = list[at.item];
        Mutant made{.kind = kind, .subject = subject_of(file, item), .before = text_of(file, item)};
        std::visit([&](const auto& written) { made.where = written.where; }, item);
        const std::size_t count = list.size();
        change(file, list, item);
        made.after = text_of(file, list[at.item]);
        if (list.size() > count) made.after += ' ' + text_of(file, list[at.item + 1]);
        made.text = formatted(file);
        if (made.text != original_ && texts_.insert(made.text).second) mutants_.push_back(std::move(made));
    }

    // -- terms --------------------------------------------------------------------------------------------------------

    /// Overwrites the node at `place`. The operands that follow this node in its parent do not change.
    static void put(tree::File& file, Id<tree::Expr> place, tree::Expr node) {
        node.next = file.exprs[place].next;
        file.exprs[place] = node;
    }
    static void negate(tree::File& file, Id<tree::Expr> place) {
        if (file.exprs[place].op == tree::Op::Not) return put(file, place, file.exprs[file.exprs[place].first]);
        tree::Expr inner = file.exprs[place];
        inner.next = {};
        tree::Expr outer{.op = tree::Op::Not, .where = inner.where};
        outer.depth = static_cast<std::uint16_t>(inner.depth + 1);
        outer.first = outer.last = file.exprs.add(inner);
        put(file, place, outer);
    }
    static std::vector<Id<tree::Expr>> operands(const tree::File& file, Id<tree::Expr> place) {
        std::vector<Id<tree::Expr>> found;
        for (Id<tree::Expr> each = file.exprs[place].first; each.valid(); each = file.exprs[each].next)
            found.push_back(each);
        return found;
    }
    /// Removes an operand of the node at `place`. If only one operand remains, this operand replaces the node.
    static void drop(tree::File& file, Id<tree::Expr> place, std::size_t operand) {
        std::vector<Id<tree::Expr>> left = operands(file, place);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(operand));
        if (left.size() == 1) return put(file, place, file.exprs[left.front()]);
        file.exprs[place].first = left.front();
        file.exprs[place].last = left.back();
        for (std::size_t k = 0; k < left.size(); ++k)
            file.exprs[left[k]].next = k + 1 < left.size() ? left[k + 1] : Id<tree::Expr>{};
    }

    /// Adds the mutants of a Boolean term. The operands of edges, of time conditions and of comparisons do not
    /// change, except for durations.
    void change_condition(At at, Id<tree::Expr> term) {
        if (!term.valid()) return;
        add("term-negated", at, [term](tree::File& file, Items&, tree::ChartItem&) { negate(file, term); });
        change_operators(at, term);
        change_durations(at, term);
    }
    void change_operators(At at, Id<tree::Expr> term) {
        const tree::Expr& node = file_.exprs[term];
        if (node.op != tree::Op::And && node.op != tree::Op::Or && node.op != tree::Op::Not) return;
        const std::vector<Id<tree::Expr>> each = operands(file_, term);
        if (node.op != tree::Op::Not) {
            for (std::size_t k = 0; k < each.size(); ++k) {
                add("term-dropped", at, [term, k](tree::File& file, Items&, tree::ChartItem&) { drop(file, term, k); });
                add("term-negated", at, [&, k](tree::File& file, Items&, tree::ChartItem&) { negate(file, each[k]); });
            }
            add("and-or", at, [term](tree::File& file, Items&, tree::ChartItem&) {
                file.exprs[term].op = file.exprs[term].op == tree::Op::And ? tree::Op::Or : tree::Op::And;
            });
        }
        for (const Id<tree::Expr> operand : each) change_operators(at, operand);
    }
    void change_durations(At at, Id<tree::Expr> term) {
        if (!term.valid()) return;
        if (file_.exprs[term].op == tree::Op::Duration)
            add("duration", at, [term](tree::File& file, Items&, tree::ChartItem&) { file.exprs[term].value *= 2; });
        for (const Id<tree::Expr> operand : operands(file_, term)) change_durations(at, operand);
    }

    // -- transitions --------------------------------------------------------------------------------------------------

    static bool same_names(const tree::File& file, const std::vector<tree::Name>& one,
                           const std::vector<tree::Name>& other) {
        return std::ranges::equal(one, other, [&](tree::Name a, tree::Name b) { return file.text(a) == file.text(b); });
    }

    void change_transition(At at, const tree::Transition& transition, const Items& list) {
        change_condition(at, transition.condition);
        for (std::size_t k = 0; k < transition.to.size(); ++k) change_successor(at, transition, k, list);
        if (transition.to.size() > 1)
            add("and-divergence", at, [&](tree::File&, Items& items, tree::ChartItem& item) {
                auto& first = std::get<tree::Transition>(item);
                tree::Transition second = first;
                second.name = {};
                second.to.erase(second.to.begin());
                first.to.resize(1);
                items.insert(items.begin() + static_cast<std::ptrdiff_t>(at.item) + 1, std::move(second));
            });
        for (std::size_t other = at.item + 1; other < list.size(); ++other) {
            const auto* sibling = std::get_if<tree::Transition>(&list[other]);
            if (!sibling || transition.from.empty() || !same_names(file_, sibling->from, transition.from)) continue;
            std::vector<tree::Name> added;
            for (const tree::Name to : sibling->to)
                if (std::ranges::none_of(transition.to, [&](tree::Name known) { return known.word == to.word; }))
                    added.push_back(to);
            if (added.empty()) continue;
            add("or-divergence", at, [added, other](tree::File&, Items& items, tree::ChartItem& item) {
                auto& to = std::get<tree::Transition>(item).to;
                to.insert(to.end(), added.begin(), added.end());
                items.erase(items.begin() + static_cast<std::ptrdiff_t>(other));
            });
        }
    }

    /// Replaces the successor at index `place`. The new successor is the next step, in the cyclic order of the list,
    /// that is not already a successor of the transition.
    void change_successor(At at, const tree::Transition& transition, std::size_t place, const Items& list) {
        std::vector<tree::Name> steps;
        for (const tree::ChartItem& item : list)
            if (const auto* step = std::get_if<tree::Step>(&item)) steps.push_back(step->name);
        const auto is = [&](tree::Name name) {
            return [&, name](tree::Name each) { return file_.text(each) == file_.text(name); };
        };
        const auto here = std::ranges::find_if(steps, is(transition.to[place]));
        if (here == steps.end()) return;
        std::ranges::rotate(steps, here);
        for (std::size_t k = 1; k < steps.size(); ++k) {
            if (std::ranges::any_of(transition.to, is(steps[k]))) continue;
            const tree::Name other = steps[k];
            return add("wrong-successor", at, [place, other](tree::File&, Items&, tree::ChartItem& item) {
                std::get<tree::Transition>(item).to[place] = other;
            });
        }
    }

    // -- steps --------------------------------------------------------------------------------------------------------

    void change_step(At at, const tree::Step& step, const Items& list) {
        const auto initial = [](const tree::ChartItem& item) {
            const auto* other = std::get_if<tree::Step>(&item);
            return other != nullptr && other->initial;
        };
        if (step.initial && std::ranges::count_if(list, initial) > 1)
            add("not-initial", at,
                [](tree::File&, Items&, tree::ChartItem& item) { std::get<tree::Step>(item).initial = false; });
        for (at.action = 0; at.action < step.actions.size(); ++at.action) {
            const tree::Action& action = step.actions[at.action];
            const char* const kind =
                std::holds_alternative<tree::ForcingOrder>(action) ? "forcing-missing" : "action-missing";
            add(kind, at, [at](tree::File&, Items&, tree::ChartItem& item) {
                auto& actions = std::get<tree::Step>(item).actions;
                actions.erase(actions.begin() + static_cast<std::ptrdiff_t>(at.action));
            });
            if (const auto* continuous = std::get_if<tree::ContinuousAction>(&action))
                change_continuous(at, *continuous);
            if (const auto* stored = std::get_if<tree::StoredAction>(&action)) change_stored(at, *stored);
        }
    }

    void change_continuous(At at, const tree::ContinuousAction& action) {
        change_condition(at, action.condition);
        change_durations(at, action.delay);
        change_durations(at, action.limit);
        std::vector<tree::Name> outputs = continuous_outputs();
        const auto here = std::ranges::find_if(
            outputs, [&](tree::Name name) { return file_.text(name) == file_.text(action.output); });
        if (here == outputs.end() || outputs.size() < 2) return;
        std::ranges::rotate(outputs, here);
        add("output-swapped", at, [at, other = outputs[1]](tree::File&, Items&, tree::ChartItem& item) {
            std::get<tree::ContinuousAction>(std::get<tree::Step>(item).actions[at.action]).output = other;
        });
    }

    /// Returns the outputs of continuous actions of the chart, in order of first use.
    std::vector<tree::Name> continuous_outputs() const {
        tree::File file = file_;
        std::vector<tree::Name> found;
        std::set<std::string> known;
        for (const Items* list : lists_of(file))
            for (const tree::ChartItem& item : *list)
                if (const auto* step = std::get_if<tree::Step>(&item))
                    for (const tree::Action& action : step->actions)
                        if (const auto* continuous = std::get_if<tree::ContinuousAction>(&action))
                            if (known.emplace(file.text(continuous->output)).second)
                                found.push_back(continuous->output);
        return found;
    }

    void change_stored(At at, const tree::StoredAction& action) {
        if (action.when != tree::StoredWhen::Activation && action.when != tree::StoredWhen::Deactivation) return;
        add("stored-side", at, [at](tree::File&, Items&, tree::ChartItem& item) {
            tree::StoredWhen& when = std::get<tree::StoredAction>(std::get<tree::Step>(item).actions[at.action]).when;
            when = when == tree::StoredWhen::Activation ? tree::StoredWhen::Deactivation : tree::StoredWhen::Activation;
        });
    }

    const tree::File& file_;
    std::string chart_;
    std::string original_;
    std::set<std::string> texts_ = {};
    std::vector<Mutant> mutants_ = {};
};

}  // namespace

std::vector<Mutant> mutants(const tree::File& file, std::string_view chart) { return Maker(file, chart).make(); }

}  // namespace grafverif
