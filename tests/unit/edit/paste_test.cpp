// SPDX-License-Identifier: MIT
// Tests copy and paste of steps with their transitions.
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
              "// steps of lamp\nstep 1 { LAMP; }\nstep 2 {\n        FAN;  // cools\n        LAMP if ON;\n    }\n"
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
    EXPECT_EQ(edit.document.copied({}).obstacle, "no step is selected; select or mark the steps");
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
              "the copied steps are not connected; copy a branch in which all steps can be reached from its first "
              "steps");
    EXPECT_EQ(edit.document.copied({edit.at("step L")}).obstacle,
              "a step is declared in a repeated declaration (`for`); copy its text");
}

TEST(EditPaste, StepVariableOfAStepThatIsNotCopiedIsOnlyPastedInTheSameChart) {
    Editing edit(
        "grafcet g {\n    input A;\n    initial step 0;\n    step 1;\n    transition 0 -> 1 when A;\n"
        "    transition 1 -> 0 when !A;\n    partial P {\n        initial step 0;\n        step 1;\n        step 2;\n"
        "        transition a: 0 -> 1 when A;\n        transition b: 1 -> 2 when A && g.X1;\n"
        "        transition c: 2 -> 0 when !X1;\n    }\n}\n");
    const std::string text = copy(edit, {"step 2"});
    EXPECT_EQ(edit.obstacle(OperationKind::Paste, "transition 0", text),
              "the copied text contains `X1`, which may refer to another step here; copy step `1` too, or edit the "
              "text");
    edit.perform(OperationKind::Paste, "transition b", text);
    edit.expect("        step 2;\n", "        step 3;\n        step 2;\n")
        .expect("g.X1;\n",
                "g.X1;\n        transition 1 -> 3 when !(A && g.X1);\n        transition 3 -> 2 when !X1;\n");
}

TEST(EditPaste, QualifiedVariablesOfCopiedStepsAreRenamed) {
    Editing edit(
        "grafcet g {\n    input A;\n    initial step 0;\n    step 5;\n    transition 0 -> 5 when A;\n"
        "    transition 5 -> 0 when g.X5 && P.X5;\n    partial P {\n        initial step 4;\n        step 5;\n"
        "        transition 4 -> 5 when A;\n        transition 5 -> 4 when P.X5 && g.X5;\n    }\n}\n");
    edit.perform(OperationKind::Paste, "transition 4", copy(edit, {"step 5;\n        transition"}));
    edit.perform(OperationKind::Paste, "transition 0", copy(edit, {"step 5;\n    transition"}));
    edit.expect("initial step 4;\n", "initial step 4;\n        step 6;\n")
        .expect("4 -> 5 when A;\n",
                "4 -> 5 when A;\n        transition 4 -> 6 when !A;\n        transition 6 -> 5 when X6 && g.X5;\n")
        .expect("initial step 0;\n", "initial step 0;\n    step 7;\n")
        .expect("0 -> 5 when A;\n",
                "0 -> 5 when A;\n    transition 0 -> 7 when !A;\n    transition 7 -> 5 when X7 && P.X5;\n");
}

TEST(EditPaste, NewStepIsNotTheStepThatACopiedConditionReads) {
    Editing edit(lamp);
    EXPECT_EQ(edit.obstacle(OperationKind::Paste, "transition on",
                            "// steps of lamp\nstep 2;\ntransition 1 -> 2 when ON;\ntransition 2 -> 0 when X3;\n")
                  .substr(0, 40),
              "the change would make the text invalid: ");
}

TEST(EditPaste, PartOfAParallelStructureAndTransitionsInForAreNotCopied) {
    Editing edit(
        "grafcet g {\n    input A;\n    initial step S;\n    step P1;\n    step P2;\n    step M;\n"
        "    transition s: S -> P1, P2 when A;\n    transition t: P1, P2 -> S when A;\n"
        "    transition u: S -> M when !A;\n"
        "    for i in 1..2 {\n        transition M -> S when A;\n    }\n}\n");
    EXPECT_EQ(edit.document.copied({edit.at("step P1")}).obstacle,
              "transition `s` also leads to step `P2`; copy this step too");
    EXPECT_EQ(edit.document.copied({edit.at("initial step S"), edit.at("step M")}).obstacle,
              "step `S` is declared or used in a repeated declaration (`for`); edit the text");
    EXPECT_EQ(edit.document.copied({edit.at("step M")}).obstacle,
              "step `M` is declared or used in a repeated declaration (`for`); edit the text");
    Editing join(
        "grafcet g {\n    input A;\n    initial step S;\n    initial step P2;\n    step Q;\n"
        "    transition t: S, P2 -> Q when A;\n    transition Q -> S, P2 when A;\n}\n");
    EXPECT_EQ(join.document.copied({join.at("initial step S")}).obstacle,
              "transition `t` also begins at step `P2`; copy this step too");
}

TEST(EditPaste, CopiesOfMoreThan1000StepsAreRejected) {
    Editing edit(lamp);
    std::string text;
    for (int k = 0; k <= 1000; ++k) text += "step s" + std::to_string(k) + ";\n";
    EXPECT_EQ(edit.obstacle(OperationKind::Paste, "step 1", text),
              "at most 1000 steps and 2000 transitions can be pasted");
}

TEST(EditPaste, CopyWithUnknownVariablesIsRejected) {
    Editing edit(lamp);
    EXPECT_EQ(edit.obstacle(OperationKind::Paste, "step 1", "step 7 { HORN; }").substr(0, 40),
              "the change would make the text invalid: ");
}

}  // namespace
}  // namespace grafverif::edit
