// SPDX-License-Identifier: MIT
// Tests `grafverif faults`: text, JSON, fault tree, exit codes and invalid values.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "unit/app/run_program.hpp"

namespace grafverif::app {
namespace {

const std::string head =
    "grafcet lamp_control {\n    input ON, OFF;\n    output LAMP;\n\n    initial step 0;\n    step 1 { LAMP; }\n\n"
    "    transition t0: 0 -> 1 when ON && !OFF;\n    transition t1: 1 -> 0 when OFF;\n}\n\n"
    "component stuck(output OUT; VALUE: bool) {\n    initial location stuck with OUT := VALUE;\n}\n\n"
    "component switch(output OUT; NEVER = false) {\n    clock t;\n\n    initial location switch;\n\n"
    "    timed switch -> switch when t >= 1s && !NEVER do OUT := !OUT, t := 0;\n}\n\n"
    "closed_loop room {\n    controller lamp_control;\n\n"
    "    environment On = switch(OUT = ON);\n    environment Off = switch(OUT = OFF, NEVER = true);\n\n";
const std::string faults =
    "    fault On_held of On: stuck(VALUE = true);\n    fault On_dead of On: stuck(VALUE = false);\n"
    "    fault Off_held of Off: stuck(VALUE = true);\n\n";
const std::string properties =
    "    property never_both \"not both\": never ON && OFF;\n    property lit: reachable X1;\n"
    "    property rare: never X0 && LAMP && OFF at stable;\n}\n";

class FaultsCommand : public testing::Test {
protected:
    Result run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"faults", file_});
        return grafverif(arguments);
    }

    Folder folder_ = {};
    std::string file_ = folder_.write("room.grafcet", head + faults + properties);
};

TEST_F(FaultsCommand, PrintsMinimalCombinationsEffectsAndRuns) {
    const Result result = run({"--order", "2", "--jobs", "1"});
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
    for (const char* const part :
         {"room: 3 faults, 5 combinations of at most 2, ", "never_both  Off_held\n", "lit         On_dead; Off_held\n",
          "rare        none\n", "On_held: On behaves as stuck\n    leads to no violation\n",
          "Off_held: Off behaves as stuck\n    leads to a violation of never_both, lit\n",
          "never true if this fault is present from power-on: LAMP, X1\n", "never_both: violated with Off_held\n",
          "lit: violated with On_dead, present from power-on: On_dead\n"})
        EXPECT_NE(result.out.find(part), std::string::npos) << part << '\n' << result.out;
}

TEST_F(FaultsCommand, JsonHasTheSameResults) {
    const Result result = run({"--order", "2", "--format", "json"});
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json.at("order"), 2);
    EXPECT_EQ(json.at("combinations"), 5);
    EXPECT_EQ(json.at("faults").at(2).at("name"), "Off_held");
    EXPECT_EQ(json.at("faults").at(2).at("violates"), nlohmann::json({"never_both", "lit"}));
    EXPECT_EQ(json.at("faults").at(2).at("line"), 32);
    const auto& cut = json.at("properties").at(0).at("minimal").at(0);
    EXPECT_EQ(cut.at("faults"), nlohmann::json({"Off_held"}));
    EXPECT_EQ(cut.at("from_power_on"), nlohmann::json::array());
    EXPECT_FALSE(cut.at("trace").at("steps").empty());
}

TEST_F(FaultsCommand, WritesAFaultTree) {
    const std::string path = folder_.file("tree.xml");
    EXPECT_EQ(run({"--openpsa", path}).code, ExitCode::Verdict);
    const std::string xml = folder_.read("tree.xml");
    for (const char* const part :
         {"<opsa-mef>\n  <define-fault-tree name=\"room\">\n    <label>room</label>\n"
          "    <!-- only combinations of at most 1 faults -->\n",
          "    <define-gate name=\"lit\">\n      <label>lit</label>\n      <or>\n        <basic-event "
          "name=\"On_dead\"/>\n"
          "        <basic-event name=\"Off_held\"/>\n      </or>\n    </define-gate>\n",
          "    <define-gate name=\"rare\">\n      <label>rare</label>\n      <constant value=\"false\"/>\n    "
          "</define-gate>\n",
          "<define-basic-event name=\"On_held\"><label>On_held: On behaves as stuck</label></define-basic-event>\n"})
        EXPECT_NE(xml.find(part), std::string::npos) << part << '\n' << xml;
}

TEST_F(FaultsCommand, WritesAnHtmlReportWithTheRunsOfTheText) {
    const std::string page = folder_.file("faults.html"), tree = folder_.file("tree.xml");
    const Result result = run({"--order", "2", "--report", page, "--openpsa", tree});
    EXPECT_EQ(result.code, ExitCode::Verdict) << result.err;
    EXPECT_EQ(result.out, run({"--order", "2"}).out);
    const std::string html = folder_.read("faults.html");
    EXPECT_EQ(html.rfind("<!DOCTYPE html>", 0), 0U);
    EXPECT_NE(html.find("data-run=\"never_both: Off_held\""), std::string::npos);
    EXPECT_NE(html.find("2 properties are violated with combinations of at most 2 faults."), std::string::npos);
    EXPECT_NE(folder_.read("tree.xml").find("<opsa-mef>"), std::string::npos);
    EXPECT_EQ(run({"--report", folder_.file("none/faults.html")}).code, ExitCode::Input);
}

TEST_F(FaultsCommand, ExitCodeIsZeroIfNoCombinationViolatesAProperty) {
    const Result result = run({"--order", "2", "--property", "rare"});
    EXPECT_EQ(result.code, ExitCode::Done);
    EXPECT_EQ(result.out.find("no_timelock"), std::string::npos) << result.out;
}

TEST_F(FaultsCommand, ExitCodeIsOneAfterAnUnexpectedViolationWithoutFaults) {
    const auto code = [&](const std::string& property) {
        return grafverif({"faults", folder_.write("lit.grafcet", head + faults + property + "}\n")}).code;
    };
    EXPECT_EQ(code("    property dark expected violated: never LAMP && ON;\n"), ExitCode::Done);
    EXPECT_EQ(code("    property dark: never LAMP && ON;\n"), ExitCode::Verdict);
}

TEST_F(FaultsCommand, OtherCommandsIgnoreFaults) {
    const Result result = grafverif({"check", file_});
    EXPECT_EQ(result.code, ExitCode::Done) << result.out;
    EXPECT_EQ(grafverif({"fmt", "--check", file_}).code, ExitCode::Done);
}

TEST_F(FaultsCommand, RejectsInvalidRequests) {
    const auto expect_error = [](const Result& result, const std::string& message) {
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_EQ(result.out, "");
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    };
    expect_error(run({"--order", "0"}), "`--order 0` is not in 1..8");
    expect_error(run({"--order", "9"}), "`--order 9` is not in 1..8");
    expect_error(run({"--property", "lid"}), "did you mean `lit`?");
    expect_error(
        grafverif({"faults", folder_.write("none.grafcet", head + properties)}),
        "the closed loop `room` declares no fault; write `fault NAME of INSTANCE: COMPONENT(...);` [no-faults]");
    std::string many;
    for (int k = 0; k < 400; ++k)
        many += "    fault f" + std::to_string(k) + " of " + (k % 2 == 0 ? "On" : "Off") + ": stuck(VALUE = true);\n";
    for (int k = 0; k < 400; ++k)
        many += "    environment E" + std::to_string(k) + " = switch(OUT = e" + std::to_string(k) + ");\n    fault g" +
                std::to_string(k) + " of E" + std::to_string(k) + ": stuck(VALUE = true);\n";
    expect_error(grafverif({"faults", folder_.write("many.grafcet", head + many + properties), "--order", "2"}),
                 "have more than 100000 combinations of at most 2");
}

}  // namespace
}  // namespace grafverif::app
