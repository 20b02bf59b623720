// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <sstream>

#include "emit/uppaal/uppaal.hpp"
#include "unit/emit/uppaal/hand_networks.hpp"
#include "unit/emit/uppaal/project_text.hpp"

namespace grafverif {
namespace {

/// Returns the text of the template called `name` from `tag` on, with entities replaced.
std::string template_text(const std::string& xml, const std::string& name, const char* tag) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(xml.c_str()));
    for (const pugi::xml_node node : document.child("nta").children("template"))
        if (name == node.child_value("name")) return node.child_value(tag);
    return "no template " + name;
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(UppaalProject, BeginsWithItsDocumentType) {
    EXPECT_TRUE(test::project(test::station())
                    .starts_with("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n"
                                 "<!DOCTYPE nta PUBLIC '-//Uppaal Team//DTD Flat System 1.6//EN' "
                                 "'http://www.it.uu.se/research/group/darts/uppaal/flat-1_6.dtd'>\n<nta>\n"));
}

TEST(UppaalProject, DescribesItselfInItsHeader) {
    const std::string xml = test::project(test::station());
    for (const char* line :
         {"// station: the closed loop", "// Controller handling with stability search", "// Grain: phased",
          "// Time unit: 1s.", "// Assumed: a PLC cycle takes no time", "//   push_button.1 is renamed to _1\n"})
        EXPECT_TRUE(holds(xml, line)) << line;
}

TEST(UppaalProject, DeclaresVariablesByRole) {
    const std::string xml = test::project(test::station());
    EXPECT_TRUE(holds(xml,
                      "\n// inputs of the controller\nbool START;\nbool IS_IN = true;\nbool IS_OUT;\n\n"
                      "// outputs of the controller\nbool GO_IN;\n"));
    EXPECT_TRUE(holds(xml, "int[-3,10] COUNT = -3;\nmeta int[-3,10] COUNT_old = -3;\n"));
    EXPECT_TRUE(holds(xml, "urgent broadcast chan hurry;\n"));
}

TEST(UppaalProject, PassesVariablesByReferenceAndConstantsByValue) {
    const std::string xml = test::project(test::station());
    EXPECT_EQ(template_text(xml, "cylinder_5_3", "parameter"),
              "bool &G_IN, bool &G_OUT, int[0,20] &X, const int X_min, const int X_max, const int D_X, const int STEP");
    EXPECT_EQ(template_text(xml, "timer", "parameter"),
              "const int[-32768,60000] D, bool &X, bool &P, bool &Q, bool &EVOL_TI");
    EXPECT_TRUE(holds(template_text(xml, "cylinder_5_3", "declaration"), "// reads G_IN, G_OUT; writes X\nclock t;\n"));
}

TEST(UppaalProject, WritesProceduresAsFunctionsOneAssignmentPerLine) {
    EXPECT_TRUE(holds(template_text(test::project(test::station()), "plc_cycle", "declaration"),
                      "void fire() {\n"
                      "    // firing conditions\n"
                      "    CF_T0 = X_0 && START;\n"
                      "    CF_T1 = X_1 && T_X1_3s_Q && IS_OUT;\n"
                      "    // inputs as sampled in this cycle\n"
                      "    IS_IN_sample = IS_IN;\n"
                      "}\n"));
}

TEST(UppaalProject, WritesAConditionalUpdateAsIf) {
    const std::string text = template_text(test::project(test::station()), "plc_cycle", "declaration");
    EXPECT_TRUE(holds(text, "    if (CF_T0) COUNT = COUNT + 1; else if (CF_T1 && COUNT_old == 9) COUNT = -3;\n"));
    EXPECT_TRUE(holds(text, "    if (CF_T0) LOCK_image = IS_IN_sample;\n"));
}

TEST(UppaalProject, SynchronisesUrgentEdgesAndNoOther) {
    pugi::xml_document document;
    ASSERT_TRUE(document.load_string(test::project(test::station()).c_str()));
    int urgent = 0, timed = 0;
    for (const pugi::xml_node node : document.child("nta").children("template"))
        for (const pugi::xml_node edge : node.children("transition")) {
            const pugi::xml_node label = edge.find_child_by_attribute("kind", "synchronisation");
            ++(label ? urgent : timed);
            EXPECT_TRUE(!label || std::string(label.child_value()) == "hurry!");
        }
    EXPECT_EQ(urgent, 4 + 2 * 2 + 5 + 6);
    EXPECT_EQ(timed, 4 + 1 + 1);
}

TEST(UppaalProject, BracketsADisjunctionBeforeAClock) {
    test::Hand h;
    const auto a = h.boolean("a", Network::Role::Plant), b = h.boolean("b", Network::Role::Plant);
    Network::Template automaton{.name = "t"};
    const auto clock = automaton.clocks.add({"c"});
    automaton.initial = automaton.locations.add({"l", {{clock, Op::LessEqual, h.number(3)}}, {}});
    automaton.edges.add({.from = {0},
                         .to = {0},
                         .guard = h.any({h.v(a), h.v(b)}),
                         .constraint = {{clock, Op::Equal, h.number(3)}},
                         .resets = {clock}});
    h.process("p", h.network.templates.add(std::move(automaton)), {}, Network::ProcessKind::Plant);
    EXPECT_TRUE(holds(test::project(h.network), ">(a || b) &amp;&amp; c == 3<"));
}

TEST(UppaalProject, PutsALongGuardIntoAFunction) {
    const std::string xml = test::project(test::crowded());
    EXPECT_TRUE(holds(template_text(xml, "guarded", "declaration"),
                      "bool guard_1() {\n    return (a_rather_long_name_0 || !a_rather_long_name_5) && "));
    EXPECT_TRUE(holds(xml, ">guard_1()</label>"));
}

TEST(UppaalProject, ListsProcessesByKind) {
    const std::string xml = test::project(test::station());
    EXPECT_TRUE(holds(xml, "<system>// plant\nH_Act = cylinder_5_3(GO_IN, GO_OUT, H, 0, 20, 2, 1);  // STEP = 1s\n"));
    EXPECT_TRUE(holds(xml,
                      "\n// environment\nStart = push_button(START, EVOL_PL);\n\n// controller\nhandling = "
                      "plc_cycle();\n\n// timers\n"));
    EXPECT_TRUE(holds(xml, "\nsystem H_Act, H_In, H_Out, Start, handling, T_X1_3s;\n"));
}

TEST(UppaalProject, KeepsLocalNamesFromHidingGlobals) {
    const std::string xml = test::project(test::awkward_names());
    // The guard of an edge of this process reads the global W.
    EXPECT_TRUE(holds(xml, "//   process.W is renamed to W_\n"));
    EXPECT_TRUE(holds(xml, ">W</label>"));
    EXPECT_TRUE(holds(xml, "urgent broadcast chan hurry_;"));
}

TEST(UppaalProject, KeepsALegalisedLocalNameFromHidingAGlobalToo) {
    for (const char* name : {"_2", "init_", "guard_1", "hurry"}) {
        const std::string global = name;
        SCOPED_TRACE(global);
        test::Hand h;
        const auto read = h.boolean(global, Network::Role::Plant), written = h.boolean("w", Network::Role::Plant);
        Network::Template automaton{.name = "t"};
        automaton.initial = automaton.locations.add({"2", {}, {}});
        automaton.locations.add({"init", {}, {}});
        std::vector<Id<Expr>> terms = {h.v(read)};
        for (int i = 0; i < 20; ++i)
            terms.push_back(h.v(h.boolean("a_long_name_" + std::to_string(i), Network::Role::Plant)));
        automaton.edges.add({.from = {0},
                             .to = {1},
                             .guard = h.network.exprs.disjunction(terms),
                             .assignments = {{h.v(written), h.v(read)}}});
        h.process("p", h.network.templates.add(std::move(automaton)), {}, Network::ProcessKind::Plant);
        const std::string xml = test::project(h.network);
        EXPECT_TRUE(holds(xml, "bool " + global + ";\n"));
        EXPECT_TRUE(holds(xml, ">w = " + global + "</label>"));
        for (const std::string& declared : {">" + global + "</name>", "bool " + global + "()", "chan " + global + ";"})
            EXPECT_FALSE(holds(xml, declared)) << declared;
    }
}

TEST(UppaalProject, IsWellFormedForAnyText) {
    Network network = test::station();
    network.properties[{0}].text =
        std::string("tab\t, <&>, \x01, broken \xC3, \xED\xA0\x80, fine \xE2\x86\x91 ") + '\0' + ".";
    network.properties[{6}].text = "--->";
    pugi::xml_document document;
    const std::string xml = test::project(network);
    ASSERT_TRUE(document.load_string(xml.c_str()));
    EXPECT_TRUE(holds(xml, "tab\t, &lt;&amp;&gt;, ?, broken ?, ???, fine \xE2\x86\x91 ?.\n"));
    EXPECT_TRUE(holds(xml, "<!-- T: - - ->: omitted"));
}

TEST(UppaalProject, IsTheSameEveryTime) { EXPECT_EQ(test::project(test::station()), test::project(test::station())); }

}  // namespace
}  // namespace grafverif
