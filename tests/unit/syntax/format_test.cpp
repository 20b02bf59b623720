// SPDX-License-Identifier: MIT
#include "syntax/language/format.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "syntax/language/parse.hpp"

namespace grafverif {
namespace {

namespace fs = std::filesystem;

std::string formatted_text(const std::string& text) {
    Sources sources;
    Diagnostics diagnostics;
    const tree::File file = parse_file(sources.add({"test.grafcet", text}), sources, diagnostics);
    std::ostringstream rendered;
    render_text(diagnostics.all(), sources, Colour::Plain, rendered);
    EXPECT_FALSE(file.broken) << rendered.str() << text;
    return file.broken ? "" : formatted(file);
}

std::string formatted_condition(const std::string& text) {
    Sources sources;
    Diagnostics diagnostics;
    const Id<Source> source =
        sources.add({"test", "grafcet c { initial step 1; transition t: 1 -> 1 when " + text + "; }"});
    const tree::File file = parse_file(source, sources, diagnostics);
    if (file.broken) return "?";
    return formatted(
        file, std::get<tree::Transition>(std::get<tree::Chart>(file.declarations.front()).items.back()).condition);
}

struct Case {
    std::string in, out;
};

TEST(FormatCondition, UsesOneSpellingAndClarifyingParentheses) {
    const std::vector<Case> cases = {
        {"a and  b", "a && b"},
        {"not a or b", "!a || b"},
        {"((a))", "a"},
        {"a implies b or c", "a => b || c"},
        {"a => b => c", "a => (b => c)"},
        {"(a => b) => c", "(a => b) => c"},
        {"not (a implies b) && Gate in open", "!(a => b) && Gate in open"},
        {"!Gate in 3", "!Gate in 3"},
        {"a [ i ] [j+1]", "a[i][j + 1]"},
        {"Head[3].X2[k] && Gate[i]in open", "Head[3].X2[k] && Gate[i] in open"},
        {"not all ( i in 1 .. N+1 : (a[i] or b) )", "!all(i in 1..N + 1: a[i] || b)"},
        {"any(i in 1..2:all(k in i..3:a[k]))&&any", "any(i in 1..2: all(k in i..3: a[k])) && any"},
        {"(a) && (b == c)", "a && b == c"},
        // The parentheses are kept, because they make the mixed operators unambiguous.
        {"(a && b) || c", "(a && b) || c"},
        {"a && b || c", "a && b || c"},
        {"(a || b) && c", "(a || b) && c"},
        {"(a && b) && c", "a && b && c"},
        {"!(a && b)", "!(a && b)"},
        {"(a == b) == c", "(a == b) == c"},
        {"a - (b - c)", "a - (b - c)"},
        {"(a - b) - c", "a - b - c"},
        {"a * (b + c)", "a * (b + c)"},
        {"-(-a)", "-(-a)"},
        {"- -a", "-(-a)"},
        {"↑a && ↓(b||c)", "rise(a) && fall(b || c)"},
        {"3s / X2", "3s/X2"},
        {"3s/X2/2000ms", "3s/X2/2000ms"},
        {"5min/X2/1.50s", "5min/X2/1.5s"},
        {"0.0001min/X2 || 060s/X2", "0.0001min/X2 || 60s/X2"},
        {"(3s/X2)/2s", "(3s/X2)/2s"},
        {"1.5s/(a && b)", "1.5s/(a && b)"},
        {"N / 2 > 1", "N / 2 > 1"},
        {"G2 . X2", "G2.X2"},
    };
    for (const Case& example : cases) {
        SCOPED_TRACE(example.in);
        EXPECT_EQ(formatted_condition(example.in), example.out);
        EXPECT_EQ(formatted_condition(example.out), example.out);
    }
}

TEST(Format, ArrangesDeclarations) {
    EXPECT_EQ(
        formatted_text("include \"a.grafcet\"; include \"b.grafcet\";\n"
                       "grafcet press{input START,LEVEL:int 0..10;internal N:int 0..3=0,ON=true;\n"
                       "constraint not(START and ON);initial step 0{ALARM;LIGHT;}linked initial step 1;\n"
                       "step 2{A if b after 3s for 5s;C:=C+1 on event rise(a);force G:={1,2};}\n"
                       "step 3{force G:={};force H:={*};}macro step M expands E;enclosing step 6 encloses G,H{A;}\n"
                       "transition a,b->c when true;transition t:->7 when a;transition 7->when a do N:=0,ON:=a;\n"
                       "partial G{initial step 1;}expansion E{entry step a;exit step b;}}\n"
                       "component arm(input A;output X:int 0..9=0;W=1s,B:bool){variable N:int 0..3;clock t,u;\n"
                       "initial location in invariant t<=W with X:=1,N:=0;timed in->in when A&&t==W do X:=X+1,t:=0;}\n"
                       "closed_loop cell{controller press every 1000ms..2s with every_cycle;\n"
                       "grain atomic;time unit 1000ms;\n"
                       "plant Arm=arm(A=START,X=POS)initially in;environment E=free(OUT=a);\n"
                       "property P\"says\"expected violated:a leads to b at stable;property Q:exactly one of{X1,X2};\n"
                       "property R:ctl\"AG x\";accept range-skipped\"so\";schedule sequenced;constraint !a;\n"
                       "observer O{location l;initial location 2;l->2 when a&&X1;2->l;}}"),
        "include \"a.grafcet\";\n"
        "include \"b.grafcet\";\n"
        "\n"
        "grafcet press {\n"
        "    input START, LEVEL: int 0..10;\n"
        "    internal N: int 0..3 = 0, ON = true;\n"
        "    constraint !(START && ON);\n"
        "    initial step 0 { ALARM; LIGHT; }\n"
        "    initial linked step 1;\n"
        "    step 2 {\n"
        "        A if b after 3s for 5s;\n"
        "        C := C + 1 on event rise(a);\n"
        "        force G := {1, 2};\n"
        "    }\n"
        "    step 3 { force G := {}; force H := {*}; }\n"
        "    macro step M expands E;\n"
        "    enclosing step 6 encloses G, H { A; }\n"
        "    transition a, b -> c when true;\n"
        "    transition t: -> 7 when a;\n"
        "    transition 7 -> when a do N := 0, ON := a;\n"
        "    partial G {\n"
        "        initial step 1;\n"
        "    }\n"
        "    expansion E {\n"
        "        entry step a;\n"
        "        exit step b;\n"
        "    }\n"
        "}\n"
        "\n"
        "component arm(input A; output X: int 0..9 = 0; W = 1s, B: bool) {\n"
        "    variable N: int 0..3;\n"
        "    clock t, u;\n"
        "    initial location in invariant t <= W with X := 1, N := 0;\n"
        "    timed in -> in when A && t == W do X := X + 1, t := 0;\n"
        "}\n"
        "\n"
        "closed_loop cell {\n"
        "    controller press every 1000ms..2s with every_cycle;\n"
        "    grain atomic;\n"
        "    time unit 1000ms;\n"
        "    plant Arm = arm(A = START, X = POS) initially in;\n"
        "    environment E = free(OUT = a);\n"
        "    property P \"says\" expected violated: a leads to b at stable;\n"
        "    property Q: exactly one of {X1, X2};\n"
        "    property R: ctl \"AG x\";\n"
        "    accept range-skipped \"so\";\n"
        "    schedule sequenced;\n"
        "    constraint !a;\n"
        "    observer O {\n"
        "        location l;\n"
        "        initial location 2;\n"
        "        l -> 2 when a && X1;\n"
        "        2 -> l;\n"
        "    }\n"
        "}\n");
}

TEST(Format, ArrangesReplications) {
    EXPECT_EQ(formatted_text("grafcet g{for i in 1..2{input a[i];partial p[i]{for k in i..3{// each\n"
                             "initial step s[k]{q[i];}}transition t[i]:s[1]->s[i+1]when a[i];}}}\n"
                             "component c(output X){for i in 1..2{location l[i];}}\n"
                             "closed_loop l{for i in 1..N{}for i in 1..N{constant T[i]=1s;\n"
                             "environment E[i]=free(OUT=a[i]);fault f[i]of E[i]:c(X=a[i]);\n"
                             "property p[i]:exactly one of{b,a[k]for k in 1..i};}}"),
              "grafcet g {\n"
              "    for i in 1..2 {\n"
              "        input a[i];\n"
              "        partial p[i] {\n"
              "            for k in i..3 {  // each\n"
              "                initial step s[k] { q[i]; }\n"
              "            }\n"
              "            transition t[i]: s[1] -> s[i + 1] when a[i];\n"
              "        }\n"
              "    }\n"
              "}\n"
              "\n"
              "component c(output X) {\n"
              "    for i in 1..2 {\n"
              "        location l[i];\n"
              "    }\n"
              "}\n"
              "\n"
              "closed_loop l {\n"
              "    for i in 1..N {}\n"
              "    for i in 1..N {\n"
              "        constant T[i] = 1s;\n"
              "        environment E[i] = free(OUT = a[i]);\n"
              "        fault f[i] of E[i]: c(X = a[i]);\n"
              "        property p[i]: exactly one of {b, a[k] for k in 1..i};\n"
              "    }\n"
              "}\n");
}

TEST(Format, GroupsSuccessivePrograms) {
    EXPECT_EQ(formatted_text("include \"a.grafcet\";program p=\"p.st\";program program=\"q.st\"; // the second one\n"
                             "grafcet g{initial step 0;}"),
              "include \"a.grafcet\";\n"
              "\n"
              "program p = \"p.st\";\n"
              "program program = \"q.st\";  // the second one\n"
              "\n"
              "grafcet g {\n"
              "    initial step 0;\n"
              "}\n");
}

TEST(Format, KeepsCommentsAndSingleBlankLines) {
    EXPECT_EQ(formatted_text("// head\n"
                             "\n"
                             "\n"
                             "/* about a */ grafcet a { // behind the head\n"
                             "\n"
                             "  // before the input\n"
                             "  input A, // behind A\n"
                             "    B; // behind B\n"
                             "  step 1; // one\n"
                             "  step 1000 { A; } /* thousand */ // and more\n"
                             "\n"
                             "\n"
                             "  // before two\n"
                             "\n"
                             "  step 2 { A; // the action\n"
                             "    /* last */ }\n"
                             "  /* a comment\n"
                             "     of two lines */\n"
                             "  transition t: 1 -> 2 when /* why */ A;\n"
                             "  // at the end\n"
                             "} // behind the brace\n"
                             "// last words"),
              "// head\n"
              "\n"
              "/* about a */\n"
              "grafcet a {  // behind the head\n"
              "    // before the input\n"
              "    // behind A\n"
              "    input A, B;       // behind B\n"
              "    step 1;           // one\n"
              "    step 1000 { A; }  /* thousand */ // and more\n"
              "\n"
              "    // before two\n"
              "\n"
              "    step 2 {\n"
              "        A;  // the action\n"
              "        /* last */\n"
              "    }\n"
              "    /* a comment\n"
              "     of two lines */\n"
              "    /* why */\n"
              "    transition t: 1 -> 2 when A;\n"
              "    // at the end\n"
              "}  // behind the brace\n"
              "// last words\n");
}

TEST(Format, PlacesACommentAfterAStepOnItsFirstLine) {
    EXPECT_EQ(formatted_text("grafcet a {\n"
                             "    step 1 { A; B; C if d; }  // soak\n"
                             "    step 2 { A; }  // heat\n"
                             "    step 3 { A; B; C if d; } step 4;  // four\n"
                             "    step 5 { A; B; C if d; } /* two\n"
                             "lines */\n"
                             "    step 6 { A; B; /* the heater */ C if d; }  // six\n"
                             "}\n"),
              "grafcet a {\n"
              "    step 1 {  // soak\n"
              "        A;\n"
              "        B;\n"
              "        C if d;\n"
              "    }\n"
              "    step 2 { A; }  // heat\n"
              "    step 3 {\n"
              "        A;\n"
              "        B;\n"
              "        C if d;\n"
              "    }\n"
              "    step 4;  // four\n"
              "    step 5 {\n"
              "        A;\n"
              "        B;\n"
              "        C if d;\n"
              "    }\n"
              "    /* two\n"
              "lines */\n"
              "    step 6 {\n"
              "        A;\n"
              "        B;  /* the heater */\n"
              "        C if d;\n"
              "    }  // six\n"
              "}\n");
}

TEST(Format, BreaksLinesThatAreTooLong) {
    const std::string text = formatted_text(
        "component c(input SOME_RATHER_LONG_NAME_A, SOME_RATHER_LONG_NAME_B; output SOME_RATHER_LONG_NAME_C, D; E = 1, "
        "F = 2, G = 3) {\n"
        "    timed some_rather_long_location -> another_rather_long_location when SOME_RATHER_LONG_NAME_A && "
        "SOME_RATHER_LONG_NAME_B do SOME_RATHER_LONG_NAME_C := true;\n"
        "}\n"
        "closed_loop l {\n"
        "    plant P = c(SOME_RATHER_LONG_NAME_A = SOMETHING, SOME_RATHER_LONG_NAME_B = SOMETHING_ELSE, "
        "SOME_RATHER_LONG_NAME_C = A_THIRD_THING);\n"
        "    property P \"a sentence of some length about what is to be proved here\": never SOME_RATHER_LONG_NAME_A "
        "&& "
        "SOME_RATHER_LONG_NAME_B;\n"
        "}\n");
    EXPECT_EQ(text,
              "component c(input SOME_RATHER_LONG_NAME_A, SOME_RATHER_LONG_NAME_B; output SOME_RATHER_LONG_NAME_C, D;\n"
              "            E = 1, F = 2, G = 3) {\n"
              "    timed some_rather_long_location -> another_rather_long_location\n"
              "        when SOME_RATHER_LONG_NAME_A && SOME_RATHER_LONG_NAME_B do SOME_RATHER_LONG_NAME_C := true;\n"
              "}\n"
              "\n"
              "closed_loop l {\n"
              "    plant P = c(SOME_RATHER_LONG_NAME_A = SOMETHING, SOME_RATHER_LONG_NAME_B = SOMETHING_ELSE,\n"
              "                SOME_RATHER_LONG_NAME_C = A_THIRD_THING);\n"
              "    property P \"a sentence of some length about what is to be proved here\":\n"
              "        never SOME_RATHER_LONG_NAME_A && SOME_RATHER_LONG_NAME_B;\n"
              "}\n");
}

TEST(Format, ChangesNothingTheSecondTime) {
    const std::vector<std::string> texts = {
        "",
        "// only a comment",
        "/* a */ /* b */ // c\n\n\n// d",
        "grafcet a{/*x*/}",
        "grafcet a{//x\n}",
        "grafcet a{\n\n//x\n\n//y\n\n}\n\n\n",
        "grafcet a /* 1 */ { /* 2 */ input /* 3 */ A /* 4 */ , /* 5 */ B /* 6 */ ; /* 7 */ } /* 8 */",
        "grafcet a { step 1 { // x\n A; } step 2 { /* y */ } step 3 { A; /* z\n z */ B; } }",
        "grafcet a { step 1; /* two\n lines */ step 2; // behind\n // own\n }",
        "component c( // in the head\n input A; // A\n B = 1 /* B */ ) { // body\n location l; }",
        "include \"a\"; // why\n// before\ninclude \"b\";\n// before a\ngrafcet a { initial step 0; }",
        "closed_loop l { // one\n // two\n plant p = c( // three\n a = b, // four\n c = d); // five\n}",
        "grafcet a {\r\n    // windows\r\n    input A; // lines\r\n\r\n    input B;\r\n}\r\n",
        "grafcet a { partial p { // in p\n step 1; } // after p\n }",
        "grafcet a { step 1 { A; B; C if d; } /* x */ // y\n step 2 { A; B; C if d; } /* z\n */ // end\n }",
    };
    for (const std::string& text : texts) {
        SCOPED_TRACE(text);
        const std::string once = formatted_text(text);
        EXPECT_EQ(formatted_text(once), once);
        for (const char* mark : {"/*", "//"}) {  // all comments are kept
            const auto count = [&](const std::string& in) {
                std::size_t found = 0;
                for (std::size_t at = in.find(mark); at != std::string::npos; at = in.find(mark, at + 2)) ++found;
                return found;
            };
            EXPECT_EQ(count(once), count(text)) << once;
        }
    }
}

TEST(Format, KeepsFormattedSamplesAndTemplates) {
    std::size_t files = 0;
    for (const char* folder : {"samples", "templates"}) {
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(GRAFVERIF_SOURCE_DIR) / folder)) {
            if (entry.path().extension() != ".grafcet") continue;
            SCOPED_TRACE(entry.path());
            std::ifstream in(entry.path(), std::ios::binary);
            std::ostringstream text;
            text << in.rdbuf();
            EXPECT_EQ(formatted_text(text.str()), text.str());
            ++files;
        }
    }
    EXPECT_GT(files, 20u);
}

}  // namespace
}  // namespace grafverif
