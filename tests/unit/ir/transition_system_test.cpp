// SPDX-License-Identifier: MIT
#include "grafverif/ir/transition_system.hpp"

#include <gtest/gtest.h>

namespace grafverif {
namespace {

using System = TransitionSystem;

/// A system with a free input, a member, one property, and an instance of a module with a parameter, a state and a
/// definition.
struct Small {
    System system = {};
    Id<System::Module> module = {};
    Id<System::Symbol> input = {}, parameter = {}, state = {}, define = {}, member = {};
    Id<System::Instance> instance = {};

    Id<Expr> leaf(Id<System::Symbol> symbol) { return system.exprs.leaf(Op::Variable, symbol.index); }
    System::Module& main() { return system.modules[system.main]; }
    System::Module& inner() { return system.modules[module]; }

    Small() {
        system.main = system.modules.add({"main", {}, {}, {}});
        module = system.modules.add({"controller", {}, {}, {}});
        parameter = inner().symbols.add({"a", {}, System::ParameterSymbol{}, "", {}});
        state =
            inner().symbols.add({"x", {}, System::StateSymbol{system.exprs.constant(false), leaf(parameter)}, "", {}});
        define = inner().symbols.add({"d", {}, System::DefineSymbol{system.exprs.negation(leaf(state))}, "", {}});
        input = main().symbols.add({"a", {}, System::StateSymbol{}, "", {}});
        instance = system.instances.add({"c", module, {input}});
        member = main().symbols.add({"c.d", {}, System::MemberSymbol{instance, define}, "", {}});
        Property property;
        property.name = "P";
        property.operands = {leaf(member)};
        system.properties.add(property);
        system.settled = leaf(member);
    }
};

TEST(VerifyTransitionSystem, FindsNothingInAWellFormedOne) {
    EXPECT_EQ(verify(Small{}.system), std::vector<std::string>{});
}

TEST(VerifyTransitionSystem, NamesEachBrokenInvariant) {
    struct Case {
        const char* fault;
        void (*damage)(Small&);
    };
    const Case cases[] = {
        {"no main module", [](Small& s) { s.system.main = {}; }},
        {"`a` does not have a unique name", [](Small& s) { s.inner().symbols[s.define].name = "a"; }},
        {"`x` does not have exactly one name for each value",
         [](Small& s) {
             s.inner().symbols[s.state].values = {"off", "on"};
         }},
        {"the initial value of `x` reads a choice",
         [](Small& s) {
             const auto choice = s.inner().symbols.add({"e", {}, System::ChoiceSymbol{}, "", {}});
             std::get<System::StateSymbol>(s.inner().symbols[s.state].kind).initial = s.leaf(choice);
         }},
        {"a justice condition reads a choice",
         [](Small& s) {
             s.main().symbols[s.input].kind = System::ChoiceSymbol{};
             s.inner().justice.push_back(s.leaf(s.parameter));
         }},
        {"property `P` reads a choice",
         [](Small& s) {
             const auto choice = s.inner().symbols.add({"e", {}, System::ChoiceSymbol{}, "", {}});
             s.inner().symbols[s.define].kind = System::DefineSymbol{s.leaf(choice)};
         }},
        {"transition is not Boolean", [](Small& s) { s.inner().transitions.push_back(s.system.exprs.integer(1)); }},
        {"`c.d` has a type that differs from the one of its symbol",
         [](Small& s) { s.main().symbols[s.member].type = integer_type(0, 3); }},
        {"initial is not Boolean",
         [](Small& s) {
             std::get<System::StateSymbol>(s.inner().symbols[s.state].kind).initial = s.system.exprs.integer(1);
         }},
        {"next contains a type error",
         [](Small& s) {
             std::get<System::StateSymbol>(s.inner().symbols[s.state].kind).next = s.system.exprs.leaf(Op::Variable, 9);
         }},
        {"definitions depend on themselves",
         [](Small& s) {
             s.inner().symbols[s.define].kind = System::DefineSymbol{s.system.exprs.negation(s.leaf(s.define))};
         }},
        {"initial values depend on themselves",
         [](Small& s) { std::get<System::StateSymbol>(s.inner().symbols[s.state].kind).initial = s.leaf(s.define); }},
        {"is a misplaced parameter", [](Small& s) { s.main().symbols[s.input].kind = System::ParameterSymbol{}; }},
        {"has a number of arguments that differs", [](Small& s) { s.system.instances[s.instance].arguments.clear(); }},
        {"not a symbol of the main module with the type of the parameter",
         [](Small& s) { s.system.instances[s.instance].arguments = {{7}}; }},
        {"no module that can be instantiated", [](Small& s) { s.system.instances[s.instance].module = s.system.main; }},
        {"`P` has the wrong number of operands", [](Small& s) { s.system.properties[{0}].pattern = Pattern::LeadsTo; }},
        {"`P` has a pattern that transition systems do not support",
         [](Small& s) {
             s.system.properties[{0}].pattern = Pattern::NoDeadlock;
             s.system.properties[{0}].operands.clear();
         }},
        {"operand is not Boolean", [](Small& s) { s.system.properties[{0}].operands = {s.system.exprs.integer(1)}; }},
        {"operand contains a type error",
         [](Small& s) {
             const auto nested =
                 s.system.exprs.apply(Op::Less, s.system.exprs.leaf(Op::Variable, 0), s.system.exprs.integer(1));
             s.system.properties[{0}].operands = {s.system.exprs.negation(nested)};
         }},
        {"settled is not Boolean", [](Small& s) { s.system.settled = s.system.exprs.integer(1); }},
        {"justice is not Boolean", [](Small& s) { s.main().justice = {s.system.exprs.integer(1)}; }},
        {"an omitted property has an invalid position",
         [](Small& s) {
             s.system.omitted.push_back({{}, "", 5});
         }},
    };
    for (const Case& broken : cases) {
        SCOPED_TRACE(broken.fault);
        Small small;
        broken.damage(small);
        std::string all;
        for (const std::string& fault : verify(small.system)) all += fault + '\n';
        EXPECT_NE(all.find(broken.fault), std::string::npos) << "found only these faults:\n" << all;
    }
}

}  // namespace
}  // namespace grafverif
