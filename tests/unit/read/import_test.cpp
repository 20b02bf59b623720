// SPDX-License-Identifier: MIT
// Tests charts of other formats: their translation to text, and its equivalence to the original chart.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "fixtures.hpp"
#include "read/formats.hpp"
#include "read/text.hpp"
#include "support/print_model.hpp"
#include "syntax/language/format.hpp"

namespace grafverif {
namespace {

struct Imported {
    std::string text = {}, rendered = {};
};

/// Returns the text of an imported chart. Checks that it is read back as the same model.
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
    std::ostringstream rendered;
    render_text(again.all(), sources, Colour::Plain, rendered);
    result.rendered = rendered.str();
    if (file.broken) return result;
    result.text = formatted(laid_out(file));
    EXPECT_TRUE(model) << result.rendered;
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

TEST(Import, RecognizesFormatsByTheirContent) {
    EXPECT_EQ(format_of("// a chart\ngrafcet g {}"), FileFormat::Grafcet);
    EXPECT_EQ(format_of("\xEF\xBB\xBF  <?xml version='1.0'?><a/>"), FileFormat::Xml);
    EXPECT_EQ(format_of("(* x *) program p"), FileFormat::StructuredText);
    EXPECT_EQ(format_of("/* x */ Function_Block f"), FileFormat::StructuredText);
    EXPECT_EQ(format_of("/* x */ closed_loop w {"), FileFormat::Grafcet);
    EXPECT_EQ(format_of("program drive = \"drive.st\";"), FileFormat::Grafcet);
    EXPECT_EQ(format_of("program // x\n drive= \"drive.st\";"), FileFormat::Grafcet);
    EXPECT_EQ(format_of("program drive\nVAR x : BOOL := TRUE; END_VAR"), FileFormat::StructuredText);
    EXPECT_EQ(format_of("program"), FileFormat::StructuredText);
    EXPECT_EQ(format_of("programme"), FileFormat::Unknown);
    EXPECT_EQ(format_of(""), FileFormat::Unknown);
}

std::string utf16(const std::string& text) {
    std::string wide = "\xFF\xFE";
    for (const char c : text) (wide += c) += '\0';
    return wide;
}

TEST(Import, RecognizesTheFormatOfUtf16Text) {
    EXPECT_EQ(format_of(utf16(" <project/>")), FileFormat::Xml);
    EXPECT_EQ(format_of(utf16("grafcet g {}")), FileFormat::Grafcet);
    EXPECT_EQ(format_of(utf16("PROGRAM p END_PROGRAM").substr(2)), FileFormat::StructuredText);
    EXPECT_EQ(format_of(utf16("")), FileFormat::Unknown);
}

TEST(Import, ReadsTextInUtf16AndLatin1AsItsUtf8) {
    const std::string text = "grafcet g { initial step 0; } // Größe";
    std::string latin =
                    "grafcet g { initial step 0; } // Gr\xF6\xDF"
                    "e",
                wide = utf16("grafcet g { initial step 0; } // Gr");
    wide += std::string("\xF6\0\xDF\0e\0", 6);
    const Imported expected = imported(text);
    EXPECT_EQ(expected.rendered, "");
    EXPECT_EQ(imported(wide).text, expected.text);
    EXPECT_EQ(imported(wide).rendered, "");
    EXPECT_EQ(imported(latin).text, expected.text);
    Sources sources;
    Diagnostics rendered;
    read_any(sources.add({"g.grafcet", latin}), sources, {}, rendered);
    ASSERT_EQ(rendered.all().size(), 1U);
    EXPECT_EQ(rendered.all()[0].code, "read-as-latin");
    EXPECT_NE(imported(latin + " Größe").rendered.find("byte 0xF6 is not UTF-8"), std::string::npos)
        << "the encoding of a mixed text is not guessed";
}

TEST(Import, RejectsUtf16WithHalfACharacter) {
    for (const std::string& text : {std::string("grafcet g { initial step 0; }"), std::string("<project/>")}) {
        const Imported result = imported(utf16(text) + "}");
        EXPECT_NE(result.rendered.find("UTF-16 and ends within a character"), std::string::npos) << result.rendered;
    }
    EXPECT_EQ(imported(utf16("grafcet g { initial step 0; }")).rendered, "");
}

TEST(Import, ImportsTheCompleteMetaModelOfAgrafe) {
    const Imported result = imported(fixtures::agrafe);
    EXPECT_EQ(result.text, fixtures::agrafe_text) << result.rendered;
}

TEST(Import, ImportsInternalVariablesOfContinuousActionsAsOutputs) {
    std::string driven = fixtures::agrafe;
    const std::string output = "name=\"M\" variableDeclarationType=\"output\"";
    driven.replace(driven.find(output), output.size(), "name=\"M\" variableDeclarationType=\"internal\"");
    const std::string edge =
        "<transitions id=\"2\"><term xsi:type=\"t:FallingEdge\"><subterm xsi:type=\"t:Variable\" "
        "variableDeclaration=\"//@variableDeclarationContainer/@variableDeclarations.3\"/>";
    const std::size_t at = driven.find(edge) + edge.size() - 4;
    driven[at] = '1';  // the transition reads M
    const Imported result = imported(driven);
    std::string wanted = fixtures::agrafe_text;
    wanted.replace(wanted.find("fall(G1.X1)"), 11, "fall(M)");
    EXPECT_EQ(result.text, wanted) << result.rendered;
    EXPECT_NE(result.rendered.find("continuous actions assign it; a condition that reads it depends on"),
              std::string::npos)
        << result.rendered;
}

TEST(Import, ImportsVariablesWithoutAKindAsOutputsIfActionsDriveThem) {
    std::string driven = fixtures::agrafe, refused = fixtures::agrafe;
    const std::string kind = " variableDeclarationType=\"output\"";
    driven.erase(driven.find(kind), kind.size());
    EXPECT_EQ(imported(driven).text, fixtures::agrafe_text);
    refused.replace(refused.find(kind), kind.size(), " variableDeclarationType=\"input\"");
    Sources sources;
    Diagnostics diagnostics;
    EXPECT_FALSE(read_text(sources.add({"chart.xml", refused}), sources, {}, diagnostics));
    EXPECT_EQ(diagnostics.errors(), 1U);
    EXPECT_EQ(diagnostics.all().back().code, "not-an-output") << "a declared input remains an input";
}

TEST(Import, CutsNamesSoThatTheirNumbersAndPrefixesFit) {
    const std::string longest(1000, 'n');
    std::string text = fixtures::agrafe;
    for (const char* name : {"name=\"a\"", "name=\"M\"", "name=\"G1\"", "name=\"G2\""})
        text.replace(text.find(name), std::string(name).size(), "name=\"" + longest + '"');
    for (const char* id : {"id=\"1\" initial", "id=\"2\"/>"})
        text.replace(text.find(id), std::string(id).size(), std::string(id).replace(4, 1, longest + id[4]));
    EXPECT_NE(imported(text).text, "") << imported(text).rendered;
}

TEST(Import, ImportsPlcopenWithPrioritiesInTheConditions) {
    const Imported result = imported(fixtures::plcopen);
    EXPECT_EQ(result.text, fixtures::plcopen_text) << result.rendered;
    EXPECT_NE(result.rendered.find("[explicit-priority]"), std::string::npos) << result.rendered;
}

TEST(Import, ImportsTextualChartsWithTheirActionBlocks) {
    const Imported result = imported(fixtures::sfc);
    for (const char* line :
         {"// a press", "step Left { down; lamp := true on activation; }",
          "initial step Wait { lamp := false on activation; }", "horn_limited := true on activation;",
          "horn_pulse := false on event rise(horn_pulse);", "horn if horn_limited && !(3s/horn_limited);",
          "transition both: Wait -> Left, Right when go;", "transition Left, Right -> Wait when done != go;"})
        EXPECT_NE(result.text.find(line), std::string::npos) << line << "\n" << result.text << result.rendered;
    EXPECT_NE(result.rendered.find("R of `lamp`"), std::string::npos) << result.rendered;
}

/// Returns a chart with two steps in PLCopen XML. The condition of its first transition is connected to the element
/// with localId 9, which `network` (XML text) must contain.
std::string connected(const std::string& network) {
    return R"(<project><pou name="p" pouType="program"><interface><inputVars>
<variable name="a"><type><BOOL/></type></variable><variable name="b"><type><BOOL/></type></variable></inputVars>
<localVars><variable name="c"><type><BOOL/></type></variable></localVars></interface>
<body><SFC><step localId="1" name="S1" initialStep="1"><connectionPointIn><connection refLocalId="4"/></connectionPointIn></step>
<transition localId="2"><connectionPointIn><connection refLocalId="1"/></connectionPointIn>
<condition><connectionPointIn><connection refLocalId="9"/></connectionPointIn></condition></transition>
<step localId="3" name="S2"><connectionPointIn><connection refLocalId="2"/></connectionPointIn></step>
<transition localId="4"><connectionPointIn><connection refLocalId="3"/></connectionPointIn>
<condition><inline name=""><ST>b</ST></inline></condition></transition>
<leftPowerRail localId="5"/>
<inVariable localId="6"><expression>a</expression></inVariable>
<inVariable localId="7" negated="1"><expression>b</expression></inVariable>)" +
           network + "</SFC></body></pou></project>";
}

std::string block(const std::string& type, const std::string& first, const std::string& second,
                  const std::string& output) {
    const auto pin = [](const std::string& marks, const char* source) {
        return "<variable " + marks + "><connectionPointIn><connection refLocalId=\"" + source +
               "\"/></connectionPointIn></variable>";
    };
    return "<block localId=\"9\" typeName=\"" + type + "\"><inputVariables>" + pin(first, "6") + pin(second, "7") +
           "</inputVariables><outputVariables><variable " + output + "/></outputVariables></block>";
}

std::string contact(const std::string& marks, const std::string& wire = "<connection refLocalId=\"5\"/>") {
    return "<contact localId=\"9\" " + marks + "><connectionPointIn>" + wire +
           "</connectionPointIn><variable>a</variable></contact>";
}

TEST(Import, KeepsEveryNegationOfANetwork) {
    struct Case {
        std::string network = {}, condition = {};
    };
    const Case cases[] = {
        {block("AND", "", "", ""), "a && !b"},
        {block("and", "negated=\"true\"", "", ""), "!a && !b"},
        {block("OR", "", "negated=\"true\"", "negated=\"1\""), "!(a || !!b)"},
        {block("XOR", "", "negated=\"0\"", "negated=\"false\""), "a != !b"},
        {contact(""), "a"},
        {contact("negated=\"true\""), "!a"},
        {"<inOutVariable localId=\"9\" negatedOut=\"true\"><expression>a</expression></inOutVariable>", "!a"}};
    for (const Case& one : cases) {
        SCOPED_TRACE(one.network);
        const Imported result = imported(connected(one.network));
        EXPECT_NE(result.text.find("S1 -> S2 when " + one.condition + ";"), std::string::npos)
            << result.text << result.rendered;
    }
}

TEST(Import, RejectsNetworksWithMemoryOrMissingWires) {
    struct Case {
        std::string network = {}, message = {};
    };
    const Case cases[] = {{block("AND", "edge=\"rising\"", "", ""), "an edge in the network"},
                          {block("AND", "", "", "storage=\"set\""), "a value stored in the network"},
                          {block("AND", "formalParameter=\"EN\"", "", ""), "with a separate enable condition"},
                          {block("SUB", "", "", ""), "arithmetic with operands that are not integers"},
                          {block("NOT", "", "", ""), "number of inputs of this block"},
                          {contact("edge=\"falling\""), "an edge in the network"},
                          {contact("storage=\"reset\""), "a value stored in the network"},
                          {contact("", ""), "this contact has no connection"},
                          {block("RS", "", "", ""), "the block `RS`"}};
    for (const Case& one : cases) {
        SCOPED_TRACE(one.network);
        const Imported result = imported(connected(one.network));
        EXPECT_EQ(result.text, "");
        EXPECT_NE(result.rendered.find(one.message), std::string::npos) << result.rendered;
    }
}

TEST(Import, OmitsConditionsThatItCannotImportCompletely) {
    const std::string behind_an_edge =
        R"(<contact localId="8" edge="rising"><connectionPointIn><connection refLocalId="5"/></connectionPointIn><variable>b</variable></contact>)" +
        contact("", "<connection refLocalId=\"8\"/>");
    const Imported result = imported(connected(behind_an_edge), true);
    EXPECT_NE(result.text.find("S1 -> S2 when unknown_condition;"), std::string::npos)
        << result.text << result.rendered;
}

TEST(Import, RejectsStatementsUnderQualifiersThatOutliveTheirStep) {
    for (const char* qualifier : {"S", "R", "D, T#1s"}) {
        std::string text = fixtures::sfc;
        text.replace(text.find("horn(P);"), 8, "work(" + std::string(qualifier) + ");");
        text.replace(text.find("END_PROGRAM"), 0, "ACTION work: lamp := go; END_ACTION\n");
        EXPECT_NE(imported(text).rendered.find("a list of statements with the qualifier"), std::string::npos)
            << qualifier;
    }
}

TEST(Import, ReadsOtherEncodings) {
    std::string latin =
        "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<!-- Gr\xFC\xDF"
        "e -->\n" +
        fixtures::agrafe.substr(fixtures::agrafe.find("<g:"));
    EXPECT_FALSE(imported(latin).text.empty());
    EXPECT_EQ(imported(utf16(fixtures::plcopen.substr(fixtures::plcopen.find("<project")))).text,
              fixtures::plcopen_text);
}

TEST(Import, OmitsElementsOnlyOnRequest) {
    std::string text = fixtures::sfc;
    text.replace(text.find(":= go;"), 6, ":= go AND LREAL_TO_BOOL(3.5);");
    EXPECT_NE(imported(text).rendered.find("[cannot-import]"), std::string::npos);
    const Imported lossy = imported(text, true);
    EXPECT_NE(lossy.rendered.find("[left-out]"), std::string::npos);
    EXPECT_NE(lossy.text.find("// omitted: "), std::string::npos);
    EXPECT_NE(lossy.text.find("when unknown_condition"), std::string::npos) << lossy.text;
}

}  // namespace
}  // namespace grafverif
