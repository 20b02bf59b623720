// SPDX-License-Identifier: MIT
// Copy and paste of steps with their transitions.
#include <gtest/gtest.h>

#include "editing.hpp"

namespace grafverif::edit {
namespace {

std::string copy(Editing& edit, const std::vector<std::string>& steps) {
    std::vector<std::uint32_t> at;
    for (const std::string& step : steps) at.push_back(edit.at(step));
    const Copy made = edit.document.copied(at);
    EXPECT_EQ(made.obstacle, "");
    return made.text;
}

TEST(EditPaste, StepsArePastedAsAnAlternativeWithNewNames) {
    Editing edit(lamp);
    const std::string text = copy(edit, {"step 1", "step 2"});
    EXPECT_EQ(text,
              "step 1 { LAMP; }\nstep 2 {\n        FAN;  // cools\n        LAMP if ON;\n    }\n"
              "transition on: 0 -> 1 when ON;\ntransition t2: 1 -> 2 when 3s/X1;\n"
              "transition off: 2 -> 0 when OFF && !ON;\n");
    edit.perform(OperationKind::Paste, "transition on", text);
    EXPECT_EQ(edit.selected.substr(0, 7), "step 3 ");
    edit.expect("// dark\n",
                "// dark\n    step 3 { LAMP; }\n    step 4 {\n        FAN;  // cools\n        LAMP if ON;\n    }\n")
        .expect("when ON;  // pressed\n",
                "when ON;  // pressed\n    transition t4: 0 -> 3 when !ON;\n    transition t5: 3 -> 4 when 3s/X3;\n"
                "    transition t6: 4 -> 1 when OFF && !ON;\n");
}

TEST(EditPaste, StepWithoutTransitionsGetsTheCopyWithoutItsEnd) {
    Editing edit("grafcet g {\n    input A;\n    initial step 0;\n    step 1;\n    transition 0 -> 1 when A;\n}\n");
    edit.perform(OperationKind::Paste, "step 1", copy(edit, {"initial step 0", "step 1"}));
    EXPECT_EQ(edit.selected.substr(0, 7), "step 2;");
    edit.expect("    step 1;\n", "    step 1;\n    step 2;\n    step 3;\n")
        .expect("when A;\n", "when A;\n    transition 1 -> 2 when true;\n    transition 2 -> 3 when A;\n");
}

TEST(EditPaste, ParallelBranchesAndLoopsBackAreCopied) {
    Editing edit(
        "grafcet g {\n    input A, B;\n    output Q;\n    initial step S;\n    step P1 { Q if XP2; }\n    step P2;\n"
        "    transition S -> P1, P2 when A;\n    transition P1, P2 -> S when B && XP1 /* XP1 */;\n"
        "    transition P1 -> P1 when A && B;\n}\n");
    EXPECT_EQ(edit.obstacle(OperationKind::Paste, "initial step S", "step 1; input C;"),
              "the copied text does not consist of steps and their transitions");
    edit.perform(OperationKind::Paste, "transition S", copy(edit, {"step P2", "step P1"}));
    edit.expect("initial step S;\n", "initial step S;\n    step P3;\n    step P4 { Q if XP3; }\n")
        .expect("P2 when A;\n",
                "P2 when A;\n    transition S -> P4, P3 when !A;\n"
                "    transition P4, P3 -> P1, P2 when B && XP4 /* XP1 */;\n"
                "    transition P4 -> P4 when A && B;\n");
}

TEST(EditPaste, CopyCanBePastedAfterItsStepsAreDeletedAndInAnotherPartialChart) {
    Editing edit(
        "grafcet g {\n    input A;\n    initial step 0;\n    step 1;\n    transition 0 -> 1 when A;\n"
        "    transition 1 -> 0 when !A;\n    partial P {\n        initial step 10;\n        step 11;\n"
        "        transition 10 -> 11 when A;\n        transition 11 -> 10 when !A;\n    }\n}\n");
    const std::string text = copy(edit, {"step 11"});
    EXPECT_EQ(edit.document.copied({edit.at("step 1;"), edit.at("step 11")}).obstacle,
              "the steps belong to different charts or partial charts; copy them separately");
    EXPECT_EQ(edit.document.copied({edit.at("transition 0")}).obstacle, "only steps can be copied");
    EXPECT_EQ(edit.document.copied({}).obstacle, "select the steps first");
    edit.perform(OperationKind::Delete, "step 11");
    edit.perform(OperationKind::Paste, "transition 0", text);
    edit.expect("        step 11;\n", "").expect("        transition 11 -> 10 when !A;\n", "");
    edit.expect("transition 10 -> 11", "transition 10 -> 10");
    edit.expect("initial step 0;\n", "initial step 0;\n    step 2;\n")
        .expect("0 -> 1 when A;\n", "0 -> 1 when A;\n    transition 0 -> 2 when !A;\n    transition 2 -> 1 when !A;\n");
}

TEST(EditPaste, UnconnectedAndRepeatedStepsAreRejected) {
    Editing edit(
        "grafcet g {\n    input A;\n    initial step 0;\n    step 1;\n    step 2;\n    transition 0 -> 1 when A;\n"
        "    transition 1 -> 0 when !A;\n    transition 0 -> 2 when !A;\n    transition 2 -> 0 when A;\n"
        "    for i in 1..2 {\n        step L[i];\n        transition L[i] -> L[i] when A;\n    }\n}\n");
    EXPECT_EQ(edit.obstacle(OperationKind::Paste, "step 1", copy(edit, {"step 1", "step 2"})),
              "the copied steps are not connected; copy steps to which links lead from one of them");
    EXPECT_EQ(edit.document.copied({edit.at("step L")}).obstacle,
              "a step is declared in a repeated declaration (`for`); copy its text");
}

TEST(EditPaste, CopyWithUnknownVariablesIsRejected) {
    Editing edit(lamp);
    EXPECT_EQ(edit.obstacle(OperationKind::Paste, "step 1", "step 7 { HORN; }").substr(0, 40),
              "the change would make the text invalid: ");
}

}  // namespace
}  // namespace grafverif::edit
