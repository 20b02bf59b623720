// SPDX-License-Identifier: MIT
// Tests each edit operation: the text before it, and the text after it or the reason for its rejection.
#include <gtest/gtest.h>

#include "editing.hpp"

namespace grafverif::edit {
namespace {

TEST(EditOperations, StepIsAddedAfterStep) {
    Editing edit(lamp);
    edit.perform(OperationKind::StepAfter, "initial step 0");
    EXPECT_EQ(edit.selected.substr(0, 7), "step 3;");
    edit.expect("// dark\n", "// dark\n    step 3;\n")
        .expect("on: 0 -> 1 when ON;  // pressed\n",
                "on: 3 -> 1 when ON;  // pressed\n    transition t4: 0 -> 3 when true;\n");
}

TEST(EditOperations, ConditionOnAStepStaysAfterThisStep) {
    Editing edit(lamp);
    const std::string rejected =
        "transition `t2` reads `X1`, which would no longer be true; add the step after this transition instead";
    EXPECT_EQ(edit.obstacle(OperationKind::StepAfter, "step 1"), rejected);
    EXPECT_EQ(edit.obstacle(OperationKind::StepBefore, "transition t2"), rejected);
    edit.perform(OperationKind::StepAfter, "transition t2");
    edit.expect("// bright\n", "// bright\n    step 3;\n")
        .expect("t2: 1 -> 2 when 3s/X1;\n", "t2: 1 -> 3 when 3s/X1;\n    transition t4: 3 -> 2 when true;\n");
}

TEST(EditOperations, StepIsAddedBeforeStep) {
    Editing edit(lamp);
    edit.perform(OperationKind::StepBefore, "step 2");
    edit.expect("        LAMP if ON;\n    }\n", "        LAMP if ON;\n    }\n    step 3;\n")
        .expect("t2: 1 -> 2 when 3s/X1;\n", "t2: 1 -> 3 when 3s/X1;\n    transition t4: 3 -> 2 when true;\n");
}

TEST(EditOperations, StepIsAddedAfterAndBeforeTransition) {
    Editing edit(lamp);
    edit.perform(OperationKind::StepAfter, "transition on");
    edit.expect("initial step 0;  // dark\n", "initial step 0;  // dark\n    step 3;\n")
        .expect("on: 0 -> 1 when ON;  // pressed\n",
                "on: 0 -> 3 when ON;  // pressed\n    transition t4: 3 -> 1 when true;\n");
    edit.perform(OperationKind::StepBefore, "transition off");
    edit.expect("    }\n\n", "    }\n    step 4;\n\n")
        .expect("off: 2 -> 0 when OFF && !ON;\n",
                "off: 4 -> 0 when OFF && !ON;\n    transition t5: 2 -> 4 when true;\n");
}

TEST(EditOperations, TransitionToNewStepExcludesTheOtherConditions) {
    Editing edit(lamp);
    edit.perform(OperationKind::Transition, "step 2");
    edit.expect("    }\n\n", "    }\n    step 3;\n\n")
        .expect("2 -> 0 when OFF && !ON;\n",
                "2 -> 0 when OFF && !ON;\n    transition t4: 2 -> 3 when !(OFF && !ON);\n");
}

TEST(EditOperations, AlternativeBranchIsUnambiguous) {
    Editing edit(lamp);
    edit.perform(OperationKind::Alternative, "transition on");
    EXPECT_EQ(edit.selected.substr(0, 7), "step 3;");
    edit.expect("// dark\n", "// dark\n    step 3;\n")
        .expect("when ON;  // pressed\n",
                "when ON;  // pressed\n    transition t4: 0 -> 3 when !ON;\n    transition t5: 3 -> 1 when true;\n");
}

TEST(EditOperations, ParallelBranchBeginsAndEndsWithTheStep) {
    Editing edit(lamp);
    edit.perform(OperationKind::Parallel, "step 1");
    edit.expect("// bright\n", "// bright\n    step 3;\n")
        .expect("0 -> 1 when", "0 -> 1, 3 when")
        .expect("1 -> 2 when", "1, 3 -> 2 when");
    edit.perform(OperationKind::Parallel, "initial step 0");
    EXPECT_EQ(edit.selected, "initial step");
    edit.expect("// dark\n", "// dark\n    initial step 4;\n")
        .expect("0 -> 1, 3", "0, 4 -> 1, 3")
        .expect("2 -> 0 when", "2 -> 0, 4 when");
    edit.perform(OperationKind::Parallel, "transition t2");
    edit.expect("    }\n\n", "    }\n    step 5;\n\n")
        .expect("1, 3 -> 2 when", "1, 3 -> 2, 5 when")
        .expect("2 -> 0, 4", "2, 5 -> 0, 4");
}

TEST(EditOperations, ParallelBranchOfALinkedStepIsLinked) {
    Editing edit(
        "grafcet g {\n    input A;\n    initial step 0;\n    enclosing step 1 encloses G;\n    macro step 2 expands "
        "M;\n"
        "    transition a: 0 -> 1 when A;\n    transition b: 1 -> 2 when !A;\n    transition c: 2 -> 0 when A;\n"
        "    partial G { linked step 5; step 6; transition d: 5 -> 6 when A; }\n"
        "    expansion M { entry step 7; exit step 8; transition e: 7 -> 8 when A; }\n}\n");
    edit.perform(OperationKind::Parallel, "linked step 5");
    EXPECT_EQ(edit.selected, "linked step ");
    edit.expect("linked step 5;", "linked step 5; linked step 9;").expect("5 -> 6", "5, 9 -> 6");
    const auto rejected = [](const std::string& step) {
        return "step `" + step + "` is the entry step or the exit step of an expansion; edit the text";
    };
    EXPECT_EQ(edit.obstacle(OperationKind::Parallel, "entry step 7"), rejected("7"));
    EXPECT_EQ(edit.obstacle(OperationKind::Parallel, "transition e"), rejected("8"));
    EXPECT_EQ(edit.obstacle(OperationKind::StepBefore, "entry step 7"), rejected("7"));
    EXPECT_EQ(edit.obstacle(OperationKind::StepAfter, "exit step 8"), rejected("8"));
}

TEST(EditOperations, JumpAddsATransitionOrChangesItsTarget) {
    Editing edit(lamp);
    edit.perform(OperationKind::Jump, "step 1", "", "initial step 0");
    EXPECT_EQ(edit.selected, "transition t");
    edit.expect("when 3s/X1;\n", "when 3s/X1;\n    transition t4: 1 -> 0 when !(3s/X1);\n");
    edit.perform(OperationKind::Jump, "transition off", "", "step 1");
    edit.expect("off: 2 -> 0", "off: 2 -> 1");
}

TEST(EditOperations, JumpIsRejectedWithoutTargetOrWithTheSameTarget) {
    Editing edit(lamp);
    EXPECT_EQ(edit.obstacle(OperationKind::Jump, "step 1"), "the target of a jump must be a step");
    EXPECT_EQ(edit.obstacle(OperationKind::Jump, "step 1", "", "transition on"), "the target of a jump must be a step");
    EXPECT_EQ(edit.obstacle(OperationKind::Jump, "transition on", "", "step 1"),
              "transition `on` already leads to step `1`");
    Editing two(
        "grafcet g { input A; partial P { initial step 0; step 1; transition 0 -> 1 when A; }\n"
        "partial Q { initial step 5; step 6; transition 5 -> 6 when A; } }\n");
    EXPECT_EQ(two.obstacle(OperationKind::Jump, "step 1", "", "step 6"),
              "step `6` belongs to another chart or partial chart");
}

TEST(EditOperations, ActionIsAddedToStepsAndTransitions) {
    Editing edit(lamp);
    edit.perform(OperationKind::Action, "initial step 0", "FAN if ON;");
    edit.expect("initial step 0;", "initial step 0 { FAN if ON; }");
    edit.perform(OperationKind::Action, "step 1", "FAN after 2s");
    edit.expect("step 1 { LAMP; }", "step 1 { LAMP; FAN after 2s; }");
    EXPECT_EQ(edit.obstacle(OperationKind::Action, "step 2", "HEATER"),
              "the change would make the text invalid: unknown variable `HEATER`; declare it or correct the name");
    EXPECT_EQ(edit.obstacle(OperationKind::Action, "step 2", "FAN; } step 9 { LAMP"),
              "`FAN; } step 9 { LAMP` is not one action");
    EXPECT_EQ(edit.obstacle(OperationKind::Action, "step 2", "FAN // off"),
              "`FAN // off` is not one action: the declaration is not terminated; append `;`");
}

TEST(EditOperations, ActionIsAddedInTheLayoutOfTheStep) {
    Editing edit(
        "grafcet g {\n\tinput A;\n\tinternal n: int 0..9;\n\toutput B, C;\n\tinitial step 0 {\n\t\tB;  // first\n\t}\n"
        "\tstep 1 { /* none */ }\n\tstep 2 {}\n\ttransition t: 0 -> 1 when A;\n\ttransition u: 1 -> 2 when A;\n}\n");
    edit.perform(OperationKind::Action, "initial step 0", "C");
    edit.expect("// first\n", "// first\n\t\tC;\n");
    edit.perform(OperationKind::Action, "step 1", "C");
    edit.expect("/* none */ }", "/* none */ C; }");
    edit.perform(OperationKind::Action, "step 2", "C");
    edit.expect("step 2 {}", "step 2 { C; }");
    edit.perform(OperationKind::Action, "transition t", "n := 1");
    edit.perform(OperationKind::Action, "transition t", "n := 2");
    edit.expect("1 when A;", "1 when A do n := 1, n := 2;");
    edit.perform(OperationKind::Delete, "n := 1");
    edit.expect("n := 1, ", "");
    edit.perform(OperationKind::Replace, "n := 2", "n := n + 1");
    edit.expect("n := 2", "n := n + 1");
    edit.perform(OperationKind::Delete, "n := n + 1");
    edit.expect(" do n := n + 1", "");
}

TEST(EditOperations, ConditionsAndActionsAreReplaced) {
    Editing edit(lamp);
    edit.perform(OperationKind::Replace, "transition off", " OFF || 5s/X2 ");
    edit.expect("OFF && !ON", "OFF || 5s/X2");
    edit.perform(OperationKind::Replace, "FAN;  //", "FAN for 1s");
    edit.expect("FAN;  //", "FAN for 1s;  //");
    EXPECT_EQ(edit.obstacle(OperationKind::Replace, "transition on", "ON; step 9"), "`ON; step 9` is not a condition");
    EXPECT_EQ(edit.obstacle(OperationKind::Replace, "transition on", "ON"), "the text would not change");
    EXPECT_LT(edit.obstacle(OperationKind::Replace, "transition on", std::string(100'000, '(')).size(), 500U);
    EXPECT_EQ(edit.obstacle(OperationKind::Replace, "step 1", "ON"),
              "a step has no condition; rename it, or edit one of its actions");
    EXPECT_EQ(edit.obstacle(OperationKind::StepAfter, "FAN for"), "select a step or a transition");
}

TEST(EditOperations, DeletedStepIsReplacedByALink) {
    Editing edit(lamp);
    edit.perform(OperationKind::Delete, "step 2");
    edit.expect("    step 2 {\n        FAN;  // cools\n        LAMP if ON;\n    }\n", "")
        .expect("1 -> 2 when", "1 -> 0 when")
        .expect("    transition off: 2 -> 0 when OFF && !ON;\n", "");
}

TEST(EditOperations, DeletedStepWithSeveralTransitionsAfterItLosesTheTransitionBeforeIt) {
    Editing edit(
        "grafcet g {\n    input A, B;\n    initial step 0;\n    step 1;\n    step 2;\n    step 3;\n"
        "    transition s: 0 -> 1 when A;\n    transition a: 1 -> 2 when A;\n    transition b: 1 -> 3 when B && "
        "!A;\n}\n");
    edit.perform(OperationKind::Delete, "step 1");
    edit.expect("    step 1;\n", "")
        .expect("    transition s: 0 -> 1 when A;\n", "")
        .expect("1 -> 2", "0 -> 2")
        .expect("1 -> 3", "0 -> 3");
    edit.perform(OperationKind::Delete, "step 3");
    edit.expect("    step 3;\n", "").expect("    transition b: 0 -> 3 when B && !A;\n", "");
}

TEST(EditOperations, DeletedParallelBranchIsRemovedFromTheLists) {
    Editing edit(
        "grafcet g { input A; initial step 0; step 1; step 2; step 3; transition s: 0 -> 1, 2 when A; "
        "transition e: 1, 2 -> 3 when A; }\n");
    edit.perform(OperationKind::Delete, "step 1");
    edit.expect(" step 1;", "").expect("1, 2 when", "2 when").expect("1, 2 ->", "2 ->");
}

TEST(EditOperations, DeletionIsRejectedWithItsReason) {
    Editing edit(lamp);
    edit.perform(OperationKind::Replace, "transition off", "OFF && !X1");
    edit.expect("OFF && !ON", "OFF && !X1");
    EXPECT_EQ(edit.obstacle(OperationKind::Delete, "step 1"), "`1` is also used in line 17; change this line first");
    EXPECT_EQ(
        edit.obstacle(OperationKind::Delete, "transition on"),
        "without transition `on`, no transition leads to step `1`; delete the step, or add another transition to it");
    Editing many(
        "grafcet g { input A, B; initial step 0; initial step 1; step 2; step 3; step 4;\n"
        "transition 0 -> 2 when A; transition 1 -> 2 when A; transition 2 -> 3 when B; transition 2 -> 4 when !B; }\n");
    EXPECT_EQ(many.obstacle(OperationKind::Delete, "step 2"),
              "step `2` has several transitions before it and after it, which cannot be reconnected unambiguously; "
              "delete or redirect some of them first");
    Editing counted(
        "grafcet g { input A; internal n: int 0..9; initial step 0; step 1; step 2;\n"
        "transition s: 0 -> 1 when A; transition t: 1 -> 2 when A do n := 1; }\n");
    EXPECT_EQ(counted.obstacle(OperationKind::Delete, "step 1"),
              "transition `t` would be deleted with its actions; move the actions first");
    Editing both("grafcet g { input A; initial step 0; step 1; transition 0 -> 0, 1 when A; }\n");
    EXPECT_EQ(both.obstacle(OperationKind::Delete, "initial step 0"),
              "the transition from 0 to 0, 1 begins and ends at step `0` and at other steps; change the transition "
              "first");
}

TEST(EditOperations, StepIsNotDeletedIfAStepOfAnotherPartialChartTakesItsName) {
    Editing edit(
        "grafcet g {\n    input A, B;\n    partial P {\n        initial step 1;\n        step 2;\n        step 9;\n"
        "        transition p: 1 -> 2 when A;\n        transition q: 2 -> 9 when B;\n"
        "        transition r: 9 -> 1 when 3s/X2;\n    }\n    partial Q {\n        initial step 1;\n        step 2;\n"
        "        transition s: 1 -> 2 when A;\n        transition t: 2 -> 1 when B;\n    }\n}\n");
    EXPECT_EQ(edit.obstacle(OperationKind::Delete, "step 2"), "`2` is also used in line 9; change this line first");
    edit.perform(OperationKind::Delete, "step 9");
    edit.expect("        step 9;\n", "")
        .expect("2 -> 9 when B", "2 -> 1 when B")
        .expect("        transition r: 9 -> 1 when 3s/X2;\n", "");
    edit.perform(OperationKind::Delete, "step 2");
    edit.expect("        step 2;\n", "")
        .expect("1 -> 2 when A", "1 -> 1 when A")
        .expect("        transition q: 2 -> 1 when B;\n", "");
}

TEST(EditOperations, DeletedTransitionAndActionLeaveTheRest) {
    Editing edit(lamp);
    edit.perform(OperationKind::Delete, "transition off");
    edit.expect("    transition off: 2 -> 0 when OFF && !ON;\n", "");
    edit.perform(OperationKind::Delete, "LAMP; }");
    edit.expect("step 1 { LAMP; }", "step 1;");
    edit.perform(OperationKind::Delete, "FAN;  //");
    edit.expect("        FAN;  // cools\n", "");
}

TEST(EditOperations, RenamingChangesEveryUse) {
    Editing edit(std::string(lamp) +
                 "closed_loop house { controller lamp; environment A = push_button(OUT = ON);\n"
                 "environment B = push_button(OUT = OFF); property P: reachable lamp.X1; }\n");
    edit.perform(OperationKind::Rename, "step 1", "bright");
    edit.expect("step 1 {", "step bright {")
        .expect("0 -> 1 when", "0 -> bright when")
        .expect("1 -> 2 when 3s/X1", "bright -> 2 when 3s/Xbright")
        .expect("lamp.X1", "lamp.Xbright");
    edit.perform(OperationKind::Rename, "transition on", "start");
    edit.expect("transition on:", "transition start:");
    EXPECT_EQ(edit.obstacle(OperationKind::Rename, "step bright", "2").substr(0, 28), "`2` has another meaning in t");
    EXPECT_EQ(edit.obstacle(OperationKind::Rename, "step bright", "a b"), "`a b` is not a valid name here");
    EXPECT_EQ(edit.obstacle(OperationKind::Rename, "LAMP; }", "a"), "only steps and transitions can be renamed");
}

TEST(EditOperations, UnnamedTransitionGetsAName) {
    Editing edit(
        "grafcet g { input A; initial step 0; step W1; transition 0 -> W1 when A; transition W1 -> 0 when !A; }\n");
    edit.perform(OperationKind::Rename, "transition W1", "back");
    edit.expect("transition W1 ->", "transition back: W1 ->");
    edit.perform(OperationKind::StepAfter, "step W1");
    edit.expect("step W1;", "step W1; step W2;")
        .expect("back: W1 -> 0 when !A;", "back: W2 -> 0 when !A; transition W1 -> W2 when true;");
}

TEST(EditOperations, SourceAndSinkTransitionsGetSteps) {
    Editing edit(
        "grafcet g {\n    input A;\n    initial step 0;\n    transition s: -> 0 when A;\n    transition e: 0 -> when "
        "A;\n}\n");
    edit.perform(OperationKind::StepAfter, "transition e");
    edit.expect("initial step 0;\n", "initial step 0;\n    step 1;\n")
        .expect("0 -> when A;\n", "0 -> 1 when A;\n    transition t3: 1 -> when true;\n");
    EXPECT_EQ(edit.obstacle(OperationKind::Parallel, "transition t3"),
              "no step follows the transition; add a step after it first");
}

TEST(EditOperations, LineEndsAreKept) {
    Editing edit(
        "grafcet g {\r\n  input A;\r\n  initial step 0;\r\n  step 1;\r\n  transition t: 0 -> 1 when A;\r\n}\r\n");
    edit.perform(OperationKind::StepAfter, "step 1");
    edit.expect("step 1;\r\n", "step 1;\r\n  step 2;\r\n")
        .expect("when A;\r\n", "when A;\r\n  transition t2: 1 -> 2 when true;\r\n");
    edit.perform(OperationKind::Delete, "step 2");
    edit.expect("  step 2;\r\n", "").expect("  transition t2: 1 -> 2 when true;\r\n", "");
}

TEST(EditOperations, CommentsInListsAreKept) {
    Editing edit(
        "grafcet g {\n  input A;\n  initial step 0;\n  step 1;\n  step 2;\n  transition t: 0 -> 1 /* one */, 2 when "
        "A;\n}\n");
    edit.perform(OperationKind::Delete, "step 2");
    edit.expect("  step 2;\n", "").expect("1 /* one */, 2 when", "1 /* one */  when");
    Editing after(
        "grafcet g {\n  input A;\n  initial step 0;\n  step 1;\n  step 2;\n  transition t: 0 -> 1, // one\n    2 when "
        "A;\n}\n");
    after.perform(OperationKind::StepAfter, "transition t");
    after.expect("step 0;\n", "step 0;\n  step 3;\n")
        .expect("0 -> 1, // one\n    2 when A;\n",
                "0 -> 3 when A;\n  transition t2: 3 -> 1, // one\n    2 when true;\n");
    EXPECT_EQ(after.obstacle(OperationKind::Jump, "transition t2", "", "step 1"),
              "transition `t2` leads to several steps, so its target cannot be replaced here; edit the text");
}

TEST(EditOperations, RepeatedDeclarationsAreEditedAsText) {
    Editing edit(
        "grafcet g {\n  input A;\n  initial step 0;\n  for i in 1..2 {\n    step S[i];\n    transition 0 -> S[i] when "
        "A;\n"
        "    transition S[i] -> 0 when !A;\n  }\n}\n");
    EXPECT_EQ(edit.obstacle(OperationKind::StepAfter, "step S"),
              "the element is declared in a repeated declaration (`for`); edit the text");
    EXPECT_EQ(edit.obstacle(OperationKind::Delete, "initial step 0"),
              "step `0` is declared or used in a repeated declaration (`for`); edit the text");
    edit.perform(OperationKind::Replace, "transition 0", "A || X0");
    edit.expect("when A;", "when A || X0;");
}

TEST(EditOperations, IndicesBelongToNames) {
    Editing edit(
        "grafcet g {\n  for i in 1..2 { input S[i]; internal m[i]: int 0..9; }\n  input A;\n  initial step 0;\n  step "
        "1;\n"
        "  for i in 1..2 { step L[i]; transition L[i] -> 0 when S[i]; }\n  transition a: 1 -> 0 when S[1];\n"
        "  transition b: 0 -> 1, L /* [ */ [2] when (A) do m[2] := 1;\n}\n");
    const std::vector<DrawnElement> elements = edit.document.elements(Id<Chart>{0}, "");
    const auto a = std::ranges::find(elements, "a", &DrawnElement::name);
    ASSERT_NE(a, elements.end());
    EXPECT_EQ(a->text, "S[1]");
    edit.perform(OperationKind::Replace, "transition a", "A");
    edit.expect("when S[1]", "when A");
    edit.perform(OperationKind::Delete, "m[2] := 1");
    edit.expect(" do m[2] := 1", "");
    edit.perform(OperationKind::StepAfter, "transition b");
    edit.expect("  initial step 0;\n", "  initial step 0;\n  step 3;\n")
        .expect("0 -> 1, L /* [ */ [2] when (A);\n",
                "0 -> 3 when (A);\n  transition 3 -> 1, L /* [ */ [2] when true;\n");
    edit.perform(OperationKind::Parallel, "step 1");
    edit.expect("  step 1;\n", "  step 1;\n  step 4;\n")
        .expect("1 -> 0 when", "1, 4 -> 0 when")
        .expect("L /* [ */ [2] when", "L /* [ */ [2], 4 when");
}

TEST(EditOperations, TextWithErrorsCanOnlyBeTyped) {
    Editing edit(lamp);
    const std::string broken = edit.document.text() + "grafcet";
    edit.document.type(broken);
    EXPECT_EQ(edit.obstacle(OperationKind::StepAfter, "step 1").substr(0, 46),
              "correct the errors in the text first (line 19:");
    EXPECT_NE(edit.document.drawn(), nullptr) << "the last text without errors remains drawn";
    edit.document.undo();
    edit.perform(OperationKind::Rename, "step 2", "20");
    edit.expect("step 2 {", "step 20 {").expect("1 -> 2", "1 -> 20").expect("2 -> 0", "20 -> 0");
    EXPECT_EQ(edit.document.perform({OperationKind::StepAfter, 3, {}, {}}).obstacle, "the element is not in this text");
}

TEST(EditOperations, ElementsOfTheDrawingHaveTheirText) {
    Editing edit(lamp);
    const std::vector<DrawnElement> elements = edit.document.elements(Id<Chart>{0}, "c0-");
    ASSERT_EQ(elements.size(), 9U);
    EXPECT_EQ(elements[1].id, "c0-step-1");
    EXPECT_EQ(edit.document.text().substr(elements[1].where.begin, 6), "step 1");
    EXPECT_EQ(elements[4].condition, "c0-condition-t2");
    EXPECT_EQ(elements[4].text, "3s/X1");
    EXPECT_EQ(elements[8].text, "LAMP if ON");
}

}  // namespace
}  // namespace grafverif::edit
