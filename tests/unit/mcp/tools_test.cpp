// SPDX-License-Identifier: MIT
// Tests the tools of the MCP server with the commands of the program in the same process.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

#include "unit/app/run_program.hpp"
#include "unit/mcp/client.hpp"

namespace grafverif::mcp {
namespace {

namespace fs = std::filesystem;

const std::string lamp =
    "grafcet lamp {\n"
    "    input ON, OFF;\n"
    "    output LAMP;\n"
    "    initial step 0;\n"
    "    step 1 {\n"
    "        LAMP;\n"
    "    }\n"
    "    transition on: 0 -> 1 when ON;\n"
    "    transition off: 1 -> 0 when OFF && !ON;\n"
    "}\n"
    "closed_loop room {\n"
    "    controller lamp;\n"
    "    environment a = free(OUT = ON);\n"
    "    environment b = free(OUT = OFF);\n"
    "    property lit \"the lamp can be lit\": reachable LAMP;\n"
    "    property never_lit: never LAMP;\n"
    "}\n";

/// A server for the folder `inside` of a temporary folder.
class Server {
public:
    Server() {
        fs::create_directories(folder.file("inside/sub"));
        folder.write("inside/lamp.grafcet", lamp);
        ServerEnvironment environment;
        environment.folders = {fs::canonical(folder.file("inside")).string()};
        environment.execute = [this](const CommandRun& run) {
            const std::lock_guard hold(door_);
            commands.push_back(run.arguments);
            const app::Result found = app::grafverif(run.arguments, run.input);
            return ProgramResult{ProgramResult::End::Exited, static_cast<int>(found.code), found.out, found.err};
        };
        client = std::make_unique<Client>(environment);
        client->begin();
    }

    /// Returns the result of a call that succeeds.
    Json call(const std::string& tool, const Json& arguments) const {
        const Json found = client->call(tool, arguments);
        EXPECT_EQ(found["isError"], false) << found.dump();
        return found;
    }
    /// Returns the text of a call that fails.
    std::string failure(const std::string& tool, const Json& arguments) const {
        const Json found = client->call(tool, arguments);
        EXPECT_EQ(found["isError"], true) << found.dump();
        EXPECT_FALSE(found.contains("structuredContent"));
        return found["content"][0]["text"];
    }

    app::Folder folder = {};
    std::vector<std::vector<std::string>> commands = {};
    std::unique_ptr<Client> client = {};

private:
    std::mutex door_ = {};
};

std::string text_of(const Json& result) { return result["content"][0]["text"]; }
bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(McpTools, CheckReturnsVerdictsAssumptionsAndCounterexamples) {
    const Server server;
    const Json found = server.call("check", {{"file", "lamp.grafcet"}});
    const Json& data = found["structuredContent"];
    EXPECT_EQ(data["model"], "room");
    EXPECT_EQ(data["as_expected"], false);
    const Json &lit = data["properties"][0], &never = data["properties"][1];
    EXPECT_EQ(lit["name"], "lit");
    EXPECT_EQ(lit["description"], "the lamp can be lit");
    EXPECT_EQ(lit["verdict"], "holds");
    EXPECT_EQ(lit["as_expected"], true);
    EXPECT_EQ(lit["line"], 15);
    EXPECT_TRUE(lit["counterexample"].is_null());
    EXPECT_EQ(never["verdict"], "violated");
    EXPECT_EQ(never["as_expected"], false);
    EXPECT_TRUE(has(never["counterexample"], "LAMP"));
    for (const Json& each : data["properties"]) {
        const std::string assumptions = each["assumptions"];
        EXPECT_TRUE(has(assumptions, "timed engine") || has(assumptions, "timed")) << assumptions;
        EXPECT_TRUE(has(text_of(found), "Assumptions: " + assumptions));
    }
    EXPECT_TRUE(has(text_of(found), "room: not all verdicts are as expected\n")) << text_of(found);
    EXPECT_TRUE(has(text_of(found), "never_lit: violated, expected holds")) << text_of(found);
}

TEST(McpTools, CheckHasTheVerdictsOfTheCommand) {
    const Server server;
    const std::string station = app::station;
    Server other;
    fs::copy_file(station, other.folder.file("inside/station.grafcet"));
    const Json direct = Json::parse(app::grafverif({"check", station, "--format", "json", "--grain", "atomic"}).out);
    const Json data = other.call("check", {{"file", "station.grafcet"}, {"grain", "atomic"}})["structuredContent"];
    ASSERT_EQ(data["properties"].size(), direct["properties"].size());
    for (std::size_t k = 0; k < direct["properties"].size(); ++k)
        for (const char* const member : {"name", "verdict", "expected", "vacuous", "reason", "assumptions"})
            EXPECT_EQ(data["properties"][k][member], direct["properties"][k][member]) << member;
}

TEST(McpTools, ExplainReturnsTheRunAsTextAndAsData) {
    const Server server;
    const Json found = server.call("explain", {{"file", "lamp.grafcet"}, {"property", "never_lit"}});
    const Json& data = found["structuredContent"];
    EXPECT_EQ(data["verdict"], "violated");
    EXPECT_EQ(data["steps_complete"], true);
    ASSERT_FALSE(data["steps"].empty());
    EXPECT_EQ(data["steps"].front()["situation"], Json::array({"0"}));
    EXPECT_EQ(data["steps"].back()["situation"], Json::array({"1"}));
    EXPECT_EQ(data["steps"].back()["outputs"]["LAMP"], true);
    EXPECT_TRUE(has(text_of(found), data["counterexample"].get<std::string>()));
    EXPECT_FALSE(data["causes"].empty());
    EXPECT_TRUE(data["proof"].is_null());
    const Json why = server.call("explain", {{"file", "lamp.grafcet"}, {"property", "lit"}, {"why", true}});
    EXPECT_EQ(why["structuredContent"]["verdict"], "holds");
    EXPECT_EQ(why["structuredContent"]["proof"]["property"], "lit");
    EXPECT_TRUE(has(text_of(why), "proof needs transitions: on\n")) << text_of(why);
    EXPECT_TRUE(has(server.failure("explain", {{"file", "lamp.grafcet"}, {"property", "litt"}}), "did you mean `lit`"));
}

TEST(McpTools, AcceptsATextInsteadOfAFile) {
    const Server server;
    const Json checked = server.call("check", {{"text", lamp}, {"property", {"lit"}}});
    EXPECT_EQ(checked["structuredContent"]["properties"].size(), 2U);  // with `no_timelock`, which is always checked
    EXPECT_EQ(checked["structuredContent"]["properties"][0]["name"], "lit");
    EXPECT_TRUE(text_of(server.call("draw", {{"text", lamp}})).starts_with("<svg"));
    EXPECT_TRUE(has(server.failure("check", {{"text", "grafcet a {\n  nonsense\n}\n"}}), ":2:3: error: "));
    EXPECT_EQ(server.failure("check", {{"text", lamp}, {"file", "lamp.grafcet"}}), "pass either `file` or `text`");
    EXPECT_EQ(server.failure("check", Json::object()), "pass either `file` or `text`");
}

TEST(McpTools, ReadListsModelsAndDiagnostics) {
    const Server server;
    const Json data = server.call("read", {{"file", "lamp.grafcet"}})["structuredContent"];
    EXPECT_EQ(data["text"], lamp);
    EXPECT_EQ(data["format"], "grafcet");
    EXPECT_EQ(data["diagnostics"], Json::array());
    EXPECT_EQ(data["models"],
              Json::array({{{"name", "room"},
                            {"kind", "loop"},
                            {"properties",
                             {{{"name", "lit"}, {"description", "the lamp can be lit"}, {"expected", "holds"}},
                              {{"name", "never_lit"}, {"description", nullptr}, {"expected", "holds"}}}}}}));
    const Json broken = server.call("read", {{"text", "grafcet a { step 0; }"}});
    EXPECT_FALSE(broken["structuredContent"]["diagnostics"].empty());
    EXPECT_TRUE(has(text_of(broken), "error: ")) << text_of(broken);
    const Json imported =
        server.call("read", {{"text", app::grafverif({"st", app::station}).out}})["structuredContent"];
    EXPECT_EQ(imported["format"], "xml");
}

TEST(McpTools, SimulateExecutesCommandsAndRejectsSave) {
    const Server server;
    const std::string before = std::to_string(server.folder.entries());
    const Json found = server.call("simulate", {{"file", "lamp.grafcet"}, {"commands", "do a\nexpect X1\nexpect X0"}});
    EXPECT_TRUE(has(found["structuredContent"]["run"], "output     LAMP = true")) << found.dump(2);
    EXPECT_EQ(found["structuredContent"]["expectations_met"], false);
    EXPECT_TRUE(has(found["structuredContent"]["messages"], ":3: not met")) << found.dump(2);
    EXPECT_TRUE(has(server.failure("simulate", {{"file", "lamp.grafcet"}, {"commands", "wait 1s\nsave x.script"}}),
                    "`save` is allowed only interactively"));
    EXPECT_TRUE(has(server.failure("simulate", {{"file", "lamp.grafcet"}, {"commands", "dance"}}), "error"));
    EXPECT_EQ(std::to_string(server.folder.entries()), before);
}

TEST(McpTools, AnalyseAndCompareReturnTheirFindings) {
    const Server server;
    server.folder.write("inside/other.grafcet",
                        "grafcet lamp { input ON, OFF; output LAMP; initial step 0; step 1 { LAMP; }\n"
                        "transition on: 0 -> 1 when ON; transition off: 1 -> 0 when OFF; }\n");
    const Json analysis = server.call("analyse", {{"file", "other.grafcet"}});
    EXPECT_EQ(analysis["structuredContent"]["chart"], "lamp");
    EXPECT_FALSE(
        analysis["structuredContent"]["findings"].empty());  // the chart does not become stable if ON and OFF are true
    const Json different = server.call("compare", {{"file", "lamp.grafcet"}, {"other", "other.grafcet"}});
    EXPECT_EQ(different["structuredContent"]["outcome"], "different");
    EXPECT_FALSE(different["structuredContent"]["scans"].empty());
    const Json equal = server.call("compare", {{"file", "lamp.grafcet"}, {"other", "lamp.grafcet"}});
    EXPECT_EQ(equal["structuredContent"]["outcome"], "equal");
}

TEST(McpTools, TuneReturnsBoxesAndMargins) {
    const Server server;
    const std::string text =
        "component door(output OPEN; T = 1s) { clock t; initial location closed invariant t <= T;\n"
        "location open with OPEN := true; timed closed -> open when t >= T do OPEN := true; }\n"
        "grafcet g { input OPEN; output LIGHT; initial step 0; step 1 { LIGHT; } transition a: 0 -> 1 when OPEN; }\n"
        "closed_loop l { controller g; constant T = 2s; plant D = door(OPEN = OPEN, T = T);\n"
        "property prompt: X0 leads to LIGHT within 3s; }\n";
    const Json found = server.call("tune", {{"text", text}, {"over", {"T=1s..6s"}}});
    const Json& data = found["structuredContent"];
    EXPECT_EQ(data["points"], 6);
    const Json& prompt = data["properties"][0];
    EXPECT_EQ(prompt["current"], "holds");
    EXPECT_EQ(prompt["boxes"][0]["constants"]["T"], Json::array({"1s", "3s"}));
    EXPECT_EQ(prompt["margins"][0]["value"], "4s");
    EXPECT_TRUE(has(text_of(found),
                    "prompt: holds with the current values\n  T = 1s..3s: holds\n  T = 4s..6s: violated\n"
                    "  margin up: violated at T = 4s\n"))
        << text_of(found);
    EXPECT_TRUE(has(server.failure("tune", {{"text", text}, {"over", {"U=1s..6s"}}}), "no constant"));
}

TEST(McpTools, FaultsReturnsMinimalCombinations) {
    const Server server;
    const std::string text =
        "component held(output OUT) { initial location held with OUT := true; }\n"
        "grafcet g { input A; output LIGHT; initial step 0; step 1 { LIGHT; } transition a: 0 -> 1 when ↑A; }\n"
        "closed_loop l { controller g; environment S = push_button(OUT = A); fault stuck of S: held();\n"
        "property works: reachable X1; property dark: never X0 && LIGHT at stable; }\n";
    const Json found = server.call("faults", {{"text", text}, {"order", 2}});
    const Json& data = found["structuredContent"];
    EXPECT_EQ(data["combinations"], 1);
    EXPECT_EQ(data["faults"][0]["never_true"], Json::array({"LIGHT", "X1"}));
    EXPECT_EQ(data["properties"][0]["minimal"], Json::array({Json::array({"stuck"})}));
    EXPECT_TRUE(has(text_of(found), "works: violated with stuck\ndark: no combination leads to a violation\n"))
        << text_of(found);
}

TEST(McpTools, FaultsReturnsModelErrorsAndUnknownCombinations) {
    const Server server;
    const std::string text =
        "component runaway(output R: int 0..1 = 0) { clock t; initial location r;\n"
        "timed r -> r when t >= 1s do R := R + 1, t := 0; }\n"
        "component still(output R: int 0..1 = 0) { initial location still; }\n"
        "component toggle(output OUT) { clock t; initial location l invariant t <= 1s;\n"
        "timed l -> l when t == 1s do OUT := !OUT, t := 0; }\n"
        "component open(output OUT) { clock t; initial location l invariant t < 2s;\n"
        "timed l -> l when t > 1s do OUT := !OUT, t := 0; }\n"
        "grafcet g { input A; output L; initial step 0; step 1 { L; } transition a: 0 -> 1 when A;\n"
        "transition b: 1 -> 0 when !A; }\n"
        "closed_loop l { controller g; environment S = toggle(OUT = A); plant Still = still(R = R);\n"
        "fault loose of S: open(); fault fast of Still: runaway(); property p: X1 leads to X0; }\n";
    const Json found = server.call("faults", {{"text", text}});
    const Json& data = found["structuredContent"];
    ASSERT_EQ(data["errors"].size(), 1u) << found.dump(2);
    EXPECT_EQ(data["errors"][0]["faults"], Json::array({"fast"}));
    EXPECT_EQ(data["errors"][0]["code"], "out-of-range");
    EXPECT_EQ(data["properties"][0]["unknown"][0]["faults"], Json::array({"loose"}));
    EXPECT_TRUE(has(text_of(found), "p: unknown for loose")) << text_of(found);
    EXPECT_TRUE(has(text_of(found), "model error with fast: `R` would leave its range")) << text_of(found);
}

TEST(McpTools, CompleteProposesNamesAtThePosition) {
    const Server server;
    const std::string text =
        "grafcet a { input START; output MOVE; initial step 0; step 1 { MOVE; }\n"
        "transition t: 0 -> 1 when ST";
    const Json found = server.call("complete", {{"text", text}, {"line", 2}, {"column", 29}});
    bool proposed = false;
    for (const Json& each : found["structuredContent"]["proposals"])
        proposed = proposed || (each["label"] == "START" && each["kind"] == "variable");
    EXPECT_TRUE(proposed) << found.dump(2);
    EXPECT_TRUE(
        has(server.failure("complete", {{"file", "none.grafcet"}, {"line", 1}, {"column", 1}}), "no such file"));
}

TEST(McpTools, OldVersionsReceiveTheDataAsText) {
    const Server server;
    ServerEnvironment environment;
    environment.folders = {fs::canonical(server.folder.file("inside")).string()};
    environment.execute = [](const CommandRun& run) {
        const app::Result found = app::grafverif(run.arguments, run.input);
        return ProgramResult{ProgramResult::End::Exited, static_cast<int>(found.code), found.out, found.err};
    };
    Client client(environment);
    client.begin("2024-11-05");
    const Json found = client.call("check", {{"file", "lamp.grafcet"}});
    EXPECT_FALSE(found.contains("structuredContent"));
    EXPECT_EQ(Json::parse(found["content"][1]["text"].get<std::string>())["model"], "room");
}

TEST(McpTools, ReadsOnlyBelowTheFolders) {
    const Server server;
    server.folder.write("secret.grafcet", lamp);
    server.folder.write("inside/sub/uses.grafcet", "include \"../../secret.grafcet\";\n");
    server.folder.write("inside/sub/absolute.grafcet", "include \"" + server.folder.file("secret.grafcet") + "\";\n");
    server.folder.write("inside/sub/linked.grafcet", "include \"../link.grafcet\";\n");
    server.folder.write("inside/sub/fine.grafcet", "include \"../lamp.grafcet\";\n");
    server.folder.write("grafverif.project", "");  // permits includes of the complete folder, except with --within
    fs::create_symlink(server.folder.file("secret.grafcet"), server.folder.file("inside/link.grafcet"));
    fs::create_symlink(server.folder.file("."), server.folder.file("inside/up"));
    fs::create_symlink("lamp.grafcet", server.folder.file("inside/same.grafcet"));
    const std::string outside = "outside the ";
    for (const std::string& path :
         {std::string("../secret.grafcet"), server.folder.file("secret.grafcet"), std::string("link.grafcet"),
          std::string("up/secret.grafcet"), std::string("sub/../../secret.grafcet"), std::string("/etc/passwd"),
          std::string("/nowhere"), std::string("../nowhere"), std::string("sub/uses.grafcet"),
          std::string("sub/absolute.grafcet"), std::string("sub/linked.grafcet"), std::string("/dev/stdin"),
          std::string("/proc/self/environ")})
        for (const char* const tool : {"check", "draw", "analyse", "simulate"}) {
            SCOPED_TRACE(std::string(tool) + ' ' + path);
            Json arguments = {{"file", path}};
            if (tool == std::string("simulate")) arguments["commands"] = "";
            EXPECT_TRUE(has(server.failure(tool, arguments), outside)) << server.failure(tool, arguments);
        }
    EXPECT_TRUE(has(server.failure("read", {{"file", "link.grafcet"}}), outside));
    EXPECT_TRUE(has(server.failure("complete", {{"file", "up/secret.grafcet"}, {"line", 1}, {"column", 1}}), outside));
    EXPECT_TRUE(has(server.failure("compare", {{"file", "lamp.grafcet"}, {"other", "link.grafcet"}}), outside));
    EXPECT_TRUE(has(server.failure("check", {{"file", "lamp.grafcet"}, {"properties_file", "/etc/passwd"}}), outside));
    EXPECT_TRUE(has(server.failure("check", {{"text", "include \"../secret.grafcet\";"}}), outside));
    for (const char* const path : {"sub/fine.grafcet", "same.grafcet", "sub/../lamp.grafcet", "up/inside/lamp.grafcet"})
        EXPECT_EQ(server.call("check", {{"file", path}})["structuredContent"]["model"], "room") << path;
}

TEST(McpTools, CompleteDoesNotReadIncludedFilesOutsideOfTheFolders) {
    const Server server;
    server.folder.write("secret.grafcet", "component hidden_secret(input A) { initial location a; }\n");
    const auto proposes = [&](const std::string& included) {
        const std::string text =
            "include \"" + included + "\";\ngrafcet g { initial step 0; }\nclosed_loop l { plant p = ";
        return has(text_of(server.call("complete", {{"text", text}, {"line", 3}, {"column", 27}})), "hidden_secret");
    };
    EXPECT_FALSE(proposes("../secret.grafcet"));
    EXPECT_FALSE(proposes(server.folder.file("secret.grafcet")));
    fs::create_symlink("../secret.grafcet", server.folder.file("inside/hidden.grafcet"));
    EXPECT_FALSE(proposes("missing/../hidden.grafcet"));
    server.folder.write("inside/public.grafcet", "component hidden_secret(input A) { initial location a; }\n");
    EXPECT_TRUE(proposes("public.grafcet"));
}

TEST(McpTools, RejectsFilesThatAreNotRegular) {
    const Server server;
    ASSERT_EQ(::mkfifo(server.folder.file("inside/pipe").c_str(), 0600), 0);
    server.folder.write("inside/-x.grafcet", lamp);
    server.folder.write("inside/--help", lamp);
    EXPECT_TRUE(has(server.failure("check", {{"file", "pipe"}}), "the path is a pipe, not a file"));
    EXPECT_TRUE(has(server.failure("read", {{"file", "pipe"}}), "the path is a pipe, not a file"));
    EXPECT_TRUE(has(server.failure("check", {{"file", "sub"}}), "the path is a folder"));
    EXPECT_TRUE(has(server.failure("check", {{"file", "none.grafcet"}}), "no such file"));
    EXPECT_TRUE(has(server.failure("check", {{"file", "-"}}), "no such file"));
    EXPECT_FALSE(server.failure("check", {{"file", std::string(4000, 'a')}}).empty());
    for (const char* const name : {"-x.grafcet", "--help"})
        EXPECT_EQ(server.call("check", {{"file", name}})["structuredContent"]["model"], "room");
}

TEST(McpTools, PassesLimitsAndFoldersToEveryCommand) {
    const Server server;
    server.call("draw", {{"file", "lamp.grafcet"}, {"timeout", 7}, {"max_memory", 300}});
    const std::vector<std::string>& command = server.commands.back();
    const auto given = [&](const std::string& option) { return std::ranges::find(command, option) != command.end(); };
    EXPECT_TRUE(given("--max-memory=300M"));
    EXPECT_TRUE(given("--within=" + fs::canonical(server.folder.file("inside")).string()));
    const auto timeout = std::ranges::find_if(command, [](const auto& each) { return each.starts_with("--timeout="); });
    ASSERT_NE(timeout, command.end());
    const int limit = std::stoi(timeout->substr(10));
    EXPECT_GT(limit, 0);
    EXPECT_LE(limit, 7000);
}

}  // namespace
}  // namespace grafverif::mcp
