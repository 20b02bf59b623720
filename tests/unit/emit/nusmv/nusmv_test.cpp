// SPDX-License-Identifier: MIT
// Tests the text of NuSMV models: its parts and its specifications. A randomized test checks that the text is
// equivalent to the system.
#include "emit/nusmv/nusmv.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "support/nusmv_reader.hpp"

namespace grafverif {
namespace {

using System = TransitionSystem;

/// A main module with inputs a, b, c and an instance `k` of a module with one step.
struct Small {
    System system = {};
    Id<System::Module> module = {};
    Id<System::Symbol> parameter = {}, step = {};

    System::Module& main() { return system.modules[system.main]; }
    System::Module& inner() { return system.modules[module]; }
    Id<Expr> leaf(Id<System::Symbol> symbol) { return system.exprs.leaf(Op::Variable, symbol.index); }

    Id<System::Symbol> input(const std::string& name, Type type = {}) {
        return main().symbols.add({name, type, System::StateSymbol{}, "inputs", {}});
    }

    Small() {
        system.name = "press";
        system.main = system.modules.add({"main", {}, {}, {}});
        module = system.modules.add({"controller_press", {}, {}, {}});
        parameter = inner().symbols.add({"a", {}, System::ParameterSymbol{}, "", {}});
        step = inner().symbols.add({"X_1", {}, System::StateSymbol{}, "steps", {}});
        inner().symbols[step].kind = System::StateSymbol{system.exprs.constant(true), leaf(parameter)};
        const Id<System::Symbol> a = input("a");
        input("b");
        input("c");
        const Id<System::Instance> press = system.instances.add({"press", module, {a}});
        const Id<System::Symbol> active =
            main().symbols.add({"press.X_1", {}, System::MemberSymbol{press, step}, "", {}});
        system.settled = leaf(active);
    }

    Id<Expr> a() { return system.exprs.leaf(Op::Variable, 0); }
    Id<Expr> b() { return system.exprs.leaf(Op::Variable, 1); }
    Id<Expr> c() { return system.exprs.leaf(Op::Variable, 2); }

    void add_property(Pattern pattern, std::vector<Id<Expr>> operands, bool at_stable = false, std::string raw = {}) {
        Property property;
        property.name = "P";
        property.pattern = pattern;
        property.operands = std::move(operands);
        property.at_stable = at_stable;
        property.raw = std::move(raw);
        system.properties.add(std::move(property));
    }
};

std::string emitted(const System& system) {
    EXPECT_EQ(verify(system), std::vector<std::string>{});
    std::ostringstream out;
    nusmv::emit(system, out);
    return out.str();
}

/// Checks that `expected` occurs in `text` at the beginning of a line.
void expect_lines(const std::string& text, const std::string& expected) {
    EXPECT_NE(("\n" + text).find("\n" + expected), std::string::npos) << "in:\n" << text;
}

TEST(EmitNusmv, WritesMainFirstAndThenTheController) {
    Small small;
    small.system.scope = "Inputs are free.";
    small.add_property(Pattern::Always, {small.a()});
    EXPECT_EQ(emitted(small.system),
              "-- press: NuSMV model written by grafverif\n"
              "-- to check it: NuSMV -dynamic FILE (dynamic variable reordering: much faster on large models)\n"
              "--\n"
              "-- Inputs are free.\n"
              "\n"
              "MODULE main\n"
              "VAR\n"
              "  -- inputs\n"
              "  a : boolean;\n"
              "  b : boolean;\n"
              "  c : boolean;\n"
              "  -- the controller\n"
              "  press : controller_press(a);\n"
              "\n"
              "INVARSPEC NAME P := a;\n"
              "\n"
              "MODULE controller_press(a)\n"
              "VAR\n"
              "  -- steps\n"
              "  X_1 : boolean;\n"
              "ASSIGN\n"
              "  -- steps\n"
              "  init(X_1) := TRUE;\n"
              "  next(X_1) := a;\n");
}

TEST(EmitNusmv, WritesEachPatternWithItsBrackets) {
    struct Case {
        Pattern pattern;
        bool at_stable;
        const char* formula;
    };
    const Case cases[] = {
        {Pattern::Always, false, "INVARSPEC NAME P := a | b;"},
        {Pattern::Always, true, "INVARSPEC NAME P := press.X_1 -> (a | b);"},
        {Pattern::Never, false, "INVARSPEC NAME P := !(a | b);"},
        {Pattern::Never, true, "INVARSPEC NAME P := press.X_1 -> (!(a | b));"},
        {Pattern::Reachable, false, "INVARSPEC NAME never_P := !(a | b);"},
        {Pattern::Reachable, true, "INVARSPEC NAME never_P := press.X_1 -> (!(a | b));"},
        {Pattern::Inevitable, false, "SPEC NAME P := AF (a | b);"},
        {Pattern::Inevitable, true, "SPEC NAME P := AF (press.X_1 & (a | b));"},
        {Pattern::AlwaysPossible, false, "SPEC NAME P := AG EF (a | b);"},
        {Pattern::AlwaysPossible, true, "SPEC NAME P := AG EF (press.X_1 & (a | b));"},
    };
    for (const Case& one : cases) {
        SCOPED_TRACE(one.formula);
        Small small;
        small.add_property(one.pattern, {small.system.exprs.disjunction(small.a(), small.b())}, one.at_stable);
        expect_lines(emitted(small.system), std::string(one.formula) + "\n");
    }
}

TEST(EmitNusmv, WritesPatternsOfSeveralOperands) {
    Small leads;
    leads.add_property(Pattern::LeadsTo, {leads.system.exprs.negation(leads.a()), leads.b()});
    expect_lines(emitted(leads.system), "SPEC NAME P := AG ((!a) -> AF b);\n");
    Small settled;
    settled.add_property(Pattern::LeadsTo, {settled.a(), settled.b()}, true);
    expect_lines(emitted(settled.system), "SPEC NAME P := AG ((press.X_1 & a) -> AF (press.X_1 & b));\n");
    Small one;
    one.add_property(Pattern::ExactlyOneOf, {one.a(), one.system.exprs.disjunction(one.b(), one.c())});
    expect_lines(emitted(one.system), "INVARSPEC NAME P := count(a, (b | c)) = 1;\n");
    Small alone;
    alone.add_property(Pattern::ExactlyOneOf, {alone.a()}, true);
    expect_lines(emitted(alone.system), "INVARSPEC NAME P := press.X_1 -> (a);\n");
}

TEST(EmitNusmv, PassesItsNativeFormulasThrough) {
    Small small;
    small.add_property(Pattern::RawCtl, {}, false, "AG EF press.X_1");
    small.add_property(Pattern::RawLtl, {}, false, "G F press.X_1");
    const std::string text = emitted(small.system);
    expect_lines(text, "SPEC NAME P := AG EF press.X_1;\n");
    expect_lines(text, "LTLSPEC NAME P_ := G F press.X_1;\n");
}

TEST(EmitNusmv, FormulasThatTheModelCannotExpressAreOmittedInTheirPlaces) {
    Small small;
    small.main().symbols.add({"move", {}, System::ChoiceSymbol{}, "", {}});
    Property before{.name = "before", .pattern = Pattern::NoDeadlock};
    small.system.omitted.push_back({before, "nothing is dead", 1});
    small.add_property(Pattern::RawCtl, {}, false, "AG press.X_7");
    small.add_property(Pattern::RawCtl, {}, false, "AG press.a");
    small.add_property(Pattern::RawLtl, {}, false, "G F move");
    small.add_property(Pattern::RawCtl, {}, false, "EF move");
    small.add_property(Pattern::Always, {small.a()});
    for (const Id<Property> id : small.system.properties.ids())
        small.system.properties[id].name = "P" + std::to_string(id.index);
    const System expressible = nusmv::sayable(small.system);
    ASSERT_EQ(expressible.properties.size(), 3u);
    EXPECT_EQ(expressible.properties[{0}].name, "P1");
    EXPECT_EQ(expressible.properties[{1}].name, "P2");
    ASSERT_EQ(expressible.omitted.size(), 3u);
    EXPECT_EQ(expressible.omitted[0].reason, "the model does not declare `press.X_7`");
    EXPECT_EQ(expressible.omitted[0].before, 0u);
    EXPECT_EQ(expressible.omitted[1].property.name, "before");
    EXPECT_EQ(expressible.omitted[1].before, 0u) << "it also precedes P1";
    EXPECT_EQ(expressible.omitted[2].property.name, "P3");
    EXPECT_EQ(expressible.omitted[2].before, 2u);
}

TEST(EmitNusmv, PutsTextAndExpectationAboveASpecification) {
    Small small;
    small.add_property(Pattern::Always, {small.a()});
    small.system.properties[{0}].text = "the press is safe";
    small.system.properties[{0}].expected_violated = true;
    expect_lines(emitted(small.system), "-- P: the press is safe (expected: violated)\nINVARSPEC NAME P := a;\n");
}

TEST(EmitNusmv, MarksNegatedReachableProperties) {
    Small small;
    small.add_property(Pattern::Reachable, {small.a()});
    small.system.properties[{0}].text = "the press can close";
    const std::string text = emitted(small.system);
    expect_lines(text,
                 "-- P: the press can close; holds if never_P is false\n"
                 "INVARSPEC NAME never_P := !a;\n");
    EXPECT_NE(text.substr(0, text.find("MODULE")).find("P holds if never_P is false"), std::string::npos) << text;
    Small without;
    without.add_property(Pattern::Always, {without.a()});
    EXPECT_EQ(emitted(without.system).find("opposite"), std::string::npos);
}

TEST(EmitNusmv, AnotherPropertyMayHaveTheNameOfTheOpposite) {
    Small small;
    small.add_property(Pattern::Reachable, {small.a()});
    small.add_property(Pattern::Always, {small.b()});
    small.system.properties[{1}].name = "never_P";
    expect_lines(emitted(small.system),
                 "-- P; holds if never_P is false\n"
                 "INVARSPEC NAME never_P := !a;\n"
                 "\n"
                 "-- never_P\n"
                 "INVARSPEC NAME never_P_ := b;\n");
}

TEST(EmitNusmv, LeavesACommentInThePlaceOfAnOmittedProperty) {
    Small small;
    small.add_property(Pattern::Always, {small.a()});
    small.add_property(Pattern::Always, {small.b()});
    small.system.properties[{0}].name = "P1";
    small.system.properties[{1}].name = "P3";
    Property omitted;
    omitted.name = "P2";
    omitted.text = "time passes";
    small.system.omitted.push_back({omitted, "this model has no time", 1});
    omitted.name = "P4";
    omitted.text = {};
    small.system.omitted.push_back({omitted, "nor here", 2});
    expect_lines(emitted(small.system),
                 "INVARSPEC NAME P1 := a;\n"
                 "\n"
                 "-- P2: time passes\n"
                 "-- omitted: this model has no time\n"
                 "\n"
                 "INVARSPEC NAME P3 := b;\n"
                 "\n"
                 "-- P4\n"
                 "-- omitted: nor here\n");
}

TEST(EmitNusmv, LegalisesNamesAndMapsThemInTheHeader) {
    Small small;
    small.main().symbols[{0}].name = "S";
    small.inner().symbols[small.parameter].name = "S";
    small.system.instances[{0}].name = "next";
    small.add_property(Pattern::Reachable, {small.system.settled});
    small.system.properties[{0}].name = "all.X1";
    const std::string text = emitted(small.system);
    expect_lines(text,
                 "-- names that are not valid in NuSMV\n"
                 "--   in module main:\n"
                 "--     S is S_\n"
                 "--     next is next_\n"
                 "--   in module controller_press:\n"
                 "--     S is S_\n"
                 "--   of properties:\n"
                 "--     never_all.X1 is never_all_X1\n");
    expect_lines(text, "  next_ : controller_press(S_);\n");
    expect_lines(text,
                 "-- all.X1; holds if never_all_X1 is false\n"
                 "INVARSPEC NAME never_all_X1 := !next_.X_1;\n");
    expect_lines(text, "  next(X_1) := S_;\n");
}

TEST(EmitNusmv, WritesRangesAndValuesByCases) {
    Small small;
    Exprs& exprs = small.system.exprs;
    const Id<System::Symbol> count =
        small.inner().symbols.add({"N", integer_type(-2, 10), System::StateSymbol{}, "internals", {}});
    const Id<Expr> n = small.leaf(count), x = small.leaf(small.step);
    const Id<Expr> more = exprs.apply(Op::Plus, n, exprs.integer(1));
    const Id<Expr> next =
        exprs.conditional(x, more, exprs.conditional(small.leaf(small.parameter), exprs.integer(-1), n));
    small.inner().symbols[count].kind = System::StateSymbol{exprs.conditional(x, n, exprs.integer(0)), next};
    std::get<System::StateSymbol>(small.inner().symbols[count].kind).initial =
        exprs.conditional(x, exprs.integer(3), exprs.integer(0));
    const std::string text = emitted(small.system);
    expect_lines(text, "  N : -2..10;\n");
    expect_lines(text, "  init(N) := (X_1 ? 3 : 0);\n");
    expect_lines(text, "  next(N) := case\n    X_1 : N + 1;\n    a : -1;\n    TRUE : N;\n  esac;\n");
}

TEST(EmitNusmv, WritesInvariantsAndJustice) {
    Small small;
    small.main().justice = {small.b()};
    small.main().invariants = {small.system.exprs.disjunction(small.a(), small.b())};
    expect_lines(emitted(small.system), "INVAR a | b;\nJUSTICE b;\n");
}

TEST(EmitNusmv, BreaksLongLinesBetweenTokens) {
    Small small;
    std::vector<Id<Expr>> terms;
    for (int k = 0; k < 60; ++k) terms.push_back(small.leaf(small.input("an_input_" + std::to_string(k))));
    const Id<Expr> all = small.system.exprs.conjunction(terms);
    small.add_property(Pattern::Always, {all});
    const std::string text = emitted(small.system);
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 118U) << line;
    const NusmvModel model = read_nusmv(text);
    ASSERT_EQ(model.error_text, "");
    std::string expected = "an_input_0";
    for (int k = 1; k < 60; ++k) expected += " & an_input_" + std::to_string(k);
    EXPECT_EQ(model.modules[0].specifications[0].formula, expected);
}

TEST(EmitNusmv, ChoicesAreInputVariablesAndNamedValuesAreWords) {
    Small small;
    Exprs& exprs = small.system.exprs;
    System::Module& inner = small.inner();
    const auto choice = inner.symbols.add({"edge", integer_type(0, 1), System::ChoiceSymbol{}, "", {}, {"go", "stay"}});
    const auto location = inner.symbols.add({"location", integer_type(0, 1), {}, "", {}, {"in", "out"}});
    const Id<Expr> goes = exprs.apply(Op::Equal, small.leaf(choice), exprs.integer(0));
    inner.symbols[location].kind =
        System::StateSymbol{exprs.integer(0), exprs.conditional(goes, exprs.integer(1), small.leaf(location))};
    inner.transitions.push_back(exprs.disjunction(exprs.negation(goes), small.leaf(small.parameter)));
    ASSERT_EQ(verify(small.system), std::vector<std::string>{});
    std::ostringstream out;
    nusmv::emit(small.system, out);
    const std::string text = out.str();
    for (const char* line : {"IVAR\n  edge : {go, stay};\n", "  location : {in_, out};\n", "init(location) := in_;",
                             "next(location) := (edge = go ? out : location);", "TRANS !(edge = go) | a;", "in is in_"})
        EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
}

}  // namespace
}  // namespace grafverif
