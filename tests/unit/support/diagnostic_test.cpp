// SPDX-License-Identifier: MIT
#include "grafverif/support/diagnostic.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "support/render.hpp"
#include "support/text/documentation.hpp"

namespace grafverif {
namespace {

Sources one(std::string text) {
    Sources sources;
    sources.add({"press.grafcet", std::move(text)});
    return sources;
}

Diagnostic error_at(std::uint32_t begin, std::uint32_t end) {
    return {Severity::Error, "unknown-step", {Id<Source>{0}, begin, end}, "unknown step `X12`; did you mean `X2`?"};
}

std::string text(const std::vector<Diagnostic>& diagnostics, const Sources& sources, Colour colour = Colour::Plain) {
    std::ostringstream out;
    render_text(diagnostics, sources, colour, out);
    return out.str();
}

TEST(RenderText, ShowsPlaceMessageCodeLineAndCarets) {
    const Sources sources = one("grafcet a {\n    transition t3: X12 -> 20;\n}\n");
    EXPECT_EQ(text({error_at(31, 34)}, sources),
              "press.grafcet:2:20: error: unknown step `X12`; did you mean `X2`? [unknown-step]\n"
              "        transition t3: X12 -> 20;\n"
              "                       ^^^\n");
}

TEST(RenderText, KeepsTabsUnderTheCaretAndCountsCharactersNotBytes) {
    EXPECT_EQ(text({error_at(4, 5)}, one("\té x")),
              "press.grafcet:1:5: error: unknown step `X12`; did you mean `X2`? [unknown-step]\n"
              "    \té x\n"
              "    \t  ^\n");
}

TEST(RenderText, ClipsAVeryLongLine) {
    const auto shown = [](std::size_t before, std::size_t after) {
        std::string line;
        while (line.size() < before) line += "字é ";
        const auto column = static_cast<std::uint32_t>(line.size());
        const std::string rest(after, 'z');
        const std::string text = grafverif::text({error_at(column, column + 3)}, one(line + "bad" + rest));
        return text.substr(text.find('\n'));
    };
    EXPECT_EQ(shown(1200, 600), shown(60'000, 60'000));
    EXPECT_NE(shown(60'000, 0), shown(60'000, 60'000)) << "no text after the mark is omitted";
}

TEST(RenderText, ClipsALongLineAroundItsCaret) {
    const std::string shown = text({error_at(5000, 5003)}, one(std::string(10000, 'a')));
    std::istringstream lines(shown);
    std::string message, line, carets;
    std::getline(lines, message);
    std::getline(lines, line);
    std::getline(lines, carets);
    EXPECT_LT(line.size(), 120u);
    EXPECT_TRUE(line.starts_with("    …")) << line;
    EXPECT_TRUE(line.ends_with("…")) << line;
    EXPECT_EQ(carets.size() - carets.find('^'), 3u);
    EXPECT_LT(carets.size(), line.size());
}

TEST(RenderText, MarksOnePlaceAtTheEndOfTheFile) {
    EXPECT_EQ(text({error_at(3, 3)}, one("abc")),
              "press.grafcet:1:4: error: unknown step `X12`; did you mean `X2`? [unknown-step]\n    abc\n       ^\n");
}

TEST(RenderText, ShowsUnprintableBytesAsQuestionMarks) {
    EXPECT_NE(text({error_at(0, 1)}, one(std::string("\x01\x1b[31m", 6))).find("    ??[31m\n"), std::string::npos);
}

TEST(RenderText, ShowsInvalidUtf8AsQuestionMarks) {
    EXPECT_NE(text({error_at(0, 1)}, one("\xff\xc3\xa9\xc3")).find("    ?\xc3\xa9?\n"), std::string::npos);
}

TEST(RenderText, FitsTheLineIntoTheTerminalAroundTheMarkedPart) {
    struct Case {
        std::string before, marked, after;
        std::size_t columns;
        std::string shown, marks;
    };
    const std::string many(60, 'b');
    for (const Case& c : {
             Case{"ab", "X", "cd", 24, "abXcd", "  ^"},
             Case{"ab", "X", std::string(17, 'c'), 24, "abX" + std::string(17, 'c'), "  ^"},
             Case{"ab", "X", std::string(18, 'c'), 24, "abX" + std::string(16, 'c') + "…", "  ^"},
             Case{many, "X", "", 24, "…" + std::string(10, 'b') + "X", std::string(11, ' ') + "^"},
             Case{many, "X", std::string(8, 'c'), 24, "…bbbbbbbbbbX" + std::string(8, 'c'), std::string(11, ' ') + "^"},
             Case{many, "X", many, 24, "…bbbbbbbbbbX" + std::string(7, 'b') + "…", std::string(11, ' ') + "^"},
             Case{many, "XXXXXXXXXX", many, 24, "…bbbbbbbbbbXXXXXXXX…", std::string(11, ' ') + "^^^^^^^^"},
             Case{many, "X", many, 3, "…bbbbbbbbbbX" + std::string(7, 'b') + "…", std::string(11, ' ') + "^"},
             // Each character has two columns. Of the 40 columns before the mark, ten columns are shown; a character
             // that does not fit completely is removed.
             Case{"字字字字字字字字字字字字字字字字字字字字", "字", "x字字字字字", 24, "…字字字字字字x字字…",
                  "           ^^"},
             Case{"字字字字字字字字字字字字字字字字字字字字", "X", "", 24, "…字字字字字X", "           ^"},
             // A combining character is removed together with its base.
             Case{std::string(40, 'b') + "e\xCC\x81" + std::string(9, 'b'), "X", "", 24,
                  "…e\xCC\x81" + std::string(9, 'b') + "X", std::string(11, ' ') + "^"},
             Case{std::string(40, 'b') + "e\xCC\x81" + std::string(10, 'b'), "X", "", 24,
                  "…" + std::string(10, 'b') + "X", std::string(11, ' ') + "^"},
             Case{"\t", "X", std::string(30, 'c'), 24, "\tX" + std::string(14, 'c') + "…", "\t^"},
             Case{"\t\t\t\t", "X", "", 28, "…\tX", " \t^"},
         }) {
        SCOPED_TRACE(c.shown);
        std::ostringstream out;
        const auto begin = static_cast<std::uint32_t>(c.before.size());
        const Diagnostic error = error_at(begin, begin + static_cast<std::uint32_t>(c.marked.size()));
        render_text({error}, one(c.before + c.marked + c.after), Colour::Plain, c.columns, out);
        const std::string lines = out.str().substr(out.str().find('\n') + 1);
        EXPECT_EQ(lines, "    " + c.shown + "\n    " + c.marks + "\n");
    }
}

TEST(RenderText, OrdersByPlaceAndKeepsNotesWithTheirError) {
    const Sources sources = one("a\nb\n");
    Diagnostic second = error_at(2, 3);
    second.notes.push_back({Severity::Note, "", {Id<Source>{0}, 0, 1}, "first declared here", {}});
    const std::string shown = text({second, error_at(0, 1)}, sources);
    EXPECT_LT(shown.find(":1:1: error"), shown.find(":2:1: error"));
    EXPECT_LT(shown.find(":2:1: error"), shown.find(":1:1: note: first declared here"));
}

TEST(RenderText, ColoursOnlyOnRequest) {
    const Sources sources = one("abc");
    EXPECT_EQ(text({error_at(0, 1)}, sources).find('\x1b'), std::string::npos);
    EXPECT_NE(text({error_at(0, 1)}, sources, Colour::Ansi).find("\x1b[1;31merror"), std::string::npos);
}

TEST(RenderJson, GivesLinesAndColumnsAndSurvivesInvalidUtf8) {
    Diagnostic broken = error_at(2, 3);
    broken.message = "bad byte \xff";
    std::ostringstream out;
    render_json({broken}, one("a\nb\n"), out);
    const auto parsed = nlohmann::json::parse(out.str());
    ASSERT_EQ(parsed.size(), 1u);
    EXPECT_EQ(parsed[0]["file"], "press.grafcet");
    EXPECT_EQ(parsed[0]["line"], 2);
    EXPECT_EQ(parsed[0]["column"], 1);
    EXPECT_EQ(parsed[0]["end_column"], 2);
    EXPECT_EQ(parsed[0]["severity"], "error");
}

TEST(Diagnostics, StoresABoundedNumberAndCountsAll) {
    Diagnostics diagnostics;
    EXPECT_FALSE(diagnostics.has_errors());
    for (std::uint32_t i = 0; i < 1000; ++i) diagnostics.add(error_at(i, i + 1));
    EXPECT_EQ(diagnostics.errors(), 1000u);
    EXPECT_EQ(diagnostics.all().size(), Diagnostics::limit);
    EXPECT_TRUE(diagnostics.full());
}

TEST(Diagnostics, AreFullAfterManyRepetitions) {
    Diagnostics diagnostics;
    for (std::size_t i = 0; i < 20 * Diagnostics::limit; ++i) diagnostics.add(error_at(0, 1));
    EXPECT_EQ(diagnostics.distinct_errors(), 1u);
    EXPECT_FALSE(diagnostics.full());
    diagnostics.add(error_at(0, 1));
    EXPECT_TRUE(diagnostics.full());
}

TEST(Diagnostics, StoresAnErrorOfSeveralCopiesOnce) {
    Diagnostics diagnostics;
    const auto in_copy = [](const char* values) {
        return [values] {
            Diagnostic note = error_at(5, 6);
            note.message = values;
            return note;
        };
    };
    diagnostics.add(error_at(0, 1));
    diagnostics.add(error_at(0, 1));
    diagnostics.set_context(in_copy("i = 1"));
    diagnostics.add(error_at(2, 3));
    Diagnostic other = error_at(2, 3);
    other.message = "another one of the same copy";
    diagnostics.add(other);
    EXPECT_EQ(diagnostics.set_context(in_copy("i = 2"))().message, "i = 1");
    other.message = "the same one of another copy";
    diagnostics.add(other);
    diagnostics.set_context({});
    EXPECT_EQ(diagnostics.errors(), 5u);
    EXPECT_EQ(diagnostics.distinct_errors(), 3u);
    ASSERT_EQ(diagnostics.all().size(), 3u);
    EXPECT_TRUE(diagnostics.all()[0].notes.empty());
    EXPECT_EQ(diagnostics.all()[2].notes[0].message, "i = 1");
}

TEST(Diagnostics, HaveAPageIfTheSiteIsPublished) {
    const std::string page = "https://example.org/docs/reference/diagnostics.html#unknown-step";
    EXPECT_EQ(diagnostic_page("unknown-step", "https://example.org/docs"), page);
    EXPECT_EQ(diagnostic_page("unknown-step", "https://example.org/docs/"), page);
    EXPECT_EQ(diagnostic_page("unknown-step", ""), "");
    EXPECT_EQ(diagnostic_page("", "https://example.org/docs"), "");
}

TEST(Documentation, LinksACodeOnTheTerminalIfTheSiteIsPublished) {
    EXPECT_EQ(
        terminal_link("unknown-step", "https://example.org/docs"),
        "\x1b]8;;https://example.org/docs/reference/diagnostics.html#unknown-step\x1b\\unknown-step\x1b]8;;\x1b\\");
    EXPECT_EQ(terminal_link("unknown-step", ""), "unknown-step");
}

}  // namespace
}  // namespace grafverif
