// SPDX-License-Identifier: MIT
#include "grafverif/support/source.hpp"

#include <gtest/gtest.h>

namespace grafverif {
namespace {

TEST(Place, CountsLinesAndColumnsFromOne) {
    struct Case {
        std::uint32_t offset, line, column;
    };
    for (const Case& c : {Case{0, 1, 1}, {2, 1, 3}, {3, 2, 1}, {4, 3, 1}, {6, 3, 3}}) {
        SCOPED_TRACE(c.offset);
        const Place found = place("ab\n\ncd", c.offset);
        EXPECT_EQ(found.line, c.line);
        EXPECT_EQ(found.column, c.column);
    }
}

TEST(LineAt, ExcludesTheLineEnd) {
    EXPECT_EQ(line_at("ab\r\ncd\n", 1), "ab");
    EXPECT_EQ(line_at("ab\r\ncd\n", 4), "cd");
    EXPECT_EQ(line_at("ab\r\ncd\n", 7), "");
    EXPECT_EQ(line_at("", 0), "");
    EXPECT_EQ(line_at("ab", 99), "ab");
}

TEST(Span, IsIgnoredInComparisons) { EXPECT_EQ((Span{Id<Source>{0}, 1, 2}), (Span{Id<Source>{3}, 4, 5})); }

}  // namespace
}  // namespace grafverif
