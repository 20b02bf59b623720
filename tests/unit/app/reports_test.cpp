// SPDX-License-Identifier: MIT
// Tests reports for build servers: their content, and that no report of an earlier run remains.
#include "app/reports.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

using Json = nlohmann::json;

/// Returns a loop whose property `claim` is violated. Line 5 contains the property, and line 2 declares the step whose
/// activity violates it.
std::string lamp_loop(const std::string& name, const std::string& claim = "never X1") {
    return "grafcet c" + name +
           " {\n    input x; output L; initial step 0; step 1 { L; }\n"
           "    transition t: 0 -> 1 when x; transition u: 1 -> 0 when !x; }\nclosed_loop " +
           name + " { controller c" + name +
           "; environment E = push_button(OUT = x);\n    property p \"a <claim>\": " + claim +
           ";\n    property q: never false; }\n";
}

std::vector<Json> objects_in(const std::string& text) {
    std::vector<Json> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(Json::parse(line));
    return lines;
}

TEST(Reports, OfJunitHaveTheLocationAndTheBeginningOfTheTrace) {
    const Folder folder;
    const std::string file = folder.write("lamp.grafcet", lamp_loop("l"));
    EXPECT_EQ(grafverif({"check", file, "--junit", folder.file("r.xml")}).code, ExitCode::Verdict);
    pugi::xml_document junit;
    ASSERT_TRUE(junit.load_string(folder.read("r.xml").c_str())) << folder.read("r.xml");
    const pugi::xml_node suite = junit.child("testsuites").child("testsuite");
    const pugi::xml_node p = suite.find_child_by_attribute("testcase", "name", "p");
    EXPECT_EQ(p.attribute("file").value(), file);
    EXPECT_EQ(p.attribute("line").as_int(), 5);
    const std::string message = p.child("failure").attribute("message").value();
    EXPECT_TRUE(message.starts_with("violated (" + file + ":5)\n  time  event")) << message;
    EXPECT_NE(std::string(p.child("failure").text().get()).find("t        1"), std::string::npos);
    EXPECT_EQ(suite.find_child_by_attribute("testcase", "name", "q").attribute("line").as_int(), 6);
    EXPECT_EQ(suite.find_child_by_attribute("testcase", "name", "no_timelock").attribute("line").as_int(), 4)
        << "an undeclared result has the position of its loop";
}

TEST(Reports, OfJsonHaveTheLocationOfAProperty) {
    const Folder folder;
    const std::string file = folder.write("lamp.grafcet", lamp_loop("l"));
    const Json p = Json::parse(grafverif({"check", file, "--format", "json"}).out)["properties"][0];
    EXPECT_EQ(p["file"], file);
    EXPECT_EQ(p["line"], 5);
    EXPECT_EQ(p["column"], 14);
}

/// Checks the requirements of the SARIF 2.1.0 schema and of SARIF viewers on the log, and returns its results.
Json checked(const std::string& text) {
    const Json log = Json::parse(text);
    EXPECT_EQ(log["version"], "2.1.0");
    EXPECT_EQ(log["runs"].size(), 1u);
    const Json& run = log["runs"][0];
    const Json& rules = run["tool"]["driver"]["rules"];
    EXPECT_TRUE(run["invocations"][0]["executionSuccessful"].is_boolean());
    const auto expect_place = [](const Json& location) {
        EXPECT_TRUE(location["physicalLocation"]["artifactLocation"]["uri"].is_string()) << location;
        const Json& region = location["physicalLocation"]["region"];
        for (const char* key : {"startLine", "startColumn", "endLine", "endColumn"}) EXPECT_GE(region[key], 1) << key;
    };
    for (const Json& result : run["results"]) {
        EXPECT_EQ(rules.at(result["ruleIndex"].get<std::size_t>())["id"], result["ruleId"]);
        EXPECT_FALSE(result["message"]["text"].get<std::string>().empty());
        EXPECT_EQ(result.value("kind", "fail") == "open", result["level"] == "none")
            << "exactly the open results have the level `none`";
        for (const Json& location : result.value("locations", Json::array())) expect_place(location);
        for (const Json& flow : result.value("codeFlows", Json::array())) {
            const Json& locations = flow["threadFlows"].at(0)["locations"];
            EXPECT_FALSE(locations.empty());
            for (const Json& step : locations) {
                expect_place(step["location"]);
                EXPECT_FALSE(step["location"]["message"]["text"].get<std::string>().empty());
                EXPECT_TRUE(step["importance"] == "important" || step["importance"] == "essential");
            }
        }
    }
    return run["results"];
}

TEST(Reports, OfSarifContainTheCounterexampleAsACodeFlow) {
    const Folder folder;
    const std::string file = folder.write("a lamp.grafcet", lamp_loop("l"));
    EXPECT_EQ(grafverif({"check", file, "--sarif", folder.file("r.sarif")}).code, ExitCode::Verdict);
    const Json results = checked(folder.read("r.sarif"));
    ASSERT_EQ(results.size(), 1u) << "expected verdicts are not reported";
    EXPECT_EQ(results[0]["ruleId"], "property-violated");
    EXPECT_EQ(results[0]["message"]["text"], "l: p \"a <claim>\": violated");
    EXPECT_EQ(results[0]["locations"][0]["physicalLocation"]["region"]["startLine"], 5);
    EXPECT_TRUE(results[0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"].get<std::string>().ends_with(
        "a%20lamp.grafcet"));
    const Json& trace_locations = results[0]["codeFlows"][0]["threadFlows"][0]["locations"];
    const auto line = [&](std::size_t step) {
        return trace_locations.at(step)["location"]["physicalLocation"]["region"]["startLine"];
    };
    const auto location_text = [&](std::size_t step) {
        return trace_locations.at(step)["location"]["message"]["text"].get<std::string>();
    };
    EXPECT_EQ(line(0), 2) << "the initial step";
    EXPECT_TRUE(location_text(0).starts_with("0 s: cl: power on")) << location_text(0);
    std::size_t cleared = 0;
    for (std::size_t step = 0; step < trace_locations.size(); ++step) {
        if (location_text(step).find("cleared t") == std::string::npos) continue;
        ++cleared;
        EXPECT_EQ(line(step), 3) << "the transition";
        EXPECT_EQ(trace_locations[step]["importance"], "essential");
    }
    EXPECT_EQ(cleared, 1u);
}

TEST(Reports, OfSarifIncludeUndecidedAndUnexpectedlyHoldingProperties) {
    const Folder folder;
    std::string text = lamp_loop("l");
    text.replace(text.find("q: never"), 8, "q expected violated: never");
    const std::string file = folder.write("lamp.grafcet", text);
    grafverif({"check", file, "--sarif", folder.file("r.sarif")});
    EXPECT_EQ(checked(folder.read("r.sarif"))[1]["message"]["text"], "l: q: holds, but expected to be violated");
    grafverif({"check", file, "--max-states", "1", "--sarif", folder.file("r.sarif")});
    const Json results = checked(folder.read("r.sarif"));
    ASSERT_FALSE(results.empty());
    EXPECT_EQ(results[0]["kind"], "open");
    EXPECT_EQ(Json::parse(folder.read("r.sarif"))["runs"][0]["invocations"][0]["executionSuccessful"], false);
}

TEST(Reports, OfSeveralFilesAreOne) {
    const Folder folder;
    const std::string one = folder.write("one.grafcet", lamp_loop("first") + lamp_loop("second"));
    const std::string two = folder.write("two.grafcet", lamp_loop("third", "always true")),
                      broken = folder.write("b.grafcet", "grafcet {");
    const Result result = grafverif({"check", one, broken, two, "--all", "--junit", folder.file("r.xml"), "--sarif",
                                     folder.file("r.sarif"), "--json-lines"});
    EXPECT_EQ(result.code, ExitCode::Input);
    pugi::xml_document junit;
    ASSERT_TRUE(junit.load_string(folder.read("r.xml").c_str()));
    std::string suites;
    for (const pugi::xml_node& suite : junit.child("testsuites"))
        suites += std::string(suite.attribute("name").value()) + ";";
    EXPECT_EQ(suites, "first;second;" + broken + ";third;");
    std::string rules;
    for (const Json& each : checked(folder.read("r.sarif"))) rules += each["ruleId"].get<std::string>() + ";";
    EXPECT_EQ(rules, "property-violated;property-violated;unexpected;");
    std::string verdicts;
    for (const Json& line : objects_in(result.out)) {
        verdicts += line["verdict"].get<std::string>() + " ";
        EXPECT_EQ(line["file"], line["model"].is_null() ? broken : line["model"] == "third" ? two : one);
    }
    EXPECT_EQ(verdicts, "violated holds holds violated holds holds error holds holds holds ");
    EXPECT_EQ(objects_in(result.out)[0]["as_expected"], false);
    EXPECT_TRUE(objects_in(result.out)[0]["trace_text"][0].get<std::string>().starts_with("  time  event"));
}

TEST(Reports, OfAnEarlierRunAreRemoved) {
    const Folder folder;
    const std::string file = folder.write("lamp.grafcet", lamp_loop("l"));
    const std::string junit = folder.file("r.xml"), sarif = folder.file("r.sarif"), vcd = folder.file("t.vcd"),
                      svg = folder.file("t.svg");
    const std::vector<std::string> all = {"--junit", junit, "--sarif", sarif, "--trace-vcd", vcd, "--trace-svg", svg};
    const auto run = [&](std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), all.begin(), all.end());
        return grafverif(arguments);
    };
    ASSERT_EQ(run({"check", file}).code, ExitCode::Verdict);
    ASSERT_TRUE(fs::exists(vcd) && fs::exists(svg));
    EXPECT_EQ(run({"check", file, "--property", "q"}).code, ExitCode::Done);
    EXPECT_FALSE(fs::exists(vcd) || fs::exists(svg)) << "there is no counterexample to draw";
    for (const std::string& text :
         {std::string("grafcet {"), std::string("include \"none.grafcet\";"), lamp_loop("l", "never X7")}) {
        SCOPED_TRACE(text);
        folder.write("lamp.grafcet", lamp_loop("l"));
        ASSERT_EQ(run({"check", file}).code, ExitCode::Verdict);
        folder.write("lamp.grafcet", text);
        EXPECT_EQ(run({"check", file}).code, ExitCode::Input);
        EXPECT_FALSE(fs::exists(vcd) || fs::exists(svg));
        pugi::xml_document document;
        ASSERT_TRUE(document.load_string(folder.read("r.xml").c_str()));
        const pugi::xml_node input = document.child("testsuites").child("testsuite").child("testcase");
        EXPECT_STREQ(input.attribute("name").value(), "input");
        EXPECT_EQ(input.attribute("file").value(), file);
        EXPECT_FALSE(input.child("error").empty());
        const Json results = checked(folder.read("r.sarif"));
        ASSERT_FALSE(results.empty());
        EXPECT_EQ(results[0]["level"], "error");
        EXPECT_EQ(Json::parse(folder.read("r.sarif"))["runs"][0]["invocations"][0]["executionSuccessful"], false);
    }
    folder.write("lamp.grafcet", lamp_loop("l"));
    ASSERT_EQ(run({"check", file}).code, ExitCode::Verdict);
    fs::remove(file);
    EXPECT_EQ(run({"check", file}).code, ExitCode::Input) << "the report contains the error of the missing file";
    EXPECT_NE(folder.read("r.xml").find("type=\"cannot-read\""), std::string::npos) << folder.read("r.xml");
    EXPECT_EQ(checked(folder.read("r.sarif"))[0]["ruleId"], "cannot-read");
}

TEST(Reports, OfPagesAndFindingsAreGoneAfterAnError) {
    const Folder folder;
    const std::string file = folder.write("lamp.grafcet", lamp_loop("l"));
    const std::string page = folder.file("page.html"), out = folder.file("out"), sarif = folder.file("f.sarif");
    grafverif({"report", file, "-o", page});
    ASSERT_TRUE(fs::exists(page));
    for (const char* form : {"text", "json"}) {
        grafverif({"analyse", file, "--format", form, "-o", out});
        ASSERT_TRUE(fs::exists(out));
        folder.write("lamp.grafcet", "grafcet {");
        EXPECT_EQ(grafverif({"analyse", file, "--format", form, "-o", out}).code, ExitCode::Input);
        EXPECT_FALSE(fs::exists(out)) << form;
        folder.write("lamp.grafcet", lamp_loop("l"));
    }
    folder.write("lamp.grafcet", "grafcet {");
    EXPECT_EQ(grafverif({"report", file, "-o", page}).code, ExitCode::Input);
    EXPECT_FALSE(fs::exists(page));
    EXPECT_EQ(grafverif({"analyse", file, "--format", "sarif", "-o", sarif}).code, ExitCode::Input);
    EXPECT_EQ(checked(folder.read("f.sarif"))[0]["ruleId"], "unexpected");
}

TEST(Reports, StateThatTheirRunDidNotFinish) {
    const Folder folder;
    const std::string file = folder.write("lamp.grafcet", lamp_loop("l"));
    grafverif({"check", file, "--junit", folder.file("r.xml"), "--sarif", folder.file("r.sarif")});
    Reports reports;
    CommandContext job{.options = {.operands = {file}, .junit = folder.file("r.xml"), .sarif = folder.file("r.sarif")},
                       .reports = &reports};
    begin_reports(false, job);  // no call ends the reports, as if the program were killed
    EXPECT_NE(folder.read("r.xml").find("the command did not complete"), std::string::npos);
    EXPECT_EQ(checked(folder.read("r.sarif")).size(), 0u);
    EXPECT_NE(folder.read("r.sarif").find("the command did not complete"), std::string::npos);
}

TEST(Reports, OverwriteNoOtherFile) {
    const Folder folder;
    const std::string part = lamp_loop("l");
    folder.write("part.grafcet", part);
    folder.write("drawing.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"/>\n");
    const std::string main = folder.write("main.grafcet", "grafcet {\ninclude \"part.grafcet\";");
    for (const char* option : {"--junit", "--sarif", "--trace-svg"}) {
        EXPECT_EQ(grafverif({"check", main, option, folder.file("part.grafcet")}).code, ExitCode::Input);
        EXPECT_EQ(folder.read("part.grafcet"), part) << option << ": it may be an included file";
        EXPECT_EQ(grafverif({"check", folder.file("drawing.svg"), option, folder.file("drawing.svg")}).code,
                  ExitCode::Input);
        EXPECT_TRUE(fs::exists(folder.file("drawing.svg"))) << option << ": an input is not removed";
    }
    folder.write("notes.txt", "mine");
    folder.write("main.grafcet", part);
    EXPECT_EQ(grafverif({"check", main, "--junit", folder.file("notes.txt")}).code, ExitCode::Verdict);
    EXPECT_TRUE(folder.read("notes.txt").starts_with("<?xml")) << "a file that is not an input is overwritten";
}

TEST(List, NamesTheAvailableChecks) {
    const Folder folder;
    const std::string file = folder.write("two.grafcet", lamp_loop("first") + lamp_loop("second"));
    EXPECT_EQ(grafverif({"check", file, "--list"}).out,
              file + "\tfirst\tp\n" + file + "\tfirst\tq\n" + file + "\tsecond\tp\n" + file + "\tsecond\tq\n");
    EXPECT_EQ(grafverif({"check", file, "--list", "--loop", "second", "--property", "q"}).out, file + "\tsecond\tq\n");
    EXPECT_EQ(grafverif({"check", file, "--list", "--loop", "second", "--property", "r"}).code, ExitCode::Input);
    EXPECT_EQ(grafverif({"check", file, "--list", "--junit", "r.xml"}).code, ExitCode::Input);
    const Json listed = Json::parse(grafverif({"check", file, "--list", "--format", "json"}).out);
    ASSERT_EQ(listed.size(), 4u);
    EXPECT_EQ(listed[0]["model"], "first");
    EXPECT_EQ(listed[0]["kind"], "loop");
    EXPECT_EQ(listed[0]["place"]["line"], 5);
    EXPECT_EQ(listed[0]["text"], "a <claim>");
    std::string alone = lamp_loop("l");
    alone.erase(alone.find("closed_loop"));
    EXPECT_EQ(grafverif({"check", folder.write("alone.grafcet", alone), "--list"}).out,
              folder.file("alone.grafcet") + "\tcl\n");
    // Each line of the list describes a property that can be checked separately.
    for (const Json& line : objects_in(grafverif({"check", file, "--list", "--json-lines"}).out)) {
        const Result one =
            grafverif({"check", line["file"], "--loop", line["model"], "--property", line["property"], "--json-lines"});
        EXPECT_EQ(objects_in(one.out)[0]["property"], line["property"]);
    }
}

TEST(All, ProcessesEveryLoopOrWithoutLoopsEveryChart) {
    const Folder folder;
    const std::string two = folder.write("two.grafcet", lamp_loop("first") + lamp_loop("second", "always true"));
    const Result checked = grafverif({"check", two, "--all"});
    EXPECT_EQ(checked.code, ExitCode::Verdict) << "the exit code of the worse result";
    EXPECT_NE(checked.out.find("first: "), std::string::npos);
    EXPECT_NE(checked.out.find("second: "), std::string::npos);
    EXPECT_EQ(grafverif({"check", two}).code, ExitCode::Input);
    EXPECT_EQ(grafverif({"analyse", two, "--all"}).code, ExitCode::Done);
    const std::string library = folder.write(
        "valve.grafcet", "component mine(input A) { initial location here; urgent here -> here when A && !A; }\n");
    EXPECT_EQ(grafverif({"check", library, two, "--all", "--loop", "first"}).code, ExitCode::Input);
    EXPECT_EQ(grafverif({"check", library, "--all"}).code, ExitCode::Done) << "nothing to check";
    EXPECT_EQ(grafverif({"analyse", library, "--all"}).code, ExitCode::Done);
    EXPECT_EQ(grafverif({"check", two, two, "--format", "json"}).code, ExitCode::Input);
    EXPECT_EQ(grafverif({"fmt", two, library}).code, ExitCode::Input);
    EXPECT_EQ(grafverif({"fmt", two, library, "-i"}).code, ExitCode::Done);
    EXPECT_EQ(grafverif({"fmt", two, library, "--check"}).code, ExitCode::Done);
}

}  // namespace
}  // namespace grafverif::app
