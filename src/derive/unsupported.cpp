// SPDX-License-Identifier: MIT
#include "unsupported.hpp"

#include <string>
#include <vector>

#include "grafverif/support/messages.hpp"

namespace grafverif {

namespace {

/// For every term: whether an edge, whether a time condition occurs in it. Children precede parents: one pass.
struct Contents {
    std::vector<bool> edge = {};
    std::vector<bool> timed = {};
};

Contents contents(const Exprs& exprs) {
    Contents result{std::vector<bool>(exprs.size()), std::vector<bool>(exprs.size())};
    for (std::uint32_t index = 0; index < exprs.size(); ++index) {
        const Id<Expr> id{index};
        result.edge[index] = exprs[id].op == Op::Rise || exprs[id].op == Op::Fall;
        result.timed[index] = exprs[id].op == Op::Timed;
        for (const Id<Expr> operand : exprs.operands(id)) {
            if (result.edge[operand.index]) result.edge[index] = true;
            if (result.timed[operand.index]) result.timed[index] = true;
        }
    }
    return result;
}

struct Refusal {
    const Chart& chart;
    Diagnostics& diagnostics;
    Contents holds;

    void refuse(Span where, std::string_view what) const {
        diagnostics.add(messages::unsupported_in_chart(where, what));
    }

    void steps() const {
        for (const Chart::PartialChart& partial : chart.partial_charts) {
            if (partial.kind == Chart::PartialKind::Expansion)
                refuse(partial.origin, "expansion `" + partial.name + "`");
            if (partial.kind == Chart::PartialKind::Enclosed)
                refuse(partial.origin, "enclosed partial chart `" + partial.name + "`");
        }
        for (const Chart::Step& step : chart.steps) {
            if (step.kind == Chart::StepKind::Macro) refuse(step.origin, "macro-step `" + step.name + "`");
            if (step.kind == Chart::StepKind::Enclosing) refuse(step.origin, "enclosing step `" + step.name + "`");
            if (step.activation_link) refuse(step.origin, "activation link of step `" + step.name + "`");
        }
        for (const Chart::ForcingOrder& order : chart.forcing)
            refuse(order.origin, "forcing order on `" + chart.partial_charts[order.forced].name + "`");
    }

    void transitions() const {
        for (const Chart::Transition& transition : chart.transitions)
            if (holds.edge[transition.condition.index])
                refuse(transition.origin, "edge in the condition of transition `" + transition.name + "`");
        for (const Chart::TimeCondition& timed : chart.time_conditions)
            if (timed.fall_ms != 0 || chart.exprs[timed.watched].op != Op::Step)
                refuse(timed.origin, "time condition other than a duration over a step variable (`3s/X2`)");
    }

    void continuous_actions() const {
        for (const Chart::ContinuousAction& action : chart.continuous) {
            const std::string& output = chart.variables[action.output].name;
            if (action.delay_ms != 0) refuse(action.origin, "delayed action on `" + output + "`");
            if (action.limit_ms != 0) refuse(action.origin, "time-limited action on `" + output + "`");
            if (holds.edge[action.condition.index])
                refuse(action.origin, "edge in the assignation condition of `" + output + "`");
            if (holds.timed[action.condition.index])
                refuse(action.origin, "time condition in the assignation condition of `" + output + "`");
        }
    }

    void stored_actions() const {
        for (const Chart::StoredAction& action : chart.stored) {
            const std::string& target = chart.variables[action.target].name;
            if (action.on == Chart::StoredOn::Event) refuse(action.origin, "action on `" + target + "` on an event");
            if (action.on == Chart::StoredOn::Clearing)
                refuse(action.origin, "action on `" + target + "` on clearing a transition");
            if (holds.edge[action.value.index]) refuse(action.origin, "edge in the value stored in `" + target + "`");
            if (holds.timed[action.value.index])
                refuse(action.origin, "time condition in the value stored in `" + target + "`");
        }
    }
};

}  // namespace

bool unsupported(const Chart& chart, Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    const Refusal refusal{chart, diagnostics, contents(chart.exprs)};
    refusal.steps();
    refusal.transitions();
    refusal.continuous_actions();
    refusal.stored_actions();
    return diagnostics.errors() != errors;
}

}  // namespace grafverif
