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
#include "syntax/language/format.hpp"
#include "syntax/language/parse.hpp"

namespace grafverif::chart_instances {
namespace {

struct Reading {
    std::optional<Model> model = {};
    std::string rendered = {};
    References references = {};
};

Reading read(const std::string& text, const std::map<std::string, std::string>& files = {}) {
    Sources sources;
    Diagnostics diagnostics;
    Reading reading;
    ReadContext context;
    context.references = &reading.references;
    context.load = [&](const std::string& path, std::string& why) -> std::optional<std::string> {
        const auto found = files.find(path);
        if (found == files.end()) return why = "not found", std::nullopt;
        return found->second;
    };
    reading.model = read_text(sources.add({"main.grafcet", text}), sources, context, diagnostics);
    std::ostringstream rendered;
    render_text(diagnostics.all(), sources, Colour::Plain, rendered);
    reading.rendered = std::move(rendered).str();
    return reading;
}

using Names = std::vector<std::string>;

template <class Entities>
Names names(const Entities& entities) {
    Names found;
    for (const auto& each : entities) found.push_back(each.name);
    return found;
}

const std::string head =
    "grafcet head(input HERE, FULL; output VALVE; DRIP = 500ms, ROUNDS: int 1..8 = 2) {\n"
    "    internal N: int 0..8 = 0;\n"
    "    initial step 0;\n"
    "    step 1 { VALVE; }\n"
    "    transition open: 0 -> 1 when HERE && N < ROUNDS do N := N + 1;\n"
    "    transition close: 1 -> 0 when FULL && DRIP/head.X1;\n"
    "}\n";

const std::string source =
    "component source(output OUT, OTHER) {\n"
    "    initial location idle;\n"
    "    timed idle -> idle do OUT := !OUT, OTHER := OUT;\n"
    "}\n";

/// Returns a loop with two instances; `more` are further arguments, `items` further declarations.
std::string controllers(const std::string& more, const std::string& items = "") {
    return head + source +
           "closed_loop l {\n"
           "    for i in 1..2 {\n"
           "        controller Head[i] = head(HERE = Source[i].OUT, FULL = FULL[i], VALVE = VALVE[i]" +
           more +
           ");\n"
           "        plant Source[i] = source(OUT = HERE[i], OTHER = FULL[i]);\n"
           "    }\n" +
           items + "}\n";
}

std::string plc(const std::string& arguments, const std::string& items = "") {
    return head + "grafcet plc {\n    input HERE, FULL, LEVEL: int 0..9;\n    output VALVE;\n" + items +
           "    partial mode { initial step 0; }\n    partial Head = head(" + arguments + ");\n}\n";
}
const std::string bound = "HERE = HERE, FULL = FULL, VALVE = VALVE";

TEST(ChartInstances, AreChartsWithTheVariablesOfTheInstance) {
    const Reading reading = read(controllers(", DRIP = i * 1s", "property p: never Head[2].X1 && Head[1].N > 1;\n"));
    ASSERT_TRUE(reading.model) << reading.rendered;
    EXPECT_EQ(names(reading.model->charts), Names({"head", "Head[1]", "Head[2]"}));
    const Chart& second = *std::next(reading.model->charts.begin(), 2);
    EXPECT_EQ(names(second.variables), Names({"HERE[2]", "FULL[2]", "VALVE[2]", "N"}));
    EXPECT_EQ(second.time_conditions.begin()->rise_ms, 2000);
    EXPECT_EQ(reading.model->charts.begin()->time_conditions.begin()->rise_ms, 500);
    EXPECT_EQ(second.instance_of, "head");
    EXPECT_FALSE(second.has_defaults);
    EXPECT_EQ(names(reading.model->loops.begin()->controllers), Names({"Head[1]", "Head[2]"}));
}

TEST(ChartInstances, ArePartialChartsOfAChart) {
    const Reading reading = read(plc(bound + ", ROUNDS = 4"));
    ASSERT_TRUE(reading.model) << reading.rendered;
    const Chart& chart = *std::next(reading.model->charts.begin());
    EXPECT_EQ(names(chart.variables), Names({"HERE", "FULL", "LEVEL", "VALVE", "Head.N"}));
    EXPECT_EQ(names(chart.transitions), Names({"Head.open", "Head.close"}));
    EXPECT_EQ(step_variable(chart, {2}), "Head.X1");
}

TEST(ChartInstances, ReadStepVariablesThroughInputs) {
    const Reading reading = read(plc("HERE = mode.X0, FULL = FULL, VALVE = VALVE"));
    EXPECT_TRUE(reading.model) << reading.rendered;
}

TEST(ChartInstances, UseChartsOfIncludedFilesInAnyOrder) {
    const std::string instance =
        "grafcet plc { input A, B; output C; partial P = head(HERE = A, FULL = B, VALVE = C); }\n";
    EXPECT_TRUE(read("include \"a.grafcet\";\n" + instance, {{"a.grafcet", head}}).model);
    EXPECT_TRUE(read(instance + head).model);
    EXPECT_TRUE(read("include \"a.grafcet\";\n" + head, {{"a.grafcet", instance}}).model);
}

TEST(ChartInstances, ConstantsDetermineRangesReplicationsAndOtherConstants) {
    const Reading reading = read(
        "grafcet g(COUNT = 2, LAST: int 0..9 = COUNT + 1, ON = true) {\n"
        "    for i in 1..COUNT { input A[i]; }\n"
        "    internal N: int 0..LAST = LAST, M = ON;\n"
        "    initial step 0;\n"
        "    step 1;\n"
        "    transition 0 -> 1 when all(i in 1..COUNT: A[i]) && ON && N == LAST;\n"
        "}\n" +
        source +
        "closed_loop l {\n"
        "    controller G = g(A[1] = X, A[2] = Y, A[3] = Z, COUNT = 3, ON = !true);\n"
        "    plant s = source(OUT = X, OTHER = Y);\n"
        "    plant t = source(OUT = Z, OTHER = W);\n"
        "}\n");
    ASSERT_TRUE(reading.model) << reading.rendered;
    const Chart& plain = *reading.model->charts.begin();
    const Chart& instance = *std::next(reading.model->charts.begin());
    EXPECT_EQ(names(plain.variables), Names({"A[1]", "A[2]", "N", "M"}));
    EXPECT_EQ(names(instance.variables), Names({"X", "Y", "Z", "N", "M"}));
    EXPECT_EQ(std::next(plain.variables.begin(), 2)->initial, 3);
    EXPECT_EQ(std::next(instance.variables.begin(), 3)->initial, 4);
    EXPECT_EQ(std::next(instance.variables.begin(), 4)->initial, 0);
}

TEST(ChartInstances, ConstantsMayHaveIndices) {
    const std::string chart =
        "grafcet g(input IN; T[1] = 1s, T[2] = 2s) {\n"
        "    initial step 0;\n"
        "    transition 0 -> 0 when T[1]/IN && T[2]/X0;\n"
        "}\n" +
        source;
    const Reading reading =
        read(chart + "closed_loop l { controller G = g(IN = A, T[2] = 4s); plant s = source(OUT = A, OTHER = B); }\n");
    ASSERT_TRUE(reading.model) << reading.rendered;
    const Chart& instance = *std::next(reading.model->charts.begin());
    EXPECT_EQ(instance.time_conditions.begin()->rise_ms, 1000);
    EXPECT_EQ(std::next(instance.time_conditions.begin())->rise_ms, 4000);
    EXPECT_FALSE(instance.has_defaults);
}

TEST(ChartInstances, FormatKeepsThem) {
    const std::string text =
        "grafcet head(input HERE; output VALVE; DRIP = 500ms, N: int 1..3 = 2) {\n"
        "    partial Other[1] = head(HERE = HERE, VALVE = VALVE, DRIP = 2 * 1s);\n"
        "}\n\n"
        "closed_loop l {\n"
        "    controller Head[1] = head(HERE = B[1].HERE, VALVE = VALVE) every 10ms with every_cycle;\n"
        "    controller Head_with_a_long_name = head(HERE = A_variable_with_a_very_long_name_number_1,\n"
        "                                            VALVE = A_variable_with_a_very_long_name_number_2, N = 3);\n"
        "}\n";
    Sources sources;
    Diagnostics diagnostics;
    const tree::File file = parse_file(sources.add({"main.grafcet", text}), sources, diagnostics);
    ASSERT_FALSE(diagnostics.has_errors());
    EXPECT_EQ(formatted(file), text);
}

TEST(ChartInstances, ReferencesPointToTheChart) {
    const std::string text = controllers(", DRIP = 1s", "property p: never Head[1].X1;\n");
    const Reading reading = read(text);
    ASSERT_TRUE(reading.model) << reading.rendered;
    const auto target = [&](const std::string& place, std::size_t offset, std::size_t skip = 0) {
        std::size_t at = text.find(place);
        for (; skip > 0; --skip) at = text.find(place, at + 1);
        at += offset;
        for (const References::Reference& each : reading.references.references)
            if (each.where.begin == at) return text.substr(each.declaration.begin, 8);
        return std::string("none");
    };
    EXPECT_EQ(target("= head(", 2), "head(inp");
    EXPECT_EQ(target("HERE = Source[i].OUT", 0), "HERE, FU");
    EXPECT_EQ(target("Source[i].OUT", 0), "Source[i");
    EXPECT_EQ(target("DRIP = 1s", 0), "DRIP = 5");
    EXPECT_EQ(target("Head[1].X1", 0), "Head[i] ");
    EXPECT_EQ(target("Head[1].X1", 8), "1 { VALV");
    EXPECT_EQ(target("DRIP/head", 0), "DRIP = 5");
}

TEST(ChartInstances, ReportsErrorsInArgumentsAtTheArgument) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {controllers(", DRIP = 3"), "this is an integer, but `DRIP` requires a duration"},
        {controllers(", ROUNDS = 9"), "9 is outside the range 1..8 of `ROUNDS`"},
        {controllers(", DRIPS = 1s"), "unknown parameter `DRIPS`; did you mean `DRIP`?"},
        {controllers(", DRIP = 1s, DRIP = 2s"), "a second argument is named `DRIP`"},
        {controllers(", DRIP = HERE"), "`DRIP` must be constant"},
        {plc("HERE = HERE, FULL = FULL"), "argument `VALVE` of `head` is missing; write `VALVE = NAME`"},
        {plc("HERE = HERE, FULL = HERE, VALVE = VALVE"), "`HERE` is bound to `HERE` and `FULL`"},
        {plc("HERE = !HERE, FULL = FULL, VALVE = VALVE"), "the port `HERE` is bound to a term"},
        {plc("HERE = HERES, FULL = FULL, VALVE = VALVE"), "unknown variable `HERES`; did you mean `HERE`?"},
        {plc("HERE = LEVEL, FULL = FULL, VALVE = VALVE"), "`LEVEL` is an integer; expected Boolean"},
        {plc("HERE = HERE, FULL = VALVE, VALVE = FULL"), "`FULL`"},
        {plc("HERE = mode.X7, FULL = FULL, VALVE = VALVE"), "unknown step `X7`"},
        {plc("HERE = HERE, FULL = FULL, VALVE = mode.X0"), "the output `mode.X0` is bound to a term"},
        {head + "closed_loop l { controller H = heat(HERE = A); }", "unknown chart `heat`; did you mean `head`?"},
        {head + source +
             "closed_loop l { controller H = head(HERE = s.IN, FULL = B, VALVE = C);\n"
             "plant s = source(OUT = A, OTHER = B); }",
         "unknown parameter `IN`"},
        {head + source +
             "closed_loop l { controller H = head(HERE = t.OUT, FULL = B, VALVE = C);\n"
             "plant s = source(OUT = A, OTHER = B); }",
         "unknown instance `t`"},
        {head + source +
             "closed_loop l { controller s = head(HERE = A, FULL = B, VALVE = C);\n"
             "plant s = source(OUT = A, OTHER = B); }",
         "a second instance is named `s`"},
    };
    for (const auto& [text, message] : cases) {
        const Reading reading = read(text);
        EXPECT_FALSE(reading.model) << text;
        EXPECT_NE(reading.rendered.find(message), std::string::npos) << reading.rendered << "\nexpected: " << message;
    }
}

TEST(ChartInstances, ReportsAllWrongArgumentsInOneRun) {
    const Reading reading = read(plc("HERE = HERE, FULL = FULL, DRIP = 3, ROUNDS = 0, N = HERE"));
    for (const char* message :
         {"`DRIP` requires a duration", "0 is outside the range", "`HERE` is bound to `HERE` and `N`",
          "argument `VALVE` of `head` is missing", "unknown parameter `N`"})
        EXPECT_NE(reading.rendered.find(message), std::string::npos) << message << '\n' << reading.rendered;
}

TEST(ChartInstances, ErrorsInTheChartNameTheInstance) {
    const Reading reading = read(controllers(", DRIP = (i - 1) * 1s"));
    EXPECT_TRUE(reading.rendered.starts_with("main.grafcet:6:43: error: the duration is zero or negative"))
        << reading.rendered;
    EXPECT_NE(reading.rendered.find("main.grafcet:14:20: note: in the instance `Head[1]`"), std::string::npos)
        << reading.rendered;
    EXPECT_EQ(reading.rendered.find("Head[2]"), std::string::npos) << reading.rendered;
}

TEST(ChartInstances, AChartWithErrorsHasNoFurtherErrors) {
    std::string wrong = controllers("", "property p: never Head[1].X1;\n");
    wrong.replace(wrong.find("when HERE"), 9, "when THEM");
    const Reading reading = read(wrong);
    EXPECT_EQ(reading.rendered.find("THEM"), reading.rendered.rfind("unknown variable `") + 18) << reading.rendered;
    EXPECT_EQ(reading.rendered.find("Head"), std::string::npos) << reading.rendered;
}

TEST(ChartInstances, RejectsWrongConstantsOfCharts) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"A: duration", "the constant `A` has no value"},
        {"A = 1, A = 2", "a second constant is named `A`"},
        {"A: int 1..2 = 3", "the initial value 3 of `A` is outside its range 1..2"},
        {"A: bool = 3", "requires a condition"},
        {"X0 = 3", "a second name is named `X0`"},
        {"B = 3", "a second name is named `B`"},
        {"A = B", "must be constant"},
    };
    for (const auto& [parameters, message] : cases) {
        const Reading reading =
            read("grafcet g(" + parameters + ") { input B; initial step 0; transition 0 -> 0 when B; }");
        EXPECT_FALSE(reading.model) << parameters;
        EXPECT_NE(reading.rendered.find(message), std::string::npos) << reading.rendered << "\nexpected: " << message;
    }
}

// `A[COUNT]` and `XS[COUNT]` are declared for the declared value of COUNT only. In an instance with another value, they
// must not denote a variable or a step outside the instance.
TEST(ChartInstances, NeverReadVariablesAndStepsAroundThem) {
    const std::string chart =
        "grafcet g(input IN; output OUT; COUNT = 2) {\n"
        "    input A[1], A[2];\n"
        "    internal M[1], M[2];\n"
        "    initial step 0;\n"
        "    step S[2] { OUT; }\n"
        "    transition 0 -> S[2] when READ do WRITTEN := true;\n"
        "    transition S[2] -> 0 when !IN;\n"
        "}\n";
    const auto with = [&](std::string read, std::string written) {
        std::string text = chart;
        text.replace(text.find("READ"), 4, read);
        return text.replace(text.find("WRITTEN"), 7, written);
    };
    const std::string partial =
        "grafcet plc { input A[3], B, C, D; output O; internal M[3];\n"
        "    partial m { initial step S[3]; transition S[3] -> S[3] when A[3] && M[3]; }\n"
        "    partial H = g(IN = B, OUT = O, A[1] = C, A[2] = D, COUNT = 3); }\n";
    const auto controller = [](const std::string& in, const std::string& out) {
        return source + "closed_loop l { controller H = g(IN = " + in + ", OUT = " + out +
               ", A[1] = C, A[2] = D, COUNT = 3);\n plant s = source(OUT = C, OTHER = D);\n environment e = free(OUT "
               "= " +
               in + "); }\n";
    };
    const std::vector<std::pair<std::string, std::string>> cases = {
        {with("A[COUNT]", "M[1]") + partial, "unknown variable `H.A[3]`; declare it"},
        {with("M[COUNT]", "M[1]") + partial, "unknown variable `H.M[3]`; declare it"},
        {with("IN", "M[COUNT]") + partial, "unknown variable `H.M[3]`; declare it"},
        {with("XS[COUNT]", "M[1]") + partial, "unknown step `XS[3]`"},
        {with("A[COUNT]", "M[1]") + controller("A[3]", "O"), "unknown variable `H.A[3]`; declare it"},
        {with("IN", "M[COUNT]") + controller("B", "M[3]"), "unknown variable `H.M[3]`; declare it"},
    };
    for (const auto& [text, message] : cases) {
        const Reading reading = read(text);
        EXPECT_FALSE(reading.model) << text;
        EXPECT_NE(reading.rendered.find(message), std::string::npos) << reading.rendered << "\nexpected: " << message;
    }
    EXPECT_TRUE(read(with("A[2] && XS[2]", "M[2]") + partial).model);
}

// The name of the chart denotes the chart in each instance, also if a partial chart has the name of the instance.
TEST(ChartInstances, NamesOfPartialChartsAreNotThoseOfInstances) {
    const std::string text =
        "grafcet g(input IN) {\n"
        "    initial step 0;\n"
        "    step 1;\n"
        "    transition 0 -> 1 when IN;\n"
        "    transition 1 -> 0 when P.X1;\n"
        "    partial P { initial step 0; step 1; transition 0 -> 1 when g.X1; transition 1 -> 0 when !g.X1; }\n"
        "}\n" +
        source + "closed_loop l { controller P = g(IN = A); plant s = source(OUT = A, OTHER = B); }\n";
    const Reading reading = read(text);
    ASSERT_TRUE(reading.model) << reading.rendered;
    const Chart& chart = *reading.model->charts.begin();
    const Chart& instance = *std::next(reading.model->charts.begin());
    const auto read_step = [](const Chart& of) {
        const Expr& condition = of.exprs[std::next(of.transitions.begin(), 2)->condition];
        EXPECT_EQ(condition.op, Op::Step);
        return step_variable(of, {static_cast<std::uint32_t>(condition.value)});
    };
    EXPECT_EQ(read_step(chart), "X1");
    EXPECT_EQ(read_step(instance), "X1");
}

TEST(ChartInstances, AcceptFindingsAboutTheirOwnElements) {
    const Reading reading = read(
        "grafcet g(input IN, SPARE) {\n"
        "    accept transition-never-fired IN \"spare\";\n"
        "    accept input-never-read SPARE \"spare\";\n"
        "    accept step-never-active \"spare\";\n"
        "    initial step 0;\n"
        "    transition IN: 0 -> 0 when IN;\n"
        "}\n"
        "grafcet plc { input A, B; partial P = g(IN = A, SPARE = B); }\n" +
        source + "closed_loop l { controller C = g(IN = A, SPARE = B); plant s = source(OUT = A, OTHER = B); }\n");
    ASSERT_TRUE(reading.model) << reading.rendered;
    const Chart& plc = *std::next(reading.model->charts.begin());
    const Chart& controller = *std::next(reading.model->charts.begin(), 2);
    ASSERT_EQ(plc.accepted.size(), 3U);
    EXPECT_EQ(plc.accepted[0].subject, "P.IN");
    EXPECT_EQ(plc.accepted[1].subject, "B");
    EXPECT_EQ(plc.accepted[2].subject, "P.");
    ASSERT_EQ(controller.accepted.size(), 3U);
    EXPECT_EQ(controller.accepted[0].subject, "IN");
    EXPECT_EQ(controller.accepted[1].subject, "B");
    EXPECT_EQ(controller.accepted[2].subject, "");
}

TEST(ChartInstances, ReportsWrongNamesOnce) {
    const std::vector<std::pair<std::string, std::string>> cases = {
        {plc("HERE = HERES, FULL = FULL, VALVE = VALVES"), "unknown variable `HERES`; did you mean `HERE`?"},
        {plc("HERE = X0, FULL = FULL, VALVE = VALVE"), "unknown variable `X0`; did you mean `mode.X0`?"},
        {head + source +
             "closed_loop l { controller H = head(HERE = N, FULL = A, VALVE = C); plant s = source(OUT = N, OTHER = "
             "A); }",
         "a second variable is named `N`"},
        {"grafcet g(N = 3) { initial step 0; for N in 1..2 { input A[N]; } transition 0 -> 0 when A[1]; }",
         "the index variable `N` has the name of another declaration"},
    };
    for (const auto& [text, message] : cases) {
        const Reading reading = read(text);
        EXPECT_FALSE(reading.model) << text;
        EXPECT_NE(reading.rendered.find(message), std::string::npos) << reading.rendered << "\nexpected: " << message;
        EXPECT_EQ(reading.rendered.find("in the instance"), std::string::npos) << reading.rendered;
    }
}

TEST(ChartInstances, RejectsPartialChartsInPartialCharts) {
    const Reading reading = read(
        "grafcet g { input A; output C; partial P { initial step 0 { C; } transition 0 -> 0 when A; } }\n"
        "grafcet h { input A; output C; partial Q = g(A = A, C = C); }\n"
        "grafcet k { input A; output C; partial R = k(A = A, C = C); }\n");
    EXPECT_FALSE(reading.model);
    EXPECT_NE(reading.rendered.find("main.grafcet:2:44: error: an instance of `g` cannot be a partial chart"),
              std::string::npos)
        << reading.rendered;
    EXPECT_NE(
        reading.rendered.find("an instance of `k` cannot be a partial chart, because `k` contains partial charts"),
        std::string::npos)
        << reading.rendered;
}

TEST(ChartInstances, AreLimited) {
    const std::string text = head +
                             "grafcet plc {\n    input A, B;\n    for i in 1..100000 {\n        output V[i];\n"
                             "        partial H[i] = head(HERE = A, FULL = B, VALVE = V[i]);\n    }\n}\n";
    const Reading reading = read(text);
    EXPECT_NE(reading.rendered.find(
                  "the copies of replications and instances contain more than 1000000 declarations and terms"),
              std::string::npos)
        << reading.rendered.substr(0, 1000);
    const std::string loop = head +
                             "closed_loop l {\n    for i in 1..100000 {\n"
                             "        controller H[i] = head(HERE = A, FULL = B, VALVE = V[i]);\n    }\n}\n";
    EXPECT_NE(read(loop).rendered.find("instances contain more than 1000000"), std::string::npos);
}

}  // namespace
}  // namespace grafverif::chart_instances
