// SPDX-License-Identifier: MIT
#include "syntax/language/parse.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "syntax/language/format.hpp"

namespace grafverif {
namespace {

/// Returns a term with every operator in parentheses, according to the grammar.
std::string shape(const tree::File& file, Id<tree::Expr> id) {
    const tree::Expr& node = file.exprs[id];
    if (!node.first.valid()) return formatted(file, id);
    if (node.op == tree::Op::Member) return shape(file, node.first) + '.' + std::string(file.text(node.word));
    const char* const names[] = {
        "false", "true", "number", "duration", "name", "member", "in",      "all", "any", "each",
        "not",   "rise", "fall",   "negate",   "and",  "or",     "implies", "==",  "!=",  "<",
        "<=",    ">",    ">=",     "+",        "-",    "*",      "/",       "%"};
    std::string text = std::string("(") + names[static_cast<std::size_t>(node.op)];
    for (Id<tree::Expr> operand = node.first; operand.valid(); operand = file.exprs[operand].next)
        text += ' ' + shape(file, operand);
    return text + ')';
}

Sources one(std::string text) {
    Sources sources;
    sources.add({"test.grafcet", std::move(text)});
    return sources;
}

/// Returns a chart whose only condition is `text`, which begins on the third line.
std::string chart_with(const std::string& text) {
    return "grafcet c {\n    initial step 1; transition t: 1 -> 1 when\n" + text + "\n;\n}\n";
}

Id<tree::Expr> only_condition(const tree::File& file) {
    return std::get<tree::Transition>(std::get<tree::Chart>(file.declarations.front()).items.back()).condition;
}

/// Returns the location and code of each error, one on each line.
std::string errors(const Diagnostics& diagnostics, const Sources& sources) {
    std::ostringstream out;
    for (const Diagnostic& diagnostic : diagnostics.all()) {
        const Place at = place(sources[diagnostic.where.source].text, diagnostic.where.begin);
        out << at.line << ':' << at.column << ' ' << diagnostic.code << '\n';
    }
    return std::move(out).str();
}

std::string errors_of(const std::string& text) {
    const Sources sources = one(text);
    Diagnostics diagnostics;
    const tree::File file = parse_file(Id<Source>{0}, sources, diagnostics);
    EXPECT_EQ(file.broken, diagnostics.has_errors());
    return errors(diagnostics, sources);
}

struct Case {
    std::string in, out;
};

TEST(ParseFile, EndsAtTheNextTokenOnceItIsStopped) {
    const Sources sources = one("grafcet a { initial step 0; transition t: 0 -> 0 when true; }\n");
    const std::atomic<bool> stop = true;
    Diagnostics diagnostics;
    const tree::File file = parse_file(Id<Source>{0}, sources, diagnostics, &stop);
    EXPECT_TRUE(file.broken);
    EXPECT_TRUE(file.declarations.empty());
    const std::atomic<bool> not_stopped = false;
    EXPECT_EQ(parse_file(Id<Source>{0}, sources, diagnostics, &not_stopped).declarations.size(), 1u);
}

TEST(ParseCondition, BindsOperatorsAsInTheLanguage) {
    const std::vector<Case> cases = {
        {"a || b && c", "(or a (and b c))"},
        {"a => b implies c || d", "(implies a (implies b (or c d)))"},
        {"!G.a in 3 => true", "(implies (not (in G.a)) true)"},
        {"a and b or not c", "(or (and a b) (not c))"},
        {"a && b && c && d", "(and a b c d)"},
        {"(a && b) && c", "(and (and a b) c)"},
        {"!a == b", "(== (not a) b)"},
        {"N + 1 < M * 2", "(< (+ N 1) (* M 2))"},
        {"a - b - c", "(- (- a b) c)"},
        {"a - (b - c)", "(- a (- b c))"},
        {"a * -b % c", "(% (* a (negate b)) c)"},
        {"3s/X2/2s && b", "(and (/ (/ 3s X2) 2s) b)"},
        {"rise(a) && ↓b", "(and (rise a) (fall b))"},
        {"↑(a || b)", "(rise (or a b))"},
        {"cell.G2.X2 || Arm.10", "(or cell.G2.X2 Arm.10)"},
        {"2min + 1.5s + 250ms", "(+ (+ 2min 1.5s) 250ms)"},
        {"!!a", "(not (not a))"},
        {"a /* between */ && // behind\n b", "(and a b)"},
    };
    for (const Case& example : cases) {
        SCOPED_TRACE(example.in);
        const Sources sources = one(chart_with(example.in));
        Diagnostics diagnostics;
        const tree::File file = parse_file(Id<Source>{0}, sources, diagnostics);
        ASSERT_FALSE(file.broken) << errors(diagnostics, sources);
        EXPECT_EQ(shape(file, only_condition(file)), example.out);
    }
}

TEST(ParseCondition, RejectsInvalidConditions) {
    const std::vector<Case> cases = {
        {"", "4:1 unexpected\n"},         {"a b", "3:3 unexpected\n"},        {"a < b < c", "3:7 unexpected\n"},
        {"a = b", "3:3 single-equals\n"}, {"(a", "4:1 unexpected\n"},         {"a && 3x", "3:6 unknown-unit\n"},
        {"always a", "3:1 unexpected\n"}, {"a <> b", "3:3 other-spelling\n"},
    };
    for (const Case& example : cases) {
        SCOPED_TRACE(example.in);
        EXPECT_EQ(errors_of(chart_with(example.in)), example.out);
    }
}

TEST(ParseCondition, ConvertsDurationsToMilliseconds) {
    for (const auto& [text, milliseconds] :
         {std::pair{"2min", 120'000}, {"1.5s", 1500}, {"0.25min", 15'000}, {"3s", 3000}, {"250ms", 250}}) {
        SCOPED_TRACE(text);
        const Sources sources = one(chart_with(text));
        Diagnostics diagnostics;
        const tree::File file = parse_file(Id<Source>{0}, sources, diagnostics);
        ASSERT_FALSE(file.broken) << errors(diagnostics, sources);
        EXPECT_EQ(file.exprs[only_condition(file)].value, milliseconds);
    }
}

TEST(ParseCondition, KeepsThePlaces) {
    const Sources sources = one(chart_with("a && b"));
    Diagnostics diagnostics;
    const tree::File file = parse_file(Id<Source>{0}, sources, diagnostics);
    const Span where = file.exprs[only_condition(file)].where;
    EXPECT_EQ(sources[where.source].text.substr(where.begin, where.end - where.begin), "a && b");
}

TEST(ParseProperty, AcceptsEveryPattern) {
    const std::vector<std::pair<std::string, Pattern>> cases = {
        {"always a", Pattern::Always},
        {"never a && b", Pattern::Never},
        {"reachable a", Pattern::Reachable},
        {"inevitable a", Pattern::Inevitable},
        {"a || b leads to c", Pattern::LeadsTo},
        {"no deadlock", Pattern::NoDeadlock},
        {"no timelock", Pattern::NoTimelock},
        {"reachable all steps", Pattern::ReachableAllSteps},
        {"exactly one of {X1, X2, X3}", Pattern::ExactlyOneOf},
        {"always possible a", Pattern::AlwaysPossible},
        {"a leads to b within 20s", Pattern::Watched},
        {"a holds for 3s", Pattern::Watched},
        {"a holds at most 3s * 2", Pattern::Watched},
        {"a at most 5s since b && c", Pattern::Watched},
        {"a at least every 1min", Pattern::Watched},
        {"a at most 2 times", Pattern::Watched},
        {"a at most 1 time between times and time", Pattern::Watched},
        {"a precedes b", Pattern::Watched},
        {"a precedes b between (c && d) and e || f", Pattern::Watched},
        {"never a before b", Pattern::Watched},
        {"always a => c after b", Pattern::Watched},
        {"inevitable a between !b and c", Pattern::Watched},
        {"a leads to b after c until d", Pattern::Watched},
        {"uppaal \"A[] a\"", Pattern::RawUppaal},
        {"ctl \"AG a\"", Pattern::RawCtl},
        {"ltl \"G a\"", Pattern::RawLtl},
    };
    for (const auto& [text, pattern] : cases) {
        SCOPED_TRACE(text);
        const Sources sources = one("closed_loop l {\n    property P:" + text + ";\n}\n");
        Diagnostics diagnostics;
        const tree::File file = parse_file(Id<Source>{0}, sources, diagnostics);
        ASSERT_FALSE(file.broken) << errors(diagnostics, sources);
        EXPECT_EQ(std::get<tree::Property>(std::get<tree::ClosedLoop>(file.declarations.front()).items.back()).pattern,
                  pattern);
    }
}

TEST(ParseFile, AcceptsKeywordsAsNames) {
    EXPECT_EQ(
        errors_of("grafcet on {\n"
                  "    input in, out, mid, still, with, at, stable, no, all, one, time, unit, event, if, for, after;\n"
                  "    output initial, location, plant, rise, int: int 0..3, bool;\n"
                  "    initial step partial { initial if with && !no || rise(rise); bool := int > 1 on event on; }\n"
                  "    step macro;\n"
                  "    transition of: partial -> macro, 7 when time && unit;\n"
                  "}\n"
                  "component to(input leads; clock = 1) {\n"
                  "    clock clock;\n"
                  "    initial location in with out := true;\n"
                  "    urgent in -> in when urgent do timed := 0;\n"
                  "}\n"
                  "closed_loop loop {\n"
                  "    controller with with stability_search;\n"
                  "    plant plant = environment(in = on, at = stable) initially mid;\n"
                  "    property property \"no\" expected violated: exactly leads to one at stable;\n"
                  "    property no: always no.no && exactly.of;\n"
                  "}\n"),
        "");
}

TEST(ParseFile, ContinuesWithTheNextDeclarationAfterAnError) {
    const std::vector<Case> cases = {
        {"grafcet a {\n    input A B;\n    input C D;\n    step 1;\n}\n", "2:13 unexpected\n3:13 unexpected\n"},
        {"grafcet a {\n    input A\n    output B;\n    step ;\n}\n", "2:12 missing-semicolon\n4:10 unexpected\n"},
        {"grafcet a {\n    step 1 { A\n    step 2;\n    step 3 4;\n}\n", "2:15 missing-semicolon\n4:12 unexpected\n"},
        {"grafcet a {\n    step 1;\n\ngrafcet b {\n    step 2 3;\n}\n", "1:1 missing-brace\n5:12 unexpected\n"},
        {"grafcet a {\n    step 1 { force G := {1, ; }; B C; }\n    step 2 3;\n}\n",
         "2:29 unexpected\n2:36 unexpected\n3:12 unexpected\n"},
        {"grafcet a b {\n    step 1 2;\n}\ngrafcet c {\n    step 1 2;\n}\n", "1:11 unexpected\n5:12 unexpected\n"},
        {"grafcet a {\n    step 1 { X; };\n    step 2 3;\n}\n", "2:18 unexpected\n3:12 unexpected\n"},
        {"nothing\ngrafcet a {\n    step 1 2;\n}\n", "1:1 unexpected\n3:12 unexpected\n"},
        {"grafcet a {\n    partial p {\n        step 1 2;\n        input a;\n    }\n    step 1 2;\n}\n",
         "3:16 unexpected\n4:9 unexpected\n6:12 unexpected\n"},
    };
    for (const Case& example : cases) {
        SCOPED_TRACE(example.in);
        EXPECT_EQ(errors_of(example.in), example.out);
    }
}

TEST(ParseFile, MarksTheDeclarationsThatAreBroken) {
    const Sources sources = one("grafcet a {\n    step 1 2;\n}\ngrafcet b {\n    step 1;\n}\n");
    Diagnostics diagnostics;
    const tree::File file = parse_file(Id<Source>{0}, sources, diagnostics);
    ASSERT_EQ(file.declarations.size(), 2u);
    EXPECT_TRUE(std::get<tree::Chart>(file.declarations[0]).broken);
    EXPECT_FALSE(std::get<tree::Chart>(file.declarations[1]).broken);
    EXPECT_FALSE(file.incomplete);
}

TEST(ParseFile, StopsAtFiftyErrors) {
    std::string text = "grafcet a {\n";
    for (int i = 0; i < 1000; ++i) text += "    step 1 2;\n";
    const Sources sources = one(text + "}\n");
    Diagnostics diagnostics;
    parse_file(Id<Source>{0}, sources, diagnostics);
    EXPECT_EQ(diagnostics.errors(), Diagnostics::limit);
}

TEST(ParseFile, SkipsAByteOrderMark) { EXPECT_EQ(errors_of("\xEF\xBB\xBFgrafcet a {\n    initial step 1;\n}\n"), ""); }

TEST(ParseFile, RejectsBytesThatAreNotText) {
    using namespace std::string_literals;
    EXPECT_EQ(errors_of("// \xC0\xAF\n"), "1:4 invalid-utf8\n");          // an overlong encoding
    EXPECT_EQ(errors_of("// \xED\xA0\x80\n"), "1:4 invalid-utf8\n");      // a surrogate
    EXPECT_EQ(errors_of("// \xF4\x90\x80\x80\n"), "1:4 invalid-utf8\n");  // a code point beyond U+10FFFF
    EXPECT_EQ(errors_of("// \xE2\x86"), "1:4 invalid-utf8\n");            // a truncated sequence
    EXPECT_EQ(errors_of("grafcet a {\n    input a\0b;\n}\n"s), "2:12 control-character\n2:12 unexpected-character\n");
    EXPECT_EQ(errors_of("// ünïcödé and ↑ in comments\ngrafcet a {\n    initial step 1;\n}\n"), "");
}

// -- limits -----------------------------------------------------------------------------------------------------------

std::string condition_errors(const std::string& text) { return errors_of(chart_with(text)); }

std::string repeated(const std::string& part, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += part;
    return text;
}

TEST(Limits, ExpressionsNestAThousandLevels) {
    EXPECT_EQ(condition_errors(repeated("(", 1000) + "a" + repeated(")", 1000)), "");
    EXPECT_EQ(condition_errors(repeated("(", 10001) + "a" + repeated(")", 10001)), "3:1001 too-deep\n");
    EXPECT_EQ(condition_errors(repeated("!", 10001) + "a"), "3:1001 too-deep\n");
    EXPECT_EQ(condition_errors(repeated("!(", 5000) + "a" + repeated(")", 5000)), "3:1001 too-deep\n");
    EXPECT_EQ(condition_errors("a" + repeated(" + a", 10001) + " > 1"), "3:1 too-deep\n");
    EXPECT_EQ(condition_errors(repeated("(a && ", 900) + "b" + repeated(")", 900)), "");
    EXPECT_EQ(condition_errors("a" + repeated(".b", 10001)), "3:1 too-deep\n");
}

TEST(Limits, ConjunctionsMayBeWide) { EXPECT_EQ(condition_errors("a" + repeated(" && a", 100000)), ""); }

TEST(Limits, NamesHaveAThousandBytes) {
    EXPECT_EQ(condition_errors(repeated("a", 1000)), "");
    EXPECT_EQ(condition_errors(repeated("a", 1001)), "3:1 name-too-long\n");
    EXPECT_EQ(condition_errors(repeated("a", 1 << 20)), "3:1 name-too-long\n");
}

TEST(Limits, FilesHave256MiB) {
    EXPECT_EQ(errors_of(std::string((std::size_t{256} << 20U) + 1, ' ')), "1:1 too-large\n");
}

TEST(Limits, BlocksThatNestWithoutEndAreErrorsNotCrashes) {
    EXPECT_NE(errors_of("grafcet a {" + repeated("partial b {", 100000)), "");
    EXPECT_NE(errors_of(repeated("{", 100000)), "");
    EXPECT_NE(errors_of(repeated("grafcet a {\n", 10000)), "");
}

}  // namespace
}  // namespace grafverif
