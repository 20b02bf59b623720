// SPDX-License-Identifier: MIT
#include "report/junit.hpp"

#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <string>

#include "traces.hpp"

namespace grafverif {
namespace {

struct Read {
    pugi::xml_document document = {};
    pugi::xml_node suite = {};
};

void read(const Report& report, Read& result) {
    const Sources sources;
    const Model model;
    const std::string text = junit_document(junit_suite(report, {sources, model, {}, {}}));
    const auto parsed = result.document.load_string(text.c_str());
    ASSERT_TRUE(parsed) << parsed.description() << '\n' << text;
    result.suite = result.document.child("testsuites").child("testsuite");
}

pugi::xml_node test_case(const Read& result, const char* name) {
    return result.suite.find_child_by_attribute("testcase", "name", name);
}

TEST(Junit, HasATestCasePerPropertyAndCountsThem) {
    Read result;
    read(sample_report(), result);
    EXPECT_STREQ(result.suite.attribute("name").value(), "station");
    EXPECT_EQ(result.suite.attribute("tests").as_int(), 6);
    EXPECT_EQ(result.suite.attribute("failures").as_int(), 1);
    EXPECT_EQ(result.suite.attribute("errors").as_int(), 1);
    EXPECT_EQ(result.suite.attribute("skipped").as_int(), 1);
    for (const char* element : {"failure", "error", "skipped"}) {
        int count = 0;
        for (const pugi::xml_node each : result.suite.children("testcase")) count += !each.child(element).empty();
        EXPECT_EQ(count, 1) << element;
    }
}

TEST(Junit, PutsTheTraceIntoTheFailure) {
    Read result;
    read(sample_report(), result);
    const pugi::xml_node failure = test_case(result, "P2").child("failure");
    EXPECT_TRUE(std::string(failure.attribute("message").value()).starts_with("violated\n   time  event"))
        << failure.attribute("message").value();
    EXPECT_TRUE(std::string(failure.attribute("message").value()).ends_with("\n..."));
    EXPECT_NE(std::string(failure.text().get()).find("repeated forever from here"), std::string::npos);
    EXPECT_STREQ(test_case(result, "P2").child("system-out").text().get(), "a <dangerous> & \"quoted\" text");
    EXPECT_TRUE(test_case(result, "P4").child("failure").empty()) << "violated as expected";
    EXPECT_STREQ(test_case(result, "P3").child("error").attribute("message").value(),
                 "unknown: 12 states are not enough");
}

TEST(Junit, CountsABreakdownAsAFailure) {
    Report report = sample_report();
    report.error_traces = {{"out-of-range", "`X` would leave \"its\" range\x01", sample_run()}};
    Read result;
    read(report, result);
    EXPECT_EQ(result.suite.attribute("failures").as_int(), 2);
    EXPECT_TRUE(std::string(test_case(result, "out-of-range").child("failure").attribute("message").value())
                    .starts_with("`X` would leave \"its\" range\uFFFD"));
}

}  // namespace
}  // namespace grafverif
