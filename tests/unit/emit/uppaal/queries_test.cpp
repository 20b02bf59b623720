// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <map>
#include <pugixml.hpp>
#include <sstream>

#include "emit/uppaal/uppaal.hpp"
#include "unit/emit/uppaal/hand_networks.hpp"
#include "unit/emit/uppaal/project_text.hpp"

namespace grafverif {
namespace {

struct Query {
    std::string formula = {}, comment = {}, outcome = {};
};

std::string queries_text(const Network& network) {
    std::ostringstream out;
    uppaal::emit_queries(uppaal::lower(network), out);
    return out.str();
}

/// Returns the queries, indexed by the name at the beginning of their comment.
std::map<std::string, Query> queries(const Network& network) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(test::project(network).c_str()));
    std::map<std::string, Query> found;
    for (const pugi::xml_node node : document.child("nta").child("queries").children("query")) {
        const std::string comment = node.child_value("comment"), title = comment.substr(0, comment.find('\n'));
        found[title.substr(0, title.find(':'))] = {node.child_value("formula"), comment,
                                                   node.child("expect").attribute("outcome").value()};
        EXPECT_STREQ(node.child("expect").attribute("type").value(), "symbolic");
    }
    return found;
}

const std::string settled = "(handling.W && stable && !EVOL_PL && !EVOL_TI && !T_X1_3s_P)";

TEST(UppaalQueries, ExpressEachPattern) {
    const std::map<std::string, Query> found = queries(test::station());
    const std::vector<std::pair<std::string, std::string>> cases = {
        {"P1", "A[] not (GO_IN && GO_OUT)"},
        {"P2", "A[] !(GO_IN && GO_OUT) || H_Act.going_out || H_Act.going_in"},
        {"P3", "E<> H_Act.going_out"},
        {"P4", "A<> IS_OUT"},
        {"P5", "!(X_0 && IS_IN) --> X_0 && IS_IN"},
        {"D", "A[] not deadlock"},
        {"S.X0", "E<> X_0"},
        {"S.G2.X1", "E<> X_1"},
        {"E", "A[] X_0 + X_1 == 1"},
        {"U", "A[] COUNT <= 10"},
        {"R", "E<> GO_IN && GO_OUT"},
        {"Q0", "A[] " + settled + " imply ((GO_IN && GO_OUT) || X_0)"},
        {"Q1", "A[] " + settled + " imply not ((GO_IN && GO_OUT) || X_0)"},
        {"Q2", "E<> " + settled + " && ((GO_IN && GO_OUT) || X_0)"},
        {"Q3", "A<> " + settled + " && ((GO_IN && GO_OUT) || X_0)"},
        {"Q4", settled + " && (H_Act.going_out || H_Act.going_in) --> " + settled + " && IS_OUT"},
        {"Q8", "A[] " + settled + " imply X_0 + !X_1 == 1"},
    };
    EXPECT_EQ(found.size(), cases.size());
    for (const auto& [name, formula] : cases) {
        SCOPED_TRACE(name);
        ASSERT_TRUE(found.contains(name));
        EXPECT_EQ(found.at(name).formula, formula);
    }
}

TEST(UppaalQueries, ContainNameTextAndOutcome) {
    const std::map<std::string, Query> found = queries(test::station());
    EXPECT_EQ(found.at("P3").comment, "P3: it moves <at all> & \"well\"\nexpected: satisfied");
    EXPECT_EQ(found.at("P3").outcome, "success");
    EXPECT_EQ(found.at("R").comment, "R: this one fails\nexpected: not satisfied");
    EXPECT_EQ(found.at("R").outcome, "failure");
    EXPECT_EQ(found.at("P1").outcome, "success");
}

TEST(UppaalQueries, HaveNoExpectationForSingleStepsIfSomeStepIsUnreachable) {
    Network network = test::station();
    network.properties[{7}].expected_violated = true;
    ASSERT_EQ(network.properties[{7}].pattern, Pattern::ReachableAllSteps);
    EXPECT_NE(queries_text(network).find("S.X0\n"
                                         "this step can become active; expected for at least one step: not satisfied"),
              std::string::npos);
    EXPECT_EQ(test::project(network).find("<expect", test::project(network).find("S.X0")),
              test::project(network).find("<expect", test::project(network).find("A[] X_0 + X_1")));
}

TEST(UppaalQueries, OmitInexpressiblePropertiesWithAComment) {
    const Network network = uppaal::lower(test::station());
    std::vector<std::string> names;
    for (const auto& [property, reason] : uppaal::inexpressible(network)) {
        names.push_back(network.properties[property].name);
        EXPECT_FALSE(reason.empty());
    }
    EXPECT_EQ(names, (std::vector<std::string>{"T", "A", "C", "L"}));
    const std::string xml = test::project(network);
    const std::size_t place = xml.find("<!-- T: time - - goes on: omitted;");
    EXPECT_LT(xml.find("A[] not deadlock"), place);
    EXPECT_LT(place, xml.find("S.X0"));
    EXPECT_NE(queries_text(network).find("/*\nT: time -- goes on: omitted;"), std::string::npos);
}

// UPPAAL itself cannot read a comment at the end of `queries`.
TEST(UppaalQueries, EndWithAQuery) {
    const std::string xml = test::project(test::station());
    EXPECT_LT(xml.rfind("-->", xml.find("</queries>")), xml.rfind("<query>"));
    Network network = test::station();
    Property only = network.properties[{6}];
    ASSERT_EQ(only.pattern, Pattern::NoTimelock);
    network.properties = {};
    network.properties.add(only);
    EXPECT_EQ(test::project(network).find("<queries>"), std::string::npos);
    EXPECT_NE(test::project(network).find("// Property T is omitted: "), std::string::npos);
}

TEST(UppaalQueries, AreEqualInTheQueryFileAndTheProject) {
    const std::string text = queries_text(test::station());
    for (const auto& [name, query] : queries(test::station())) {
        SCOPED_TRACE(name);
        EXPECT_NE(text.find("/*\n" + query.comment + "\n*/\n" + query.formula + "\n"), std::string::npos);
    }
}

TEST(UppaalQueries, KeepACommentOpenUntilItsEnd) {
    Network network = test::station();
    network.properties[{0}].text = "a */ A[] false /* b";
    EXPECT_NE(queries_text(network).find("/*\nP1: a * / A[] false /* b\nexpected: satisfied\n*/\n"), std::string::npos);
}

}  // namespace
}  // namespace grafverif
