// SPDX-License-Identifier: MIT
// Tests `test --against` with controllers that conform, that do not conform, and that do not respond.
#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "run_program.hpp"

namespace grafverif::app {
namespace {

using Json = nlohmann::json;

const std::string tanks_chart = (root / "samples/tanks/tanks.grafcet").string();
const std::string table2 = (root / "samples/tanks/table2.csv").string();
const std::string this_program = GRAFVERIF_PROGRAM;

/// Runs the sequence of JESA13 section 6, Table 2, against `controller`.
Result tested(const std::string& controller, std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"test", tanks_chart, "--sequence", table2, "--against", controller});
    return grafverif(options);
}

/// Returns a controller with correct responses, except that it executes `what` instead of printing the second response.
std::string faulty(const std::string& what) {
    return "read x; echo 0,0,0,0; read x; " + what + "; read x; echo 0,0,1,1";
}

std::vector<std::string> verdicts(const Json& report) {
    std::vector<std::string> words;
    for (const Json& step : report["steps"]) words.push_back(step["verdict"]);
    return words;
}

TEST(TestCommand, PassesAControllerWithStabilitySearch) {
    const Result result = tested(this_program + " plc " + tanks_chart + " --mode stability-search");
    EXPECT_EQ(result.code, ExitCode::Done) << result.out << result.err;
    EXPECT_TRUE(result.out.ends_with("passes the complete test: 3 passed, 0 failed, 0 not run\n")) << result.out;
}

TEST(TestCommand, FailsAControllerWithoutStabilitySearchAtTheSecondStep) {
    const Result result = tested(this_program + " plc " + tanks_chart + " --mode every-cycle", {"--format", "json"});
    EXPECT_EQ(result.code, ExitCode::Verdict);
    const Json report = Json::parse(result.out);
    EXPECT_EQ(report["verdict"], "failed");
    EXPECT_EQ(verdicts(report), (std::vector<std::string>{"passed", "failed", "not run"}));
    const Json failure = report["steps"][1]["failure"];
    EXPECT_EQ(failure["cause"], "different");
    EXPECT_EQ(failure["answered"], (Json{{"V1", true}, {"V2", true}, {"W1", false}, {"W2", false}}));
    EXPECT_EQ(report["steps"][1]["expected"], (Json{{"V1", false}, {"V2", true}, {"W1", true}, {"W2", false}}));
}

TEST(TestCommand, GivesAVerdictOnControllersThatMisbehaveAndEndsThem) {
    struct Case {
        const char* what;
        const char* cause;
        const char* message;
    };
    const auto start = std::chrono::steady_clock::now();
    for (const Case& c : {
             Case{"exit 7", "ended", "no response: the controller exited with code 7"},
             Case{"kill -SEGV $$", "ended", "no response: the controller was terminated by signal 11"},
             Case{"echo oops >&2; exit 1", "ended", "its error output: oops"},
             Case{"sleep 60", "silent", "no response within 300ms"},
             Case{"sleep 60 & sleep 60", "silent", "no response within 300ms"},
             Case{"echo", "not-understood", "0 values, expected 4"},
             Case{"echo 0,1,1", "not-understood", "3 values, expected 4"},
             Case{"echo 0,1,1,maybe", "not-understood", "`maybe` is not a value of `W2`"},
             Case{"echo 0,1,1,7", "not-understood", "the value `7` of `W2` is outside the range 0 to 1"},
             Case{"head -c 3000 /dev/urandom; echo", "", ""},
             Case{"yes 0,1,1,0", "flood", "more than one line for one scan"},
             Case{"tr '\\0' 1 < /dev/zero", "flood", "unterminated line: `1111"},
         }) {
        SCOPED_TRACE(c.what);
        const Result result = tested(faulty(c.what), {"--format", "json", "--timeout", "300ms"});
        EXPECT_EQ(result.code, ExitCode::Verdict);
        const Json report = Json::parse(result.out);
        EXPECT_EQ(verdicts(report), (std::vector<std::string>{"passed", "failed", "not run"}));
        const Json failure = report["steps"][1]["failure"];
        const std::string message = failure["message"];
        EXPECT_TRUE(*c.cause == '\0' || failure["cause"] == c.cause) << failure;
        EXPECT_NE(message.find(c.message), std::string::npos) << message;
        EXPECT_LT(message.size(), 400u);
        EXPECT_TRUE(no_child());
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(40));
}

TEST(TestCommand, ContinuesAfterAFailureIfTheControllerCan) {
    const auto after = [](const std::string& what) {
        return verdicts(
            Json::parse(tested(faulty(what), {"--keep-going", "--format", "json", "--timeout", "300ms"}).out));
    };
    EXPECT_EQ(after("echo 1,1,0,0"), (std::vector<std::string>{"passed", "failed", "passed"}));
    EXPECT_EQ(after("echo nonsense"), (std::vector<std::string>{"passed", "failed", "passed"}));
    EXPECT_EQ(after("exit 1"), (std::vector<std::string>{"passed", "failed", "not run"}));
    EXPECT_EQ(after("sleep 60"), (std::vector<std::string>{"passed", "failed", "not run"}));
}

TEST(TestCommand, ProgramThatTheShellCannotRunGivesNoVerdict) {
    const Result result = tested("/nowhere/at/all");
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_NE(result.err.find("[cannot-run]"), std::string::npos) << result.err;
    EXPECT_EQ(result.out, "");
}

TEST(TestCommand, ComparesEveryScanOfAStepAndWaitsOnRequest) {
    const Folder folder;
    const std::string chart = folder.write("pulse.grafcet",
                                           "grafcet pulse { input go; output L; initial step 0; step 1 { L; }\n"
                                           "transition a: 0 -> 1 when go; transition b: 1 -> 0 when 3s/X1 && !go; }\n");
    const std::string table = folder.write("t.csv",
                                           "sequence,step,wait,cycles,go,L,situation\n1,1,,2,0,0,{0}\n1,2,,2,1,1,{1}\n"
                                           "1,3,,1,0,1,{1}\n1,4,3s,2,0,0,{0}\n2,1,,1,1,1,\n");
    const auto run = [&](const std::string& controller, const std::vector<std::string>& options = {}) {
        std::vector<std::string> arguments = {"test",     chart,  "--sequence", table,
                                              "--format", "json", "--against",  controller};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return Json::parse(grafverif(arguments).out);
    };
    EXPECT_EQ(run(this_program + " plc " + chart)["passed"], 5);
    const Json early = run("sed -u -e /wait/d -e s/0/0/");
    EXPECT_EQ(early["steps"][2]["failure"]["cause"], "different");
    const Json late = run("read a; echo 0; read a; echo 0; read a; echo 1; read a; echo 0");
    EXPECT_EQ(late["steps"][1]["failure"]["scan"], 2) << "the second scan of the step is compared, too";
    const Json real = run(this_program + " plc " + chart + " --clock real", {"--clock", "real"});
    EXPECT_EQ(real["passed"], 5) << real.dump(1);
    EXPECT_GT(real["seconds"], 3.0);
}

TEST(TestCommand, WritesAJunitReport) {
    const Folder folder;
    const Result result = tested(faulty("echo '1 1 0 0'"), {"--junit", folder.file("r.xml")});
    EXPECT_EQ(result.code, ExitCode::Verdict);
    pugi::xml_document report;
    ASSERT_TRUE(report.load_string(folder.read("r.xml").c_str()));
    const pugi::xml_node suite = report.child("testsuites").child("testsuite");
    EXPECT_EQ(suite.attribute("tests").as_int(), 3);
    EXPECT_EQ(suite.attribute("failures").as_int(), 1);
    EXPECT_EQ(suite.attribute("skipped").as_int(), 1);
    const pugi::xml_node second = suite.first_child().next_sibling();
    EXPECT_STREQ(second.attribute("name").value(), "step 2");
    EXPECT_STREQ(second.child("failure").attribute("message").value(), "differs in V1, W1");
}

TEST(TestCommand, MakesTheTestOfTheChartItself) {
    const auto run = [](const std::string& of, const std::string& mode, const std::string& hold) {
        return grafverif({"test", tanks_chart, "--mode", of, "--hold", hold, "--quiet", "--against",
                          this_program + " plc " + tanks_chart + " --mode " + mode});
    };
    for (const std::string hold : {"stable", "one"})
        for (const std::string mode : {"stability-search", "every-cycle"}) {
            const Result right = run(mode, mode, hold);
            EXPECT_EQ(right.code, ExitCode::Done) << right.out << right.err;
            const Result wrong = run(mode, mode == "every-cycle" ? "stability-search" : "every-cycle", hold);
            EXPECT_EQ(wrong.code, ExitCode::Verdict) << wrong.out << wrong.err;
        }
}

TEST(TestCommand, RejectsTablesThatAreNotATest) {
    struct Case {
        const char* table;
        const char* error_text;
    };
    const std::string head = "s,h1,h2,l1,l2,V1,V2,W1,W2";
    for (const Case& c : {
             Case{"", "the table has no test step"},
             Case{"s,h1,h2,l1,l2,V1,V2,W1,W2\n", "the table has no test step"},
             Case{"s,h1,h2,l1,V1,V2,W1,W2\n", "no column for the input `l2`"},
             Case{"s,h1,h2,l1,l2,V1,V2,W1\n", "no column for the output `W2`"},
             Case{"s,h1,h2,l1,l2,V1,V2,W1,W2,W3\n", "`W3` is neither an input nor an output of `tanks`"},
             Case{"s,s,h1,h2,l1,l2,V1,V2,W1,W2\n", "the column `s` occurs twice; remove one"},
             Case{"s,h1,h2,l1,l2,V1,V2,W1,W2\n0,0,0,0,0,0,0,0\n",
                  "this row has 8 fields, but the first row has 9; add or remove fields"},
             Case{"s,h1,h2,l1,l2,V1,V2,W1,W2\n0,0,0,0,0,0,0,0,2\n",
                  "the value `2` of `W2` is outside the range 0 to 1"},
             Case{"s,h1,h2,l1,l2,V1,V2,W1,W2\n0,0,0,0,,0,0,0,1\n", "0 values, expected 1"},
             Case{"s,h1,h2,l1,l2,V1,V2,W1,W2,cycles\n0,0,0,0,0,0,0,0,0,0\n", "`0` is not a number of cycles"},
             Case{"s,h1,h2,l1,l2,V1,V2,W1,W2,wait\n0,0,0,0,0,0,0,0,0,soon\n", "`soon` is not a duration"},
             Case{"s,h1,h2,l1,l2,V1,V2,W1,W2,wait\n0,0,0,0,0,0,0,0,0,3s\n", "the first step of a sequence cannot wait"},
             Case{"s,h1,h2,l1,l2,V1,V2,W1,W2,wait\n0,0,0,0,0,0,0,0,0,\n1,0,0,0,0,0,0,0,0,3s\n",
                  "a step with `wait` changes an input"},
             Case{"s,h1,h2,l1,l2,V1,V2,W1,W2,step\n0,0,0,0,0,0,0,0,0,1\n0,0,0,0,0,0,0,0,0,0\n",
                  "step 0 is misplaced or has other values than the scan that activates the initial steps"},
         }) {
        SCOPED_TRACE(c.table);
        const Folder folder;
        const Result result =
            grafverif({"test", tanks_chart, "--against", "exit 1", "--sequence", folder.write("t.csv", c.table)});
        EXPECT_EQ(result.code, ExitCode::Input);
        EXPECT_NE(result.err.find(c.error_text), std::string::npos) << result.err;
        EXPECT_NE(result.err.find("[bad-sequence]"), std::string::npos) << result.err;
    }
}

TEST(TestCommand, ReadsTablesAsSpreadsheetsWriteThem) {
    const Folder folder;
    const std::string table = folder.write("t.csv",
                                           "\xEF\xBB\xBFW2,s,\"h1\",h2, l1 ,l2,situation,V1,V2,W1\r\n"
                                           "0,0,0,0,1,1,\"{1} \"\"rest\"\"\",0,0,0\r\n\r\n"
                                           "0,TRUE,TRUE,0,1,1,\"{3,5}\",0,1,1\r\n");
    const Result result = grafverif({"test", tanks_chart, "--sequence", table, "--format", "json", "--against",
                                     this_program + " plc " + tanks_chart});
    EXPECT_EQ(result.code, ExitCode::Done) << result.out << result.err;
    EXPECT_EQ(Json::parse(result.out)["steps"][0]["situation"], "{1} \"rest\"");
}

TEST(TestCommand, ReadsTablesWithSemicolons) {
    const Folder folder;
    const std::string table = folder.write(
        "t.csv",
        "W2;s;h1;h2;l1;l2;situation;V1;V2;W1\r\n0;0;0;0;1;1;{1};0;0;0\r\n0;1;1;0;1;1;{3,5};0;1;1\r\n;;;;;;;;;\r\n");
    const Result result = grafverif({"test", tanks_chart, "--sequence", table, "--format", "json", "--against",
                                     this_program + " plc " + tanks_chart});
    EXPECT_EQ(result.code, ExitCode::Done) << result.out << result.err;
    EXPECT_EQ(Json::parse(result.out)["steps"][1]["situation"], "{3,5}");
}

TEST(TestCommand, RequiresAControllerAndOneFailurePolicy) {
    EXPECT_NE(grafverif({"test", tanks_chart, "--sequence", table2}).err.find("`--against PROGRAM` is missing"),
              std::string::npos);
    EXPECT_NE(tested("x", {"--keep-going", "--stop-on-failure"}).err.find("are mutually exclusive"), std::string::npos);
    EXPECT_EQ(tested("x", {"--clock", "wall"}).code, ExitCode::Input);
}

}  // namespace
}  // namespace grafverif::app
