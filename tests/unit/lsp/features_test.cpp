// SPDX-License-Identifier: MIT
// Tests requests about names and locations in complete and incomplete texts.
#include "unit/lsp/editor.hpp"

namespace grafverif::lsp {
namespace {

const std::string press =
    "// Press: opens and shuts.\n"
    "grafcet press {\n"
    "    input START, DOWN;  // from the desk\n"
    "    output MOVE;\n"
    "    internal N: int 0..5;\n"
    "    initial step 0;\n"
    "    step 1 { MOVE; }\n"
    "    transition t0: 0 -> 1 when START && !X1 do N := 1;\n"
    "    transition t1: 1 -> 0 when DOWN;\n"
    "}\n";
const std::string loop =
    "include \"press.grafcet\";\n"
    "closed_loop station {\n"
    "    controller press;\n"
    "    plant Lamp = lamp(ON = MOVE);\n"
    "    environment Start = push_button(OUT = START);\n"
    "    environment Down = free(OUT = DOWN);\n"
    "    property moved \"it moves\": X1 leads to MOVE || N == 1;\n"
    "}\n";

class Editor : public TextEditor {
public:
    Editor() : TextEditor({{"press.grafcet", press}, {"loop.grafcet", loop}}) {}
};

TEST(LspNames, LeadToTheirDeclarationAcrossIncludes) {
    Editor editor;
    const auto line = [&](const std::string& text) {
        const Json found = editor.at("textDocument/definition", "loop.grafcet", text);
        return found.is_null()
                   ? std::string("none")
                   : rpc::path_of_uri(found["uri"].get<std::string>()).substr(editor.folder.path().size() + 1) + ":" +
                         std::to_string(found["range"]["start"]["line"].get<int>());
    };
    EXPECT_EQ(line(with(loop, "controller press", "controller pr@ess")), "press.grafcet:1");
    EXPECT_EQ(line(with(loop, "OUT = START", "OUT = ST@ART")), "press.grafcet:2");
    EXPECT_EQ(line(with(loop, "X1 leads", "X@1 leads")), "press.grafcet:6");
    EXPECT_EQ(line(with(loop, "N == 1", "N@ == 1")), "press.grafcet:4");
    EXPECT_EQ(line(with(loop, "plant Lamp", "plant La@mp")), "loop.grafcet:3");
    EXPECT_EQ(line(with(loop, "= lamp(", "= la@mp(")), "none");  // the library declares this component
}

TEST(LspNames, AreFoundInHalfAText) {
    Editor editor;
    const std::string half = with(with(press, "when DOWN;", "when DO@WN && ("), "}\n", "}\n");
    EXPECT_EQ(editor.at("textDocument/definition", "press.grafcet", half)["range"]["start"]["line"], 2);
    const std::string unended = with(press, "step 1 { MOVE; }", "step 1");
    EXPECT_EQ(editor.at("textDocument/definition", "press.grafcet",
                        with(unended, "t0: 0 -> 1", "t0: 0 -> @1"))["range"]["start"]["line"],
              6);
    const Json symbols = editor.of("textDocument/documentSymbol", "press.grafcet");
    ASSERT_EQ(symbols.size(), 1U);
    EXPECT_EQ(symbols[0]["children"].size(), 8U);
}

TEST(LspNames, AreReferredToFromEveryFileThatIncludesThem) {
    Editor editor;
    const auto count = [&](const std::string& text, bool declaration) {
        return editor
            .at("textDocument/references", "press.grafcet", text, {{"context", {{"includeDeclaration", declaration}}}})
            .size();
    };
    EXPECT_EQ(count(with(press, "input START", "input STA@RT"), true), 3U);
    EXPECT_EQ(count(with(press, "input START", "input STA@RT"), false), 2U);
    EXPECT_EQ(count(with(press, "step 1", "step @1"), true), 5U);
    EXPECT_EQ(count(with(press, "grafcet press", "grafcet pr@ess"), true), 2U);
    EXPECT_EQ(count(with(press, "// Press", "// Pre@ss"), true), 0U);
}

TEST(LspNames, AreRenamedEverywhereAtOnce) {
    Editor editor;
    const Json edit =
        editor.at("textDocument/rename", "press.grafcet", with(press, "step 1", "step @1"), {{"newName", "7"}});
    std::vector<std::string> texts;
    for (const auto& [name, before] : {std::pair("press.grafcet", press), std::pair("loop.grafcet", loop)})
        texts.push_back(edited(before, edit["changes"][editor.folder.uri(name)]));
    EXPECT_EQ(texts[0],
              with(with(with(with(press, "step 1", "step 7"), "0 -> 1", "0 -> 7"), "!X1", "!X7"), "t1: 1", "t1: 7"));
    EXPECT_EQ(texts[1], with(loop, "X1 leads", "X7 leads"));
}

TEST(LspNames, AreNotRenamedIfTheMeaningWouldChange) {
    Editor editor;
    const auto obstacle = [&](const std::string& text, const char* name) {
        return editor.obstacle("press.grafcet", text, name);
    };
    const std::string start = with(press, "input START", "input STA@RT");
    EXPECT_EQ(obstacle(start, "GO"), "none");
    EXPECT_EQ(obstacle(start, "DOWN"),
              "`DOWN` has another meaning in the scope of `START`, or is not allowed there; choose another name");
    EXPECT_EQ(obstacle(start, "X1"),
              "`X1` has another meaning in the scope of `START`, or is not allowed there; choose another name");
    EXPECT_EQ(obstacle(start, "when"), "`when` is not a valid name here");
    EXPECT_EQ(obstacle(start, "1"), "`1` is not a valid name here");
    EXPECT_NE(obstacle(start + "grafcet", "GO").find("has syntax errors"), std::string::npos);
}

TEST(LspNames, HaveTheirDeclarationCommentAndEquationShown) {
    Editor editor;
    const auto shown = [&](const std::string& name, const std::string& text) {
        return editor.at("textDocument/hover", name, text)["contents"]["value"].get<std::string>();
    };
    EXPECT_EQ(shown("press.grafcet", with(press, "output MOVE", "output MO@VE")),
              "```grafcet\noutput MOVE: bool\n```\n\n```text\nMOVE = X_1\n```\n");
    EXPECT_NE(shown("press.grafcet", with(press, "when START", "when STA@RT")).find("from the desk"),
              std::string::npos);
    EXPECT_NE(shown("press.grafcet", with(press, "X1 do", "X@1 do")).find("X_1 = CF_t0 or (X_1 and not CF_t1)"),
              std::string::npos)
        << shown("press.grafcet", with(press, "X1 do", "X@1 do"));
    EXPECT_NE(shown("press.grafcet", with(press, "N := 1", "@N := 1")).find("internal N: int 0..5"), std::string::npos);
    EXPECT_NE(shown("loop.grafcet", with(loop, "= push_button", "= push@_button")).find("button"), std::string::npos);
    EXPECT_NE(shown("loop.grafcet", with(loop, "(ON = MOVE", "(O@N = MOVE")).find("input"), std::string::npos);
}

/// A file in which names occur in unusual positions. `@` and `#` mark the occurrences of two names.
const std::string notations =
    "component gate(input OPEN; output CLOSED) {\n"
    "    variable #POS: int 0..2;\n"
    "    initial location still;\n"
    "    urgent still -> still when OPEN && #POS < 2 do #POS := #POS + 1;\n"
    "}\n"
    "component stuck(input OPEN; output CLOSED) {\n"
    "    initial location still with CLOSED := true;\n"
    "}\n"
    "grafcet control {\n"
    "    input CLOSED;\n"
    "    output MOVE;\n"
    "    initial step 0;\n"
    "    step 1 { MOVE; }\n"
    "    transition t0: 0 -> 1 when !(CLOSED) || 2s/(X1);\n"
    "    transition t1: 1 -> 0 when (CLOSED);\n"
    "    accept step-never-active X1 \"test\";\n"
    "}\n"
    "closed_loop machine {\n"
    "    controller control;\n"
    "    plant @Gate = gate(OPEN = MOVE, CLOSED = CLOSED);\n"
    "    fault Stuck of @Gate: stuck();\n"
    "    property p: never @Gate_#POS == 2 && control.X1;\n"
    "    property q: never @Gate.#POS == 2 || @Gate in still;\n"
    "}\n";

std::string named(const std::string& gate, const std::string& position) {
    std::string text = notations;
    for (const auto& [old, fresh] : {std::pair("@Gate", gate), std::pair("#POS", position)})
        while (text.find(old) != std::string::npos) text = with(text, old, fresh);
    return text;
}

TEST(LspNames, AreRenamedInEveryNotation) {
    Editor editor;
    const std::string before = named("Gate", "POS");
    const auto renamed = [&](const std::string& what, const std::string& cursor, const std::string& name) {
        const Json edit =
            editor.at("textDocument/rename", "all.grafcet", with(before, what, cursor), {{"newName", name}});
        return edited(before, edit["changes"][editor.folder.uri("all.grafcet")]);
    };
    EXPECT_EQ(renamed("plant Gate", "plant G@ate", "Door"), named("Door", "POS"));
    EXPECT_EQ(renamed("Gate_POS", "Gate_P@OS", "PLACE"), named("Gate", "PLACE"));
    std::string closed = before, step = before;
    for (const char* const place : {"input CLOSED", "!(CLOSED", "(CLOSED", "= CLOSED"})
        closed = with(closed, place, std::string(place, std::string(place).size() - 6) + "SHUT");
    EXPECT_EQ(renamed("!(CLOSED", "!(CLO@SED", "SHUT"), closed);
    for (const auto& [old, fresh] : std::vector<std::pair<std::string, std::string>>{{"step 1", "step 7"},
                                                                                     {"-> 1", "-> 7"},
                                                                                     {"(X1)", "(X7)"},
                                                                                     {"t1: 1", "t1: 7"},
                                                                                     {"X1 \"", "X7 \""},
                                                                                     {"l.X1", "l.X7"}})
        step = with(step, old, fresh);
    EXPECT_EQ(renamed("X1 \"", "X@1 \"", "7"), step);
    // A fault inherits the arguments of its instance by the names of its parameters.
    std::string inherited = before;
    for (const char* const place : {"gate(input OPEN", "when OPEN", "stuck(input OPEN", "gate(OPEN"})
        inherited = with(inherited, place, std::string(place, std::string(place).size() - 4) + "DRIVE");
    EXPECT_EQ(renamed("gate(OPEN", "gate(OP@EN", "DRIVE"), inherited);
}

TEST(LspNames, AreNotRenamedIfAFaultWouldInheritAnotherArgument) {
    Editor editor;
    std::string text =
        with(named("Gate", "POS"), "gate(input OPEN; output CLOSED)", "gate(input OPEN; output CLOSED; WAIT = 1)");
    text = with(text, "stuck(input OPEN; output CLOSED)", "stuck(input OPEN; output CLOSED; DELAY = 2)");
    EXPECT_EQ(editor.obstacle("all.grafcet", with(text, "WAIT", "WA@IT"), "PAUSE"), "none");
    EXPECT_EQ(editor.obstacle("all.grafcet", with(text, "WAIT", "WA@IT"), "DELAY"),
              "`DELAY` has another meaning in the scope of `WAIT`, or is not allowed there; choose another name");
    text = with(text, "property p: ", "property p: uppaal \"A[] !Gate_POS_\"; property r: ");
    EXPECT_EQ(editor.obstacle("all.grafcet", with(text, "plant Gate", "plant G@ate"), "Door"),
              "the formula of property `p` may contain `Gate`; rename the element manually, also in the formula");
}

TEST(LspNames, AreRenamedInATextWithErrorsIfTheirMeaningIsKnown) {
    Editor editor;
    // The parameter of the instance is unknown. Therefore, the fault has no arguments that it could inherit.
    const std::string text = with(with(named("Gate", "POS"), "gate(OPEN = MOVE", "gate(OPNE = MOVE"), "Gate: stuck()",
                                  "Gate: stuck(OPEN = MOVE)");
    const Json edit = editor.at("textDocument/rename", "all.grafcet", with(text, "output MOVE", "output MO@VE"),
                                {{"newName", "LIFT"}});
    std::string renamed = text;
    for (const char* const place : {"output MOVE", "1 { MOVE", "gate(OPNE = MOVE", "stuck(OPEN = MOVE"})
        renamed = with(renamed, place, std::string(place, std::string(place).size() - 4) + "LIFT");
    EXPECT_EQ(edited(text, edit["changes"][editor.folder.uri("all.grafcet")]), renamed);
    // The value that is assigned to an input is not resolved.
    const std::string hidden = with(text, "{ MOVE; }", "{ MOVE; CLOSED := MOVE on activation; }");
    EXPECT_EQ(editor.obstacle("all.grafcet", with(hidden, "output MOVE", "output MO@VE"), "LIFT"),
              "`" + editor.folder.file("all.grafcet") +
                  "` contains an occurrence of `MOVE` whose meaning is unknown because of errors; correct the errors "
                  "first");
}

TEST(LspNames, OfALoopThatDoesNotIncludeItsChartLeadToTheChart) {
    Editor editor;
    editor.folder.write("all.grafcet", "include \"press.grafcet\";\ninclude \"loop.grafcet\";\n");
    const std::string alone = with(loop, "include \"press.grafcet\";\n", "");
    const Json found = editor.at("textDocument/definition", "loop.grafcet", with(alone, "OUT = START", "OUT = ST@ART"));
    EXPECT_EQ(found["uri"], editor.folder.uri("press.grafcet"));
}

TEST(LspNames, OfAProgramLeadToItsFileAndAreRenamed) {
    Editor editor;
    editor.folder.write("main.st",
                        "PROGRAM main\nVAR_INPUT\n  go : BOOL;\nEND_VAR\nVAR_OUTPUT\n  lit : BOOL;\nEND_VAR\n"
                        "lit := go;\nEND_PROGRAM\n");
    const std::string text =
        "program main = \"main.st\";\nclosed_loop lamp {\n    controller main every 10ms;\n"
        "    environment Go = free(OUT = go);\n    property p: never lit && !go;\n}\n";
    const Json found = editor.at("textDocument/definition", "lamp.grafcet", with(text, "OUT = go", "OUT = g@o"));
    EXPECT_EQ(found["uri"], editor.folder.uri("main.st"));
    EXPECT_EQ(found["range"]["start"]["line"], 2);
    EXPECT_EQ(editor.obstacle("lamp.grafcet", with(text, "OUT = go", "OUT = g@o"), "start"), "none");
}

/// A loop that uses constants in other constants, ranges, the time unit, arguments of instances, and properties.
const std::string steady =
    "include \"press.grafcet\";\n"
    "closed_loop steady {\n"
    "    controller press;\n"
    "    constant MOST: int 1..8 = 2;  // litres\n"
    "    constant SLOW = MOST * 500ms, LEAST: int 0..MOST = 1;\n"
    "    time unit SLOW;\n"
    "    plant Lamp = valve(ORDER = MOVE || MOST > 4, FLOW = FLOW, TRAVEL = SLOW);\n"
    "    property few: MOVE at most MOST times after N == MOST;\n"
    "    property soon: START leads to MOVE within SLOW;\n"
    "}\n";

TEST(LspNames, ConstantsOfALoopAreNamesInAllTheirUses) {
    Editor editor;
    editor.open("press.grafcet", press);
    for (const std::string read :
         {"SLOW = M@OST * 500", "0..M@OST = 1", "|| M@OST > 4", "most M@OST times", "N == M@OST", "MOVE || M@OST"}) {
        std::string plain = read;
        plain.erase(plain.find('@'), 1);
        const Json found = editor.at("textDocument/definition", "loop.grafcet", with(steady, plain, read));
        ASSERT_FALSE(found.is_null()) << read;
        EXPECT_EQ(found["range"]["start"]["line"], 3) << read;
    }
    for (const std::string read : {"unit S@LOW", "TRAVEL = S@LOW", "within S@LOW"}) {
        std::string plain = read;
        plain.erase(plain.find('@'), 1);
        const Json found = editor.at("textDocument/definition", "loop.grafcet", with(steady, plain, read));
        ASSERT_FALSE(found.is_null()) << read;
        EXPECT_EQ(found["range"]["start"]["line"], 4) << read;
    }
    EXPECT_EQ(
        editor.at("textDocument/hover", "loop.grafcet", with(steady, "most MOST", "most MO@ST"))["contents"]["value"],
        "```grafcet\nconstant MOST: int 1..8 = 2\n```\n\n```text\nlitres\n```\n");
    std::size_t edits = 0;
    const Json edit = editor.at("textDocument/rename", "loop.grafcet", with(steady, "constant MOST", "constant MO@ST"),
                                {{"newName", "LITRES"}});
    for (const auto& [file, changes] : edit["changes"].items()) edits += changes.size();
    EXPECT_EQ(edits, 6U) << edit;
    EXPECT_EQ(editor
                  .at("textDocument/references", "loop.grafcet", with(steady, "constant SLOW", "constant SL@OW"),
                      {{"context", {{"includeDeclaration", false}}}})
                  .size(),
              3U);
}

const std::string lamps =
    "grafcet lamps {\n"
    "    for i in 1..2 {\n"
    "        input GO[i];\n"
    "        output LAMP[i];\n"
    "        partial lamp[i] {\n"
    "            initial step s[0];\n"
    "            step s[i] { LAMP[i]; }\n"
    "            transition s[0] -> s[i] when GO[i] && Xs[0];\n"
    "            transition s[i] -> s[0] when !all(k in 1..i: GO[k]);\n"
    "        }\n"
    "    }\n"
    "}\n";

TEST(LspNames, OfReplicatedDeclarationsAreThoseOfTheDeclaration) {
    Editor editor;
    const auto definition = [&](const std::string& what, const std::string& read) {
        const Json found = editor.at("textDocument/definition", "lamps.grafcet", with(lamps, what, read));
        return found.is_null() ? -1 : found["range"]["start"]["line"].get<int>();
    };
    EXPECT_EQ(definition("{ LAMP[i]", "{ LA@MP[i]"), 3);
    EXPECT_EQ(definition("{ LAMP[i]", "{ LAMP[@i]"), 1);
    EXPECT_EQ(definition("GO[k]", "G@O[k]"), 2);
    EXPECT_EQ(definition("GO[k]", "GO[@k]"), 8);
    EXPECT_EQ(definition("1..i:", "1..@i:"), 1);
    const Json edit =
        editor.at("textDocument/rename", "lamps.grafcet", with(lamps, "step s[i]", "step @s[i]"), {{"newName", "lit"}});
    const std::string renamed = edited(lamps, edit["changes"][editor.folder.uri("lamps.grafcet")]);
    EXPECT_NE(renamed.find("step lit[i] { LAMP[i]; }\n            transition s[0] -> lit[i] when GO[i] && Xs[0]"),
              std::string::npos)
        << renamed;
    const Json symbols = editor.of("textDocument/documentSymbol", "lamps.grafcet");
    ASSERT_EQ(symbols.size(), 1U);
}

const std::string heads =
    "grafcet head(input HERE; output VALVE; DRIP = 1s) {\n"
    "    internal N: int 0..3;\n"
    "    initial step 0;\n"
    "    step 1 { VALVE; }\n"
    "    transition 0 -> 1 when HERE;\n"
    "    transition 1 -> 0 when DRIP / X1;\n"
    "}\n"
    "grafcet plc {\n"
    "    input GO[1];\n"
    "    output OPEN;\n"
    "    partial Head = head(HERE = GO[1], VALVE = OPEN);\n"
    "}\n"
    "closed_loop line {\n"
    "    controller First = head(HERE = Go.OUT, VALVE = MOVE, DRIP = 2s);\n"
    "    environment Go = free(OUT = GO);\n"
    "    plant Lamp = lamp(ON = MOVE);\n"
    "    property p: never First.X1 && First.N == 1;\n"
    "}\n";

TEST(LspNames, OfChartInstancesAreThoseOfTheChart) {
    Editor editor;
    const auto renamed = [&](const std::string& what, const std::string& cursor, const std::string& name) {
        const Json edit =
            editor.at("textDocument/rename", "heads.grafcet", with(heads, what, cursor), {{"newName", name}});
        return edited(heads, edit["changes"][editor.folder.uri("heads.grafcet")]);
    };
    EXPECT_EQ(
        renamed("step 1", "step @1", "2"),
        with(with(with(with(with(heads, "step 1", "step 2"), "0 -> 1", "0 -> 2"), "1 -> 0", "2 -> 0"), "/ X1", "/ X2"),
             "First.X1", "First.X2"));
    EXPECT_EQ(renamed("Head = head(HERE", "Head = head(H@ERE", "AT"),
              with(with(with(with(heads, "input HERE", "input AT"), "when HERE", "when AT"), "head(HERE", "head(AT"),
                   "head(HERE = Go", "head(AT = Go"));
    EXPECT_EQ(renamed("DRIP = 2s", "DR@IP = 2s", "T"),
              with(with(with(heads, "DRIP = 1s", "T = 1s"), "DRIP / X1", "T / X1"), "DRIP = 2s", "T = 2s"));
    EXPECT_EQ(renamed("VALVE = MOVE", "VALVE = MO@VE", "M"),
              with(with(heads, "VALVE = MOVE", "VALVE = M"), "ON = MOVE", "ON = M"));
    EXPECT_EQ(renamed("First.N", "First.@N", "COUNT"),
              with(with(heads, "internal N", "internal COUNT"), "First.N", "First.COUNT"));
}

TEST(LspCompletion, KnowsChartInstances) {
    Editor editor;
    const auto at = [&](const std::string& before, const std::string& half) {
        return editor.labels("heads.grafcet", with(heads, before, half));
    };
    EXPECT_TRUE(holds(at("Head = head(HERE = GO[1], VALVE = OPEN);", "Head = @"), "head"));
    EXPECT_EQ(at("Head = head(HERE = GO[1], VALVE = OPEN);", "Head = head(VALVE = OPEN, @"),
              (std::vector<std::string>{"DRIP", "HERE"}));
    EXPECT_TRUE(holds(at("Head = head(HERE = GO[1], VALVE = OPEN);", "Head = head(VALVE = @"), "OPEN"));
    EXPECT_TRUE(holds(at("First = head(HERE = Go.OUT, VALVE = MOVE, DRIP = 2s);", "First = @"), "plc"));
    EXPECT_TRUE(holds(at("never First.X1", "never First.@"), "X1"));
}

TEST(LspCompletion, KnowsReplicatedDeclarations) {
    Editor editor;
    const auto at = [&](const std::string& before, const std::string& half) {
        return editor.labels("lamps.grafcet", with(lamps, before, half));
    };
    EXPECT_TRUE(holds(at("{ LAMP[i]", "{ @"), "LAMP"));
    EXPECT_TRUE(holds(at("{ LAMP[i]", "{ LAMP[@"), "i"));
    EXPECT_TRUE(holds(at("1..i:", "1..@:"), "i"));
    EXPECT_TRUE(holds(at("when GO[i]", "when GO[i] && @"), "GO"));
    EXPECT_TRUE(holds(at("partial lamp[i] {", "@"), "transition"));
    EXPECT_EQ(at("for i in 1..2 {", "for i @").size(), 1U);
    EXPECT_EQ(at("for i in 1..2 {", "for @"), std::vector<std::string>{});
    const std::string ring =
        "component ring(output AT: bool) {\n"
        "    initial location at[0];\n"
        "    for i in 1..3 {\n"
        "        location at[i];\n"
        "        urgent at[i - 1] -> at[i] when AT;\n"
        "    }\n"
        "}\n";
    EXPECT_TRUE(holds(editor.labels("ring.grafcet", with(ring, "-> at[i]", "-> at[@")), "i"));
    EXPECT_EQ(editor.labels("ring.grafcet", with(ring, "for i in 1..3", "for i @")), std::vector<std::string>{"in"});
}

TEST(LspCompletion, OffersConstantsWhereAConstantIsAllowed) {
    Editor editor;
    editor.open("press.grafcet", press);
    const auto at = [&](const std::string& before, const std::string& half) {
        return editor.labels("loop.grafcet", with(steady, before, half));
    };
    for (const auto& [before, half] :
         std::vector<std::pair<const char*, const char*>>{{"time unit SLOW;", "time unit @"},
                                                          {"TRAVEL = SLOW);", "TRAVEL = @"},
                                                          {"|| MOST > 4", "|| @"},
                                                          {"0..MOST = 1", "0..@"},
                                                          {"SLOW = MOST * 500ms, LEAST", "SLOW = @, LEAST"},
                                                          {"most MOST times", "most @"},
                                                          {"N == MOST;", "N == @"},
                                                          {"within SLOW;", "within @"}})
        EXPECT_TRUE(holds(at(before, half), "MOST")) << half;
    EXPECT_EQ(at("LEAST: int 0..MOST = 1", "LEAST: @"), (std::vector<std::string>{"bool", "int", "duration"}));
    EXPECT_TRUE(at("LEAST: int 0..MOST = 1", "@").empty()) << "there are no completions for a new name";
}

TEST(LspCompletion, OffersValidProposals) {
    Editor editor;
    editor.open("press.grafcet", press);
    const auto in_chart = [&](const std::string& line) {
        return editor.labels("press.grafcet", with(press, "    transition t1: 1 -> 0 when DOWN;\n", line + "\n"));
    };
    const auto in_loop = [&](const std::string& line) {
        return editor.labels("loop.grafcet", with(loop, "    environment Down = free(OUT = DOWN);\n", line + "\n"));
    };
    EXPECT_TRUE(holds(in_chart("    tra@"), "transition"));
    EXPECT_EQ(in_chart("    transition t1: @"), (std::vector<std::string>{"0", "1"}));
    EXPECT_EQ(in_chart("    transition t1: 1 -> 0 @"), (std::vector<std::string>{"when", "do"}));
    for (const char* name : {"START", "DOWN", "MOVE", "N", "X0", "X1", "rise", "not"})
        EXPECT_TRUE(holds(in_chart("    transition t1: 1 -> 0 when START && D@"), name)) << name;
    EXPECT_FALSE(holds(in_chart("    transition t1: 1 -> 0 when D@"), "transition"));
    EXPECT_EQ(in_chart("    step 2 { M@ }"), (std::vector<std::string>{"MOVE", "N", "force"}));
    EXPECT_EQ(in_chart("    step 2 { N := 1 on @ }"),
              (std::vector<std::string>{"activation", "deactivation", "event"}));
    EXPECT_TRUE(holds(in_chart("    accept @"), "step-never-active"));
    EXPECT_TRUE(in_chart("    // transition t1: @").empty());

    EXPECT_EQ(in_loop("    controller @"), std::vector<std::string>{"press"});
    EXPECT_TRUE(holds(in_loop("    plant A = cyl@"), "cylinder_5_3"));
    EXPECT_EQ(in_loop("    plant A = cylinder_5_3(G_IN = MOVE, G_OUT = MOVE, X = H, X_min = 1, X_max = 2, @"),
              (std::vector<std::string>{"D_X", "STEP", "X_start"}));
    EXPECT_TRUE(holds(in_loop("    plant A = lamp(ON = @"), "MOVE"));
    EXPECT_EQ(in_loop("    plant A = position_sensors_2() initially @"),
              (std::vector<std::string>{"between", "in", "out"}));
    EXPECT_EQ(in_loop("    fault F of @"), (std::vector<std::string>{"Lamp", "Start"}));
    EXPECT_TRUE(holds(in_loop("    fault F of Start: fr@"), "free"));
    EXPECT_TRUE(holds(in_loop("    fault F of Lamp: lamp(ON = @"), "MOVE"));
    EXPECT_TRUE(holds(in_loop("    property p: @"), "never"));
    EXPECT_TRUE(holds(in_loop("    property p: never X1 && @"), "START"));
    EXPECT_EQ(in_loop("    property p: never Start.@"),
              (std::vector<std::string>{"idle", "leads to", "at stable", "implies", "in", "within", "precedes",
                                        "holds for", "holds at most", "at most", "since", "times", "at least every",
                                        "before", "after", "between", "until"}));
}

TEST(LspCompletion, KnowsDeclarationsOfAnIncompleteChart) {
    Editor editor;
    const std::string begin = press.substr(0, press.find("    transition"));
    const std::string end = press.substr(press.find("    transition"));
    for (const char* rest : {"", "}\n", "\n    step 3;\n}\n"})
        EXPECT_EQ(editor.labels("press.grafcet", begin + "    step 2 { M@\n" + rest),
                  (std::vector<std::string>{"MOVE", "N", "force"}))
            << rest;
    EXPECT_EQ(editor.labels("press.grafcet", begin + "    step 2 { M@\n" + end),
              (std::vector<std::string>{"MOVE", "N", "force"}));
    EXPECT_EQ(editor.labels("press.grafcet", begin + "    transition t0: 0 -> @"),
              (std::vector<std::string>{"0", "1"}));
    EXPECT_TRUE(holds(editor.labels("loop.grafcet", with(loop, "}\n", "    property p: never Start.@")), "idle"));
    EXPECT_TRUE(holds(editor.labels("loop.grafcet", with(loop, "}\n", "    controller press @")), "every"));
}

TEST(LspCompletion, OffersNothingInABlockWithoutAHead) {
    Editor editor;
    for (const char* const block : {"{ @", "observer { @", "force { @"})
        EXPECT_TRUE(editor.labels("loop.grafcet", with(loop, "plant Lamp", block)).empty()) << block;
}

TEST(LspCompletion, DescribesParameters) {
    Editor editor;
    const Json items = editor.at("textDocument/completion", "loop.grafcet", with(loop, "(ON = MOVE)", "(@)"))["items"];
    ASSERT_EQ(items.size(), 1U);
    EXPECT_EQ(items[0]["label"], "ON");
    EXPECT_EQ(items[0]["insertText"], "ON = $1");
    EXPECT_FALSE(items[0]["documentation"]["value"].get<std::string>().empty());
}

TEST(LspOutline, ShowsFoldsAndColours) {
    Editor editor;
    editor.open("press.grafcet", press);
    const Json folds = editor.of("textDocument/foldingRange", "press.grafcet");
    ASSERT_EQ(folds.size(), 1U);
    EXPECT_EQ(folds[0], (Json{{"startLine", 1}, {"endLine", 9}}));

    const Json data = editor.of("textDocument/semanticTokens/full", "press.grafcet")["data"];
    ASSERT_EQ(data.size() % 5, 0U);
    std::vector<int> first(data.begin(), data.begin() + 20);
    EXPECT_EQ(first, (std::vector<int>{0, 0, 26, 1, 0, 1, 0, 7, 0, 0, 0, 8, 5, 7, 1, 1, 4, 5, 0, 0}));

    editor.open("press.grafcet", with(press, "    output MOVE;\n", "output   MOVE;\n"));
    const Json edits = editor.of("textDocument/formatting", "press.grafcet");
    ASSERT_EQ(edits.size(), 1U);
    EXPECT_EQ(edits[0]["newText"], press);
    editor.open("press.grafcet", press);
    EXPECT_EQ(editor.of("textDocument/formatting", "press.grafcet"), Json::array());
    editor.open("press.grafcet", press + "grafcet");
    EXPECT_TRUE(editor.of("textDocument/formatting", "press.grafcet").is_null());
}

TEST(LspFeatures, SurviveEveryTruncationOfAText) {
    Editor editor;
    const std::string uri = editor.folder.uri("loop.grafcet");
    std::string all = press + loop.substr(loop.find('\n') + 1);
    for (std::size_t length = 0; length < all.size(); length += 7) {
        editor.client.open(uri, all.substr(0, length));
        const Position end = Text(all.substr(0, length)).position(length);
        const Json params = {{"textDocument", {{"uri", uri}}},
                             {"position", {{"line", end.line}, {"character", end.character}}},
                             {"context", Json::object()},
                             {"newName", "Q"}};
        for (const char* method :
             {"completion", "hover", "definition", "references", "documentSymbol", "foldingRange",
              "semanticTokens/full", "formatting", "documentHighlight", "prepareRename", "rename"}) {
            const Json answer =
                editor.client.answer(editor.client.send_request(std::string("textDocument/") + method, params));
            EXPECT_TRUE(!answer.contains("error") || answer["error"]["code"] == -32803) << method << answer;
        }
    }
}

}  // namespace
}  // namespace grafverif::lsp
