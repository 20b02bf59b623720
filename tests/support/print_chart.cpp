// SPDX-License-Identifier: MIT
// Converts a chart to a tree: the declarations, the steps and transitions of the unnamed partial chart, and then the
// other partial charts.
#include <string>
#include <unordered_map>
#include <vector>

#include "support/model_trees.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

namespace {

class ChartPrinter {
public:
    ChartPrinter(const Chart& chart, tree::File& file, Trees& trees)
        : chart_(chart), file_(file), trees_(trees), actions_(chart.steps.size()), clearing_(chart.transitions.size()) {
        for (const Chart::Step& step : chart.steps) ++namesakes_[step.name];
    }

    tree::Chart print() {
        tree::Chart printed;
        printed.name = trees_.name(chart_.name);
        printed.where = trees_.next();
        variables(printed.items);
        collect_actions();
        const bool unnamed =
            !chart_.partial_charts.empty() && chart_.partial_charts[Id<Chart::PartialChart>{0}].name.empty();
        if (unnamed) body(Id<Chart::PartialChart>{0}, printed.items);
        for (const Id<Chart::PartialChart> id : chart_.partial_charts.ids())
            if (!chart_.partial_charts[id].name.empty()) printed.items.emplace_back(partial(id));
        trees_.end(printed.where);
        return printed;
    }

private:
    // -- declarations ------------------------------------------------------------------------------------------------

    tree::Variable variable(const Chart::Variable& declared) {
        tree::Variable written;
        written.name = trees_.name(declared.name);
        if (!declared.type.boolean) {
            written.type = tree::TypeWord::Int;
            written.range = tree::Range{trees_.number(declared.type.low), trees_.number(declared.type.high)};
        }
        if (declared.kind != Chart::VariableKind::Internal) return written;
        if (!declared.type.boolean) written.value = trees_.number(declared.initial);
        else if (declared.initial != 0) written.value = trees_.node(tree::Op::True, {});
        return written;
    }

    /// Declares successive Boolean variables of one kind on one line, and each integer variable on a separate line.
    void variables(std::vector<tree::ChartItem>& items) {
        const Chart::Variable* last = nullptr;
        for (const Chart::Variable& declared : chart_.variables) {
            const bool joins = last != nullptr && last->kind == declared.kind && last->type.boolean &&
                               declared.type.boolean && declared.kind != Chart::VariableKind::Internal;
            if (!joins) {
                const auto kind = declared.kind == Chart::VariableKind::Input    ? tree::VariableKind::Input
                                  : declared.kind == Chart::VariableKind::Output ? tree::VariableKind::Output
                                                                                 : tree::VariableKind::Internal;
                items.emplace_back(tree::Variables{kind, {}, trees_.next()});
            }
            std::get<tree::Variables>(items.back()).variables.push_back(variable(declared));
            last = &declared;
        }
        for (const Chart::Constraint& constraint : chart_.constraints) {
            const Span where = trees_.next();
            items.emplace_back(tree::Constraint{expression(constraint.condition, {}), where});
        }
        for (const Chart::Acceptance& accepted : chart_.accepted)
            items.emplace_back(tree::Accept{accepted.code, accepted.subject, accepted.reason, trees_.next()});
    }

    // -- conditions ---------------------------------------------------------------------------------------------------

    /// Returns the step variable, such as `X2`, with the name of its partial chart if the plain name does not refer to
    /// this step.
    Id<tree::Expr> step_variable_in(Id<Chart::Step> id, Id<Chart::PartialChart> here) {
        const Chart::Step& step = chart_.steps[id];
        if (step.chart == here || namesakes_.at(step.name) == 1) return trees_.path("X" + step.name);
        const std::string& partial = chart_.partial_charts[step.chart].name;
        return trees_.path((partial.empty() ? chart_.name : partial) + ".X" + step.name);
    }

    Id<tree::Expr> time(const Chart::TimeCondition& written, Id<Chart::PartialChart> here) {
        Id<tree::Expr> watched = expression(written.watched, here);
        file_.exprs[watched].bracketed = true;
        if (written.rise_ms > 0) watched = trees_.node(tree::Op::Divide, {trees_.duration(written.rise_ms), watched});
        if (written.fall_ms > 0) watched = trees_.node(tree::Op::Divide, {watched, trees_.duration(written.fall_ms)});
        return watched;
    }

    Id<tree::Expr> expression(Id<Expr> root, Id<Chart::PartialChart> here) {
        return trees_.expression(chart_.exprs, root, [&](const Expr& leaf) {
            const auto index = static_cast<std::uint32_t>(leaf.value);
            if (leaf.op == Op::Step) return step_variable_in(Id<Chart::Step>{index}, here);
            if (leaf.op == Op::Timed) return time(chart_.time_conditions[Id<Chart::TimeCondition>{index}], here);
            return trees_.path(chart_.variables[Id<Chart::Variable>{index}].name);
        });
    }

    // -- actions ------------------------------------------------------------------------------------------------------

    tree::Assignment assignment(const Chart::StoredAction& action, Id<Chart::PartialChart> here) {
        return {trees_.name(chart_.variables[action.target].name), expression(action.value, here), {}};
    }

    void collect_actions() {
        for (const Chart::ContinuousAction& action : chart_.continuous) {
            tree::ContinuousAction written;
            written.output = trees_.name(chart_.variables[action.output].name);
            if (!is_true(chart_.exprs, action.condition))
                written.condition = expression(action.condition, chart_.steps[action.step].chart);
            if (action.delay_ms > 0) written.delay = trees_.duration(action.delay_ms);
            if (action.limit_ms > 0) written.limit = trees_.duration(action.limit_ms);
            actions_[action.step.index].emplace_back(written);
        }
        for (const Chart::StoredAction& action : chart_.stored) {
            if (action.on == Chart::StoredOn::Clearing) {
                clearing_[action.transition.index].push_back(
                    assignment(action, chart_.transitions[action.transition].chart));
                continue;
            }
            const Id<Chart::PartialChart> here = chart_.steps[action.step].chart;
            tree::StoredAction written;
            written.assignment = assignment(action, here);
            written.when = action.on == Chart::StoredOn::Activation     ? tree::StoredWhen::Activation
                           : action.on == Chart::StoredOn::Deactivation ? tree::StoredWhen::Deactivation
                                                                        : tree::StoredWhen::Event;
            if (action.event.valid()) written.event = expression(action.event, here);
            actions_[action.step.index].emplace_back(written);
        }
        for (const Chart::ForcingOrder& order : chart_.forcing) {
            tree::ForcingOrder written;
            written.chart = trees_.name(chart_.partial_charts[order.forced].name);
            written.to = order.to == Chart::ForcedTo::Empty     ? tree::ForcedTo::Empty
                         : order.to == Chart::ForcedTo::Current ? tree::ForcedTo::Current
                         : order.to == Chart::ForcedTo::Initial ? tree::ForcedTo::Initial
                                                                : tree::ForcedTo::Steps;
            for (const Id<Chart::Step> step : order.situation)
                written.steps.push_back(trees_.name(chart_.steps[step].name));
            actions_[order.step.index].emplace_back(written);
        }
        for (const Id<Chart::PartialChart> id : chart_.partial_charts.ids())
            if (chart_.partial_charts[id].owner.valid()) owned_[chart_.partial_charts[id].owner.index].push_back(id);
    }

    // -- steps and transitions ----------------------------------------------------------------------------------------

    tree::Step step(Id<Chart::Step> id, bool first) {
        const Chart::Step& declared = chart_.steps[id];
        tree::Step written;
        written.where = trees_.next(first);
        written.initial = declared.initial;
        written.linked = declared.activation_link;
        written.entry = declared.entry;
        written.exit = declared.exit;
        written.name = trees_.name(declared.name);
        if (declared.kind == Chart::StepKind::Macro) written.kind = tree::StepKind::Macro;
        if (declared.kind == Chart::StepKind::Enclosing) written.kind = tree::StepKind::Enclosing;
        const auto owned = owned_.find(id.index);
        if (owned != owned_.end())
            for (const Id<Chart::PartialChart> partial : owned->second)
                written.contents.push_back(trees_.name(chart_.partial_charts[partial].name));
        written.actions = std::move(actions_[id.index]);
        for (tree::Action& action : written.actions)
            std::visit([this](auto& one) { one.where = trees_.next(); }, action);
        trees_.end(written.where);
        return written;
    }

    tree::Transition transition(Id<Chart::Transition> id, bool first) {
        const Chart::Transition& declared = chart_.transitions[id];
        tree::Transition written;
        written.where = trees_.next(first);
        written.name = trees_.name(declared.name);
        for (const Id<Chart::Step> from : declared.from) written.from.push_back(trees_.name(chart_.steps[from].name));
        for (const Id<Chart::Step> to : declared.to) written.to.push_back(trees_.name(chart_.steps[to].name));
        written.condition = expression(declared.condition, declared.chart);
        written.assignments = std::move(clearing_[id.index]);
        return written;
    }

    /// Computes the steps and transitions of each partial chart once.
    void sort_into_partials() {
        steps_.resize(chart_.partial_charts.size());
        transitions_.resize(chart_.partial_charts.size());
        for (const Id<Chart::Step> id : chart_.steps.ids()) steps_[chart_.steps[id].chart.index].push_back(id);
        for (const Id<Chart::Transition> id : chart_.transitions.ids())
            transitions_[chart_.transitions[id].chart.index].push_back(id);
    }

    void body(Id<Chart::PartialChart> partial, std::vector<tree::ChartItem>& items) {
        if (steps_.empty()) sort_into_partials();
        bool first = true;
        for (const Id<Chart::Step> id : steps_[partial.index])
            items.emplace_back(step(id, std::exchange(first, false)));
        first = true;
        for (const Id<Chart::Transition> id : transitions_[partial.index])
            items.emplace_back(transition(id, std::exchange(first, false)));
    }

    tree::Partial partial(Id<Chart::PartialChart> id) {
        const Chart::PartialChart& declared = chart_.partial_charts[id];
        tree::Partial written;
        written.kind =
            declared.kind == Chart::PartialKind::Expansion ? tree::PartialKind::Expansion : tree::PartialKind::Partial;
        written.name = trees_.name(declared.name);
        written.where = trees_.next(true);
        body(id, written.items);
        trees_.end(written.where);
        return written;
    }

    const Chart& chart_;
    tree::File& file_;
    Trees& trees_;
    std::unordered_map<std::string, std::size_t> namesakes_ = {};
    std::vector<std::vector<tree::Action>> actions_;
    std::vector<std::vector<tree::Assignment>> clearing_;
    std::unordered_map<std::uint32_t, std::vector<Id<Chart::PartialChart>>> owned_ = {};
    std::vector<std::vector<Id<Chart::Step>>> steps_ = {};
    std::vector<std::vector<Id<Chart::Transition>>> transitions_ = {};
};

}  // namespace

tree::Chart tree_of(const Chart& chart, tree::File& file, Trees& trees) {
    return ChartPrinter(chart, file, trees).print();
}

}  // namespace grafverif
