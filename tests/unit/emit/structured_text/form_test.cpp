// SPDX-License-Identifier: MIT
// Tests the forms of a controller: the content of the PLCopen XML, the names that it uses, and rejected charts.
#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <sstream>

#include "emit/structured_text/dialects.hpp"
#include "emit/structured_text/structured_text.hpp"
#include "support/play.hpp"
#include "support/run_structured_text.hpp"

namespace grafverif {
namespace {

using structured_text::Form;

std::string controller(std::string_view declarations, Form form, ExecutionMode mode = ExecutionMode::StabilitySearch) {
    std::ostringstream out;
    structured_text::emit(equations(declarations), {mode, 1000, form}, out);
    return std::move(out).str();
}

constexpr std::string_view lamp =
    "input go, level: int 0..7; output L; internal N: int 0..3 = 1; initial step 0; step 1 { L if level < 3; }\n"
    "transition a: 0 -> 1 when go && 3s/X0; transition b: 1 -> 0 when !go;";

std::string names_of_children(const pugi::xml_node& node) {
    std::string names;
    for (const pugi::xml_node child : node.children()) names += std::string(names.empty() ? "" : " ") + child.name();
    return names;
}

TEST(StructuredTextForm, TheXmlHasTheElementsOfTheSchemaInItsOrder) {
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(controller(lamp, Form::PlcopenXml).c_str()));
    const pugi::xml_node project = document.child("project");
    EXPECT_STREQ(project.attribute("xmlns").value(), "http://www.plcopen.org/xml/tc6_0201");
    EXPECT_EQ(names_of_children(project), "fileHeader contentHeader types instances");
    for (const char* attribute : {"companyName", "productName", "productVersion", "creationDateTime"})
        EXPECT_TRUE(project.child("fileHeader").attribute(attribute)) << attribute;
    EXPECT_EQ(names_of_children(project.child("contentHeader").child("coordinateInfo")), "fbd ld sfc");
    EXPECT_EQ(names_of_children(project.child("types")), "dataTypes pous");
    const pugi::xml_node pou = project.child("types").child("pous").child("pou");
    EXPECT_STREQ(pou.attribute("name").value(), "chart");
    EXPECT_STREQ(pou.attribute("pouType").value(), "functionBlock");
    EXPECT_EQ(names_of_children(pou), "interface body");
    EXPECT_EQ(names_of_children(pou.child("interface")), "inputVars outputVars localVars localVars documentation");
    const pugi::xml_node level = pou.child("interface").child("inputVars").find_child_by_attribute("name", "level");
    EXPECT_EQ(names_of_children(level), "type initialValue documentation");
    EXPECT_EQ(names_of_children(level.child("type")), "DINT");
    EXPECT_EQ(names_of_children(pou.child("body").child("ST")), "xhtml");
}

TEST(StructuredTextForm, AChartWithoutOutputsHasNoEmptyBranch) {
    for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle}) {
        const std::string text =
            controller("input go; initial step 0; step 1; transition 0 -> 1 when go;", Form::Text, mode);
        EXPECT_EQ(text.find("FAULT = 0 THEN\n"), std::string::npos) << text;
        SmallPlc plc({text}, "chart");
        plc.set("go", 1);
        plc.call(0);
        EXPECT_EQ(plc.value("FAULT"), 0);
    }
}

TEST(StructuredTextForm, BothFormsAreTheSameProgram) {
    for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle}) {
        SmallPlc text({controller(lamp, Form::Text, mode)}, "chart");
        SmallPlc xml({units_of_plcopen(controller(lamp, Form::PlcopenXml, mode))}, "chart");
        for (SmallPlc* plc : {&text, &xml}) {
            plc->set("go", 1);
            plc->call(0);
            plc->call(3000);
            EXPECT_EQ(plc->value("L"), 1);
            EXPECT_EQ(plc->value("N"), 1);
        }
    }
}

TEST(StructuredTextForm, NamesFollowIecAndAreListedInTheHeader) {
    const std::string text = controller(
        "input step_, END_IF, go; output GO__2, FAULT; initial step 0; step 1 { FAULT; }\n"
        "transition TON: 0 -> 1 when step_ && END_IF && go; step 2 { GO__2; }\n"
        "transition ton: 1 -> 2 when go;",
        Form::Text);
    EXPECT_NE(text.find("(* END_IF is END_IF_2 *)"), std::string::npos) << text;
    EXPECT_NE(text.find("(* step_ is step_0 *)"), std::string::npos) << text;
    EXPECT_NE(text.find("(* GO__2 is GO_2 *)"), std::string::npos) << text;
    EXPECT_NE(text.find("    FAULT_2 : INT := 0;"), std::string::npos) << text;
    SmallPlc plc({text}, "chart");  // this checks that no name is declared twice
    for (const char* input : {"step_0", "END_IF_2", "go"}) plc.set(input, 1);
    plc.call(0);
    EXPECT_EQ(plc.value("GO_2"), 1);
    EXPECT_EQ(plc.value("FAULT"), 0);
    EXPECT_EQ(plc.value("FAULT_2"), 0);
}

TEST(StructuredTextForm, IsTheSameEachTimeAndHasNoLongLines) {
    const std::string text = controller(lamp, Form::PlcopenXml);
    EXPECT_EQ(text, controller(lamp, Form::PlcopenXml));
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 240u) << line;
}

// -- dialects ---------------------------------------------------------------------------------------------------------

using structured_text::Dialect;

std::string in_dialect(std::string_view declarations, Dialect dialect) {
    std::ostringstream out;
    structured_text::emit(equations(declarations), {ExecutionMode::StabilitySearch, 1000, Form::Text, dialect}, out);
    return std::move(out).str();
}

std::string without(std::string text, const std::string& part, const std::string& replacement = "") {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + replacement.size()))
        text.replace(at, part.size(), replacement);
    return text;
}

/// A chart with both timers, a term with cases, and a term with `SEL`.
constexpr std::string_view timed =
    "input go; output L, M: int 0..7; internal N: int 0..3; initial step 0; step 1 { L if 1s/go/2s; M := N + 1 on "
    "activation; M := 2 on deactivation; } transition a: 0 -> 1 when go && 3s/X0; transition b: 1 -> 0 when !go;";

TEST(StructuredTextDialects, SiemensDiffersOnlyInTheRowOfTheTable) {
    const std::string source = in_dialect(timed, Dialect::Siemens);
    EXPECT_NE(source.find("\nFUNCTION_BLOCK \"chart\"\n{ S7_Optimized_Access := 'TRUE' }\nVERSION : 0.1\nVAR_INPUT\n"),
              std::string::npos)
        << source;
    EXPECT_NE(source.find("    T_X0_3s : TON_TIME;\n"), std::string::npos) << source;
    EXPECT_NE(source.find("\nEND_VAR\nBEGIN\nIF #FAULT <> 0 THEN RETURN; END_IF;\n"), std::string::npos) << source;
    EXPECT_NE(source.find("#T_X0_3s(IN := #X_0, PT := T#3s);\n"), std::string::npos) << source;
    EXPECT_NE(source.find("#T_X0_3s_Q := #T_X0_3s.Q;\n"), std::string::npos) << source;
    std::string plain = without(source, "\"chart\"\n{ S7_Optimized_Access := 'TRUE' }\nVERSION : 0.1\n", "chart\n");
    plain = without(without(without(plain, "\nBEGIN\n", "\n\n"), "_TIME;", ";"), "T#", "@");
    plain = without(without(plain, "#"), "@", "T#");
    EXPECT_EQ(plain, in_dialect(timed, Dialect::Iec));
}

TEST(StructuredTextDialects, SelHasNamedArgumentsForSiemens) {
    Exprs exprs;
    const Id<Expr> choice = exprs.conditional(exprs.leaf(Op::Variable, 0), exprs.integer(1), exprs.integer(2));
    const auto name = [](std::ostream& out, const Expr&) { out << "#a"; };
    EXPECT_EQ(expr_text(exprs, choice, structured_text::row_of(Dialect::Siemens).spelling, name),
              "SEL(G := #a, IN0 := 2, IN1 := 1)");
    EXPECT_EQ(expr_text(exprs, choice, structured_text::row_of(Dialect::Codesys).spelling, name), "SEL(#a, 2, 1)");
}

TEST(StructuredTextDialects, TwincatFileContainsDeclarationAndStatements) {
    pugi::xml_document file;
    ASSERT_TRUE(file.load_string(in_dialect(timed, Dialect::Twincat).c_str()));
    const pugi::xml_node pou = file.child("TcPlcObject").child("POU");
    EXPECT_STREQ(pou.attribute("Name").value(), "chart");
    EXPECT_EQ(std::string(pou.attribute("Id").value()).size(), 38U);
    const std::string declaration = pou.child("Declaration").text().get();
    const std::string body = pou.child("Implementation").child("ST").text().get();
    EXPECT_EQ(declaration + "\n" + body + "\nEND_FUNCTION_BLOCK\n", in_dialect(timed, Dialect::Iec));
}

TEST(StructuredTextDialects, EachDialectRenamesItsReservedWords) {
    constexpr std::string_view names =
        "input Pointer, begin, persistent, R, name; output OK; initial step 0 { OK if Pointer; }";
    for (const auto& [dialect, renamed] :
         {std::pair(Dialect::Iec, ""), std::pair(Dialect::Codesys, "Pointer persistent R"),
          std::pair(Dialect::Twincat, "Pointer persistent R"), std::pair(Dialect::Siemens, "Pointer begin OK name")}) {
        const std::string text = in_dialect(names, dialect);
        std::string found;
        for (const std::string name : {"Pointer", "begin", "persistent", "R", "OK", "name"})
            if (text.find(name + " is " + name + "_2") != std::string::npos) found += (found.empty() ? "" : " ") + name;
        EXPECT_EQ(found, renamed) << text;
    }
}

TEST(StructuredTextForm, TermsThatAPlcMayComputeDifferentlyAreRejected) {
    struct Case {
        const char* value;
        const char* reason;
    };
    for (const Case& c : {
             Case{"N / level", "a division by a variable"},
             Case{"N % (level + 1)", "a division by a variable"},
             Case{"N * 30000 * 30000 * 30000", "a value that may need more than 32 bits"},
         }) {
        Diagnostics diagnostics;
        const Equations found = equations(
            "input level: int 1..7; output L; internal N: int 0..7 = 1; initial step 0 { L; }\n"
            "step 1 { N := " +
            std::string(c.value) + " on activation; } transition a: 0 -> 1 when true;");
        EXPECT_FALSE(structured_text::expressible(found, diagnostics));
        ASSERT_FALSE(diagnostics.all().empty());
        EXPECT_TRUE(diagnostics.all()[0].message.starts_with(c.reason)) << diagnostics.all()[0].message;
        EXPECT_TRUE(diagnostics.all()[0].where.source.valid()) << "the diagnostic has no position";
    }
    Diagnostics none;
    EXPECT_TRUE(structured_text::expressible(
        equations("input level: int -7..7; output L; internal N: int -9..9 = 1;\n"
                  "initial step 0 { L; } step 1 { N := level / 2 + N % 3 on activation; }\n"
                  "transition a: 0 -> 1 when true;"),
        none));
}

}  // namespace
}  // namespace grafverif
