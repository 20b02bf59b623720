// SPDX-License-Identifier: MIT
// Resolves the transitions of a chart.
#include <unordered_map>
#include <unordered_set>

#include "support/messages.hpp"
#include "support/unique_names.hpp"
#include "syntax/resolve/chart_scope.hpp"
#include "syntax/resolve/expand.hpp"

namespace grafverif {

namespace {

/// Assigns names to transitions: the declared name or, for a transition without a declared name, `t1`, `t2`, ...
/// according to its position.
class TransitionNames {
public:
    explicit TransitionNames(ChartScope& scope, const WrittenChart& written) : scope_(&scope) {
        for (const WrittenTransition& transition : written.transitions)
            if (transition.transition->name.valid()) {
                const std::string name(scope.text(transition.transition->name));
                written_.emplace(name, transition.transition->name.where);
                names_.take(name);
            }
    }

    std::string name(const tree::Transition& written, std::size_t position) {
        if (!written.name.valid()) return names_.fresh("t" + std::to_string(position));
        const std::string_view name = scope_->text(written.name);
        const Span first = written_.at(std::string(name));
        scope_->record.declare(DeclarationKind::Transition, name, written.name.where, written.where,
                               scope_->chart.origin);
        if (!named_.emplace(name).second) scope_->diagnostics.add(duplicate(written.name, "transition", name, first));
        return std::string(name);
    }

private:
    ChartScope* scope_;
    std::unordered_map<std::string, Span> written_ = {};  ///< the first occurrence of each name
    std::unordered_set<std::string_view> named_ = {};
    UniqueNames names_ = {};
};

/// Returns a name that occurs in the transition, and that therefore belongs to the same copy of the
/// declarations as the transition; invalid if the transition contains no name.
tree::Name name_in_copy(const tree::Transition& written) {
    if (written.name.valid()) return written.name;
    if (!written.from.empty()) return written.from.front();
    return written.to.empty() ? tree::Name{} : written.to.front();
}

std::vector<Id<Chart::Step>> side(ChartScope& scope, const std::vector<tree::Name>& labels,
                                  Id<Chart::PartialChart> partial) {
    std::vector<Id<Chart::Step>> steps;
    std::unordered_set<std::uint32_t> seen;
    for (const tree::Name& label : labels) {
        const Id<Chart::Step> step = step_in(scope, partial, label);
        if (!step.valid()) continue;
        if (labels.size() > 1 && !seen.insert(step.index).second) {
            scope.diagnostics.add(messages::step_twice(label.where, scope.text(label)));
            continue;
        }
        steps.push_back(step);
    }
    return steps;
}

}  // namespace

void resolve_transitions(ChartScope& scope, const WrittenChart& written) {
    TransitionNames names(scope, written);
    for (std::size_t i = 0; i < written.transitions.size(); ++i) {
        const auto& [transition, partial] = written.transitions[i];
        const InChartCopy copy(scope, name_in_copy(*transition));
        Chart::Transition resolved;
        resolved.name = names.name(*transition, i + 1);
        resolved.chart = partial;
        resolved.origin = transition->where;
        resolved.from = side(scope, transition->from, partial);
        resolved.to = side(scope, transition->to, partial);
        if (transition->from.empty() && transition->to.empty())
            scope.diagnostics.add(messages::detached_transition(transition->where));
        if (transition->condition.valid())
            resolved.condition = resolve_condition(scope, transition->condition, partial, "a transition");
        else scope.diagnostics.add(messages::missing_condition(transition->where));
        const Id<Chart::Transition> id = scope.chart.transitions.add(std::move(resolved));
        scope.here = partial;
        for (const tree::Assignment& assignment : transition->assignments) {
            Chart::StoredAction action;
            action.on = Chart::StoredOn::Clearing;
            action.transition = id;
            resolve_stored(scope, assignment, action);
        }
    }
}

}  // namespace grafverif
