// SPDX-License-Identifier: MIT
#include "pipeline/variants/supervise_model.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "ir/patterns.hpp"
#include "support/messages_choice.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif {

namespace {

using System = TransitionSystem;

}  // namespace

ModelOptions untimed(const SuperviseRequest& request) {
    ModelOptions how;
    how.mode = request.mode;
    how.grain = Grain::Atomic;
    how.untimed.plant = PlantApproach::Automata;
    how.untimed.schedule = Schedule::Interleaved;
    return how;
}

namespace {

/// Returns, for each variable of the chart, true if the chart reads it. Outputs that the chart reads are not
/// restricted, because their values depend on conditions in earlier evolutions.
std::vector<bool> read_outputs(const Chart& chart) {
    std::vector<bool> read(chart.variables.size());
    for (std::uint32_t index = 0; index < chart.exprs.size(); ++index) {
        const Expr& node = chart.exprs[Id<Expr>{index}];
        if (node.op == Op::Variable) read[static_cast<std::size_t>(node.value)] = true;
    }
    return read;
}

}  // namespace

std::vector<PermittedElement> add_permissions(Model& model, ClosedLoop& loop, Id<ClosedLoop::Controller> controller,
                                              const Chart& written, const SuperviseRequest& request,
                                              UniqueNames& names) {
    Chart& chart = model.charts[loop.controllers[controller].chart];
    const std::vector<bool> read = read_outputs(written);
    std::vector<PermittedElement> held;
    const auto permission = [&](const std::string& subject, bool output) {
        PermittedElement& made = held.emplace_back(PermittedElement{names.fresh("may_" + subject), subject, output});
        const Id<Chart::Variable> variable =
            chart.variables.add({.name = made.permission, .kind = Chart::VariableKind::Input});
        loop.shared.add({.name = made.permission, .reader = controller, .variable = variable});
        return chart.exprs.leaf(Op::Variable, variable.index);
    };
    for (const Id<Chart::Transition> id : chart.transitions.ids()) {
        if (!request.transitions) break;
        Chart::Transition& transition = chart.transitions[id];
        const Id<Expr> may = permission(transition.name, false);
        transition.condition = chart.exprs.conjunction(transition.condition, may);
        held.back().places = {written.transitions[id].origin};
    }
    std::map<std::uint32_t, Id<Expr>> of_output;
    // Each element contains an action without its permission, the index of its output in `held`, and the index of the
    // action in `sets` of this output.
    std::vector<std::tuple<Chart::ContinuousAction, std::size_t, std::size_t>> unrestricted;
    for (const Chart::ContinuousAction& action : chart.continuous)
        if (request.outputs && !read[action.output.index]) of_output.try_emplace(action.output.index);
    for (auto& [output, may] : of_output) {
        may = permission(chart.variables[{output}].name, true);
        std::size_t conditional = 0;
        for (const Id<Chart::ContinuousAction> id : chart.continuous.ids()) {
            Chart::ContinuousAction& action = chart.continuous[id];
            if (action.output.index != output) continue;
            held.back().sets.emplace_back();
            if (!is_true(chart.exprs, action.condition) || action.delay_ms > 0 || action.limit_ms > 0) {
                unrestricted.emplace_back(action, held.size() - 1, held.back().sets.size() - 1);
                ++conditional;
            }
            action.condition = chart.exprs.conjunction(action.condition, may);
            held.back().places.push_back(written.continuous[id].origin);
            held.back().steps.push_back(action.step);
        }
        // If an output has only one action, this action needs no additional output.
        if (held.back().steps.size() == 1 && conditional > 0) unrestricted.pop_back();
    }
    for (auto& [action, subject, site] : unrestricted) {
        const std::string name = held[subject].sets[site] = names.fresh("set_" + held[subject].subject);
        action.output = chart.variables.add({.name = name, .kind = Chart::VariableKind::Output});
        chart.continuous.add(std::move(action));
    }
    return held;
}

ObservableVariables sight_of(System& system, const System::Controller& controller, const ClosedLoop& loop,
                             Id<ClosedLoop::Controller> id) {
    ObservableVariables sight;
    const auto add = [&](const std::string& name, Id<System::Symbol> symbol) {
        if (!system.modules[system.main].symbols[symbol].type.boolean) return;
        sight.names.push_back(name);
        sight.terms.push_back(system.exprs.leaf(Op::Variable, symbol.index));
    };
    for (const auto& input : controller.words.inputs) {
        const auto shared = std::ranges::find(loop.shared, input.name, &ClosedLoop::Shared::name);
        if (shared != loop.shared.end() && shared->writer == id) continue;
        if (!std::holds_alternative<System::ChoiceSymbol>(system.modules[system.main].symbols[input.variable].kind))
            add(input.name, input.variable);
    }
    for (const auto& internal : controller.words.internals) add(internal.name, internal.variable);
    sight.first_step = sight.names.size();
    for (const auto& step : controller.words.steps) add(step.name.variable(), step.variable);
    return sight;
}

Id<Expr> initial_situation(TransitionSystem& system, const Model& model, const ClosedLoop& loop) {
    std::vector<Id<Expr>> terms;
    for (std::size_t index = 0; index < system.controllers.size(); ++index) {
        Diagnostics none;  // remains empty: these equations have been checked before
        const auto equations =
            equations_of(model, loop.controllers[{static_cast<std::uint32_t>(index)}].chart, none).value();
        for (std::size_t step = 0; step < equations.steps.size(); ++step) {
            const auto& words = system.controllers[index].words.steps[step];
            const Id<Expr> active = system.exprs.leaf(Op::Variable, words.variable.index);
            const bool initial = equations.variables[equations.steps[step].variable].initial != 0;
            terms.push_back(initial ? active : system.exprs.negation(active));
        }
    }
    return system.exprs.conjunction(terms);
}

std::optional<std::vector<Id<Property>>> kept(const System& system, const SuperviseRequest& request,
                                              const std::string& marked, Diagnostics& diagnostics) {
    std::vector<Id<Property>> found;
    std::vector<std::string> known;
    for (const Id<Property> id : system.properties.ids()) {
        const Property& property = system.properties[id];
        if (!is_about_all_states(property.pattern) || property.name == marked) continue;
        known.push_back(property.name);
        const bool requested = request.properties.empty()
                                   ? !property.expected_violated
                                   : std::ranges::find(request.properties, property.name) != request.properties.end();
        if (requested || !property.origin.source.valid()) found.push_back(id);
    }
    for (const std::string& name : request.properties)
        if (std::ranges::find(known, name) == known.end()) {
            diagnostics.add(messages::no_such_choice("property about states", name, known, nearest_of(name, known)));
            return {};
        }
    if (known.empty()) {
        diagnostics.add(messages::no_such_choice("property about states", "", known, {}));
        return {};
    }
    return found;
}

Id<Expr> violation(System& system, const Property& property) {
    Exprs& exprs = system.exprs;
    Id<Expr> bad = property.operands[0];
    if (property.pattern == Pattern::Always) bad = exprs.negation(bad);
    if (property.pattern == Pattern::ExactlyOneOf) {
        std::vector<Id<Expr>> ones;
        for (std::size_t i = 0; i < property.operands.size(); ++i) {
            std::vector<Id<Expr>> one;
            for (std::size_t j = 0; j < property.operands.size(); ++j)
                one.push_back(i == j ? property.operands[j] : exprs.negation(property.operands[j]));
            ones.push_back(exprs.conjunction(one));
        }
        bad = exprs.negation(exprs.disjunction(ones));
    }
    return property.at_stable ? exprs.conjunction(system.settled, bad) : bad;
}

}  // namespace grafverif
