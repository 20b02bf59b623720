// SPDX-License-Identifier: MIT
#include "read/text.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "support/print_model.hpp"

namespace grafverif {
namespace {

using Files = std::map<std::string, std::string>;

const std::vector<LibraryEntry> library = {
    {"button",
     "// A button.\n// It is pressed.\ncomponent button(output OUT; GAP = 1s) {\n    clock t;\n    initial location "
     "idle;\n"
     "    timed idle -> idle when t >= GAP do OUT := !OUT, t := 0;\n}\n",
     "button.grafcet"},
    {"broken", "component broken(", "broken.grafcet"},
};

struct Reading {
    std::optional<Model> model = {};
    std::string rendered = {};
    std::vector<std::string> codes = {};
};

Reading read(const std::string& text, const Files& files = {}) {
    Sources sources;
    Diagnostics diagnostics;
    const ReadContext context{[&](const std::string& path, std::string& why) -> std::optional<std::string> {
                                  const auto found = files.find(path);
                                  if (found != files.end()) return found->second;
                                  why = "there is no such file";
                                  return {};
                              },
                              library};
    Reading reading;
    reading.model = read_text(sources.add({"main.grafcet", text}), sources, context, diagnostics);
    std::ostringstream rendered;
    render_text(diagnostics.all(), sources, Colour::Plain, rendered);
    reading.rendered = std::move(rendered).str();
    for (const Diagnostic& diagnostic : diagnostics.all()) reading.codes.push_back(diagnostic.code);
    if (reading.model) {
        EXPECT_EQ(verify(*reading.model), std::vector<std::string>{});
    }
    return reading;
}

Model model(const std::string& text, const Files& files = {}) {
    Reading reading = read(text, files);
    EXPECT_TRUE(reading.model) << reading.rendered;
    return reading.model ? *reading.model : Model{};
}

std::string printed(const Model& model) {
    std::ostringstream out;
    print(out, model);
    return std::move(out).str();
}

const std::string lamp =
    "grafcet lamp {\n"
    "    input BUTTON;\n"
    "    output LAMP;\n"
    "    initial step 0;\n"
    "    step 1 { LAMP; }\n"
    "    transition 0 -> 1 when BUTTON;\n"
    "    transition t1: 1 -> 0 when 3s/X1 || 3s/X1 && !BUTTON;\n"
    "    transition 1 -> 0 when 3s/X1/2s;\n"
    "}\n";

// -- charts -----------------------------------------------------------------------------------------------------------

TEST(ReadText, WithoutAModelOnceItIsStopped) {
    std::atomic<bool> stop = false;
    Sources sources;
    Diagnostics diagnostics;
    const Id<Source> main = sources.add({"main.grafcet",
                                         "include \"part.grafcet\";\n"
                                         "grafcet a { initial step 0; transition t: 0 -> 0 when true; }\n"});
    ReadContext context;
    context.stop = &stop;
    context.load = [&](const std::string&, std::string&) -> std::optional<std::string> {
        stop = true;  // the returned text is correct, but reading stops
        return "grafcet b { initial step 0; transition t: 0 -> 0 when true; }\n";
    };
    EXPECT_FALSE(read_text(main, sources, context, diagnostics));
}

TEST(ReadChart, NamesTransitionsByPosition) {
    const Chart chart = *model(lamp).charts.begin();
    std::vector<std::string> names;
    for (const Chart::Transition& transition : chart.transitions) names.push_back(transition.name);
    EXPECT_EQ(names, (std::vector<std::string>{"t1_2", "t1", "t3"}));  // the name t1 is already declared
}

TEST(ReadChart, SharesEqualTimeConditions) {
    const Chart chart = *model(lamp).charts.begin();
    ASSERT_EQ(chart.time_conditions.size(), 2u);
    const Chart::TimeCondition& first = chart.time_conditions[{0}];
    EXPECT_EQ(first.rise_ms, 3000);
    EXPECT_EQ(first.fall_ms, 0);
    EXPECT_EQ(chart.exprs[first.watched].op, Op::Step);
    EXPECT_EQ(chart.time_conditions[{1}].fall_ms, 2000);
}

TEST(ReadChart, LooksForStepsInItsPartialChartFirst) {
    const Chart chart = *model(
                             "grafcet g {\n"
                             "    input a;\n"
                             "    initial step 1;\n"
                             "    step 2;\n"
                             "    transition t: 1 -> 2 when X1 && p.X1 && X7;\n"
                             "    partial p {\n"
                             "        initial step 1;\n"
                             "        step 7;\n"
                             "        transition u: 1 -> 7 when X1 && g.X1 && X2;\n"
                             "    }\n"
                             "}\n")
                             .charts.begin();
    const auto steps = [&](Id<Chart::Transition> transition) {
        std::string names;
        for (const Id<Expr> leaf : leaves(chart.exprs, chart.transitions[transition].condition))
            names += step_variable(chart, Id<Chart::Step>{static_cast<std::uint32_t>(chart.exprs[leaf].value)}) + ' ';
        return names;
    };
    EXPECT_EQ(steps({0}), "X1 p.X1 p.X7 ");
    EXPECT_EQ(steps({1}), "p.X1 X1 X2 ");
}

TEST(ReadChart, SupportsTheCompleteStandard) {
    const Chart chart =
        *model(
             "grafcet g {\n"
             "    input a, b;\n"
             "    output O;\n"
             "    internal N: int -2..5 = 1, M = true;\n"
             "    constraint !(a && b);\n"
             "    initial step 0 { O if a after 1s for 2s; force p := {INIT}; force p := {*}; force p := {21, 20}; }\n"
             "    macro step 1 expands e;\n"
             "    enclosing step 2 encloses q;\n"
             "    transition s: -> 2 when rise(a);\n"
             "    transition t: 0, 2 -> 1 when fall(a) do N := N - 1, M := !M;\n"
             "    transition k: 1 -> when 2s/a/1s && b/3s;\n"
             "    expansion e { entry exit step E { N := -1 on event rise(b); } }\n"
             "    partial p { initial step 20; step 21; }\n"
             "    partial q { linked step 30; }\n"
             "}\n")
             .charts.begin();
    EXPECT_EQ(chart.forcing.size(), 3u);
    EXPECT_EQ(chart.forcing[{2}].situation.size(), 2u);
    EXPECT_EQ(chart.stored.size(), 3u);
    EXPECT_EQ(chart.continuous[{0}].delay_ms, 1000);
    EXPECT_EQ(chart.continuous[{0}].limit_ms, 2000);
    EXPECT_EQ(chart.constraints.size(), 1u);
    EXPECT_EQ(chart.partial_charts[{1}].kind, Chart::PartialKind::Expansion);
    EXPECT_EQ(chart.partial_charts[{1}].owner, Id<Chart::Step>{1});
    EXPECT_EQ(chart.partial_charts[{3}].kind, Chart::PartialKind::Enclosed);
    EXPECT_EQ(chart.variables[{3}].type, integer_type(-2, 5));
    EXPECT_EQ(chart.variables[{4}].initial, 1);
}

TEST(ReadChart, AcceptsStepsActivatedByForcingEnclosingAndMacroSteps) {
    EXPECT_TRUE(read("grafcet g {\n"
                     "    input a;\n"
                     "    initial step 0 { force p := {20}; }\n"
                     "    transition t: -> 7 when a;\n"
                     "    step 7;\n"
                     "    transition t7: 7 -> when a;\n"
                     "    partial p { step 20; step 21; transition u: 20 -> 21 when a; }\n"
                     "}\n")
                    .model);
}

// -- one cause, one error ---------------------------------------------------------------------------------------------

TEST(ReadErrors, AreReportedTogetherAndOnce) {
    const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
        // There is one error for every use of a misspelt name, but there are no consequential errors.
        {"grafcet g {\n input a;\n initial step 0;\n step 1;\n transition t: 0 -> 1 when b;\n transition u: 1 -> 0 "
         "when b && !b;\n}\n",
         {"unknown-variable", "unknown-variable", "unknown-variable"}},
        // A chart with an error causes no errors in a loop that refers to it.
        {"grafcet g {\n input a;\n initial step 0 { O; }\n}\nclosed_loop l {\n controller g;\n property p: always "
         "X0;\n}\n",
         {"unknown-variable"}},
        // A chart with a syntax error causes no errors in the loop either.
        {"grafcet g {\n input a\n initial step 0;\n}\nclosed_loop l {\n controller g;\n property p: always X0;\n}\n",
         {"missing-semicolon"}},
        // A syntax error in one chart does not hide a semantic error in another chart.
        {"grafcet g {\n input a\n initial step 0;\n}\ngrafcet h {\n initial step 0 { O; }\n}\n",
         {"missing-semicolon", "unknown-variable"}},
        // An instance with an error still drives the variables that it binds.
        {lamp + "closed_loop l {\n controller lamp;\n environment b = button(OUT = BUTTON, GAPP = 1s);\n property p: "
                "never BUTTON && PP;\n}\n",
         {"unknown-parameter", "unknown-variable"}},
        // A missing file may contain any declaration.
        {"include \"x.grafcet\";\nclosed_loop l {\n controller g;\n}\n", {"cannot-include"}},
    };
    for (const auto& [text, codes] : cases) {
        SCOPED_TRACE(text);
        const Reading reading = read(text);
        EXPECT_FALSE(reading.model);
        EXPECT_EQ(reading.codes, codes) << reading.rendered;
    }
}

TEST(ReadErrors, WarnOnceOfAGroupOfStepsThatNothingActivates) {
    const Reading reading = read(
        "grafcet g {\n initial step 0;\n step 1;\n step 2;\n step 3;\n transition a: 1 -> 2 when true;\n transition "
        "b: 2 -> 3 when true;\n}\n");
    EXPECT_TRUE(reading.model);
    EXPECT_EQ(reading.codes, std::vector<std::string>{"unreachable-step"}) << reading.rendered;
}

TEST(ReadErrors, StaySearchableInHugeCharts) {
    std::string text = "grafcet g {\n    input a;\n    initial step 0;\n";
    for (int i = 1; i < 20000; ++i)
        text += "    step " + std::to_string(i) + ";\n    transition " + std::to_string(i - 1) + " -> " +
                std::to_string(i) + " when Xnowhere" + std::to_string(i) + ";\n";
    const Reading reading = read(text + "}\n");
    EXPECT_FALSE(reading.model);
    EXPECT_EQ(reading.codes.size(), Diagnostics::limit);
}

// -- components -------------------------------------------------------------------------------------------------------

TEST(ReadComponent, InfersTypesOfConstantsFromTheirDefaults) {
    const Component component =
        *model(
             "component c(output X: int L..H = L; L = 0, H, B = true, T = 2 * S, S = 1s, D: duration, K = H + L) {\n"
             "    initial location l;\n}\n")
             .components.begin();
    std::vector<Component::ValueKind> kinds;
    for (const Component::Parameter& parameter : component.parameters) kinds.push_back(parameter.value);
    using enum Component::ValueKind;
    EXPECT_EQ(kinds, (std::vector{Integer, Integer, Integer, Boolean, Duration, Duration, Duration, Integer}));
}

TEST(ReadComponent, PartsClocksFromData) {
    const Component component = *model(
                                     "component c(input A; output O; T = 1s) {\n"
                                     "    clock t;\n"
                                     "    initial location l invariant t <= T && t < 2 * T;\n"
                                     "    timed l -> l when A && (T <= t && !O) && t == 3s do O := A, t := 0;\n"
                                     "}\n")
                                     .components.begin();
    const Component::Edge& edge = component.edges[{0}];
    ASSERT_EQ(edge.constraint.size(), 2u);
    EXPECT_EQ(edge.constraint[0].relation, Op::GreaterEqual);  // `T <= t` is stored as t >= T
    EXPECT_EQ(edge.constraint[1].relation, Op::Equal);
    EXPECT_EQ(component.exprs.operands(edge.guard).size(), 2u);
    EXPECT_EQ(edge.resets.size(), 1u);
    EXPECT_EQ(edge.assignments.size(), 1u);
    EXPECT_EQ(component.locations[{0}].invariant.size(), 2u);
}

TEST(ReadComponent, UsesTheCommentAboveItAsSummary) {
    const auto summary = [](const std::string& text) {
        return model(text + "component c() {\n    initial location l;\n}\n").components.begin()->summary;
    };
    EXPECT_EQ(summary("// First.\n// Second.\n"), "First.");
    EXPECT_EQ(summary("// Of the file.\n\n// First.\n"), "First.");
    EXPECT_EQ(summary("// Of the file.\n\n"), "");
    EXPECT_EQ(summary("/* First.\n   Second. */\n"), "First.");
    EXPECT_EQ(summary("grafcet g { initial step 0; } // behind\n"), "");
}

// -- closed loops -----------------------------------------------------------------------------------------------------

TEST(ReadLoop, BindsArgumentsAndDefaults) {
    const Model read =
        model(lamp +
              "component sensor(input X: int; output HIGH; LIMIT = 2 * HALF, HALF = 3) {\n    initial location l;\n}\n"
              "component level(output X: int LOW..HIGH = LOW; LOW = 0, HIGH) {\n    initial location l;\n}\n"
              "closed_loop room {\n"
              "    controller lamp every CYCLE..2 * CYCLE with every_cycle;\n"
              "    constant CYCLE = 10ms;\n"
              "    plant Sensor = sensor(X = LEVEL, HIGH = FULL, HALF = 2 + 2);\n"
              "    plant Level = level(X = LEVEL, HIGH = 9);\n"
              "    environment Button = button(OUT = BUTTON);\n"
              "    property P: always !FULL || LEVEL > 3 && Button.idle && lamp.X1 && LAMP;\n"
              "}\n");
    const ClosedLoop& loop = read.loops[{0}];
    EXPECT_EQ(loop.controllers[{0}].mode, ExecutionMode::EveryCycle);
    EXPECT_EQ(loop.controllers[{0}].cycle, (TaskCycle{10, 20, {}}));
    const ClosedLoop::Instance& sensor = loop.instances[{0}];
    EXPECT_EQ(std::get<std::int64_t>(sensor.arguments[2]), 8);
    EXPECT_EQ(std::get<std::int64_t>(sensor.arguments[3]), 4);
    const ClosedLoop::Shared& level = loop.shared[std::get<Id<ClosedLoop::Shared>>(sensor.arguments[0])];
    EXPECT_EQ(level.name, "LEVEL");
    EXPECT_EQ(level.type, integer_type(0, 9));
    EXPECT_EQ(std::get<std::int64_t>(loop.instances[{2}].arguments[1]), 1000);
    EXPECT_EQ(loop.symbols.size(), 5u);
    EXPECT_EQ(read.components.size(), 3u);  // the library provides `button`
}

TEST(ReadLoop, LetsControllersShareInputsAndReadEachOther) {
    const Model read = model(
        "grafcet a {\n    input GO;\n    output READY;\n    initial step 0 { READY; }\n    transition t: 0 -> 0 when "
        "GO;\n}\n"
        "grafcet b {\n    input GO, READY;\n    initial step 0;\n    transition t: 0 -> 0 when GO && READY;\n}\n"
        "closed_loop l {\n    controller a;\n    controller b;\n    environment e = button(OUT = GO);\n}\n");
    const ClosedLoop& loop = read.loops[{0}];
    ASSERT_EQ(loop.shared.size(), 2u);
    EXPECT_EQ(loop.shared[{0}].name, "READY");
    EXPECT_TRUE(loop.shared[{0}].writer.valid() && loop.shared[{0}].reader.valid());
}

TEST(ReadLoop, PrefersComponentsOfTheFileToThoseOfTheLibrary) {
    const Reading reading =
        read(lamp +
             "component button(output OUT) {\n    initial location mine;\n}\n"
             "closed_loop l {\n    controller lamp;\n    environment e = button(OUT = BUTTON);\n}\n");
    ASSERT_TRUE(reading.model) << reading.rendered;
    EXPECT_EQ(reading.codes, std::vector<std::string>{"shadows-library"});
    EXPECT_EQ(reading.model->components[{0}].locations[{0}].name, "mine");
}

// -- files ------------------------------------------------------------------------------------------------------------

TEST(ReadIncludes, ReadsEachFileOnceRelativeToItsIncluder) {
    const Files files = {
        {"parts/a.grafcet", "include \"b.grafcet\";\ngrafcet a { initial step 0; }\n"},
        {"parts/b.grafcet", "include \"../c.grafcet\";\ngrafcet b { initial step 0; }\n"},
        {"c.grafcet", "grafcet c { initial step 0; }\n"},
    };
    const Model read = model(
        "include \"parts/a.grafcet\";\ninclude \"./parts/../parts/b.grafcet\";\ninclude \"c.grafcet\";\n"
        "grafcet main { initial step 0; }\n",
        files);
    std::string names;
    for (const Chart& chart : read.charts) names += chart.name + ' ';
    EXPECT_EQ(names, "c b a main ");
}

TEST(ReadIncludes, RejectsCyclesAndMissingFiles) {
    EXPECT_EQ(read("include \"main.grafcet\";\n").codes, std::vector<std::string>{"include-cycle"});
    EXPECT_EQ(read("include \"a.grafcet\";\n",
                   {{"a.grafcet", "include \"./b.grafcet\";\n"}, {"b.grafcet", "include \"a.grafcet\";\n"}})
                  .codes,
              std::vector<std::string>{"include-cycle"});
    EXPECT_EQ(read("include \"a.grafcet\";\ninclude \"a.grafcet\";\n").codes,
              std::vector<std::string>{"cannot-include"});
}

TEST(ReadIncludes, FollowsLongChains) {
    Files files;
    for (int i = 0; i < 2000; ++i) files[std::to_string(i)] = "include \"" + std::to_string(i + 1) + "\";\n";
    files["2000"] = "grafcet last { initial step 0; }\n";
    EXPECT_EQ(model("include \"0\";\n", files).charts.size(), 1u);
}

// -- printing ---------------------------------------------------------------------------------------------------------

TEST(PrintModel, PrintedTextIsReadBackUnchanged) {
    const std::vector<std::string> texts = {
        lamp,
        "grafcet g {\n input a, L: int 0..9, b;\n output O, P: int 0..3;\n internal N: int -2..5 = -1, M = true, K;\n "
        "constraint !(a && b) || L > 3;\n"
        " initial step 0 { O if a && b || !a after 1s for 2s; force p := {INIT}; force p := {*}; force p := {21, 20}; "
        "force p := {}; }\n"
        " macro step 1 expands e { P := 3 on activation; }\n enclosing step 2 encloses q;\n transition s: -> 2 when "
        "rise(a || b);\n"
        " transition t: 0, 2 -> 1 when fall(a) do N := N - -1, M := !M;\n transition k: 1 -> when 2s/(a && b)/1s && "
        "X20 && g.X0;\n"
        " expansion e { entry exit step E { N := -1 on event rise(b); } }\n partial p { initial step 20; step 0; "
        "transition z: 20 -> 0 when X0 && g.X0 && (3s/X20)/2s; step 21; transition y: 0 -> 21 when 0 - (1 - L) < N * "
        "(N + 1) % 4; }\n"
        " partial q { linked step 30; }\n}\n",
        "// It moves.\ncomponent c(input A, I: int; output X: int L..H = L, Y = true; L = 0, H, T = 1s, D: duration, "
        "B: bool, S = -1) {\n"
        " variable N: int L..H = 1;\n variable V = true;\n clock t, u;\n location l invariant t <= T + 2 * D with X := "
        "H, V := false;\n"
        " initial location 2;\n urgent l -> 2 when A && X < H do X := X + 1, t := 0;\n timed 2 -> l when t == T && A "
        "&& u > D do u := 0, Y := A;\n}\n",
        lamp +
            "closed_loop l {\n controller lamp with every_cycle;\n grain atomic;\n time unit 500ms;\n environment b = "
            "button(OUT = BUTTON, GAP = 1500ms);\n"
            " property p \"text\" expected violated: LAMP leads to !LAMP && b.idle at stable;\n property q: exactly "
            "one of {X0, X1};\n"
            " property r: uppaal \"A[] not deadlock\";\n property s: reachable all steps;\n}\n",
    };
    for (const std::string& text : texts) {
        const std::string once = printed(model(text));
        SCOPED_TRACE(once);
        EXPECT_EQ(printed(model(once)), once);
    }
}

}  // namespace
}  // namespace grafverif
