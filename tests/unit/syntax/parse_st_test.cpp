// SPDX-License-Identifier: MIT
// Tests that the tree represents the text, for Structured Text and textual Sequential Function Charts.
#include "syntax/st/parse_st.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace grafverif::st {
namespace {

constexpr const char* names[] = {
    "FALSE", "TRUE",   "int",   "time", "other", "name", "member", "address", "index", "deref", "call",
    "arg",   "result", "range", "NOT",  "neg",   "**",   "*",      "/",       "MOD",   "+",     "-",
    "<",     "<=",     ">",     ">=",   "=",     "<>",   "AND",    "XOR",     "OR"};

/// Returns the term in prefix form: `(AND a (NOT b))`.
std::string printed(const File& file, Id<Expr> id) {
    const Expr& node = file.exprs[id];
    if (node.op == Op::True || node.op == Op::False) return names[static_cast<int>(node.op)];
    if (node.op == Op::Integer) return std::to_string(node.value);
    if (node.op == Op::Time) return std::to_string(node.value) + "ms";
    if (node.op == Op::Name || node.op == Op::Address || node.op == Op::Other) return std::string(file.text(node.word));
    std::string text = std::string("(") + names[static_cast<int>(node.op)];
    if (node.word.valid()) text += " ." + std::string(file.text(node.word));
    for (const Id<Expr> one : operands(file, id)) text += ' ' + printed(file, one);
    return text + ')';
}

std::string printed(const File& file, const Block& block) {
    std::string text;
    for (const Id<Statement> id : block) {
        const Statement& statement = file.statements[id];
        text += text.empty() ? "" : " ";
        if (statement.kind == StatementKind::Assign) text += printed(file, statement.target) + ":=";
        if (statement.value.valid()) text += printed(file, statement.value);
        for (const Branch& branch : statement.branches) {
            text += '[';
            for (const Id<Expr> condition : branch.conditions) text += printed(file, condition) + ' ';
            text += "? " + printed(file, branch.body) + ']';
        }
        text += ';';
    }
    return text;
}

std::string rendered(const Diagnostics& diagnostics, const Sources& sources) {
    std::ostringstream out;
    render_text(diagnostics.all(), sources, Colour::Plain, out);
    return std::move(out).str();
}

struct Read {
    Sources sources = {};
    Diagnostics diagnostics = {};
    File file = {};
    Text text(const std::string& written, bool escaped = false) {
        const Id<Source> source = sources.add({"text.st", written});
        return {{{source, 0, static_cast<std::uint32_t>(written.size())}, escaped}};
    }
};

std::string expression(const std::string& written, bool escaped = false) {
    Read read;
    const Text text = read.text(written, escaped);
    const auto id = parse_expression(text, read.file, read.sources, read.diagnostics);
    return id ? printed(read.file, *id) : rendered(read.diagnostics, read.sources);
}

std::string statements(const std::string& written) {
    Read read;
    const Text text = read.text(written);
    const auto block = parse_statements(text, read.file, read.sources, read.diagnostics);
    return block ? printed(read.file, *block) : rendered(read.diagnostics, read.sources);
}

TEST(ParseSt, ExpressionsBindAsInTheStandard) {
    struct Case {
        std::string in = {}, out = {};
    };
    const Case cases[] = {
        {"a AND b OR c", "(OR (AND a b) c)"},
        {"a or B AnD c", "(OR a (AND B c))"},
        {"A & NOT a", "(AND A (NOT A))"},
        {"a XOR b AND c", "(XOR a (AND b c))"},
        {"x + 2 * y < 7 = b", "(= (< (+ x (* 2 y)) 7) b)"},
        {"- x ** 2", "(** (neg x) 2)"},
        {"S1.X AND S1.T >= T#1m2.5s", "(AND (member .X S1) (>= (member .T S1) 62500ms))"},
        {"16#FF + 2#1010 + 1_000 + INT#-5", "(+ (+ (+ 255 10) 1000) -5)"},
        {"MAX(a, IN2 := b)", "(call MAX a (arg .IN2 b))"},
        {"arr[i, 2].q^", "(deref (member .q (index arr i 2)))"},
        {"%IX0.1 AND (a) (* why *)", "(AND %IX0.1 a)"},
        {"bool#true", "TRUE"},
        {"t > TIME#36h", "(> t 129600000ms)"},
    };
    for (const Case& one : cases) {
        SCOPED_TRACE(one.in);
        EXPECT_EQ(expression(one.in), one.out);
    }
}

TEST(ParseSt, ReferencesOfXmlAreCharactersAndPlacesAreThoseOfTheSource) {
    EXPECT_EQ(expression("a &lt;&#61; 3 &amp; b", true), "(AND (<= a 3) b)");
    EXPECT_EQ(expression("a &lt; &lt; b", true),
              "text.st:1:8: error: unexpected `&lt;`; expected an expression [unexpected]\n"
              "    a &lt; &lt; b\n"
              "           ^^^^\n");
}

TEST(ParseSt, StatementsAreReadWithTheirBranches) {
    EXPECT_EQ(statements("a := b; IF c THEN d := 1; ELSIF e THEN ; ELSE d := 2; END_IF; t(IN := a, Q => b);"),
              "a:=b; [c ? d:=1;][e ? ][? d:=2;]; (call t (arg .IN a) (result .Q b));");
    EXPECT_EQ(statements("CASE n OF 1, 3: a := TRUE; 4..6: b := 2; c := 3; ELSE a := FALSE; END_CASE;"),
              "n[1 3 ? a:=TRUE;][(range 4 6) ? b:=2; c:=3;][? a:=FALSE;];");
    EXPECT_EQ(statements("FOR i := 1 TO 3 BY 1 DO a := i; END_FOR; WHILE a DO EXIT; END_WHILE; RETURN;"),
              "[? a:=i;]; a[? ;]; ;");
}

TEST(ParseSt, EverySyntaxErrorIsReported) {
    const std::string text = statements("a := ; b := 1; c = 2; d := 3;");
    EXPECT_NE(text.find("text.st:1:6: error: unexpected `;`"), std::string::npos) << text;
    EXPECT_NE(text.find("text.st:1:18: error: unexpected `=`"), std::string::npos) << text;
}

TEST(ParseSt, HostileDepthIsAnErrorAtItsPlace) {
    EXPECT_NE(expression(std::string(200'000, '(')).find("[too-deep]"), std::string::npos);
    std::string prefixes, blocks, sums = "a", powers;
    for (int i = 0; i < 50'000; ++i) prefixes += "NOT ";
    for (int i = 0; i < 5'000; ++i) blocks += "IF a THEN ";
    for (int i = 0; i < 5'000; ++i) sums += "+a";
    EXPECT_NE(expression(prefixes + "a").find("[too-deep]"), std::string::npos);
    EXPECT_NE(statements(blocks).find("[too-deep]"), std::string::npos);
    EXPECT_NE(expression(sums).find("[too-deep]"), std::string::npos);
}

constexpr const char* chart = R"(
PROGRAM press (* the press *)
  VAR_INPUT start AT %IX0.0 : BOOL; n : INT (0..10) := 3; END_VAR
  VAR CONSTANT limit : TIME := T#5s; END_VAR
  VAR_OUTPUT down, up : BOOL; list : ARRAY[1..3] OF INT := [1, 2, 3]; END_VAR
  INITIAL_STEP S0: END_STEP
  STEP S1: down(N); up(D, T#2s); count(P1); END_STEP
  TRANSITION FROM S0 TO S1 := start; END_TRANSITION
  TRANSITION back (PRIORITY := 2) FROM (S1, S2) TO (S0, S3) := S1.T > limit; END_TRANSITION
  ACTION count: n := n + 1; END_ACTION
END_PROGRAM
)";

TEST(ParseSt, TextualChartsAreUnitsWithVariablesStepsAndTransitions) {
    Read read;
    const Text text = read.text(chart);
    ASSERT_TRUE(parse_units(text, read.file, read.sources, read.diagnostics))
        << rendered(read.diagnostics, read.sources);
    ASSERT_EQ(read.file.units.size(), 1u);
    const Unit& unit = read.file.units.front();
    EXPECT_EQ(read.file.text(unit.name), "press");
    ASSERT_EQ(unit.variables.size(), 6u);
    EXPECT_EQ(unit.variables[0].address, "%IX0.0");
    EXPECT_EQ(printed(read.file, unit.variables[1].type.high), "10");
    EXPECT_TRUE(unit.variables[2].constant);
    EXPECT_TRUE(unit.variables[5].type.composite);
    ASSERT_EQ(unit.networks.size(), 1u);
    ASSERT_EQ(unit.networks[0].steps.size(), 2u);
    EXPECT_TRUE(unit.networks[0].steps[0].initial);
    EXPECT_EQ(unit.networks[0].steps[1].actions[1].qualifier, "D");
    EXPECT_EQ(printed(read.file, unit.networks[0].steps[1].actions[1].time), "2000ms");
    const Transition& back = unit.networks[0].transitions[1];
    EXPECT_EQ(back.priority, 2);
    EXPECT_EQ(back.from.size() + back.to.size(), 4u);
    EXPECT_EQ(printed(read.file, back.condition), "(> (member .T S1) limit)");
    EXPECT_EQ(printed(read.file, unit.actions[0].body), "n:=(+ n 1);");
    EXPECT_EQ(read.file.comments[0].text, "(* the press *)");
}

}  // namespace
}  // namespace grafverif::st
