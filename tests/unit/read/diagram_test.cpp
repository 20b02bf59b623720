// SPDX-License-Identifier: MIT
// Tests ladder diagrams and function block diagrams of PLCopen XML as programs: the order of evaluation, edges,
// latches, calls, and diagnostics of rejected elements.
#include <gtest/gtest.h>

#include <string>

#include "unit/read/program_values.hpp"

namespace grafverif {
namespace {

using Inputs = std::vector<std::vector<std::int64_t>>;

std::string project(const std::string& locals, const std::string& body, const std::string& more = "",
                    const std::string& instances = "") {
    const auto variable = [](const std::string& name) {
        return "<variable name=\"" + name + "\"><type><BOOL/></type></variable>";
    };
    return "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"><types><dataTypes/><pous>" + more +
           "<pou name=\"p\" pouType=\"program\"><interface><inputVars>" + variable("a") + variable("b") +
           "</inputVars><outputVars>" + variable("q") + variable("r") + "</outputVars><localVars>" + locals +
           "</localVars></interface><body>\n" + body + "\n</body></pou></pous></types>" + instances + "</project>";
}

std::string instance(const std::string& name, const std::string& type) {
    return "<variable name=\"" + name + "\"><type><derived name=\"" + type + "\"/></type></variable>";
}

std::string lines(const std::string& sources) {
    std::string text = "<connectionPointIn>";
    for (std::size_t at = 0; at < sources.size();) {
        const std::size_t end = std::min(sources.find(' ', at), sources.size());
        const std::string source = sources.substr(at, end - at);
        const std::size_t point = source.find('.');
        text += "<connection refLocalId=\"" + source.substr(0, point) + "\"";
        if (point != std::string::npos) text += " formalParameter=\"" + source.substr(point + 1) + "\"";
        text += "/>";
        at = end + 1;
    }
    return text + "</connectionPointIn>";
}

std::string element(const std::string& kind, int id, int y, const std::string& sources, const std::string& variable,
                    const std::string& marks = "") {
    const bool contact = kind == "contact" || kind == "coil";
    const std::string tag = contact ? "variable" : "expression";
    return "<" + kind + " localId=\"" + std::to_string(id) + "\" " + marks + "><position x=\"" + std::to_string(id) +
           "\" y=\"" + std::to_string(y) + "\"/>" + (sources.empty() ? "" : lines(sources)) + "<" + tag + ">" +
           variable + "</" + tag + "></" + kind + ">\n";
}

std::string pin(const std::string& name, const std::string& sources, const std::string& marks = "") {
    return "<variable formalParameter=\"" + name + "\" " + marks + ">" + (sources.empty() ? "" : lines(sources)) +
           "</variable>";
}

std::string block(int id, int y, const std::string& type, const std::string& name, const std::string& inputs,
                  const std::string& outputs) {
    return "<block localId=\"" + std::to_string(id) + "\" typeName=\"" + type + "\"" +
           (name.empty() ? "" : " instanceName=\"" + name + "\"") + "><position x=\"" + std::to_string(id) + "\" y=\"" +
           std::to_string(y) + "\"/><inputVariables>" + inputs + "</inputVariables><outputVariables>" + outputs +
           "</outputVariables></block>\n";
}

std::string ladder(const std::string& elements, const std::string& locals = "", const std::string& more = "") {
    return project(locals, "<LD><leftPowerRail localId=\"0\"/>\n" + elements + "</LD>", more);
}

TEST(Diagram, SumsAndProductsHaveAnyNumberOfInputs) {
    const auto text = [](const std::string& type) {
        const std::string n = "<variable name=\"n\"><type><INT/></type></variable>";
        return project(n,
                       "<FBD>" + element("inVariable", 1, 0, "", "5") + element("inVariable", 2, 10, "", "n") +
                           element("inVariable", 3, 20, "", "2") +
                           block(4, 0, type, "", pin("IN1", "1") + pin("IN2", "2") + pin("IN3", "3"), pin("OUT", "")) +
                           element("outVariable", 5, 0, "4", "n") + "</FBD>");
    };
    EXPECT_EQ(values(text("ADD"), "n", {{0, 0}, {0, 0}}), "7 14");
    EXPECT_EQ(values(text("MUL"), "n", {{0, 0}, {0, 0}}), "0 0");
}

TEST(Diagram, ParallelContactsHoldACoil) {
    const std::string text =
        ladder(element("contact", 1, 0, "0", "a") + element("contact", 2, 10, "0", "q") +
               element("contact", 3, 0, "1 2", "b", "negated=\"true\"") + element("coil", 4, 0, "3", "q"));
    EXPECT_EQ(values(text, "q", {{0, 0}, {1, 0}, {0, 0}, {0, 1}, {0, 0}}), "0 1 1 0 0");
}

TEST(Diagram, NetworksAreEvaluatedFromTopToBottom) {
    const auto text = [](int first, int second) {
        return ladder(element("contact", 1, first, "0", "a") + element("coil", 2, first, "1", "q") +
                      element("contact", 3, second, "0", "q") + element("coil", 4, second, "3", "r"));
    };
    EXPECT_EQ(values(text(0, 50), "r", {{0, 0}, {1, 0}, {0, 0}}), "0 1 0");
    EXPECT_EQ(values(text(50, 0), "r", {{0, 0}, {1, 0}, {0, 0}}), "0 0 1") << "the value of q from the previous scan";
}

TEST(Diagram, AnInvalidPositionCountsAsZero) {
    const std::string text = ladder("<contact localId=\"1\"><position x=\"nan\" y=\"nan\"/>" + lines("0") +
                                    "<variable>a</variable></contact>" + element("coil", 2, 0, "1", "q") +
                                    element("contact", 3, 50, "0", "q") + element("coil", 4, 50, "3", "r"));
    EXPECT_EQ(values(text, "r", {{0, 0}, {1, 0}, {0, 0}}), "0 1 0");
}

TEST(Diagram, EdgesAndLatchesKeepTheirState) {
    const std::string edge = ladder(element("contact", 1, 0, "0", "a", "edge=\"rising\"") +
                                    element("coil", 2, 0, "1", "q", "storage=\"set\"") +
                                    element("contact", 3, 50, "0", "b", "edge=\"falling\"") +
                                    element("coil", 4, 50, "3", "q", "storage=\"reset\""));
    EXPECT_EQ(values(edge, "q", {{0, 1}, {1, 1}, {1, 1}, {1, 0}, {1, 0}}), "0 1 1 0 0");
    const std::string coil =
        ladder(element("contact", 1, 0, "0", "a") + element("coil", 2, 0, "1", "q", "edge=\"rising\""));
    EXPECT_EQ(values(coil, "q", {{0, 0}, {1, 0}, {1, 0}}), "0 1 0");
}

TEST(Diagram, ACallPrecedesWhatReadsItsOutputs) {
    const std::string text =
        ladder(element("coil", 1, 0, "2.Q", "q") + block(2, 40, "R_TRIG", "t", pin("CLK", "3"), pin("Q", "")) +
                   element("contact", 3, 40, "0", "a"),
               instance("t", "R_TRIG"));
    EXPECT_EQ(values(text, "q", {{0, 0}, {1, 0}, {1, 0}}), "0 1 0");
}

TEST(Diagram, FeedbackReadsTheLastScan) {
    const std::string own = ladder(
        block(1, 0, "SR", "s", pin("S1", "2") + pin("R", "1.Q1"), pin("Q1", "")) + element("contact", 2, 0, "0", "a"),
        instance("s", "SR"));
    EXPECT_EQ(values(own, "s.Q1", {{0, 0}, {1, 0}, {0, 0}, {1, 0}}), "0 1 0 1");
    const auto cycle = [](const std::string& first, const std::string& second) {
        std::string text =
            ladder("<block executionOrderId=\"" + first + "\"" +
                       block(1, 0, "SR", "s", pin("S1", "3") + pin("R", "2.Q1"), pin("Q1", "")).substr(6) +
                       "<block executionOrderId=\"" + second + "\"" +
                       block(2, 20, "SR", "t", pin("S1", "1.Q1") + pin("R", ""), pin("Q1", "")).substr(6) +
                       element("contact", 3, 0, "0", "a"),
                   instance("s", "SR") + instance("t", "SR"));
        return text;
    };
    const Inputs pulse = {{0, 0}, {1, 0}, {0, 0}, {0, 0}};
    EXPECT_EQ(values(cycle("1", "2"), "t.Q1", pulse), "0 1 1 1");
    EXPECT_EQ(values(cycle("2", "1"), "t.Q1", pulse), "0 0 1 1");
    EXPECT_NE(values(cycle("0", "0"), "t.Q1", pulse).find("not-in-program"), std::string::npos);
}

TEST(Diagram, AnEnableInputSkipsTheCall) {
    const std::string text = ladder(
        element("contact", 1, 0, "0", "b") + element("contact", 2, 10, "0", "a") +
            block(3, 0, "CTU", "c", pin("EN", "1") + pin("CU", "2") + pin("PV", "4"), pin("ENO", "") + pin("Q", "")) +
            element("inVariable", 4, 20, "", "2") + element("coil", 5, 0, "3.ENO", "q"),
        instance("c", "CTU"));
    EXPECT_EQ(values(text, "c.CV", {{1, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 0}}), "0 0 1 1 1");
    EXPECT_EQ(values(text, "q", {{1, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 0}}), "0 1 1 0 0");
}

TEST(Diagram, FunctionsOfTheStandardAndOfTheProject) {
    const std::string function =
        "<pou name=\"both\" pouType=\"function\"><interface><returnType><BOOL/></returnType><inputVars><variable "
        "name=\"x\"><type><BOOL/></type></variable><variable name=\"y\"><type><BOOL/></type></variable></inputVars>"
        "</interface><body><ST><xhtml>both := x AND NOT y;</xhtml></ST></body></pou>";
    const std::string text =
        project("",
                "<FBD>" + element("inVariable", 1, 0, "", "a") + element("inVariable", 2, 10, "", "b") +
                    block(3, 0, "both", "", pin("y", "2") + pin("x", "1"), pin("both", "")) +
                    element("outVariable", 4, 0, "3", "q") +
                    block(5, 50, "SEL", "", pin("G", "1") + pin("IN0", "2") + pin("IN1", "2", "negated=\"true\""),
                          pin("OUT", "")) +
                    element("outVariable", 6, 50, "5", "r") + "</FBD>",
                function);
    EXPECT_EQ(values(text, "q", {{0, 0}, {1, 0}, {0, 1}, {1, 1}}), "0 1 0 0");
    EXPECT_EQ(values(text, "r", {{0, 0}, {1, 0}, {0, 1}, {1, 1}}), "0 1 1 0");
}

TEST(Diagram, AnExecutionOrderReplacesPositions) {
    const auto text = [](const std::string& first, const std::string& second) {
        return project("", "<FBD>" + element("inVariable", 1, 0, "", "a") +
                               element("outVariable", 2, 0, "1", "q", "executionOrderId=\"" + first + "\"") +
                               element("inVariable", 3, 50, "", "q") +
                               element("outVariable", 4, 50, "3", "r", "executionOrderId=\"" + second + "\"") +
                               "</FBD>");
    };
    EXPECT_EQ(values(text("1", "2"), "r", {{0, 0}, {1, 0}, {0, 0}}), "0 1 0");
    EXPECT_EQ(values(text("2", "1"), "r", {{0, 0}, {1, 0}, {0, 0}}), "0 0 1");
    EXPECT_NE(values(text("1", "0"), "r", {}).find("not-in-program"), std::string::npos);
}

TEST(Diagram, TasksHaveDurationsOfBothStandards) {
    for (const std::string interval : {"T#20ms", "PT0.02S", "PT0.020S"}) {
        const ReadProgram read(
            project("", "<ST><xhtml>q := a;</xhtml></ST>", "",
                    "<instances><configurations><configuration name=\"c\"><resource name=\"r\"><task "
                    "name=\"t\" interval=\"" +
                        interval +
                        "\" priority=\"0\"><pouInstance name=\"i\" typeName=\"p\"/></task></resource>"
                        "</configuration></configurations></instances>"));
        ASSERT_TRUE(read.text) << interval << read.codes();
        EXPECT_EQ(read.text->program().interval_ms, 20) << interval;
    }
}

TEST(Diagram, RejectsWhatHasNoDefinedMeaning) {
    const auto codes = [](const std::string& text) { return ReadProgram(text).codes(); };
    const std::string contact = element("contact", 1, 0, "0", "a");
    EXPECT_EQ(codes(ladder(contact + element("coil", 2, 0, "1", "a1") + element("coil", 3, 0, "1", "q"))),
              "4:120 unknown-variable\n");
    EXPECT_NE(codes(ladder(contact + element("contact", 2, 0, "1", "q") + element("coil", 3, 0, "2", "q") +
                           element("coil", 4, 0, "2", "r")))
                  .find("not-in-program"),
              std::string::npos)
        << "the second coil reads q after the first has assigned it";
    EXPECT_NE(codes(ladder(element("contact", 1, 0, "2", "a") + element("contact", 2, 0, "1", "b") +
                           element("coil", 3, 0, "2", "q")))
                  .find("not-in-program"),
              std::string::npos)
        << "a cycle without memory";
    EXPECT_NE(
        codes(ladder(contact + "<jump localId=\"2\" label=\"x\">" + lines("1") + "</jump>")).find("not-in-program"),
        std::string::npos);
    EXPECT_NE(codes(ladder(contact + element("coil", 2, 0, "9", "q"))).find("dangling-reference"), std::string::npos);
    EXPECT_NE(codes(ladder(block(1, 0, "TON", "t", pin("IN", "0"), pin("Q", "")), instance("t", "TOF")))
                  .find("type-mismatch"),
              std::string::npos)
        << "the type differs from the declared type";
    EXPECT_NE(
        codes(project("", "<FBD>" + element("inVariable", 1, 0, "", "a") + element("inOutVariable", 2, 0, "1", "q") +
                              element("outVariable", 3, 0, "2", "r") + "</FBD>"))
            .find("not-in-program"),
        std::string::npos)
        << "the value of q may be that before or after its assignment";
    EXPECT_NE(codes(project("", "<SFC/>")).find("not-in-program"), std::string::npos);
}

}  // namespace
}  // namespace grafverif
