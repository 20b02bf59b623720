// SPDX-License-Identifier: MIT
// Compares a loop in which an input of an instance is bound to a term with an equivalent loop. In the equivalent loop,
// a separate component has an input for each variable of the term, and its guards contain the term.
// The two loops must have the same states and the same verdicts by the timed and the symbolic
// engine, and the UPPAAL project must be read back as the network.
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "check/symbolic/symbolic.hpp"
#include "check/timed/timed.hpp"
#include "emit/uppaal/uppaal.hpp"
#include "grafverif/grafverif.hpp"
#include "support/component_builder.hpp"
#include "support/naive_tadd.hpp"
#include "support/print_network.hpp"
#include "support/random_loop.hpp"
#include "support/test_size.hpp"
#include "support/uppaal_reader.hpp"
#include "unit/compose/hand_chart.hpp"

namespace grafverif {
namespace {

/// Returns a component that outputs true while A holds and X is at least 1.
Component watcher() {
    ComponentBuilder build{{.name = "watcher"}};
    Exprs& exprs = build.component.exprs;
    const Id<Expr> a = build.parameter("A", ComponentBuilder::ParameterKind::Input);
    const Id<Expr> x =
        build.parameter("X", ComponentBuilder::ParameterKind::Input, ComponentBuilder::ValueKind::Integer);
    const Id<Expr> out = build.parameter("OUT", ComponentBuilder::ParameterKind::Output);
    build.component.variables.add({.name = "LAST"});
    const auto off = build.location("off"), on = build.location("on");
    build.component.initial = off;
    const Id<Expr> sees = exprs.conjunction(a, exprs.apply(Op::GreaterEqual, x, exprs.integer(1)));
    build.edge(off, on, true, sees).assignments = {{out, a, {}}, {exprs.leaf(Op::Variable, 0), out, {}}};
    build.edge(on, off, true, exprs.negation(sees)).assignments = {{out, exprs.constant(false), {}}};
    return std::move(build.component);
}

Id<Expr> read(ClosedLoop& loop, Id<ClosedLoop::Shared> shared) {
    for (const Id<ClosedLoop::Symbol> id : loop.symbols.ids())
        if (loop.symbols[id] == ClosedLoop::Symbol(ClosedLoop::SharedSymbol{shared}))
            return loop.exprs.leaf(Op::Variable, id.index);
    return loop.exprs.leaf(Op::Variable, loop.symbols.add(ClosedLoop::SharedSymbol{shared}).index);
}

Id<ClosedLoop::Shared> any_shared(const ClosedLoop& loop, Random& random) {
    return {static_cast<std::uint32_t>(random_number(random, 0, static_cast<std::int64_t>(loop.shared.size()) - 1))};
}

Id<Expr> condition(ClosedLoop& loop, Random& random, int depth) {
    Exprs& exprs = loop.exprs;
    if (depth > 0 && chance(random, 60)) {
        const Id<Expr> left = condition(loop, random, depth - 1), right = condition(loop, random, depth - 1);
        if (chance(random, 20)) return exprs.apply(Op::Equal, left, right);
        return chance(random, 50) ? exprs.conjunction(left, right) : exprs.disjunction(left, right);
    }
    const Id<ClosedLoop::Shared> shared = any_shared(loop, random);
    const Id<Expr> leaf = read(loop, shared);
    const Type type = loop.shared[shared].type;
    const Id<Expr> holds =
        type.boolean ? leaf : exprs.apply(Op::Less, leaf, exprs.integer(random_number(random, type.low, type.high)));
    return chance(random, 40) ? exprs.negation(holds) : holds;
}

Id<Expr> number(ClosedLoop& loop, Random& random) {
    const Id<Expr> constant = loop.exprs.integer(random_number(random, -1, 2));
    const Id<ClosedLoop::Shared> shared = any_shared(loop, random);
    if (loop.shared[shared].type.boolean) return constant;
    return loop.exprs.apply(chance(random, 50) ? Op::Plus : Op::Minus, read(loop, shared), constant);
}

/// Returns a random loop whose actuators follow terms, with one or two watchers of terms.
Model with_terms(Random& random) {
    Model model = random_loop(random);
    const Id<Component> watchers = model.components.add(watcher());
    ClosedLoop& loop = model.loops[{0}];
    for (const Id<ClosedLoop::Instance> id : loop.instances.ids())
        if (model.components[loop.instances[id].component].name == "follower" && chance(random, 80))
            loop.instances[id].arguments[0] = condition(loop, random, 2);
    for (std::int64_t k = random_number(random, 1, 2); k > 0; --k) {
        const std::string name = "watcher" + std::to_string(k);
        const Id<Expr> order = condition(loop, random, 2), level = number(loop, random);
        const Id<ClosedLoop::Shared> out = loop.shared.add({.name = "seen" + std::to_string(k)});
        const Id<ClosedLoop::Instance> instance =
            loop.instances.add({.name = name, .component = watchers, .arguments = {order, level, out}, .initial = {0}});
        const Id<Expr> last = loop.exprs.leaf(
            Op::Variable, loop.symbols.add(ClosedLoop::OwnSymbol{instance, Id<Component::Variable>{0}}).index);
        Property property{.name = "follows" + std::to_string(k), .pattern = Pattern::Always};
        property.operands = {loop.exprs.disjunction(loop.exprs.negation(last), order)};
        property.at_stable = chance(random, 50);
        loop.properties.add(std::move(property));
    }
    return model;
}

/// Returns the component of an instance in the equivalent loop, in which no input is bound to a term: each variable
/// that a term reads becomes an input of the component.
Component written_out(const ClosedLoop& loop, ClosedLoop::Instance& instance, const Component& from) {
    Component made{.name = from.name + "_" + instance.name};
    std::map<std::uint32_t, Id<Expr>> reads;  // indexed by shared variable
    std::vector<Id<Expr>> parameters;
    std::vector<ClosedLoop::Argument> arguments;
    const auto add = [&](Component::Parameter parameter, ClosedLoop::Argument argument) {
        arguments.push_back(argument);
        return made.exprs.leaf(Op::Parameter, made.parameters.add(std::move(parameter)).index);
    };
    for (const ClosedLoop::Argument& argument : instance.arguments) {
        if (!std::holds_alternative<Id<Expr>>(argument)) continue;
        for (const Id<ClosedLoop::Shared> shared : shared_in(loop, argument)) {
            const ClosedLoop::Shared& of = loop.shared[shared];
            const auto value = of.type.boolean ? Component::ValueKind::Boolean : Component::ValueKind::Integer;
            if (!reads.contains(shared.index))
                reads[shared.index] = add({.name = "reads_" + of.name, .value = value}, shared);
        }
    }
    const auto copy = [&](Id<Expr> term) {
        return translate(from.exprs, term, made.exprs, [&](const Expr& leaf) {
            const auto index = static_cast<std::uint32_t>(leaf.value);
            return leaf.op == Op::Parameter ? parameters[index] : made.exprs.leaf(Op::Variable, index);
        });
    };
    for (const Id<Component::Parameter> id : from.parameters.ids()) {
        const ClosedLoop::Argument& argument = instance.arguments[id.index];
        const auto* term = std::get_if<Id<Expr>>(&argument);
        if (term == nullptr) {
            Component::Parameter parameter = from.parameters[id];
            if (parameter.low) parameter.low = copy(*parameter.low), parameter.high = copy(*parameter.high);
            parameters.push_back(add(std::move(parameter), argument));
            continue;
        }
        parameters.push_back(translate(loop.exprs, *term, made.exprs, [&](const Expr& leaf) {
            const ClosedLoop::Symbol& symbol = loop.symbols[{static_cast<std::uint32_t>(leaf.value)}];
            return reads.at(std::get<ClosedLoop::SharedSymbol>(symbol).shared.index);
        }));
    }
    for (Component::Variable variable : from.variables) {
        if (variable.low) variable.low = copy(*variable.low), variable.high = copy(*variable.high);
        made.variables.add(std::move(variable));
    }
    made.clocks = from.clocks;
    for (Component::Location location : from.locations) {
        for (Component::ClockConstraint& bound : location.invariant) bound.bound = copy(bound.bound);
        made.locations.add(std::move(location));
    }
    for (Component::Edge edge : from.edges) {
        edge.guard = copy(edge.guard);
        for (Component::ClockConstraint& bound : edge.constraint) bound.bound = copy(bound.bound);
        for (Component::Assignment& each : edge.assignments)
            each.target = copy(each.target), each.value = copy(each.value);
        made.edges.add(std::move(edge));
    }
    made.initial = from.initial;
    instance.arguments = std::move(arguments);
    return made;
}

Model by_hand(Model model) {
    ClosedLoop& loop = model.loops[{0}];
    for (const Id<ClosedLoop::Instance> id : loop.instances.ids()) {
        Component made = written_out(loop, loop.instances[id], model.components[loop.instances[id].component]);
        loop.instances[id].component = model.components.add(std::move(made));
    }
    return model;
}

template <class Result>
std::string verdicts(const Result& result) {
    std::string text;
    for (const Verdict& verdict : result.verdicts)
        text += verdict.property + ": " + std::string(word(verdict.outcome)) + (verdict.vacuous ? ", vacuous\n" : "\n");
    return text;
}

std::string symbolic_verdicts(const Model& model) {
    Diagnostics diagnostics;
    const auto system = transition_system_of(model, Id<ClosedLoop>{0}, ModelOptions{}, diagnostics);
    return system ? verdicts(check_symbolic(*system)) : "no system";
}

TEST(RandomizedPorts, InputBoundToATermAgreesWithASeparateComponent) {
    int compared = 0, symbolic = 0;
    for (int seed = 1; seed <= test_size(60); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(static_cast<std::uint64_t>(seed));
        const Model model = with_terms(random), other = by_hand(model);
        ASSERT_EQ(verify(model), std::vector<std::string>{});
        ASSERT_EQ(verify(other), std::vector<std::string>{});
        Diagnostics diagnostics;
        if (!derived(model, diagnostics)) continue;
        const Network network = composed(model), hand = composed(other);
        ASSERT_EQ(verify(expand(network)), std::vector<std::string>{});
        const Reachable states = reachable(network, 3000);
        if (!states.complete || states.out_of_range) continue;
        ASSERT_EQ(states.states, reachable(hand, 3000).states) << network_text(network) << network_text(hand);
        ASSERT_EQ(verdicts(check_timed(network)), verdicts(check_timed(hand)));
        const Network lowered = uppaal::lower(network);
        std::ostringstream project;
        uppaal::emit(lowered, project);
        ASSERT_EQ(test::comparable_text(test::read_uppaal(project.str())),
                  test::comparable_text(test::as_read_back(lowered)));
        ++compared;
        if (seed % 4 != 0) continue;
        ASSERT_EQ(symbolic_verdicts(model), symbolic_verdicts(other));
        ++symbolic;
    }
    EXPECT_GT(compared, test_size(60) / 6);
    EXPECT_GT(symbolic, test_size(60) / 30);
}

}  // namespace
}  // namespace grafverif
