// SPDX-License-Identifier: MIT
#include "support/printable.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "grafverif/support/diagnostic.hpp"
#include "support/json_text.hpp"
#include "support/xml_text.hpp"

namespace grafverif {
namespace {

TEST(Printable, ShowsTerminalControlCharacters) {
    struct Case {
        std::string in, out;
    };
    for (const Case& c :
         {Case{"plain text\tand \xC3\xBC \xE2\x86\x91 \xF0\x9F\x98\x80",
               "plain text\tand \xC3\xBC \xE2\x86\x91 \xF0\x9F\x98\x80"},
          Case{"\x1B[31m", "?[31m"}, Case{std::string("a\0b", 3), "a?b"}, Case{"a\r\nb\x7F", "a??b?"},
          Case{"\xC2\x9B", "?"}, Case{"\xC2\xA0", "\xC2\xA0"},
          Case{"\xE2\x80\xAE\xE2\x81\xA9\xE2\x80\x8E\xD8\x9C", "????"}, Case{"\xFF\xC3", "??"}, Case{"\xC0\xAF", "??"},
          Case{"\xED\xA0\x80", "???"}, Case{"\xF4\x90\x80\x80", "????"}, Case{"\xE2\x80", "??"}, Case{"", ""}}) {
        EXPECT_EQ(printable(c.in), c.out);
        EXPECT_EQ(printable(printable(c.in)), printable(c.in));
    }
    EXPECT_EQ(printable_lines("a\nb\x1B"), "a\nb?");
}

TEST(Printable, JsonAndXmlEscapesAreReversible) {
    const std::string text = "\x1B[0m \xE2\x80\xAE \xC2\x9B \x7F \xC3\xBC";
    const std::string json = json_text({{"text", text}}, -1);
    EXPECT_EQ(printable(json), json);
    EXPECT_EQ(nlohmann::json::parse(json)["text"], text);
    EXPECT_NE(json.find("\xC3\xBC"), std::string::npos) << "harmless characters remain readable";
    EXPECT_EQ(json_text("\xFF", -1), "\"\xEF\xBF\xBD\"");
    const std::string legal = "\xE2\x80\xAE \xC2\x9B \x7F \xC3\xBC";
    std::string xml;
    escape_xml(legal, xml);
    EXPECT_EQ(printable(xml), xml);
    EXPECT_EQ(unescape_xml(xml), legal);
}

TEST(Printable, CutsTextToTheColumnsItMayTake) {
    struct Case {
        std::string text;
        std::size_t columns;
        std::string cut;
    };
    for (const Case& c :
         {Case{"abc", 3, "abc"}, Case{"abcd", 3, "ab…"}, Case{"字字", 4, "字字"}, Case{"字字", 3, "字…"},
          Case{"字字字", 4, "字…"}, Case{"e\xCC\x81xy", 2, "e\xCC\x81…"}, Case{"ab", 1, "…"}})
        EXPECT_EQ(cut_to(c.text, c.columns), c.cut) << c.text;
    EXPECT_EQ(columns_of("e\xCC\x81字"), 3U);
}

TEST(RenderText, PutsCaretsUnderTheColumnsOfATerminal) {
    struct Case {
        std::string before, marked, shown, blanks, carets;
    };
    for (const Case& c :
         {Case{"\x1B[31m", "X12", "?[31mX12", "     ", "^^^"}, Case{"\xFF\x80", "X\x80", "??X?", "  ", "^^"},
          Case{"\xE2\x80\xAE", "\xC3\xBC", "?\xC3\xBC", " ", "^"},
          Case{"\xE6\xBC\xA2", "\xE5\xAD\x97", "\xE6\xBC\xA2\xE5\xAD\x97", "  ", "^^"},
          Case{"e\xCC\x81", "e\xCC\x81",
               "e\xCC\x81"
               "e\xCC\x81",
               " ", "^"},
          Case{"\t\xC3\xBC", "x", "\t\xC3\xBCx", "\t ", "^"}}) {
        SCOPED_TRACE(c.shown);
        Sources sources;
        const Id<Source> file = sources.add({"a\nb\x1B.grafcet", c.before + c.marked});
        const auto begin = static_cast<std::uint32_t>(c.before.size()),
                   end = begin + static_cast<std::uint32_t>(c.marked.size());
        std::ostringstream out;
        render_text({{Severity::Error, "code", {file, begin, end}, "message \x1B"}}, sources, Colour::Plain, out);
        EXPECT_EQ(out.str(), "a?b?.grafcet:1:" + std::to_string(begin + 1) + ": error: message ? [code]\n    " +
                                 c.shown + "\n    " + c.blanks + c.carets + "\n");
    }
}

}  // namespace
}  // namespace grafverif
