// SPDX-License-Identifier: MIT
// Tests the symbolic engine with an early end of the search, and with choices that have no effect.
#include "check/symbolic/symbolic.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>

#include "check/symbolic/order.hpp"

namespace grafverif {
namespace {

using System = TransitionSystem;

Id<Expr> add_state(System& system, const std::string& name, Type type, Id<Expr> initial) {
    System::Module& main = system.modules[system.main];
    const Id<System::Symbol> id = main.symbols.add({name, type, System::StateSymbol{initial, {}}, "", {}});
    return system.exprs.leaf(Op::Variable, id.index);
}

void set_next(System& system, Id<Expr> state, Id<Expr> next) {
    const auto symbol = static_cast<std::uint32_t>(system.exprs[state].value);
    std::get<System::StateSymbol>(system.modules[system.main].symbols[{symbol}].kind).next = next;
}

System empty_system() {
    System system;
    system.name = "by hand";
    system.main = system.modules.add({.name = "main"});
    system.settled = system.exprs.constant(true);
    return system;
}

void add_property(System& system, Pattern pattern, Id<Expr> operand) {
    Property property{.name = "p" + std::to_string(system.properties.size()), .pattern = pattern};
    property.operands = {operand};
    system.properties.add(std::move(property));
}

/// Returns a system with a number that counts to `last` cyclically.
System counter(std::int64_t last) {
    System system = empty_system();
    Exprs& exprs = system.exprs;
    const Id<Expr> number = add_state(system, "number", integer_type(0, last), exprs.integer(0));
    set_next(system, number,
             exprs.conditional(exprs.apply(Op::Less, number, exprs.integer(last)),
                               exprs.apply(Op::Plus, number, exprs.integer(1)), exprs.integer(0)));
    for (const std::int64_t seen : {std::int64_t{3}, last}) {
        const Id<Expr> there = exprs.apply(Op::Equal, number, exprs.integer(seen));
        add_property(system, Pattern::Never, there);
        add_property(system, Pattern::Reachable, there);
    }
    add_property(system, Pattern::Inevitable, exprs.apply(Op::Equal, number, exprs.integer(3)));
    return system;
}

TEST(Symbolic, StoppedSearchReportsOnlyWhatItHasFound) {
    const System system = counter(4000);
    ASSERT_EQ(verify(system), std::vector<std::string>{});
    for (const Id<Property> id : system.properties.ids()) {
        SCOPED_TRACE(system.properties[id].name);
        std::atomic<bool> stop = false;
        SymbolicOptions options{.properties = {system.properties[id].name}, .stop = &stop};
        options.progress = [&](const SymbolicProgress& now) { stop = now.depth >= 1000; };
        const SymbolicResult result = check_symbolic(system, options);
        EXPECT_EQ(result.states, "");
        ASSERT_EQ(result.verdicts.size(), 1u);
        const Verdict& verdict = result.verdicts.front();
        if (id.index < 2) {
            EXPECT_EQ(verdict.outcome, id.index == 0 ? Outcome::Violated : Outcome::Holds);
            ASSERT_TRUE(result.runs.front());
            EXPECT_EQ(result.runs.front()->states.size(), 4u);
        } else {
            EXPECT_EQ(verdict.outcome, Outcome::Unknown);
            EXPECT_EQ(verdict.obstacle, UnknownReason::Stopped);
        }
    }
}

TEST(Symbolic, TheFirstValueOutsideItsRangeIsShown) {
    System system = empty_system();
    Exprs& exprs = system.exprs;
    const Id<Expr> later = add_state(system, "later", integer_type(0, 3), exprs.integer(0));
    const Id<Expr> broken = add_state(system, "broken", {}, exprs.constant(false));
    const Id<Expr> number = add_state(system, "number", integer_type(0, 3), exprs.integer(0));
    set_next(system, number, exprs.apply(Op::Plus, number, exprs.integer(1)));
    set_next(system, broken, exprs.apply(Op::Equal, number, exprs.integer(3)));
    set_next(system, later, exprs.conditional(broken, exprs.integer(4), later));
    ASSERT_EQ(verify(system), std::vector<std::string>{});
    const SymbolicResult result = check_symbolic(system);
    ASSERT_TRUE(result.fault);
    EXPECT_EQ(result.fault->variable, "number");
    EXPECT_EQ(result.fault->run.states.size(), 4u);
}

TEST(Symbolic, StoppedSearchIgnoresSuccessorsOfAStepOutOfARange) {
    System system = empty_system();
    Exprs& exprs = system.exprs;
    const Id<Expr> number = add_state(system, "number", integer_type(0, 3), exprs.integer(0));
    const Id<Expr> behind = add_state(system, "behind", {}, exprs.constant(false));
    const Id<Expr> clock = add_state(system, "clock", integer_type(0, 63), exprs.integer(0));
    set_next(system, number, exprs.apply(Op::Plus, number, exprs.integer(1)));
    set_next(system, behind,
             exprs.conjunction(exprs.apply(Op::Less, number, exprs.integer(3)),
                               exprs.apply(Op::Greater, clock, exprs.integer(3))));
    const Id<Expr> full = exprs.apply(Op::Equal, clock, exprs.integer(63));
    set_next(system, clock, exprs.conditional(full, clock, exprs.apply(Op::Plus, clock, exprs.integer(1))));
    add_property(system, Pattern::Never, behind);
    ASSERT_EQ(verify(system), std::vector<std::string>{});
    std::atomic<bool> stop = false;
    std::size_t deepest = 0;
    const SymbolicResult result = check_symbolic(system, {.stop = &stop, .progress = [&](const SymbolicProgress& now) {
                                                              deepest = std::max(deepest, now.depth);
                                                              stop = now.depth > 12;
                                                          }});
    EXPECT_LE(deepest, 4U) << "the fourth ring is the last that a run reaches";
    ASSERT_TRUE(result.fault);
    EXPECT_EQ(result.fault->variable, "number");
    EXPECT_EQ(result.verdicts.at(0).outcome, Outcome::Unknown);
}

TEST(Symbolic, RelatedVariablesAreAdjacentInTheOrder) {
    System system = empty_system();
    constexpr std::size_t rings = 3, bits = 4;
    std::vector<std::vector<Id<Expr>>> ring(rings);
    std::vector<Id<Expr>> all;
    for (std::size_t bit = 0; bit < bits; ++bit)
        for (std::size_t k = 0; k < rings; ++k) {
            const std::string name = std::to_string(k) + "_" + std::to_string(bit);
            ring[k].push_back(add_state(system, name, Type{}, system.exprs.constant(bit == 0)));
            all.push_back(ring[k].back());
        }
    const Id<Expr> wide = system.exprs.negation(system.exprs.conjunction(all));
    for (std::vector<Id<Expr>>& each : ring)
        for (std::size_t bit = 0; bit < bits; ++bit)
            set_next(system, each[bit], system.exprs.conjunction(each[(bit + 1) % bits], wide));
    const FlatSystem flat = flattened(system);
    std::string order;
    for (const auto id : symbolic::variable_order(flat)) order += flat.variables[id].name.front();
    EXPECT_EQ(std::set<std::string>({order.substr(0, bits), order.substr(bits, bits), order.substr(2 * bits)}),
              (std::set<std::string>{"0000", "1111", "2222"}))
        << order;
}

TEST(Symbolic, ChoicesWithoutEffectDoNotMultiplyEventClusters) {
    System system = empty_system();
    Exprs& exprs = system.exprs;
    const Id<Expr> lamp = add_state(system, "lamp", {}, exprs.constant(false));
    Id<Expr> first = {};
    for (int i = 0; i < 30; ++i) {
        const Id<System::Symbol> id = system.modules[system.main].symbols.add(
            {"choice_" + std::to_string(i), integer_type(0, 2), System::ChoiceSymbol{}, "", {}});
        if (i == 0) first = exprs.leaf(Op::Variable, id.index);
    }
    set_next(system, lamp,
             exprs.conditional(exprs.apply(Op::Equal, first, exprs.integer(0)), exprs.negation(lamp), lamp));
    add_property(system, Pattern::Reachable, lamp);
    ASSERT_EQ(verify(system), std::vector<std::string>{});
    const SymbolicResult result =
        check_symbolic(system, {.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10)});
    EXPECT_EQ(result.states, "2");
    EXPECT_EQ(result.verdicts.front().outcome, Outcome::Holds);
}

}  // namespace
}  // namespace grafverif
