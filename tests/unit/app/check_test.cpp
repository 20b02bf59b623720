// SPDX-License-Identifier: MIT
// Tests `check` end to end: verdicts, exit codes, and reports and traces in files.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "app/system/interrupt.hpp"
#include "run_program.hpp"

namespace grafverif::app {
namespace {

using Json = nlohmann::json;

std::string sample(const std::string& path) { return (root / "samples" / path).string(); }

/// Returns a chart that counts presses of a button, and a loop with the given properties.
std::string counter(const std::string& properties) {
    return "grafcet counter { input GO; output L; internal N: int 0..2 = 0;\n"
           "initial step 0; step 1 { N := N + 1 on activation; L; } // step 2\n"
           "transition t0: 0 -> 1 when GO && N < 2; transition t1: 1 -> 0 when !GO; }\n"
           "closed_loop counting { controller counter; environment Go = push_button(OUT = GO); " +
           properties + " }\n";
}

TEST(Check, ProvesThePropertiesOfTheSamples) {
    for (const char* path : {"blinker/blinker.grafcet", "oven_door/oven_door.grafcet", "tanks/tanks.grafcet",
                             "testing_station/testing_station.grafcet"}) {
        SCOPED_TRACE(path);
        const Result result = grafverif({"check", sample(path), "--format", "json"});
        EXPECT_EQ(result.code, ExitCode::Done) << result.err;
        const Json properties = Json::parse(result.out)["properties"];
        EXPECT_GE(properties.size(), 3u);
        for (const Json& property : properties) EXPECT_EQ(property["verdict"], "holds") << property["name"];
    }
}

TEST(Check, PrintsTheAssumptionsOfAVerdict) {
    const Result result =
        grafverif({"check", sample("blinker/blinker.grafcet"), "--grain", "atomic", "--mode", "every-cycle"});
    EXPECT_NE(result.out.find("timed engine; every-cycle, atomic grain; time unit 1 s, cycle time taken as zero"),
              std::string::npos)
        << result.out;
}

TEST(Check, HasAnExitCodeForEachOutcome) {
    const Folder folder;
    const Path without_programs(folder.file(""));
    struct Case {
        const char* properties;
        std::vector<std::string> options;
        ExitCode code;
    };
    const std::string too_few = "1";
    for (const Case& c : std::vector<Case>{
             {"property a: always N <= 2;", {}, ExitCode::Done},
             {"property a expected violated: always N < 1;", {}, ExitCode::Done},
             {"property a: always N < 1;", {}, ExitCode::Verdict},
             {"property a expected violated: always N <= 2;", {}, ExitCode::Verdict},
             {"property a: always N <= 2;", {"--max-states", too_few}, ExitCode::Unknown},
             {"property a: always N < 1; property b: L leads to !L;", {"--property", "a"}, ExitCode::Verdict},
             {"property a: always N;", {}, ExitCode::Input},
             {"property a: always UNKNOWN;", {}, ExitCode::Input},
             {"property a: always N <= 2;", {"--property", "b"}, ExitCode::Input},
             {"property a: always N <= 2;", {"--why"}, ExitCode::Done},
             {"property a: always N <= 2;", {"--why", "--untimed"}, ExitCode::Input},
             {"property a: always N <= 2;", {"--why", "--json-lines"}, ExitCode::Input},
             {"property a: always N <= 2;", {"--why", "--ablate", "stable"}, ExitCode::Input},
             {"property a: always N <= 2;", {"--engine", "NuSMV"}, ExitCode::Input},
             {"property a: always N <= 2;", {"--max-memory", "lots"}, ExitCode::Input},
             {"property a: always N <= 2;", {"--timeout", "5 s"}, ExitCode::Input},
         }) {
        SCOPED_TRACE(c.properties);
        std::vector<std::string> arguments = {"check", folder.write("counter.grafcet", counter(c.properties))};
        arguments.insert(arguments.end(), c.options.begin(), c.options.end());
        const Result result = grafverif(arguments);
        EXPECT_EQ(result.code, c.code) << result.out << result.err;
        EXPECT_EQ(result.err.empty(), c.code != ExitCode::Input) << result.err;
    }
}

/// Two charts with a button and a lamp each, which share only time.
const char* const two_lamps = R"(
grafcet left { input A; output L; initial step 0; step 1 { L; }
    transition on: 0 -> 1 when A; transition off: 1 -> 0 when 2s/X1; }
grafcet right { input B; output R; initial step 0; step 1 { R; }
    transition on: 0 -> 1 when B; transition off: 1 -> 0 when 3s/X1; }
closed_loop lamps {
    controller left;
    controller right;
    environment PA = push_button(OUT = A);
    environment PB = push_button(OUT = B);
    property lit: always !L;
    property off: left.X1 leads to left.X0;
    property both: never L && R;
    property D: no deadlock;
})";

TEST(Check, DecidesAFragmentOfALineAndNamesTheOmittedParts) {
    const std::vector<std::string> command = {
        "check", (root / "samples/transfer_line/transfer_line.grafcet").string(), "--property", "held[2]", "--format",
        "json"};
    const Result ran = grafverif(command);
    EXPECT_EQ(ran.code, ExitCode::Done) << "the undecided query for timelocks does not change the exit code";
    const Json properties = Json::parse(ran.out)["properties"];
    EXPECT_EQ(properties[0]["verdict"], "holds");
    EXPECT_EQ(properties[0]["cells"],
              Json::parse(R"({"searched": ["cell[2]"], "left_out": ["cell[1]", "cell[3]", "Buffer[1]", "Buffer[2]"],
                              "because": "may do anything at any time, which is an over-approximation"})"));
    EXPECT_EQ(properties[0]["declared"], true);
    EXPECT_TRUE(std::string(properties[0]["notes"].at(0))
                    .starts_with("timelocks were searched only in the first 131072 states"));
    EXPECT_EQ(properties[1]["verdict"], "unknown");
    EXPECT_EQ(properties[1]["declared"], false);
    std::vector<std::string> whole = command;
    whole.insert(whole.end(), {"--monolithic", "--max-states", "1000"});
    EXPECT_EQ(Json::parse(grafverif(whole).out)["properties"][0]["verdict"], "unknown");
}

TEST(Check, ProvesThatAStateIsAlwaysPossibleUnlessTheCheckIsMonolithic) {
    const auto verdicts = [](const std::vector<std::string>& more) {
        std::vector<std::string> command = {"check",        (root / "bench/stations/lift.grafcet").string(),
                                            "--format",     "json",
                                            "--grain",      "atomic",
                                            "--property",   "back",
                                            "--property",   "no_deadlock",
                                            "--max-states", "200000"};
        command.insert(command.end(), more.begin(), more.end());
        const Json report = Json::parse(grafverif(command).out);
        std::vector<std::string> found;
        for (const Json& property : report["properties"]) found.push_back(property["verdict"]);
        return found;
    };
    EXPECT_EQ(verdicts({}), (std::vector<std::string>{"holds", "holds", "holds"}))
        << "the last verdict is that on `no timelock`";
    EXPECT_EQ(verdicts({"--monolithic"}), (std::vector<std::string>{"unknown", "unknown", "unknown"}));
}

TEST(Check, StatesOmittedSubsystemsWithTheReason) {
    const Folder folder;
    const std::string file = folder.write("lamps.grafcet", two_lamps);
    std::string text = grafverif({"check", file}).out;
    for (std::size_t at = 0; (at = text.find("\n        ")) != std::string::npos;) text.replace(at, 9, " ");
    for (const char* words : {"sub-loop `left` alone; omitted: `right`, which shares only time with the checked "
                              "sub-loops and can let time pass forever\n",
                              "sub-loop `left` alone; omitted: `right`, which shares only time with the checked "
                              "sub-loops, has no timelock and makes only "
                              "finitely many moves within one instant\n",
                              "sub-loops `left`, `right`, each separately\n"})
        EXPECT_NE(text.find(words), std::string::npos) << text;
    const Json apart = Json::parse(grafverif({"check", file, "--format", "json"}).out)["properties"];
    const Json whole = Json::parse(grafverif({"check", file, "--format", "json", "--monolithic"}).out)["properties"];
    EXPECT_EQ(apart[0]["sub_loops"], Json::parse(R"({"searched": ["left"], "left_out": ["right"],
                              "because": "shares only time with the checked sub-loops and can let time pass forever"})"));
    EXPECT_FALSE(apart[2].contains("sub_loops"));
    for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_EQ(apart[i]["verdict"], whole[i]["verdict"]) << whole[i]["name"];
        EXPECT_FALSE(whole[i].contains("sub_loops"));
    }
    EXPECT_LT(apart[1]["states"], whole[1]["states"]);
    EXPECT_EQ(apart[2]["states"], whole[2]["states"]);
}

TEST(Check, ChecksThePropertiesNamedAndTimelock) {
    const Result result = grafverif({"check", sample("oven_door/oven_door.grafcet"), "--property", "warned",
                                     "--property", "one_order", "--format", "json"});
    std::vector<std::string> names;
    const Json properties = Json::parse(result.out)["properties"];
    for (const Json& property : properties) names.push_back(property["name"]);
    ASSERT_EQ(names.size(), 3u);
    EXPECT_EQ(names[0], "one_order");
    EXPECT_EQ(names[1], "warned");
    EXPECT_TRUE(names[2].starts_with("no_timelock")) << names[2];
}

TEST(Check, ReportsAValueOutOfRangeWithATrace) {
    const Folder folder;
    std::string text = counter("property a: always N <= 2;");
    text.replace(text.find(" && N < 2"), 9, "");
    const std::string file = folder.write("counter.grafcet", text);
    const Result result = grafverif({"check", file, "--junit", folder.file("report.xml")});
    EXPECT_EQ(result.code, ExitCode::Verdict);
    EXPECT_TRUE(result.out.starts_with(
        "model error: `N` would leave its range 0..2, in an evolution of `counter` [out-of-range]\n"))
        << result.out;
    EXPECT_NE(result.out.find("counter: N 1 -> 2"), std::string::npos);
    EXPECT_NE(result.out.find("a                           unknown"), std::string::npos) << result.out;
    EXPECT_NE(folder.read("report.xml").find("<failure type=\"out-of-range\""), std::string::npos);
    const Json document = Json::parse(grafverif({"check", file, "--format", "json"}).out);
    EXPECT_EQ(document["errors"][0]["code"], "out-of-range");
}

TEST(Check, ReportsARaceOfStoredActions) {
    const Folder folder;
    std::string text = counter("");
    text.replace(text.find("// step 2"), 9, "step 2 { N := 2 on activation; }");
    text.replace(text.find("0 -> 1 when"), 11, "0 -> 1, 2 when");
    const Result result = grafverif({"check", folder.write("race.grafcet", text)});
    EXPECT_EQ(result.code, ExitCode::Verdict);
    EXPECT_NE(result.out.find(
                  "two stored actions assign different values to `N`, in an evolution of `counter` [action-race]"),
              std::string::npos)
        << result.out;
}

TEST(Check, WritesJunitAndTraces) {
    const Folder folder;
    const std::string file =
        folder.write("counter.grafcet", counter("property a \"few\": always N < 2; property b: always N <= 2;"));
    const Result result = grafverif({"check", file, "--junit", folder.file("r/report.xml"), "--create-dirs",
                                     "--trace-vcd", folder.file("a.vcd"), "--trace-svg", folder.file("a.svg")});
    EXPECT_EQ(result.code, ExitCode::Verdict);
    pugi::xml_document junit, svg;
    ASSERT_TRUE(junit.load_string(folder.read("r/report.xml").c_str()));
    EXPECT_EQ(junit.child("testsuites").child("testsuite").attribute("failures").as_int(), 1);
    ASSERT_TRUE(svg.load_string(folder.read("a.svg").c_str()));
    EXPECT_STREQ(svg.child("svg").find_child_by_attribute("class", "heading").text().get(), "counting: a violated");
    EXPECT_NE(folder.read("a.vcd").find("$enddefinitions"), std::string::npos);
}

TEST(Check, ReportsThatThereIsNoTraceToWrite) {
    const Folder folder;
    const Result result = grafverif({"check", folder.write("counter.grafcet", counter("property b: always N <= 2;")),
                                     "--trace-svg", folder.file("a.svg")});
    EXPECT_EQ(result.code, ExitCode::Done);
    EXPECT_EQ(result.err, "note: no verdict has a trace, so no trace file was written\n");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Check, ReportsResultsSoFarAtTheTimeLimit) {
    const Result result = grafverif({"check", sample("testing_station/testing_station.grafcet"), "--timeout", "0s"});
    EXPECT_EQ(result.code, ExitCode::Unknown);
    EXPECT_NE(result.out.find("P14, P15, no_deadlock, no_timelock: unknown\n    why: stopped at the time limit"),
              std::string::npos)
        << result.out;
}

TEST(Check, FirstInterruptRequestsAnOrderlyEnd) {
    void (*const before)(int) = std::signal(SIGINT, SIG_DFL);
    {
        const Interrupt interrupt;
        EXPECT_FALSE(interrupt.requested());
        std::raise(SIGINT);
        EXPECT_TRUE(interrupt.requested());
    }
    EXPECT_EQ(std::signal(SIGINT, before), SIG_DFL) << "the previous handler is restored";
    EXPECT_FALSE(Interrupt().requested());
}

TEST(Check, RepeatedRunsPrintTheSame) {
    const std::string file = sample("testing_station/faulty.grafcet");
    EXPECT_EQ(grafverif({"check", file}).out, grafverif({"check", file}).out);
}

TEST(Check, NamesTheEmbeddedEngineIfVerifytaIsNotInstalled) {
    const Folder nothing;
    const Path path(nothing.file(""));
    const Result result = grafverif({"check", sample("blinker/blinker.grafcet"), "--engine", "verifyta"});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_EQ(result.err,
              "error: `verifyta` is not on the PATH; install it, or use the embedded engine: `--engine timed` "
              "[missing-program]\n");
}

TEST(Check, PrintsProofCoresOnRequest) {
    const Folder folder;
    const std::string file =
        folder.write("counter.grafcet", counter("property small: always N <= 2; property seen: reachable N == 1;"
                                                "property off: always N == 2 && L => N > 1;"));
    const Result text = grafverif({"check", file, "--why"});
    EXPECT_EQ(text.code, ExitCode::Done) << text.err;
    EXPECT_TRUE(text.out.ends_with(
        "\n"
        "proof dependencies (10 additional searches):\n"
        "small, off: fails without `N < 2` of t0; holds for any behaviour of the plant and the timers\n"
        "seen: fails if t0 is never cleared, or if step 1 has no effect\n"
        "no property of all states depends on Go\n"
        "\n"
        "proof coverage of these properties:\n"
        "transitions: 1 of 2; no property fails if t1 is never cleared\n"
        "steps with actions: 1 of 1\n"
        "terms of conditions: 1 of 3; no property fails without `GO` of t0 or `!GO` of t1\n"
        "edges of the plant: 1 of 1\n"))
        << text.out;
    EXPECT_EQ(grafverif({"check", file, "--why", "-q"}).out, "");
    const Json why = Json::parse(grafverif({"check", file, "--why", "--format", "json"}).out)["why"];
    EXPECT_EQ(why["properties"][1]["transitions"], Json({"t0"}));
    EXPECT_TRUE(why["properties"][1]["parts"].is_null());
    EXPECT_EQ(why["unneeded_transitions"], Json({"t1"}));
    EXPECT_EQ(why["coverage"][4], Json({{"kind", "term"},
                                        {"name", "N < 2"},
                                        {"of", "t0"},
                                        {"needed_by", {"small", "off"}},
                                        {"open", Json::array()}}));
    EXPECT_TRUE(why["ended"].is_null());
}

TEST(Check, WhyCoversPropertiesWithDurationsAndScopes) {
    const Folder folder;
    const std::string file = folder.write(
        "lamp.grafcet",
        "grafcet lamp { input GO; output L; initial step 0; step 1 { L; } step 2;\n"
        "transition t0: 0 -> 1 when rise(GO); transition t1: 1 -> 2 when 2s/X1; transition t2: 2 -> 0 when 1s/X2; }\n"
        "closed_loop l { controller lamp; environment Go = free(OUT = GO);\n"
        "property soon: X1 leads to X2 within 3s; property apart: never X0 && X2 after X1; }\n");
    const Result text = grafverif({"check", file, "--why"});
    EXPECT_EQ(text.code, ExitCode::Done) << text.out << text.err;
    EXPECT_NE(text.out.find("soon: fails if t1 is never cleared"), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("apart: no single transition, step or term"), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("transitions: 1 of 3"), std::string::npos) << text.out;
    const Json why = Json::parse(grafverif({"check", file, "--why", "--format", "json"}).out)["why"];
    EXPECT_EQ(why["properties"][0]["transitions"], Json({"t1"}));
    EXPECT_TRUE(why["properties"][0]["parts"].is_null());
}

/// Installs a stand-in for verifyta that reports exactly the formulas containing `wrong` as not satisfied. The licence
/// of the real program forbids automated tests.
void install_stand_in(const Folder& folder, const std::string& wrong) {
    fs::permissions(folder.write("verifyta",
                                 "#!/bin/sh\n"
                                 "grep -q '<!DOCTYPE nta' \"$1\" || exit 1\n"
                                 "echo 'Verifying formula 1 at line 1'\n"
                                 "if grep -q '" +
                                     wrong +
                                     "' \"$2\"; then echo ' -- Formula is NOT satisfied.'\n"
                                     "else echo ' -- Formula is satisfied.'; fi\n"),
                    fs::perms::owner_all);
}

TEST(Check, ReadsTheVerdictsOfVerifyta) {
    const Folder folder;
    install_stand_in(folder, "deadlock");
    const Path path(fs::path(folder.file("")).string() + ":/usr/bin:/bin");
    const std::string file = sample("testing_station/testing_station.grafcet");
    const Result result = grafverif({"check", file, "--engine", "verifyta"});
    EXPECT_EQ(result.err, "");
    EXPECT_EQ(result.code, ExitCode::Verdict);
    EXPECT_EQ(result.out, fmt::format("station, checked with: verifyta engine; stability-search, phased grain; time "
                                      "unit 1 s, cycle time taken as zero\n"
                                      "\n"
                                      "{0}:60: no_deadlock: violated\n"
                                      "\n"
                                      "{0}:61: no_timelock: unknown\n"
                                      "    why: UPPAAL has no query for `no timelock`\n"
                                      "\n"
                                      "property     verdict   location{1}  description\n"
                                      "P14          holds     {0}:58  the station always returns to rest\n"
                                      "P15          holds     {0}:59  no horizontal move unless the cup is up\n"
                                      "no_deadlock  violated  {0}:60\n"
                                      "no_timelock  unknown   {0}:61\n"
                                      "station: 2 hold, 1 violated, 1 unknown; 1 unexpected\n",
                                      file, std::string(file.size() + 3 - 8, ' ')));
    const Json document = Json::parse(grafverif({"check", sample("oven_door/oven_door.grafcet"), "--engine", "verifyta",
                                                 "--property", "warned", "--format", "json"})
                                          .out);
    const Json& property = document["properties"][0];
    EXPECT_EQ(property["name"], "warned");
    EXPECT_EQ(property["engine"], "verifyta");
    EXPECT_EQ(property["verdict"], "holds");
    EXPECT_TRUE(property["states"].is_null());
    EXPECT_TRUE(property["trace"].is_null());
}

/// The guard of an urgent edge of the observer is undefined at power-on: no run continues from there, not even by a
/// delay, so that the replay accepts the run of the model error.
TEST(Check, ARunEndsWithAnUndefinedGuard) {
    const Folder folder;
    const Result result =
        grafverif({"check", folder.write("room.grafcet",
                                         "grafcet c { input a; output L; internal C: int 0..3 = 0; initial step 0;\n"
                                         "step 1 { L; C := 1 on activation; } transition t: 0 -> 1 when a;\n"
                                         "transition u: 1 -> 0 when !a; }\n"
                                         "closed_loop l { controller c; environment B = free(OUT = a);\n"
                                         "property p: X0 holds at most 1s before 6 / C > 2; }\n")});
    EXPECT_EQ(result.err, "");
    EXPECT_TRUE(result.out.starts_with("model error: division by zero, in `p_watch`")) << result.out;
    EXPECT_TRUE(result.out.ends_with("l: 1 holds, 1 unknown, 1 model error\n")) << result.out;
}

TEST(Check, TheTimedEngineNeedsAClosedLoop) {
    const Folder folder;
    const Result result = grafverif({"check", "--engine", "timed",
                                     folder.write("lone.grafcet",
                                                  "grafcet a { input x; output L; initial step 0 { L; } step 1;\n"
                                                  "transition t: 0 -> 1 when x; }\n")});
    EXPECT_EQ(result.code, ExitCode::Input);
    EXPECT_NE(result.err.find("[no-closed-loop]"), std::string::npos);
    const Result chart = grafverif({"check", "--engine", "timed", "--chart", "testing_station", station});
    EXPECT_EQ(chart.code, ExitCode::Input);
    EXPECT_EQ(chart.out, "");
    EXPECT_NE(chart.err.find("to check the chart (`--chart`) untimed"), std::string::npos) << chart.err;
}

}  // namespace
}  // namespace grafverif::app
