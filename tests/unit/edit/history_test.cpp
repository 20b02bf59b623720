// SPDX-License-Identifier: MIT
#include "edit/history.hpp"

#include <gtest/gtest.h>

namespace grafverif::edit {
namespace {

TEST(EditHistory, DifferenceIsMinimalAndDoesNotDivideCharacters) {
    EXPECT_EQ(difference("abcd", "abXcd"), (TextEdit{2, 2, "X"}));
    EXPECT_EQ(difference("aaa", "aa"), (TextEdit{2, 3, ""}));
    EXPECT_EQ(difference("ab", "ab"), (TextEdit{2, 2, ""}));
    EXPECT_EQ(difference("x\u00e4y", "x\u00e5y"), (TextEdit{1, 3, "\u00e5"})) << "equal first bytes";
    EXPECT_EQ(difference("x\u00e4y", "x\u0164y"), (TextEdit{1, 3, "\u0164"})) << "equal last bytes";
}

TEST(EditHistory, InverseEditsRestoreTheText) {
    const std::string text = "one two three";
    const std::vector<TextEdit> edits = {{0, 3, "1"}, {4, 4, "x"}, {4, 4, "y"}, {7, 13, ""}};
    const std::string after = applied(text, edits);
    EXPECT_EQ(after, "1 xytwo");
    EXPECT_EQ(applied(after, inverse(text, edits)), text);
}

TEST(EditHistory, UndoAndRedoReturnToEveryText) {
    History history("a");
    history.apply({{1, 1, "b"}});
    history.apply({{0, 1, ""}, {2, 2, "c"}});
    EXPECT_EQ(history.text(), "bc");
    history.undo();
    EXPECT_EQ(history.text(), "ab");
    history.undo();
    EXPECT_EQ(history.text(), "a");
    EXPECT_FALSE(history.can_undo());
    history.redo();
    history.redo();
    EXPECT_EQ(history.text(), "bc");
    EXPECT_FALSE(history.can_redo());
    history.undo();
    history.apply({{2, 2, "d"}});
    EXPECT_EQ(history.text(), "abd");
    EXPECT_FALSE(history.can_redo()) << "a new edit discards undone edits";
}

TEST(EditHistory, TypedTextInOneLineIsOneStep) {
    History history("");
    history.apply({{0, 0, "a"}}, true);
    history.apply({{1, 1, "b"}}, true);
    history.apply({{2, 2, "\n"}}, true);
    history.apply({{3, 3, "c"}}, true);
    history.apply({{0, 0, "d"}}, true);
    history.undo();
    EXPECT_EQ(history.text(), "ab\nc") << "at another place";
    history.undo();
    EXPECT_EQ(history.text(), "ab\n");
    history.undo();
    EXPECT_EQ(history.text(), "ab");
    history.undo();
    EXPECT_EQ(history.text(), "");
    history.redo();
    EXPECT_EQ(history.text(), "ab");
    history.apply({{2, 2, "e"}}, true);
    history.undo();
    EXPECT_EQ(history.text(), "ab") << "after an undone step, typing is a new step";
}

}  // namespace
}  // namespace grafverif::edit
