// SPDX-License-Identifier: MIT
#include "support/random_loop.hpp"

#include <map>
#include <utility>

#include "support/component_builder.hpp"

namespace grafverif {

namespace {

using ParameterKind = ComponentBuilder::ParameterKind;
using ValueKind = ComponentBuilder::ValueKind;

/// Returns a component that changes OUT at any time, but at least PERIOD after the last change.
Component toggle() {
    ComponentBuilder build{{.name = "toggle"}};
    const Id<Expr> out = build.parameter("OUT", ParameterKind::Output);
    const Id<Expr> period = build.parameter("PERIOD", ParameterKind::Constant, ValueKind::Duration);
    const Id<Component::Clock> t = build.component.clocks.add({.name = "t"});
    const auto on = build.location("on");
    build.component.initial = on;
    Component::Edge& edge = build.edge(on, on, false, build.component.exprs.constant(true));
    edge.constraint.push_back({t, Op::GreaterEqual, period, {}});
    edge.assignments.push_back({out, build.component.exprs.negation(out), {}});
    edge.resets.push_back(t);
    return std::move(build.component);
}

/// Returns a component that increments or decrements OUT within LOW..HIGH, at least 1 s after the previous change.
Component wander() {
    ComponentBuilder build{{.name = "wander"}};
    Exprs& exprs = build.component.exprs;
    const Id<Expr> low = build.parameter("LOW", ParameterKind::Constant, ValueKind::Integer);
    const Id<Expr> high = build.parameter("HIGH", ParameterKind::Constant, ValueKind::Integer);
    const Id<Expr> out = build.parameter("OUT", ParameterKind::Output, ValueKind::Integer);
    build.component.parameters[{2}].low = low;
    build.component.parameters[{2}].high = high;
    const Id<Component::Clock> t = build.component.clocks.add({.name = "t"});
    const auto on = build.location("on");
    build.component.initial = on;
    for (const Op direction : {Op::Plus, Op::Minus}) {
        const Id<Expr> limit =
            direction == Op::Plus ? exprs.apply(Op::Less, out, high) : exprs.apply(Op::Greater, out, low);
        Component::Edge& edge = build.edge(on, on, false, limit);
        edge.constraint.push_back({t, Op::GreaterEqual, exprs.duration(1000), {}});
        edge.assignments.push_back({out, exprs.apply(direction, out, exprs.integer(1)), {}});
        edge.resets.push_back(t);
    }
    return std::move(build.component);
}

/// Returns a component whose OUT becomes true DELAY after G, and false together with G. The component counts its
/// movements.
Component follower() {
    ComponentBuilder build{{.name = "follower"}};
    Exprs& exprs = build.component.exprs;
    const Id<Expr> order = build.parameter("G", ParameterKind::Input);
    const Id<Expr> out = build.parameter("OUT", ParameterKind::Output);
    const Id<Expr> delay = build.parameter("DELAY", ParameterKind::Constant, ValueKind::Duration);
    const Id<Component::Clock> t = build.component.clocks.add({.name = "t"});
    build.component.variables.add(
        {.name = "N", .value = ValueKind::Integer, .low = exprs.integer(0), .high = exprs.integer(2)});
    const Id<Expr> count = exprs.leaf(Op::Variable, 0);
    const auto off = build.location("off"), moving = build.location("moving"), on = build.location("on");
    build.component.initial = off;
    build.component.locations[moving].invariant.push_back({t, Op::LessEqual, delay, {}});
    build.edge(off, moving, true, order).resets.push_back(t);
    Component::Edge& end = build.edge(moving, on, false, order);
    end.constraint.push_back({t, Op::Equal, delay, {}});
    end.assignments = {
        {out, exprs.constant(true), {}},
        {count, exprs.apply(Op::Modulo, exprs.apply(Op::Plus, count, exprs.integer(1)), exprs.integer(3)), {}}};
    build.edge(moving, off, true, exprs.negation(order));
    build.edge(on, off, true, exprs.negation(order)).assignments.push_back({out, exprs.constant(false), {}});
    return std::move(build.component);
}

struct Generator {
    Random& random;
    Model model = {};
    ClosedLoop loop = {};
    std::map<std::string, Id<ClosedLoop::Shared>> shared = {};
    std::vector<Id<ClosedLoop::Shared>> orders = {};  ///< the Boolean outputs
    bool requested = false;                           ///< terms may read internal variables and observers, too

    std::int64_t number(std::int64_t low, std::int64_t high) { return random_number(random, low, high); }
    template <class T>
    Id<T> any(const Table<T>& from) {
        return {static_cast<std::uint32_t>(number(0, static_cast<std::int64_t>(from.size()) - 1))};
    }

    void add_controller(Chart chart, const std::string& name) {
        chart.name = name;
        const Id<Chart> id = model.charts.add(std::move(chart));
        const ExecutionMode mode = chance(random, 70) ? ExecutionMode::StabilitySearch : ExecutionMode::EveryCycle;
        const auto controller = loop.controllers.add({.name = name, .chart = id, .mode = mode});
        const Chart& added = model.charts[id];
        for (const Id<Chart::Variable> variable : added.variables.ids()) {
            const Chart::Variable& from = added.variables[variable];
            if (from.kind == Chart::VariableKind::Internal) continue;
            const auto [at, fresh] = shared.try_emplace(from.name, Id<ClosedLoop::Shared>{});
            if (fresh) at->second = loop.shared.add({.name = from.name, .type = from.type, .variable = variable});
            ClosedLoop::Shared& here = loop.shared[at->second];
            const bool output = from.kind == Chart::VariableKind::Output;
            Id<ClosedLoop::Controller>& end = output ? here.writer : here.reader;
            if (!end.valid()) end = controller;
            if (output && from.type.boolean) orders.push_back(at->second);
        }
    }

    /// Returns a second chart, whose outputs have other names than those of the first chart. Some
    /// inputs of the second chart are outputs of the first chart.
    Chart second_chart() {
        Chart chart = random_chart(random);
        std::vector<Id<ClosedLoop::Shared>> free = orders;
        for (const Id<Chart::Variable> id : chart.variables.ids()) {
            Chart::Variable& variable = chart.variables[id];
            if (variable.kind == Chart::VariableKind::Output) variable.name = "second_" + variable.name;
            if (variable.kind != Chart::VariableKind::Input || !variable.type.boolean || free.empty() ||
                chance(random, 60))
                continue;
            variable.name = loop.shared[free.back()].name;
            free.pop_back();
        }
        return chart;
    }

    void add_plant() {
        const Id<Component> switches = model.components.add(toggle());
        const Id<Component> levels = model.components.add(wander());
        const Id<Component> actuators = model.components.add(follower());
        for (const Id<ClosedLoop::Shared> id : loop.shared.ids()) {
            const ClosedLoop::Shared& variable = loop.shared[id];
            if (variable.writer.valid()) continue;
            ClosedLoop::Instance instance{
                .name = "drives_" + variable.name, .initial = {0}, .environment = chance(random, 50)};
            if (!variable.type.boolean) {
                instance.component = levels;
                instance.arguments = {variable.type.low, variable.type.high, id};
            } else if (orders.empty() || chance(random, 50)) {
                instance.component = switches;
                instance.arguments = {id, number(1, 3) * 1000};
            } else {
                instance.component = actuators;
                instance.arguments = {
                    orders[static_cast<std::size_t>(number(0, static_cast<std::int64_t>(orders.size()) - 1))], id,
                    number(1, 4) * 500};
            }
            loop.instances.add(std::move(instance));
        }
    }

    Id<Expr> atom() {
        const auto controller = any(loop.controllers);
        ClosedLoop::Symbol symbol =
            ClosedLoop::StepSymbol{controller, any(model.charts[loop.controllers[controller].chart].steps)};
        if (chance(random, 40)) {
            const auto variable = any(loop.shared);
            if (loop.shared[variable].type.boolean) symbol = ClosedLoop::SharedSymbol{variable};
        } else if (chance(random, 30) && !loop.instances.empty()) {
            const auto instance = any(loop.instances);
            symbol = ClosedLoop::LocationSymbol{instance,
                                                any(model.components[loop.instances[instance].component].locations)};
        }
        if (requested && !loop.observers.empty() && chance(random, 10)) {
            const auto observer = any(loop.observers);
            symbol = ClosedLoop::ObserverSymbol{observer, any(loop.observers[observer].locations)};
        } else if (requested && chance(random, 20)) {
            const Chart& chart = model.charts[loop.controllers[controller].chart];
            const auto variable = any(chart.variables);
            const Chart::Variable& internal = chart.variables[variable];
            if (internal.kind == Chart::VariableKind::Internal) {
                const Id<Expr> read = leaf(ClosedLoop::InternalSymbol{controller, variable});
                if (internal.type.boolean) return read;
                const Id<Expr> some = loop.exprs.integer(number(internal.type.low, internal.type.high));
                return loop.exprs.apply(Op::Equal, read, some);
            }
        }
        if (requested && chance(random, 15))
            if (const auto time = time_condition(controller)) return *time;
        return leaf(symbol);
    }

    /// Returns one of the terms `3s/X2` in the transition conditions, delayed actions and other terms of the chart.
    std::optional<Id<Expr>> time_condition(Id<ClosedLoop::Controller> controller) {
        const Chart& chart = model.charts[loop.controllers[controller].chart];
        std::vector<std::pair<Id<Chart::Step>, ClosedLoop::TimeSymbol>> found;
        const std::vector<bool> read = read_terms(chart).time_conditions;
        for (const Id<Chart::TimeCondition> id : chart.time_conditions.ids()) {
            const Chart::TimeCondition& time = chart.time_conditions[id];
            const Expr& watched = chart.exprs[time.watched];
            if (read[id.index] && time.fall_ms == 0 && watched.op == Op::Step)
                found.push_back(
                    {{static_cast<std::uint32_t>(watched.value)}, {.controller = controller, .condition = id}});
        }
        if (found.empty())
            for (const Chart::ContinuousAction& action : chart.continuous)
                if (action.delay_ms > 0)
                    found.push_back(
                        {action.step, {.controller = controller, .step = action.step, .rise_ms = action.delay_ms}});
        if (found.empty()) return {};
        const auto& [step, symbol] =
            found[static_cast<std::size_t>(number(0, static_cast<std::int64_t>(found.size()) - 1))];
        return loop.exprs.conjunction(leaf(ClosedLoop::StepSymbol{controller, step}), leaf(symbol));
    }

    Id<Expr> leaf(const ClosedLoop::Symbol& symbol) {
        for (const Id<ClosedLoop::Symbol> id : loop.symbols.ids())
            if (loop.symbols[id] == symbol) return loop.exprs.leaf(Op::Variable, id.index);
        return loop.exprs.leaf(Op::Variable, loop.symbols.add(symbol).index);
    }

    Id<Expr> formula() {
        const Id<Expr> first = chance(random, 30) ? loop.exprs.negation(atom()) : atom();
        if (chance(random, 50)) return first;
        return chance(random, 50) ? loop.exprs.conjunction(first, atom()) : loop.exprs.disjunction(first, atom());
    }

    void add_properties() {
        const std::vector<Pattern> patterns{
            Pattern::Always,  Pattern::Never,      Pattern::Reachable,  Pattern::Inevitable,
            Pattern::LeadsTo, Pattern::NoDeadlock, Pattern::NoTimelock, Pattern::ReachableAllSteps};
        for (std::int64_t k = number(1, 4); k > 0; --k) {
            Property property{.name = "P" + std::to_string(k)};
            property.pattern =
                patterns[static_cast<std::size_t>(number(0, static_cast<std::int64_t>(patterns.size()) - 1))];
            if (property.pattern <= Pattern::LeadsTo) property.operands.push_back(formula());
            if (property.pattern == Pattern::LeadsTo) property.operands.push_back(formula());
            property.at_stable = property.pattern <= Pattern::Reachable && chance(random, 30);
            loop.properties.add(std::move(property));
        }
    }

    void add_constraint() {
        std::vector<Id<Expr>> inputs;
        for (const Id<ClosedLoop::Shared> id : loop.shared.ids())
            if (!loop.shared[id].writer.valid() && loop.shared[id].type.boolean)
                inputs.push_back(leaf(ClosedLoop::SharedSymbol{id}));
        if (inputs.size() < 2) return;
        loop.constraints.add(
            {.name = "constraint_1", .condition = loop.exprs.negation(loop.exprs.conjunction(inputs[0], inputs[1]))});
    }

    void add_observer() {
        ClosedLoop::Observer observer{.name = "Seen"};
        for (const char* const name : {"nothing", "first", "second"}) observer.locations.add({.name = name});
        observer.initial = {0};
        observer.edges.push_back({{0}, {1}, formula(), {}});
        observer.edges.push_back({{1}, {2}, formula(), {}});
        loop.observers.add(std::move(observer));
    }

    void add_queries(int count) {
        const std::vector<Pattern> patterns{Pattern::Always,        Pattern::Never,   Pattern::Reachable,
                                            Pattern::Inevitable,    Pattern::LeadsTo, Pattern::ExactlyOneOf,
                                            Pattern::AlwaysPossible};
        for (int k = 1; k <= count; ++k) {
            Property property{.name = "Q" + std::to_string(k)};
            property.pattern = patterns[static_cast<std::size_t>(k) % patterns.size()];
            const bool two = property.pattern == Pattern::LeadsTo || property.pattern == Pattern::ExactlyOneOf;
            for (int operand = 0; operand < (two ? 2 : 1); ++operand) property.operands.push_back(formula());
            property.at_stable = chance(random, 30);
            loop.properties.add(std::move(property));
        }
    }
};

Generator generated_loop(Random& random) {
    Generator generator{random};
    generator.loop.name = "law_loop";
    generator.loop.grain = chance(random, 50) ? Grain::Phased : Grain::Atomic;
    generator.add_controller(random_chart(random), "law");
    if (chance(random, 30)) generator.add_controller(generator.second_chart(), "second");
    generator.add_plant();
    generator.add_properties();
    return generator;
}

}  // namespace

Model random_loop(Random& random) {
    Generator generator = generated_loop(random);
    generator.model.loops.add(std::move(generator.loop));
    return std::move(generator.model);
}

Model random_loop_asked(Random& random, int questions) {
    Generator generator = generated_loop(random);
    if (chance(random, 40)) generator.add_constraint();
    if (chance(random, 40)) generator.add_observer();
    generator.requested = true;
    generator.add_queries(questions);
    generator.model.loops.add(std::move(generator.loop));
    return std::move(generator.model);
}

void add_task_cycles(Model& model, Random& random) {
    bool any = false;
    for (ClosedLoop::Controller& controller : model.loops[{0}].controllers) {
        if (any && chance(random, 40)) continue;
        const std::int64_t least = random_number(random, 1, 2) * 1000;
        controller.cycle = TaskCycle{least, least + (chance(random, 50) ? 0 : random_number(random, 1, 2) * 1000), {}};
        any = true;
    }
}

Model lone_controller(const Chart& chart, ExecutionMode mode) {
    Model model;
    const Id<Chart> id = model.charts.add(chart);
    ClosedLoop loop;
    loop.name = chart.name + "_alone";
    const auto controller = loop.controllers.add({.name = chart.name, .chart = id, .mode = mode});
    for (const Id<Chart::Variable> variable : chart.variables.ids()) {
        const Chart::Variable& from = chart.variables[variable];
        ClosedLoop::Shared shared{.name = from.name, .type = from.type, .variable = variable};
        if (from.kind == Chart::VariableKind::Internal) continue;
        (from.kind == Chart::VariableKind::Input ? shared.reader : shared.writer) = controller;
        loop.shared.add(std::move(shared));
    }
    model.loops.add(std::move(loop));
    return model;
}

}  // namespace grafverif
