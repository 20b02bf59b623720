// SPDX-License-Identifier: MIT
// Tests requests about PLC programs: Structured Text, textual Sequential Function Charts, and loops that use them.
#include <random>
#include <set>

#include "unit/lsp/editor.hpp"

namespace grafverif::lsp {
namespace {

const std::string press =
    "TYPE Mode : (Off, Slow, Fast); END_TYPE\n"
    "VAR_GLOBAL Lamp AT %QX0.1 : BOOL; END_VAR\n"
    "(* Counts edges. *)\n"
    "FUNCTION_BLOCK Counter\n"
    "VAR_INPUT Up : BOOL; END_VAR\n"
    "VAR_OUTPUT Sum : INT; END_VAR\n"
    "VAR Edge : R_TRIG; END_VAR\n"
    "Edge(CLK := Up);\n"
    "IF Edge.Q THEN SUM := Sum + 1; END_IF\n"
    "END_FUNCTION_BLOCK\n"
    "FUNCTION Twice : INT\n"
    "VAR_INPUT N : INT; END_VAR\n"
    "Twice := 2 * N;\n"
    "END_FUNCTION\n"
    "PROGRAM Press\n"
    "VAR_INPUT Start AT %IX0.0 : BOOL; END_VAR  // from the desk\n"
    "VAR_OUTPUT Move : BOOL; END_VAR\n"
    "VAR Count : Counter; State : Mode := Off; Delay : TON; END_VAR\n"
    "Count(Up := Start);\n"
    "Delay(IN := (START), PT := T#2s);\n"
    "IF Twice(Count.Sum) > 3 AND State = Off THEN State := Fast; END_IF\n"
    "Move := Delay.Q;\n"
    "Lamp := Move;\n"
    "END_PROGRAM\n";
const std::string loop =
    "program press = \"press.st\";\n"
    "closed_loop machine {\n"
    "    controller press every 10ms;\n"
    "    environment Start = free(OUT = Start);\n"
    "    property late: never Move;\n"
    "}\n";
const std::string chart =
    "PROGRAM spindle\n"
    "VAR_INPUT Go : BOOL; END_VAR\n"
    "VAR_OUTPUT Run : BOOL; END_VAR\n"
    "VAR N : INT; END_VAR\n"
    "INITIAL_STEP Idle: END_STEP\n"
    "STEP Turning: Run(N); Add(P); END_STEP\n"
    "TRANSITION Begin FROM Idle TO Turning := Go; END_TRANSITION\n"
    "TRANSITION FROM Turning TO Idle := NOT Go AND Turning.T > T#1s; END_TRANSITION\n"
    "ACTION Add: N := N + 1; END_ACTION\n"
    "END_PROGRAM\n";

class Editor : public TextEditor {
public:
    Editor() : TextEditor({{"press.st", press}, {"loop.grafcet", loop}, {"chart.st", chart}}) {}

    /// Returns the line of the definition of the name at the cursor, from 0, with the name of its file.
    std::string definition(const std::string& name, const std::string& text) {
        const Json found = at("textDocument/definition", name, text);
        if (found.is_null()) return "none";
        return rpc::path_of_uri(found["uri"].get<std::string>()).substr(folder.path().size() + 1) + ":" +
               std::to_string(found["range"]["start"]["line"].get<int>());
    }
    std::string hover(const std::string& name, const std::string& text) {
        const Json found = at("textDocument/hover", name, text);
        return found.is_null() ? "none" : found["contents"]["value"].get<std::string>();
    }
    std::size_t references(const std::string& name, const std::string& text) {
        return at("textDocument/references", name, text, {{"context", {{"includeDeclaration", true}}}}).size();
    }
};

TEST(LspPrograms, ErrorsHaveCodesAndPositions) {
    Editor editor;
    editor.open("press.st", with(press, "Lamp := Move", "Lamp := Count.Sum + Mvoe"));
    const Json found = editor.client.diagnostics(editor.folder.uri("press.st"));
    ASSERT_EQ(found.size(), 1U) << found;
    EXPECT_EQ(found[0]["code"], "unknown-variable") << found;
    EXPECT_EQ(found[0]["range"]["start"], (Json{{"line", 22}, {"character", 20}}));
    EXPECT_EQ(found[0]["range"]["end"], (Json{{"line", 22}, {"character", 24}}));
    editor.client.retype(editor.folder.uri("press.st"), 2, press);
    EXPECT_EQ(editor.client.diagnostics(editor.folder.uri("press.st"), 2), Json::array());
}

TEST(LspPrograms, AllErrorsOfATextAreReported) {
    Editor editor;
    editor.open("press.st", with(with(press, "Move := Delay.Q", "Move := Delay.QQ"), "Up := Start", "Up := 3"));
    EXPECT_EQ(editor.client.diagnostics(editor.folder.uri("press.st")).size(), 2U);
    editor.open("new.st", "VAR");
    EXPECT_GE(editor.client.diagnostics(editor.folder.uri("new.st")).size(), 1U);
}

TEST(LspPrograms, NamesLeadToTheirDeclarationWithoutRegardToCase) {
    Editor editor;
    const auto line = [&](const std::string& what, const std::string& cursor) {
        return editor.definition("press.st", with(press, what, cursor));
    };
    EXPECT_EQ(line("(START)", "(STA@RT)"), "press.st:15");
    EXPECT_EQ(line("Count.Sum) > 3", "Count.S@um) > 3"), "press.st:5");
    EXPECT_EQ(line("Count.Sum) > 3", "Co@unt.Sum) > 3"), "press.st:17");
    EXPECT_EQ(line("Count(Up", "Count(U@p"), "press.st:4");
    EXPECT_EQ(line("IF Twice", "IF Tw@ice"), "press.st:10");
    EXPECT_EQ(line("State := Fast", "State := Fa@st"), "press.st:0");
    EXPECT_EQ(line("Count : Counter", "Count : Cou@nter"), "press.st:3");
    EXPECT_EQ(line("State : Mode", "State : Mo@de"), "press.st:0");
    EXPECT_EQ(line("Lamp := Move", "La@mp := Move"), "press.st:1");
    EXPECT_EQ(line("Delay : TON", "Delay : T@ON"), "none");  // the library declares this block
}

TEST(LspPrograms, HoverShowsTypeDeclarationAddressAndComment) {
    Editor editor;
    const auto shown = [&](const std::string& what, const std::string& cursor) {
        return editor.hover("press.st", with(press, what, cursor));
    };
    EXPECT_EQ(shown("(START)", "(STA@RT)"),
              "```st\nVAR_INPUT Start AT %IX0.0 : BOOL\n```\n\n```text\nfrom the desk\n```\n");
    EXPECT_EQ(shown("State = Off", "@State = Off"), "```st\nVAR State : Mode := Off\n```\n");
    EXPECT_EQ(shown("Count : Counter", "Count : Cou@nter"),
              "```st\nFUNCTION_BLOCK Counter\n    VAR_INPUT Up : BOOL\n    VAR_OUTPUT Sum : INT\n```\n\n"
              "```text\n Counts edges. \n```\n");
    EXPECT_EQ(shown("Delay.Q", "Delay.@Q"), "```st\nVAR_OUTPUT Q : BOOL\n```\n");
    EXPECT_NE(shown("Delay : TON", "Delay : T@ON").find("VAR_INPUT PT : TIME"), std::string::npos);
    EXPECT_EQ(shown("State = Off", "State = O@ff"), "```st\nOff = 0, of Mode\n```\n");
    EXPECT_EQ(shown("Counts edges", "Cou@nts edges"), "none");
}

TEST(LspPrograms, ReferencesIncludeTheLoopsThatUseTheProgram) {
    Editor editor;
    EXPECT_EQ(editor.references("press.st", with(press, "Move := Delay", "Mo@ve := Delay")), 4U);  // one is in the loop
    EXPECT_EQ(editor.references("press.st", with(press, "SUM := Sum", "SU@M := Sum")), 4U);
    EXPECT_EQ(editor.references("press.st", with(press, "State = Off", "State = O@ff")), 3U);
    EXPECT_EQ(editor.definition("loop.grafcet", with(loop, "never Move", "never Mo@ve")), "press.st:16");
    EXPECT_EQ(editor.hover("loop.grafcet", with(loop, "never Move", "never Mo@ve")),
              "```st\nVAR_OUTPUT Move : BOOL\n```\n");
}

TEST(LspPrograms, VariablesAreRenamedInAllFiles) {
    Editor editor;
    Json edit = editor.at("textDocument/rename", "press.st", with(press, "Move := Delay", "Mo@ve := Delay"),
                          {{"newName", "Go"}});
    EXPECT_EQ(edited(press, edit["changes"][editor.folder.uri("press.st")]),
              with(with(with(press, "Move : BOOL", "Go : BOOL"), "Move := Delay", "Go := Delay"), "Lamp := Move",
                   "Lamp := Go"));
    EXPECT_EQ(edited(loop, edit["changes"][editor.folder.uri("loop.grafcet")]), with(loop, "never Move", "never Go"));
    edit =
        editor.at("textDocument/rename", "press.st", with(press, "SUM := Sum", "SU@M := Sum"), {{"newName", "Total"}});
    EXPECT_EQ(edited(press, edit["changes"][editor.folder.uri("press.st")]),
              with(with(with(press, "Sum : INT", "Total : INT"), "SUM := Sum", "Total := Total"), "Count.Sum",
                   "Count.Total"));
}

TEST(LspPrograms, OwnersInPathsAreNames) {
    Editor editor;
    const std::string paths = with(loop, "never Move;",
                                   "never Move && Count.Sum > 2 && press.COUNT.Sum > 1 && press.Delay.Q;\n"
                                   "    property edge: never Count.Edge.Q && Delay.Q;");
    editor.open("loop.grafcet", paths);
    Json edit = editor.at("textDocument/rename", "press.st", with(press, "Count : Counter", "Co@unt : Counter"),
                          {{"newName", "Cycles"}});
    std::string renamed = paths;
    for (const char* const path : {"Count.Sum", "COUNT.Sum", "Count.Edge"})
        renamed = with(renamed, path, "Cycles" + std::string(path).substr(5));
    EXPECT_EQ(edited(paths, edit["changes"][editor.folder.uri("loop.grafcet")]), renamed);
    edit = editor.at("textDocument/rename", "press.st", with(press, "Edge : R_TRIG", "Ed@ge : R_TRIG"),
                     {{"newName", "Rise"}});
    EXPECT_EQ(edited(paths, edit["changes"][editor.folder.uri("loop.grafcet")]),
              with(paths, "Count.Edge", "Count.Rise"));
    EXPECT_EQ(editor.definition("loop.grafcet", with(paths, "&& Delay.Q", "&& De@lay.Q")), "press.st:17");
    EXPECT_EQ(editor.obstacle("loop.grafcet", with(paths, "&& Delay.Q", "&& Delay.@Q"), "Done"),
              "`Delay.Q` belongs to the library and cannot be renamed");
}

TEST(LspPrograms, TypeAndValueOfAnEnumerationLiteralAreNames) {
    Editor editor;
    const std::string literals =
        with(with(press, "Mode := Off", "Mode := MODE#Off"), "State = Off", "State = Mode#OFF");
    const auto renamed = [&](const std::string& what, const std::string& cursor, const char* name) {
        const Json edit =
            editor.at("textDocument/rename", "press.st", with(literals, what, cursor), {{"newName", name}});
        return edited(literals, edit["changes"][editor.folder.uri("press.st")]);
    };
    const std::string state = with(
        with(with(with(literals, "TYPE Mode", "TYPE Speed"), "State : Mode", "State : Speed"), "MODE#Off", "Speed#Off"),
        "Mode#OFF", "Speed#OFF");
    EXPECT_EQ(renamed("TYPE Mode", "TYPE Mo@de", "Speed"), state);
    EXPECT_EQ(renamed("Mode#OFF", "Mo@de#OFF", "Speed"), state);
    EXPECT_EQ(renamed("Mode#OFF", "Mode#O@FF", "Halt"),
              with(with(with(literals, "(Off,", "(Halt,"), "MODE#Off", "MODE#Halt"), "Mode#OFF", "Mode#Halt"));
}

TEST(LspPrograms, InstanceIsTheOwnerOfItsSteps) {
    const std::string feeder =
        "FUNCTION_BLOCK Feeder\n"
        "VAR_INPUT Go : BOOL; END_VAR\n"
        "VAR_OUTPUT Run : BOOL; END_VAR\n"
        "INITIAL_STEP Idle: END_STEP\n"
        "STEP Turning: Run(N); END_STEP\n"
        "TRANSITION FROM Idle TO Turning := Go; END_TRANSITION\n"
        "TRANSITION FROM Turning TO Idle := NOT Go; END_TRANSITION\n"
        "END_FUNCTION_BLOCK\n"
        "PROGRAM Feed\n"
        "VAR_INPUT Go : BOOL; END_VAR\n"
        "VAR_OUTPUT Run : BOOL; END_VAR\n"
        "VAR Left : Feeder; END_VAR\n"
        "Left(Go := Go, Run => Run);\n"
        "END_PROGRAM\n";
    const std::string feed =
        "program feed = \"feed.st\";\n"
        "closed_loop machine {\n"
        "    controller feed every 10ms;\n"
        "    environment Go = free(OUT = Go);\n"
        "    property turns: never Left.XTurning && feed.Left.XIdle;\n"
        "}\n";
    TextEditor editor({{"feed.st", feeder}, {"feed.grafcet", feed}});
    const Json edit = editor.at("textDocument/rename", "feed.st", with(feeder, "Left : Feeder", "Le@ft : Feeder"),
                                {{"newName", "Right"}});
    EXPECT_EQ(edited(feed, edit["changes"][editor.folder.uri("feed.grafcet")]),
              with(with(feed, "Left.XTurning", "Right.XTurning"), "Left.XIdle", "Right.XIdle"));
}

TEST(LspPrograms, NamesAreNotRenamedIfTheMeaningWouldChange) {
    Editor editor;
    const auto obstacle = [&](const std::string& text, const char* name) {
        return editor.obstacle("press.st", text, name);
    };
    const std::string start = with(press, "Start AT", "Sta@rt AT");
    EXPECT_EQ(obstacle(start, "delay"),
              "`delay` has another meaning in the scope of `Start`, or is not allowed there; choose another name");
    EXPECT_EQ(obstacle(start, "END_IF"),
              "`END_IF` has another meaning in the scope of `Start`, or is not allowed there; choose another name");
    EXPECT_EQ(obstacle(start, "1st"), "`1st` is not a valid name here");
    EXPECT_EQ(obstacle(with(press, "Delay : TON", "Delay : T@ON"), "Timer"),
              "`TON` belongs to the library and cannot be renamed");
    EXPECT_NE(obstacle(start + "PROGRAM", "Begin").find("has syntax errors"), std::string::npos);
}

TEST(LspPrograms, StepsActionsAndTransitionsAreNames) {
    Editor editor;
    EXPECT_EQ(editor.definition("chart.st", with(chart, "TO Turning", "TO Tur@ning")), "chart.st:5");
    EXPECT_EQ(editor.definition("chart.st", with(chart, "Turning.T >", "Tur@ning.T >")), "chart.st:5");
    EXPECT_EQ(editor.definition("chart.st", with(chart, "Add(P)", "Ad@d(P)")), "chart.st:8");
    EXPECT_EQ(editor.definition("chart.st", with(chart, "Run(N)", "Ru@n(N)")), "chart.st:2");
    EXPECT_EQ(editor.references("chart.st", with(chart, "STEP Turning", "STEP Tur@ning")), 4U);
    const Json edit =
        editor.at("textDocument/rename", "chart.st", with(chart, "STEP Turning", "STEP Tur@ning"), {{"newName", "On"}});
    std::string renamed = chart;
    while (renamed.find("Turning") != std::string::npos) renamed = with(renamed, "Turning", "On");
    EXPECT_EQ(edited(chart, edit["changes"][editor.folder.uri("chart.st")]), renamed);
}

TEST(LspPrograms, OutlineAndFoldsContainUnitsAndSteps) {
    Editor editor;
    editor.open("chart.st", chart);
    const Json symbols = editor.of("textDocument/documentSymbol", "chart.st");
    ASSERT_EQ(symbols.size(), 1U);
    EXPECT_EQ(symbols[0]["name"], "spindle");
    std::vector<std::string> names;
    for (const Json& child : symbols[0]["children"]) names.push_back(child["name"]);
    EXPECT_EQ(names, (std::vector<std::string>{"Go", "Run", "N", "Idle", "Turning", "Begin", "Add"}));
    EXPECT_EQ(editor.of("textDocument/foldingRange", "chart.st")[0], (Json{{"startLine", 0}, {"endLine", 9}}));
    EXPECT_FALSE(editor.of("textDocument/semanticTokens/full", "chart.st")["data"].empty());
}

TEST(LspPrograms, CompletionProposesNamesInScope) {
    Editor editor;
    const auto labels = [&](const std::string& what, const std::string& cursor) {
        return editor.labels("press.st", with(press, what, cursor));
    };
    const auto members = labels("Count.Sum) > 3", "Count.@) > 3");
    EXPECT_EQ(std::set<std::string>(members.begin(), members.end()), (std::set<std::string>{"Sum", "Up"}));
    const auto standard = labels("Move := Delay.Q", "Move := Delay.@");
    EXPECT_EQ(std::set<std::string>(standard.begin(), standard.end()), (std::set<std::string>{"ET", "IN", "PT", "Q"}));
    const auto terms = labels("Move := Delay.Q", "Move := De@");
    for (const char* const name : {"Start", "Move", "Count", "Lamp", "Fast", "Twice", "MAX", "END_IF"})
        EXPECT_TRUE(holds(terms, name)) << name;
    for (const char* const name : {"Edge", "Sum", "Counter", "TON"}) EXPECT_FALSE(holds(terms, name)) << name;
    const auto types = labels("Delay : TON", "Delay : @");
    for (const char* const name : {"TON", "Counter", "Mode", "BOOL"}) EXPECT_TRUE(holds(types, name)) << name;
    EXPECT_FALSE(holds(types, "Start"));
    for (const char* const array : {"Delay : ARRAY[1..3] OF @", "Delay : ARRAY [1..2] of ARRAY[0..1] of T@"}) {
        const auto elements = labels("Delay : TON", array);
        for (const char* const name : {"TON", "Counter", "Mode", "BOOL"}) EXPECT_TRUE(holds(elements, name)) << name;
        EXPECT_FALSE(holds(elements, "Start"));
    }
    EXPECT_TRUE(holds(labels("Move := Delay.Q", "CASE Count.Sum OF @"), "Start"));
    const auto parameters = labels("Count(Up := Start)", "Count(@)");
    ASSERT_FALSE(parameters.empty());
    EXPECT_TRUE(holds(parameters, "Up"));
    EXPECT_EQ(labels("(* Counts edges. *)", "(* Counts @"), std::vector<std::string>());
    const auto step = editor.labels("chart.st", with(chart, "Turning.T > T#1s", "Turning.@"));
    EXPECT_EQ(step, (std::vector<std::string>{"X", "T"}));
}

TEST(LspPrograms, CompletionProposesNoNamesOfLoopsAndOtherPrograms) {
    Editor editor;
    editor.open("loop.grafcet",
                "program spindle = \"chart.st\";\n" +
                    with(loop, "environment",
                         "controller spindle every 10ms;\n    environment Go = free(OUT = Go);\n    environment"));
    const auto terms = editor.labels("press.st", with(press, "Move := Delay.Q", "Move := @"));
    EXPECT_TRUE(holds(terms, "Start"));
    for (const char* const name : {"machine", "press", "spindle", "free"}) EXPECT_FALSE(holds(terms, name)) << name;
    const auto types = editor.labels("press.st", with(press, "Delay : TON", "Delay : @"));
    EXPECT_TRUE(holds(types, "Counter"));
    EXPECT_FALSE(holds(types, "spindle"));
}

TEST(LspPrograms, DeclarationsAreKnownInAnIncompleteText) {
    Editor editor;
    // The parser does not reach the end of the unit, because END_IF is missing.
    const std::string half = with(press, "Fast; END_IF", "Fast;\nIF De@");
    const auto labels = editor.labels("press.st", half);
    for (const char* const name : {"Start", "Move", "Count", "Lamp"}) EXPECT_TRUE(holds(labels, name)) << name;
    EXPECT_EQ(
        editor.definition("press.st", with(with(press, "Fast; END_IF", "Fast;"), "Lamp := Move", "Lamp := Mo@ve")),
        "press.st:16");
}

TEST(LspPrograms, ASaveChecksTheLoopsThatUseTheProgram) {
    Editor editor;
    editor.open("press.st", press);
    editor.client.notify("textDocument/didSave", {{"textDocument", {{"uri", editor.folder.uri("press.st")}}}});
    const Json found = editor.client.next("textDocument/publishDiagnostics", [&](const Json& params) {
        return params["uri"] == editor.folder.uri("loop.grafcet") && !params["diagnostics"].empty();
    })["diagnostics"];
    EXPECT_EQ(found[0]["code"], "violated") << found;
}

// The requests for each position of a damaged text have a response, and the server continues.
TEST(LspPrograms, RequestsInDamagedTextsHaveResponses) {
    Editor editor;
    std::mt19937 random(7);
    for (int round = 0; round < 60; ++round) {
        std::string text = round % 2 == 0 ? press : chart;
        const std::size_t begin = random() % text.size();
        text.erase(begin, round % 3 == 0 ? text.size() : random() % 40);
        if (round % 5 == 0) text.insert(random() % (text.size() + 1), "END_IF;");
        const std::size_t at = random() % (text.size() + 1);
        text.insert(at, "@");
        const std::string name = round % 2 == 0 ? "press.st" : "chart.st";
        for (const char* const method : {"textDocument/hover", "textDocument/completion", "textDocument/definition"})
            editor.at(method, name, text);
        editor.of("textDocument/documentSymbol", name);
        editor.of("textDocument/semanticTokens/full", name);
    }
    EXPECT_EQ(editor.definition("press.st", with(press, "Lamp := Move", "La@mp := Move")), "press.st:1");
}

}  // namespace
}  // namespace grafverif::lsp
