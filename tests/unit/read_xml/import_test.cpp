// SPDX-License-Identifier: MIT
// Charts of other formats: what becomes of them, as text, and that the text is the same chart.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "fixtures.hpp"
#include "grafverif/read/formats.hpp"
#include "grafverif/read/text.hpp"
#include "grafverif/syntax/format.hpp"
#include "grafverif/syntax/print_model.hpp"

namespace grafverif {
namespace {

struct Imported {
    std::string text = {}, said = {};
};

/// The text of what is imported; checks that it reads back as the same model.
Imported imported(const std::string& written, bool lossy = false) {
    Sources sources;
    Diagnostics diagnostics;
    const Id<Source> source = sources.add({"chart.xml", written});
    Imported result;
    const tree::File file = read_any(source, sources, {lossy}, diagnostics);
    Diagnostics again;
    ReadContext context;
    context.lossy = lossy;
    const auto model = read_text(source, sources, context, again);
    std::ostringstream said;
    render_text(again.all(), sources, Colour::Plain, said);
    result.said = said.str();
    if (file.broken) return result;
    result.text = formatted(laid_out(file));
    EXPECT_TRUE(model) << result.said;
    Diagnostics third;
    const auto back = read_text(sources.add({"back.grafcet", result.text}), sources, {}, third);
    EXPECT_TRUE(back) << result.text;
    if (!model || !back) return result;
    std::ostringstream one, other;
    print(one, *model);
    print(other, *back);
    EXPECT_EQ(one.str(), other.str());
    return result;
}

TEST(Import, TellsFormatsFromTheirContent) {
    EXPECT_EQ(format_of("// a chart\ngrafcet g {}"), FileFormat::Grafcet);
    EXPECT_EQ(format_of("\xEF\xBB\xBF  <?xml version='1.0'?><a/>"), FileFormat::Xml);
    EXPECT_EQ(format_of("(* x *) program p"), FileFormat::StructuredText);
    EXPECT_EQ(format_of("/* x */ Function_Block f"), FileFormat::StructuredText);
    EXPECT_EQ(format_of("programme"), FileFormat::Grafcet);
    EXPECT_EQ(format_of(""), FileFormat::Grafcet);
}

TEST(Import, TakesOverTheWholeMetaModelOfAgrafe) {
    const Imported result = imported(fixtures::agrafe);
    EXPECT_EQ(result.text, fixtures::agrafe_text) << result.said;
}

TEST(Import, TakesOverPlcopenWithPrioritiesInTheConditions) {
    const Imported result = imported(fixtures::plcopen);
    EXPECT_EQ(result.text, fixtures::plcopen_text) << result.said;
    EXPECT_NE(result.said.find("[explicit-priority]"), std::string::npos) << result.said;
}

TEST(Import, TakesOverTextualChartsWithTheirActionBlocks) {
    const Imported result = imported(fixtures::sfc);
    for (const char* line : {"// a press", "step Left { down; lamp := true on activation; }", "initial step Wait { lamp := false on activation; }",
                             "horn_limited := true on activation;", "horn_pulse := false on event rise(horn_pulse);",
                             "horn if horn_limited && !(3s/horn_limited);", "transition both: Wait -> Left, Right when go;",
                             "transition Left, Right -> Wait when done != go;"})
        EXPECT_NE(result.text.find(line), std::string::npos) << line << "\n" << result.text << result.said;
    EXPECT_NE(result.said.find("S and R of `lamp`"), std::string::npos) << result.said;
}

TEST(Import, ReadsOtherEncodings) {
    std::string latin = "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<!-- Gr\xFC\xDF" "e -->\n" + fixtures::agrafe.substr(fixtures::agrafe.find("<g:"));
    EXPECT_FALSE(imported(latin).text.empty());
    std::string wide = "\xFF\xFE";
    for (const char c : fixtures::plcopen.substr(fixtures::plcopen.find("<project"))) (wide += c) += '\0';
    EXPECT_EQ(imported(wide).text, fixtures::plcopen_text);
}

TEST(Import, LeavesOutOnlyWhenAskedTo) {
    std::string text = fixtures::sfc;
    text.replace(text.find(":= go;"), 6, ":= go AND LREAL_TO_BOOL(3.5);");
    EXPECT_NE(imported(text).said.find("[cannot-import]"), std::string::npos);
    const Imported lossy = imported(text, true);
    EXPECT_NE(lossy.said.find("[left-out]"), std::string::npos);
    EXPECT_NE(lossy.text.find("// left out: "), std::string::npos);
    EXPECT_NE(lossy.text.find("when unknown_condition"), std::string::npos) << lossy.text;
}

}  // namespace
}  // namespace grafverif
