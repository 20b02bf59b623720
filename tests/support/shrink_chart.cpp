// SPDX-License-Identifier: MIT
// Rebuilds a chart without one element, or with one condition replaced by one of its operands. If the test still fails
// for the result, the result replaces the chart. The reductions are repeated until a complete round changes nothing.
#include <array>
#include <ostream>
#include <sstream>
#include <utility>

#include "support/random_chart.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

/// The elements that the copy omits, and the replacements of conditions, which are terms of the original.
struct Cut {
    std::vector<bool> steps = {}, transitions = {}, continuous = {}, stored = {}, forcing = {};
    /// Replacements by index. The replacement of an event is used only for an action that has an
    /// event.
    std::vector<Id<Expr>> conditions = {}, assignations = {}, values = {}, events = {};
};

Cut no_cut(const Chart& chart) {
    Cut cut{std::vector<bool>(chart.steps.size()),
            std::vector<bool>(chart.transitions.size()),
            std::vector<bool>(chart.continuous.size()),
            std::vector<bool>(chart.stored.size()),
            std::vector<bool>(chart.forcing.size()),
            {},
            {},
            {},
            {}};
    for (const Chart::Transition& transition : chart.transitions) cut.conditions.push_back(transition.condition);
    for (const Chart::ContinuousAction& action : chart.continuous) cut.assignations.push_back(action.condition);
    for (const Chart::StoredAction& action : chart.stored) cut.values.push_back(action.value);
    for (const Chart::StoredAction& action : chart.stored) cut.events.push_back(action.event);
    return cut;
}

struct Copy {
    const Chart& from;
    const Cut& cut;
    Chart to = {};
    std::vector<Id<Chart::Step>> steps = {};
    std::vector<Id<Chart::Transition>> transitions = {};

    Id<Expr> term(Id<Expr> root) {
        return translate(from.exprs, root, to.exprs, [&](const Expr& leaf) {
            const auto index = static_cast<std::uint32_t>(leaf.value);
            if (leaf.op == Op::Variable) return to.exprs.leaf(Op::Variable, index);
            if (leaf.op == Op::Step) return step_leaf(index);
            Chart::TimeCondition timed = from.time_conditions[Id<Chart::TimeCondition>{index}];
            timed.watched = term(timed.watched);
            if (is_false(to.exprs, timed.watched)) return timed.watched;
            for (const auto id : to.time_conditions.ids())
                if (to.time_conditions[id] == timed) return to.exprs.leaf(Op::Timed, id.index);
            return to.exprs.leaf(Op::Timed, to.time_conditions.add(timed).index);
        });
    }

    Id<Expr> step_leaf(std::uint32_t index) {
        return steps[index].valid() ? to.exprs.leaf(Op::Step, steps[index].index) : to.exprs.constant(false);
    }

    std::vector<Id<Chart::Step>> kept(const std::vector<Id<Chart::Step>>& old) const {
        std::vector<Id<Chart::Step>> result;
        for (const Id<Chart::Step> step : old)
            if (steps[step.index].valid()) result.push_back(steps[step.index]);
        return result;
    }

    /// Adjusts the hierarchy. A chart without its owner becomes a plain chart, and a macro-step is removed before the
    /// entry and exit of its expansion.
    void hierarchy() {
        for (Chart::PartialChart& partial : to.partial_charts) {
            if (!partial.owner.valid()) continue;
            partial.owner = steps[partial.owner.index];
            if (!partial.owner.valid()) partial.kind = Chart::PartialKind::Plain;
        }
        for (Chart::Step& step : to.steps) {
            const Chart::PartialKind kind = to.partial_charts[step.chart].kind;
            step.entry = step.entry && kind == Chart::PartialKind::Expansion;
            step.exit = step.exit && kind == Chart::PartialKind::Expansion;
            step.activation_link = step.activation_link && kind == Chart::PartialKind::Enclosed;
        }
        for (const Id<Chart::ForcingOrder> id : from.forcing.ids()) {
            Chart::ForcingOrder order = from.forcing[id];
            order.step = steps[order.step.index];
            order.situation = kept(order.situation);
            if (!cut.forcing[id.index] && order.step.valid()) to.forcing.add(order);
        }
    }

    void run() {
        to.name = from.name;
        to.variables = from.variables;
        to.partial_charts = from.partial_charts;
        for (const Id<Chart::Step> id : from.steps.ids())
            steps.push_back(cut.steps[id.index] ? Id<Chart::Step>{} : to.steps.add(from.steps[id]));
        hierarchy();
        for (const Id<Chart::Transition> id : from.transitions.ids()) {
            Chart::Transition transition = from.transitions[id];
            transition.from = kept(transition.from);
            transition.to = kept(transition.to);
            transitions.emplace_back();
            if (cut.transitions[id.index] || (transition.from.empty() && transition.to.empty())) continue;
            transition.condition = term(cut.conditions[id.index]);
            transitions.back() = to.transitions.add(transition);
        }
        for (const auto id : from.continuous.ids()) {
            Chart::ContinuousAction action = from.continuous[id];
            if (cut.continuous[id.index] || !steps[action.step.index].valid()) continue;
            action.step = steps[action.step.index];
            action.condition = term(cut.assignations[id.index]);
            to.continuous.add(action);
        }
        for (const auto id : from.stored.ids()) {
            Chart::StoredAction action = from.stored[id];
            if (cut.stored[id.index]) continue;
            if (action.on == Chart::StoredOn::Clearing) action.transition = transitions[action.transition.index];
            else action.step = steps[action.step.index];
            if (!action.step.valid() && !action.transition.valid()) continue;
            action.value = term(cut.values[id.index]);
            if (action.event.valid()) action.event = term(cut.events[id.index]);
            to.stored.add(action);
        }
    }
};

Chart without(const Chart& chart, const Cut& cut) {
    Copy copy{chart, cut};
    copy.run();
    return std::move(copy.to);
}

/// Returns each reduction that removes one element.
std::vector<Cut> element_cuts(const Chart& chart) {
    std::vector<Cut> cuts;
    const Cut none = no_cut(chart);
    const auto drop = [&](auto member) {
        for (std::size_t k = 0; k < (none.*member).size(); ++k) {
            cuts.push_back(none);
            (cuts.back().*member)[k] = true;
        }
    };
    drop(&Cut::steps);
    std::erase_if(cuts, [&](const Cut& cut) {
        for (const Id<Chart::Step> step : chart.steps.ids())
            if (cut.steps[step.index] && (chart.steps[step].entry || chart.steps[step].exit)) return true;
        return false;
    });
    drop(&Cut::transitions);
    drop(&Cut::continuous);
    drop(&Cut::stored);
    drop(&Cut::forcing);
    return cuts;
}

/// Returns each reduction that replaces one condition or value by one of its operands of the same type.
std::vector<Cut> term_cuts(const Chart& chart) {
    std::vector<Cut> cuts;
    const Cut none = no_cut(chart);
    const auto replace = [&](auto member) {
        for (std::size_t k = 0; k < (none.*member).size(); ++k) {
            if (!(none.*member)[k].valid()) continue;
            const Op op = chart.exprs[(none.*member)[k]].op;
            if (op != Op::Rise && op != Op::Fall && op != Op::Not && op != Op::And && op != Op::Or &&
                !is_arithmetic(op))
                continue;
            for (const Id<Expr> operand : chart.exprs.operands((none.*member)[k])) {
                cuts.push_back(none);
                (cuts.back().*member)[k] = operand;
            }
        }
    };
    replace(&Cut::conditions);
    replace(&Cut::assignations);
    replace(&Cut::values);
    return cuts;
}

}  // namespace

Chart tidied(const Chart& chart) { return without(chart, no_cut(chart)); }

Chart shrunk(Chart chart, const std::function<bool(const Chart&)>& fails) {
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto cuts : {element_cuts, term_cuts})
            for (const Cut& cut : cuts(chart)) {
                Chart smaller = without(chart, cut);
                if (!fails(smaller)) continue;
                chart = std::move(smaller);
                changed = true;
                break;
            }
    }
    return chart;
}

namespace {

std::string qualified(const Chart& chart, Id<Chart::Step> step, const std::string& prefix) {
    const std::string& partial = chart.partial_charts[chart.steps[step].chart].name;
    return (partial.empty() ? "" : partial + ".") + prefix + chart.steps[step].name;
}

struct Text {
    std::ostream& out;
    const Chart& chart;

    std::string term(Id<Expr> root) const {
        return expr_text(chart.exprs, root, chart_spelling, [this](std::ostream& stream, const Expr& leaf) {
            const auto index = static_cast<std::uint32_t>(leaf.value);
            if (leaf.op == Op::Variable) {
                stream << chart.variables[Id<Chart::Variable>{index}].name;
                return;
            }
            if (leaf.op == Op::Step) {
                stream << qualified(chart, Id<Chart::Step>{index}, "X");
                return;
            }
            const Chart::TimeCondition& timed = chart.time_conditions[Id<Chart::TimeCondition>{index}];
            const bool bare = chart.exprs[timed.watched].op == Op::Step;
            if (timed.rise_ms > 0) stream << duration_text(timed.rise_ms) << '/';
            stream << (bare ? "" : "(") << term(timed.watched) << (bare ? "" : ")");
            if (timed.fall_ms > 0) stream << '/' << duration_text(timed.fall_ms);
        });
    }

    void names(const std::vector<Id<Chart::Step>>& steps) const {
        for (std::size_t k = 0; k < steps.size(); ++k) out << (k > 0 ? ", " : "") << chart.steps[steps[k]].name;
    }

    void variables() const {
        static constexpr std::array kinds{"input ", "output ", "internal "};
        for (const Chart::Variable& variable : chart.variables) {
            out << "    " << kinds[static_cast<std::size_t>(variable.kind)] << variable.name;
            if (!variable.type.boolean) out << ": int " << variable.type.low << ".." << variable.type.high;
            if (variable.kind == Chart::VariableKind::Internal)
                out << " = "
                    << (!variable.type.boolean  ? std::to_string(variable.initial)
                        : variable.initial != 0 ? "true"
                                                : "false");
            out << ";\n";
        }
    }

    std::string assignment(const Chart::StoredAction& action) const {
        return chart.variables[action.target].name + " := " + term(action.value);
    }

    void clearing(Id<Chart::Transition> id) const {
        const char* before = " do ";
        for (const Chart::StoredAction& action : chart.stored)
            if (action.on == Chart::StoredOn::Clearing && action.transition == id)
                out << std::exchange(before, ", ") << assignment(action);
    }

    void step(Id<Chart::Step> id) const {
        const Chart::Step& step = chart.steps[id];
        out << "    " << (step.initial ? "initial " : "") << (step.activation_link ? "linked " : "")
            << (step.entry ? "entry " : "") << (step.exit ? "exit " : "");
        if (step.kind == Chart::StepKind::Macro) out << "macro ";
        if (step.kind == Chart::StepKind::Enclosing) out << "enclosing ";
        out << "step " << step.name;
        for (const Chart::PartialChart& partial : chart.partial_charts)
            if (partial.owner == id)
                out << (step.kind == Chart::StepKind::Macro ? " expands " : " encloses ") << partial.name;
        out << " {";
        for (const Chart::ContinuousAction& action : chart.continuous)
            if (action.step == id) {
                out << ' ' << chart.variables[action.output].name;
                if (!is_true(chart.exprs, action.condition)) out << " if " << term(action.condition);
                if (action.delay_ms > 0) out << " after " << duration_text(action.delay_ms);
                if (action.limit_ms > 0) out << " for " << duration_text(action.limit_ms);
                out << ';';
            }
        for (const Chart::StoredAction& action : chart.stored) {
            if (action.step != id) continue;
            out << ' ' << assignment(action) << " on ";
            if (action.on == Chart::StoredOn::Event) out << "event " << term(action.event) << ';';
            else out << (action.on == Chart::StoredOn::Activation ? "activation;" : "deactivation;");
        }
        for (const Chart::ForcingOrder& order : chart.forcing)
            if (order.step == id) force(order);
        out << " }\n";
    }

    void force(const Chart::ForcingOrder& order) const {
        out << " force " << chart.partial_charts[order.forced].name << " := {";
        if (order.to == Chart::ForcedTo::Current) out << '*';
        if (order.to == Chart::ForcedTo::Initial) out << "INIT";
        names(order.situation);
        out << "};";
    }

    void partial(Id<Chart::PartialChart> partial) const {
        const std::string& name = chart.partial_charts[partial].name;
        const bool expansion = chart.partial_charts[partial].kind == Chart::PartialKind::Expansion;
        if (!name.empty()) out << (expansion ? "    expansion " : "    partial ") << name << " {\n";
        for (const Id<Chart::Step> id : chart.steps.ids())
            if (chart.steps[id].chart == partial) step(id);
        for (const Id<Chart::Transition> id : chart.transitions.ids()) {
            const Chart::Transition& transition = chart.transitions[id];
            if (transition.chart != partial) continue;
            out << "    transition " << transition.name << ": ";
            names(transition.from);
            out << " -> ";
            names(transition.to);
            out << " when " << term(transition.condition);
            clearing(id);
            out << ";\n";
        }
        if (!name.empty()) out << "    }\n";
    }
};

}  // namespace

std::string chart_text(const Chart& chart) {
    std::ostringstream out;
    const Text text{out, chart};
    out << "grafcet " << chart.name << " {\n";
    text.variables();
    for (const Id<Chart::PartialChart> partial : chart.partial_charts.ids()) text.partial(partial);
    out << "}\n";
    return out.str();
}

}  // namespace grafverif
