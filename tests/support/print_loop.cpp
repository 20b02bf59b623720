// SPDX-License-Identifier: MIT
// Converts a closed loop to a tree. Arguments with their default value are written too, because the IR does not
// distinguish them.
#include <cassert>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "support/model_trees.hpp"
#include "support/overloaded.hpp"

namespace grafverif {

namespace {

class LoopPrinter {
public:
    LoopPrinter(const ClosedLoop& loop, const Model& model, Trees& trees) : loop_(loop), model_(model), trees_(trees) {
        for (const ClosedLoop::Controller& controller : loop.controllers) {
            const Chart& chart = model.charts[controller.chart];
            for (const Chart::Step& step : chart.steps) ++namesakes_["X" + step.name];
            for (const Chart::Variable& variable : chart.variables)
                if (variable.kind == Chart::VariableKind::Internal) ++namesakes_[variable.name];
        }
        for (const ClosedLoop::Shared& shared : loop.shared) ++namesakes_[shared.name];
    }

    tree::ClosedLoop print() {
        tree::ClosedLoop printed;
        printed.name = trees_.name(loop_.name);
        printed.where = trees_.next();
        for (const ClosedLoop::Controller& controller : loop_.controllers) {
            const bool search = controller.mode == ExecutionMode::StabilitySearch;
            const Span where = trees_.next();
            tree::TaskCycle cycle;
            if (controller.cycle) cycle.least = trees_.duration(controller.cycle->least_ms);
            if (controller.cycle && controller.cycle->least_ms != controller.cycle->most_ms)
                cycle.most = trees_.duration(controller.cycle->most_ms);
            printed.items.emplace_back(tree::Controller{trees_.name(controller.name),
                                                        cycle,
                                                        {trees_.name(search ? "stability_search" : "every_cycle")},
                                                        where});
        }
        for (const NamedConstant& each : loop_.constants) printed.items.emplace_back(constant(each));
        if (loop_.grain == Grain::Atomic) printed.items.emplace_back(tree::Grain{trees_.name("atomic"), trees_.next()});
        if (loop_.schedule)
            printed.items.emplace_back(tree::Schedule{trees_.name(word(*loop_.schedule)), trees_.next()});
        if (loop_.time_unit_ms) {
            const Span where = trees_.next();
            printed.items.emplace_back(tree::TimeUnit{trees_.duration(*loop_.time_unit_ms), where});
        }
        bool first = true;
        for (const ClosedLoop::Instance& one : loop_.instances)
            printed.items.emplace_back(instance(one, std::exchange(first, false)));
        first = true;
        for (const ClosedLoop::Fault& one : loop_.faults) {
            tree::Instance behaviour = instance(one.behaviour, std::exchange(first, false));
            const Span where = behaviour.where;
            printed.items.emplace_back(
                tree::Fault{trees_.name(loop_.instances[one.of].name), std::move(behaviour), where});
        }
        first = true;
        for (const ClosedLoop::Constraint& constraint : loop_.constraints) {
            if (constraint.controller.valid() || constraint.instance.valid()) continue;
            const Span where = trees_.next(std::exchange(first, false));
            printed.items.emplace_back(tree::Constraint{expression(constraint.condition), where});
        }
        first = true;
        for (const ClosedLoop::Observer& one : loop_.observers)
            printed.items.emplace_back(observer(one, std::exchange(first, false)));
        first = true;
        for (const Property& one : loop_.properties)
            printed.items.emplace_back(property(one, std::exchange(first, false)));
        trees_.end(printed.where);
        return printed;
    }

private:
    static std::string_view word(Schedule schedule) {
        switch (schedule) {
        case Schedule::Interleaved: return "interleaved";
        case Schedule::Synchronous: return "synchronous";
        case Schedule::Sequenced: return "sequenced";
        }
        unreachable();
    }

    tree::Observer observer(const ClosedLoop::Observer& declared, bool first) {
        tree::Observer written;
        written.where = trees_.next(first);
        written.name = trees_.name(declared.name);
        for (const Id<ClosedLoop::ObserverLocation> id : declared.locations.ids())
            written.items.emplace_back(tree::Location{
                id == declared.initial, trees_.name(declared.locations[id].name), {}, {}, trees_.next()});
        for (const ClosedLoop::ObserverEdge& edge : declared.edges) {
            const Span where = trees_.next();
            written.items.emplace_back(tree::ObserverEdge{trees_.name(declared.locations[edge.from].name),
                                                          trees_.name(declared.locations[edge.to].name),
                                                          expression(edge.guard),
                                                          {},
                                                          where});
        }
        trees_.end(written.where);
        return written;
    }

    tree::Variables constant(const NamedConstant& declared) {
        using Kind = Component::ValueKind;
        const Span where = trees_.next();
        const Kind kind = declared.kind == NamedConstant::Kind::Boolean   ? Kind::Boolean
                          : declared.kind == NamedConstant::Kind::Integer ? Kind::Integer
                                                                          : Kind::Duration;
        const Id<tree::Expr> value = constant(kind, declared.value);
        return {tree::VariableKind::Constant,
                {{trees_.name(declared.name), tree::TypeWord::None, {}, value, where}},
                where};
    }

    Id<tree::Expr> constant(Component::ValueKind kind, std::int64_t value) {
        switch (kind) {
        case Component::ValueKind::Boolean: return trees_.node(value != 0 ? tree::Op::True : tree::Op::False, {});
        case Component::ValueKind::Integer: return trees_.number(value);
        case Component::ValueKind::Duration: return trees_.duration(value);
        }
        unreachable();
    }

    tree::Instance instance(const ClosedLoop::Instance& declared, bool first) {
        const Component& component = model_.components[declared.component];
        tree::Instance written;
        written.where = trees_.next(first);
        written.environment = declared.environment;
        written.name = trees_.name(declared.name);
        written.component = trees_.name(component.name);
        for (const Id<Component::Parameter> id : component.parameters.ids()) {
            const Component::Parameter& parameter = component.parameters[id];
            const Id<tree::Expr> value =
                std::visit(overloaded{
                               [&](Id<ClosedLoop::Shared> shared) { return trees_.path(loop_.shared[shared].name); },
                               [&](std::int64_t number) { return constant(parameter.value, number); },
                               [&](Id<Expr> term) { return expression(term); },
                           },
                           declared.arguments[id.index]);
            written.arguments.push_back({trees_.name(parameter.name), value, {}});
        }
        if (declared.initial != component.initial)
            written.initial = trees_.name(component.locations[declared.initial].name);
        return written;
    }

    // -- names in properties ------------------------------------------------------------------------------------------

    std::string in_controller(Id<ClosedLoop::Controller> controller, const std::string& name) const {
        return namesakes_.at(name) == 1 ? name : loop_.controllers[controller].name + '.' + name;
    }

    std::string step_name(const ClosedLoop::StepSymbol& of) const {
        const Chart& chart = model_.charts[loop_.controllers[of.controller].chart];
        const Chart::Step& step = chart.steps[of.step];
        const std::string& partial = chart.partial_charts[step.chart].name;
        if (namesakes_.at("X" + step.name) == 1) return "X" + step.name;
        return loop_.controllers[of.controller].name + '.' + (partial.empty() ? "" : partial + '.') + "X" + step.name;
    }

    // Returns the step X of the time t/X. Other terms do not occur, because random_loop declares only times of steps.
    Id<Chart::Step> watched_step(const ClosedLoop::TimeSymbol& of) const {
        if (!of.condition.valid()) return of.step;
        const Chart& chart = model_.charts[loop_.controllers[of.controller].chart];
        const Expr& watched = chart.exprs[chart.time_conditions[of.condition].watched];
        assert(watched.op == Op::Step);
        return {static_cast<std::uint32_t>(watched.value)};
    }
    std::int64_t rise_of(const ClosedLoop::TimeSymbol& of) const {
        if (!of.condition.valid()) return of.rise_ms;
        return model_.charts[loop_.controllers[of.controller].chart].time_conditions[of.condition].rise_ms;
    }

    std::string name_of(const ClosedLoop::Symbol& symbol) const {
        return std::visit(
            overloaded{
                [&](const ClosedLoop::SharedSymbol& of) { return loop_.shared[of.shared].name; },
                [&](const ClosedLoop::InternalSymbol& of) {
                    return in_controller(
                        of.controller,
                        model_.charts[loop_.controllers[of.controller].chart].variables[of.variable].name);
                },
                [&](const ClosedLoop::StepSymbol& of) { return step_name(of); },
                [&](const ClosedLoop::LocationSymbol& of) {
                    const ClosedLoop::Instance& owner = loop_.instances[of.instance];
                    return owner.name + '.' + model_.components[owner.component].locations[of.location].name;
                },
                [&](const ClosedLoop::OwnSymbol& of) {
                    const ClosedLoop::Instance& owner = loop_.instances[of.instance];
                    return owner.name + '.' + model_.components[owner.component].variables[of.variable].name;
                },
                [&](const ClosedLoop::TimeSymbol& of) {
                    return step_name({of.controller, watched_step(of)});
                },
                [&](const ClosedLoop::ObserverSymbol& of) {
                    const ClosedLoop::Observer& owner = loop_.observers[of.observer];
                    return owner.name + '.' + owner.locations[of.location].name;
                },
            },
            symbol);
    }

    Id<tree::Expr> expression(Id<Expr> root) {
        return trees_.expression(loop_.exprs, root, [&](const Expr& leaf) {
            const auto& symbol = loop_.symbols[Id<ClosedLoop::Symbol>{static_cast<std::uint32_t>(leaf.value)}];
            const Id<tree::Expr> name = trees_.path(name_of(symbol));
            const auto* time = std::get_if<ClosedLoop::TimeSymbol>(&symbol);
            return time == nullptr ? name : trees_.node(tree::Op::Divide, {trees_.duration(rise_of(*time)), name});
        });
    }

    tree::Property property(const Property& declared, bool first) {
        tree::Property written;
        written.where = trees_.next(first);
        written.name = trees_.name(declared.name);
        written.text = declared.text;
        written.expected_violated = declared.expected_violated;
        written.pattern = declared.pattern;
        for (const Id<Expr> operand : declared.operands) written.operands.push_back(expression(operand));
        written.watch = declared.watch;
        if (declared.watch.duration_ms > 0) written.bound = trees_.duration(declared.watch.duration_ms);
        if (declared.watch.count > 0) written.bound = trees_.number(declared.watch.count);
        written.raw = declared.raw;
        written.at_stable = declared.at_stable;
        return written;
    }

    const ClosedLoop& loop_;
    const Model& model_;
    Trees& trees_;
    std::unordered_map<std::string, std::size_t> namesakes_ = {};
};

}  // namespace

tree::ClosedLoop tree_of(const ClosedLoop& loop, const Model& model, tree::File&, Trees& trees) {
    return LoopPrinter(loop, model, trees).print();
}

}  // namespace grafverif
