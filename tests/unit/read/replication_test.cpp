// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "read/text.hpp"
#include "support/print_model.hpp"
#include "syntax/resolve/expand.hpp"

namespace grafverif {
namespace {

struct Reading {
    std::optional<Model> model = {};
    Diagnostics diagnostics = {};
    std::string rendered = {};
    References references = {};
};

Reading read(const std::string& text, const std::map<std::string, std::string, std::less<>>& constants = {}) {
    Sources sources;
    Reading reading;
    ReadContext context;
    context.constants = constants;
    context.references = &reading.references;
    reading.model = read_text(sources.add({"main.grafcet", text}), sources, context, reading.diagnostics);
    std::ostringstream rendered;
    render_text(reading.diagnostics.all(), sources, Colour::Plain, rendered);
    reading.rendered = std::move(rendered).str();
    return reading;
}

template <class Entities>
std::vector<std::string> names(const Entities& entities) {
    std::vector<std::string> found;
    for (const auto& each : entities) found.push_back(each.name);
    return found;
}

using Names = std::vector<std::string>;

const std::string heads =
    "grafcet heads {\n"
    "    for i in 1..2 {\n"
    "        input FULL[i];\n"
    "        output VALVE[i];\n"
    "        partial head[i] {\n"
    "            initial step 0;\n"
    "            for k in i..2 {\n"
    "                step s[k] { VALVE[i] if any(n in 1..2: FULL[n]); }\n"
    "                transition t[k][i]: 0 -> s[k] when FULL[k];\n"
    "                transition s[k] -> 0 when !FULL[k] && Xs[k];\n"
    "            }\n"
    "        }\n"
    "    }\n"
    "}\n";

const std::string source =
    "component source(output OUT; GAP = 1s) {\n"
    "    clock t;\n"
    "    initial location idle;\n"
    "    timed idle -> idle when t >= GAP do OUT := !OUT, t := 0;\n"
    "}\n";

std::string in_loop(const std::string& items) {
    return heads + source + "closed_loop line {\n    controller heads;\n" + items + "}\n";
}

const std::string driven = "for i in 1..2 { environment Full[i] = source(OUT = FULL[i]); }\n";

TEST(Replication, DeclaresTheElementsOfAChartInTheOrderOfTheCopies) {
    const Reading reading = read(heads);
    ASSERT_TRUE(reading.model) << reading.rendered;
    const Chart& chart = *reading.model->charts.begin();
    EXPECT_EQ(names(chart.variables), (Names{"FULL[1]", "VALVE[1]", "FULL[2]", "VALVE[2]"}));
    EXPECT_EQ(names(chart.partial_charts), (Names{"head[1]", "head[2]"}));
    EXPECT_EQ(names(chart.steps), (Names{"0", "s[1]", "s[2]", "0", "s[2]"}));
    EXPECT_EQ(names(chart.transitions), (Names{"t[1][1]", "t2", "t[2][1]", "t4", "t[2][2]", "t6"}));
}

TEST(Replication, DeclaresTheElementsOfAClosedLoop) {
    const Reading reading =
        read(in_loop("constant N: int 0..4 = 1;\n"
                     "for i in N..N + 1 {\n"
                     "    constant T[i] = i * 1s;\n"
                     "    environment Full[i] = source(OUT = FULL[i], GAP = T[i]);\n"
                     "    property p[i]: head[i].Xs[2] leads to !FULL[2] within T[i];\n"
                     "    property q[i]: never Full[i].OUT && !FULL[i];\n"
                     "}\n"
                     "property one: exactly one of {FULL[1], head[i].X0 for i in 1..2};\n"));
    ASSERT_TRUE(reading.model) << reading.rendered;
    const ClosedLoop& loop = *reading.model->loops.begin();
    EXPECT_EQ(names(loop.constants), (Names{"N", "T[1]", "T[2]"}));
    EXPECT_EQ(names(loop.instances), (Names{"Full[1]", "Full[2]"}));
    EXPECT_EQ(names(loop.properties), (Names{"p[1]", "q[1]", "p[2]", "q[2]", "one"}));
    EXPECT_EQ(loop.properties[{2}].watch.duration_ms, 2000);
    EXPECT_EQ(loop.properties[{4}].operands.size(), 3U);
}

TEST(Replication, RepeatsTheDeclarationsOfAComponent) {
    const Reading reading = read(
        "component ring(input GO; output AT: int 0..3) {\n"
        "    initial location at[0];\n"
        "    for i in 1..3 {\n"
        "        location at[i];\n"
        "        urgent at[i - 1] -> at[i] when GO do AT := i;\n"
        "    }\n"
        "}\n");
    ASSERT_TRUE(reading.model) << reading.rendered;
    const Component& component = *reading.model->components.begin();
    EXPECT_EQ(names(component.locations), (Names{"at[0]", "at[1]", "at[2]", "at[3]"}));
    EXPECT_EQ(component.edges.size(), 3U);
}

TEST(Replication, FollowsConstantsThatAreSetFromOutside) {
    const std::string text =
        in_loop("constant N = 2;\nfor i in 1..N { environment Full[i] = source(OUT = FULL[i]); }\n");
    EXPECT_TRUE(read(text).model);
    const Reading reading = read(text, {{"N", "1"}});
    EXPECT_FALSE(reading.model);
    EXPECT_NE(reading.rendered.find("`FULL[2]`"), std::string::npos) << reading.rendered;
}

TEST(Replication, EqualsTheTextWithoutReplicationThatIsPrinted) {
    const Reading reading = read(in_loop(driven));
    ASSERT_TRUE(reading.model) << reading.rendered;
    std::ostringstream printed, again;
    print(printed, *reading.model);
    const Reading second = read(printed.str());
    ASSERT_TRUE(second.model) << second.rendered << printed.str();
    print(again, *second.model);
    EXPECT_EQ(printed.str(), again.str());
}

TEST(Replication, ReportsAnErrorOfAllCopiesOnceWithTheFirstCopy) {
    const Reading reading = read(in_loop(driven + "for i in 1..2 { for k in 3..9 { property p[i][k]: never 1; } }\n"));
    ASSERT_EQ(reading.diagnostics.all().size(), 1U) << reading.rendered;
    EXPECT_EQ(reading.diagnostics.distinct_errors(), 1U);
    ASSERT_EQ(reading.diagnostics.all()[0].notes.size(), 1U);
    EXPECT_EQ(reading.diagnostics.all()[0].notes[0].message, "in the copy with `i = 1, k = 3`");
}

TEST(Replication, ReportsTheErrorsOfAllDeclarationsInOneRun) {
    const Reading reading =
        read(in_loop(driven + "for i in 2..1 { property p[i]: no deadlock; }\nproperty q[LAST]: no deadlock;\n") +
             "closed_loop other { controller heads; }\n");
    EXPECT_EQ(reading.diagnostics.errors(), 4U) << reading.rendered;
}

TEST(Replication, IsLimited) {
    const std::string property = "property p[i][k]: never FULL[1];";
    for (const char* ranges :
         {"for i in 1..9223372036854775807 { for k in 1..2 {", "for i in 1..2000 { for k in 1..2000 {",
          "for i in 1..2 { for k in -9223372036854775807..1 {"}) {
        SCOPED_TRACE(ranges);
        const Reading reading = read(in_loop(driven + ranges + property + "} }\n"));
        ASSERT_EQ(reading.diagnostics.errors(), 1U) << reading.rendered;
        EXPECT_EQ(reading.diagnostics.all()[0].code, "too-large");
    }
    std::string nested = "!FULL[1]";
    for (int level = 0; level < 30; ++level) nested = fmt::format("all(i{} in 1..2: {})", level, nested);
    const Reading reading = read(in_loop(driven + "property p: never " + nested + ";\n"));
    ASSERT_EQ(reading.diagnostics.errors(), 1U) << reading.rendered;
    EXPECT_EQ(reading.diagnostics.all()[0].code, "too-large");
}

TEST(Replication, NestsToALimitedDepth) {
    std::string indices, open, close;
    for (int level = 0; level < 100'000; ++level) {
        indices += "[1]";
        open += fmt::format("for i{} in 1..1 {{", level);
        close += '}';
    }
    const Reading named = read(in_loop(driven + "property p" + indices + ": never FULL[1];\n"));
    ASSERT_EQ(named.diagnostics.all().size(), 1U) << named.rendered;
    EXPECT_EQ(named.diagnostics.all()[0].message, "the name has more than 8 indices; remove some of them");
    const Reading nested = read(in_loop(driven + open + close));
    ASSERT_FALSE(nested.diagnostics.all().empty());
    EXPECT_EQ(nested.diagnostics.all()[0].message, "the blocks are nested deeper than 100 levels; reduce the nesting");
}

TEST(Replication, IsRecordedOnceForAllCopies) {
    const Reading reading = read(in_loop(driven + "property p: never all(i in 1..2: FULL[i]);\n"));
    ASSERT_TRUE(reading.model) << reading.rendered;
    for (const References::Declaration& each : reading.references.declarations)
        EXPECT_EQ(each.name.find('['), std::string::npos) << each.name;
    EXPECT_EQ(std::ranges::count(reading.references.declarations, "i", &References::Declaration::name), 3);
}

std::vector<std::string> messages_of(const Reading& reading) {
    std::vector<std::string> messages;
    for (const Diagnostic& each : reading.diagnostics.all()) messages.push_back(each.message);
    return messages;
}

TEST(Replication, RejectsAnIndexVariableAsTheOwnerOfAName) {
    for (const auto& [operand, user] : {std::pair("i.X1", "`.`"), {"i.X1.Y", "`.`"}, {"i in open", "`in`"}}) {
        SCOPED_TRACE(operand);
        const Reading reading = read(in_loop(driven + "for i in 1..2 { property p[i]: never " + operand + "; }\n"));
        ASSERT_EQ(reading.diagnostics.all().size(), 1U) << reading.rendered;
        EXPECT_EQ(
            reading.diagnostics.all()[0].message,
            fmt::format("this is an integer, but {} requires the name of an instance, an observer or a chart", user));
    }
    const Reading chart =
        read("grafcet g { input A; initial step 0; for k in 1..2 { transition t[k]: 0 -> 0 when A && k.X0; } }");
    EXPECT_EQ(chart.diagnostics.all().size(), 1U) << chart.rendered;
}

TEST(Replication, RejectsAnIndexVariableWithTheNameOfAnElement) {
    const std::string chart =
        "grafcet g {\n    input A;\n    partial head { initial step 0; transition t0: 0 -> 0 when A; }\n";
    for (const char* name : {"g", "head", "A"}) {
        SCOPED_TRACE(name);
        const Reading loop = read(source + chart + "}\nclosed_loop l { controller g; plant P = source(OUT = A); for " +
                                  name + fmt::format(" in 1..2 {{ property p[{}]: no deadlock; }} }}\n", name));
        const Reading own =
            read(source + chart + "for " + name + fmt::format(" in 1..2 {{ input B[{}]; }} }}\n", name));
        for (const Reading* reading : {&loop, &own})
            EXPECT_EQ(messages_of(*reading),
                      (Names{fmt::format(
                          "the index variable `{}` has the name of another declaration; rename one of the two", name)}))
                << reading->rendered;
    }
    const Reading owner = read(source + chart +
                               "}\nclosed_loop l { controller g; plant P = source(OUT = A);\n"
                               "for head in 1..2 { property p[head]: never head.X0; } }\n");
    EXPECT_EQ(owner.diagnostics.errors(), 2U) << owner.rendered;  // once per copy
}

TEST(Replication, CountsTheBytesOfLongNamesAndTexts) {
    const std::string text(8000, 'x');
    std::string open, close;
    for (int level = 0; level < 75; ++level, close += '}')
        open += fmt::format("for n{}{} in 1..1 {{", level, std::string(240, 'x'));
    for (const std::string& items :
         {"for i in 1..100000 { property p[i] \"" + text + "\": never FULL[1]; }\n",
          open + "for i in 1..16 { for k in 1..4096 {} }" + close, open + "for i in 1..65536 { }" + close}) {
        const Reading reading = read(in_loop(driven + items));
        ASSERT_EQ(reading.diagnostics.errors(), 1U) << reading.rendered;
        EXPECT_EQ(reading.diagnostics.all()[0].code, "too-large");
        EXPECT_TRUE(reading.diagnostics.all()[0].notes.empty());
    }
}

TEST(Replication, IsLimitedForAllDeclarationsTogether) {
    const std::string items = driven + "for i in 1..90000 { property p[i]: never FULL[1]; }\n";
    EXPECT_TRUE(read(in_loop(items)).model);
    const Reading reading = read(in_loop(items) + "closed_loop second { controller heads;\n" + items + "}\n" +
                                 "closed_loop third { controller heads;\n" + items + "}\n");
    ASSERT_FALSE(reading.diagnostics.all().empty());
    EXPECT_EQ(reading.diagnostics.all()[0].code, "too-large");
}

TEST(Replication, ReportsManyErrorsOfCopiesInLinearTime) {
    const Reading reading = read(
        "grafcet g {\n    for i in 1..2000 { input A[i]; }\n    initial step 0;\n    step 1;\n"
        "    transition 0 -> 1 when A[1];\n    transition 1 -> 0 when A[2];\n"
        "    for i in 1..3000 { constraint !B[i]; }\n}\n");
    EXPECT_EQ(reading.diagnostics.errors(), 3000U);
    ASSERT_EQ(reading.diagnostics.all().size(), 1U) << reading.rendered;
    EXPECT_EQ(reading.diagnostics.all()[0].notes.back().message, "in the copy with `i = 1`");
}

TEST(Replication, ReportsTheErrorsOfAComponentOnceForAllCopies) {
    const Reading reading = read(
        "component ring(output AT: int 0..3) {\n"
        "    initial location at[0];\n"
        "    clock t;\n"
        "    for i in 1..3 {\n"
        "        variable v[i]: int;\n"
        "        location at[i] with v[i] := W[i];\n"
        "        urgent at[i - 1] -> at[i] when GO[i] do V[i] := i;\n"
        "        constraint U[i];\n"
        "        clock t;\n"
        "    }\n"
        "}\n");
    ASSERT_FALSE(reading.diagnostics.all().empty());
    for (const Diagnostic& each : reading.diagnostics.all()) {
        ASSERT_FALSE(each.notes.empty()) << reading.rendered;
        EXPECT_TRUE(each.notes.back().message.starts_with("in the copy with `i = ")) << reading.rendered;
    }
    EXPECT_EQ(reading.diagnostics.all().size(), 6U) << reading.rendered;
}

TEST(Replication, OfAComponentCannotDependOnAParameter) {
    const Reading reading = read(
        "component ring(output AT: bool; N = 3) {\n"
        "    initial location at[0];\n"
        "    for i in 1..N { location at[i]; }\n"
        "    for i in 1..M { location to[i]; }\n"
        "}\n");
    EXPECT_EQ(messages_of(reading),
              (Names{"the range of `i` cannot depend on the parameter `N`, which has a separate value in each "
                     "instance; write a number",
                     "the range of `i` must be constant; remove the variables"}))
        << reading.rendered;
}

TEST(Replication, ReportsAConstantBelowItsUseForEachElement) {
    const Reading reading = read(in_loop(driven + "constant T[1] = 1;\nconstant A = T[2];\nconstant T[2] = 2;\n"
                                                  "constant B = T[2];\nconstant C = T[3];\n"));
    EXPECT_EQ(messages_of(reading), (Names{"`T[2]` is declared after its use; move its declaration up",
                                           "`C` must be constant; remove the variables"}))
        << reading.rendered;
}

TEST(Replication, OfTermsMayHaveNoValues) {
    const auto condition = [](const std::string& term) {
        const Reading reading =
            read("grafcet g { input A[1]; initial step 0; transition t: 0 -> 0 when " + term + "; }");
        if (!reading.model) return reading.diagnostics.all()[0].message;
        const Chart& chart = *reading.model->charts.begin();
        const Expr& node = chart.exprs[chart.transitions.begin()->condition];
        return std::string(node.op == Op::True ? "true" : node.op == Op::False ? "false" : "a term");
    };
    EXPECT_EQ(condition("all(k in 2..1: A[k])"), "true");
    EXPECT_EQ(condition("any(k in 2..1: A[k])"), "false");
    EXPECT_EQ(condition("A[1] && any(k in 2..1: A[k])"), "false");
    EXPECT_EQ(condition("any(k in 1..1: all(n in k + 1..1: A[n]) && A[k])"), "a term");
    EXPECT_EQ(condition("all(k in 3..1: A[k])"), "the range 3..1 of `k` is empty; write the lower bound first");
    const Reading list = read(in_loop(driven + "property p: exactly one of {FULL[1], FULL[k] for k in 2..1};\n"));
    EXPECT_EQ(messages_of(list), (Names{"the range 2..1 of `k` is empty; write the lower bound first"}));
}

TEST(Replication, RecordsThePositionsOfMembersWithoutIndices) {
    const std::string text = in_loop(driven + "property p: never head[1].Xs[2];\n");
    const Reading reading = read(text);
    ASSERT_TRUE(reading.model) << reading.rendered;
    const std::size_t at = text.find("Xs[2];");
    EXPECT_TRUE(std::ranges::any_of(reading.references.references, [&](const References::Reference& each) {
        return each.where.begin == at && each.where.end == at + 2;
    }));
}

}  // namespace
}  // namespace grafverif
