// SPDX-License-Identifier: MIT
// Tests operations that declare variables, partial charts, macro-steps and enclosing steps, and the names that they
// propose.
#include <gtest/gtest.h>

#include <algorithm>

#include "editing.hpp"

namespace grafverif::edit {
namespace {

TEST(EditDeclare, VariableIsDeclaredAfterTheLastVariableOfItsKind) {
    Editing edit(lamp);
    edit.perform(OperationKind::Declare, "step 1", "input DOOR");
    edit.perform(OperationKind::Declare, "transition on", "internal n: int 0..3 = 1;");
    edit.expect("input ON, OFF;\n", "input ON, OFF;\n    input DOOR;\n")
        .expect("output LAMP, FAN;\n", "output LAMP, FAN;\n    internal n: int 0..3 = 1;\n");
    EXPECT_EQ(edit.obstacle(OperationKind::Declare, "step 1", "input A, B"),
              "`input A, B` is not the declaration of one variable");
    EXPECT_EQ(edit.obstacle(OperationKind::Declare, "step 1", "step 9"),
              "`step 9` is not the declaration of one variable");
    EXPECT_EQ(edit.obstacle(OperationKind::Declare, "step 1", "input ON").substr(0, 40),
              "the change would make the text invalid: ");
    EXPECT_NE(edit.obstacle(OperationKind::Declare, "step 1", "input A; } grafcet h { input B"), "");
}

TEST(EditDeclare, FirstVariableIsDeclaredAtTheBeginningOfTheChart) {
    Editing edit("grafcet g {  // a chart\r\n    initial step 0;\r\n}\r\n");
    edit.perform(OperationKind::Declare, "initial", "output Q");
    edit.expect("// a chart\r\n", "// a chart\r\n    output Q;\r\n");
    Editing line("grafcet g(input A) { initial step 0; }\n");
    line.perform(OperationKind::Declare, "initial", "output Q");
    line.expect("{ ", "{ output Q; ");
}

TEST(EditDeclare, InputOfAControlledChartIsDriven) {
    Editing edit(std::string(lamp) +
                 "closed_loop l {\n    controller lamp;\n    environment a = free(OUT = ON);\n"
                 "    environment b = free(OUT = OFF);\n    property P: never LAMP && FAN;\n}\n");
    edit.perform(OperationKind::Declare, "step 1", "input DOOR");
    edit.perform(OperationKind::Declare, "step 1", "output HORN");
    edit.expect("input ON, OFF;\n", "input ON, OFF;\n    input DOOR;\n")
        .expect("output LAMP, FAN;\n", "output LAMP, FAN;\n    output HORN;\n")
        .expect("OUT = OFF);\n", "OUT = OFF);\n    environment DOOR_any = free(OUT = DOOR);\n");
}

TEST(EditDeclare, IntegerInputOfAControlledChartIsDrivenWithinItsRange) {
    Editing edit(std::string(lamp) +
                 "closed_loop l {\n    controller lamp;\n    environment a = free(OUT = ON);\n"
                 "    environment n_any = free(OUT = OFF);\n    property P: never LAMP && FAN;\n}\n");
    edit.perform(OperationKind::Declare, "step 1", "input /* level */ n: int 1..3");
    edit.expect("input ON, OFF;\n", "input ON, OFF;\n    input /* level */ n: int 1..3;\n")
        .expect("OUT = OFF);\n", "OUT = OFF);\n    environment n_any1 = free_integer(OUT = n, LOW = 1, HIGH = 3);\n");
    EXPECT_EQ(edit.obstacle(OperationKind::Declare, "step 1", "input FULL[1]"),
              "`FULL` has an index, and closed loop `l` uses the chart as a controller; declare the input and its "
              "environment in the text");
}

TEST(EditDeclare, InputOfAnInstanceIsRejected) {
    Editing edit(
        "grafcet g(input A) {\n    initial step 0;\n}\n"
        "closed_loop l {\n    environment b = free(OUT = B);\n    controller c = g(A = B);\n"
        "    property P: never c.X0 && !c.X0;\n}\n");
    EXPECT_EQ(
        edit.obstacle(OperationKind::Declare, "initial", "input D"),
        "the instance `c` of the chart requires an argument for the input; declare the input and pass the argument "
        "in the text of the file");
}

TEST(EditDeclare, ExpansionOfAMacroStepHasNewNames) {
    Editing edit(
        "grafcet g {\n    input A;\n    initial step E;\n    step S;\n    transition E -> S when A;\n    transition S "
        "-> E when XE;\n}\n");
    edit.perform(OperationKind::Macro, "step S");
    edit.expect("step S;\n", "step S;\n    macro step S2 expands E1;\n")
        .expect("S -> E when XE;\n}",
                "S2 -> E when XE;\n    transition S -> S2 when true;\n\n    expansion E1 {\n        entry step E2;\n"
                "        exit step S1;\n        transition E2 -> S1 when true;\n    }\n}");
}

TEST(EditDeclare, PartialChartHasAnInitialStep) {
    Editing edit(lamp);
    edit.perform(OperationKind::Partial, "step 1", "G2");
    EXPECT_EQ(edit.selected, "initial step");
    edit.expect("OFF && !ON;\n}", "OFF && !ON;\n\n    partial G2 {\n        initial step 3;\n    }\n}");
    EXPECT_EQ(edit.obstacle(OperationKind::Partial, "step 1", "a b"), "`a b` is not a valid name");
    EXPECT_EQ(edit.obstacle(OperationKind::Partial, "step 1", "step"), "`step` is not a valid name");
    EXPECT_EQ(edit.obstacle(OperationKind::Partial, "step 1", "G2").substr(0, 40),
              "the change would make the text invalid: ");
    edit.perform(OperationKind::Action, "step 1", "force G2 := {INIT}");
    edit.expect("step 1 { LAMP; }", "step 1 { LAMP; force G2 := {INIT}; }");
}

TEST(EditDeclare, MacroStepHasAnExpansion) {
    Editing edit(lamp);
    edit.perform(OperationKind::Macro, "initial step 0");
    EXPECT_EQ(edit.selected, "macro step 3");
    edit.expect("// dark\n", "// dark\n    macro step 3 expands E1;\n")
        .expect("on: 0 -> 1 when ON;  // pressed\n",
                "on: 3 -> 1 when ON;  // pressed\n    transition t4: 0 -> 3 when true;\n")
        .expect("OFF && !ON;\n}",
                "OFF && !ON;\n\n    expansion E1 {\n        entry step E;\n        exit step S;\n"
                "        transition t5: E -> S when true;\n    }\n}");
    edit.perform(OperationKind::Macro, "transition off");
    edit.expect("    step 2 {\n        FAN;  // cools\n        LAMP if ON;\n    }\n",
                "    step 2 {\n        FAN;  // cools\n        LAMP if ON;\n    }\n    macro step 4 expands E2;\n")
        .expect("off: 2 -> 0 when OFF && !ON;\n",
                "off: 2 -> 4 when OFF && !ON;\n    transition t6: 4 -> 0 when true;\n")
        .expect("E -> S when true;\n    }\n",
                "E -> S when true;\n    }\n\n    expansion E2 {\n        entry step E3;\n        exit step S1;\n"
                "        transition t7: E3 -> S1 when true;\n    }\n");
}

TEST(EditDeclare, EnclosingStepEnclosesKnownAndNewPartialCharts) {
    Editing edit(lamp);
    edit.perform(OperationKind::Partial, "step 1", "G2");
    edit.perform(OperationKind::Enclosing, "transition on", "G2");
    EXPECT_EQ(edit.selected, "enclosing st");
    edit.perform(OperationKind::Enclosing, "transition off", "G3");
    edit.expect("// dark\n", "// dark\n    enclosing step 4 encloses G2;\n")
        .expect("on: 0 -> 1 when ON;  // pressed\n",
                "on: 0 -> 4 when ON;  // pressed\n    transition t4: 4 -> 1 when true;\n")
        .expect("LAMP if ON;\n    }\n", "LAMP if ON;\n    }\n    enclosing step 5 encloses G3;\n")
        .expect("off: 2 -> 0 when OFF && !ON;\n}",
                "off: 2 -> 5 when OFF && !ON;\n    transition t5: 5 -> 0 when true;\n\n    partial G2 {\n"
                "        initial step 3;\n    }\n\n    partial G3 {\n        linked step 6;\n    }\n}");
}

TEST(EditProposals, ConditionsAndActionsHaveTheNamesOfTheLanguageServer) {
    const Editing edit(lamp);
    const auto labels = [&](const std::string& before, const std::string& typed) {
        const std::size_t at = edit.document.text().find(before) + before.size();
        std::string text = edit.document.text();
        text.insert(at, typed);
        std::vector<std::string> list;
        for (const lsp::Proposal& each : edit.document.proposals(text, at + typed.size())) list.push_back(each.label);
        return list;
    };
    const auto has = [](const std::vector<std::string>& list, const std::string& label) {
        return std::ranges::find(list, label) != list.end();
    };
    for (const char* label : {"ON", "LAMP", "X2", "rise"}) EXPECT_TRUE(has(labels("when ON", " && O"), label)) << label;
    EXPECT_TRUE(has(labels("when 3s/X1", " && 5s/"), "X0")) << "a timer";
    EXPECT_TRUE(has(labels("LAMP; ", "F"), "FAN"));
    EXPECT_FALSE(has(labels("LAMP; ", "F"), "ON")) << "an input is not an action";
    EXPECT_TRUE(labels("// dark", " O").empty()) << "in a comment";
}

}  // namespace
}  // namespace grafverif::edit
