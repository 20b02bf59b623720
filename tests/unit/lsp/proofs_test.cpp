// SPDX-License-Identifier: MIT
// Tests background checks, and how the server reports their results.
#include <sstream>

#include "grafverif/grafverif.hpp"
#include "unit/lsp/client.hpp"

namespace grafverif::lsp {
namespace {

const std::string blinking =
    "grafcet blinking {\n"
    "    input A;\n"
    "    output ON;\n"
    "    initial step 0;\n"
    "    step 1 { ON; }\n"
    "    transition t0: 0 -> 1 when A;\n"
    "    transition t1: 1 -> 0 when 2s/X1;\n"
    "}\n"
    "closed_loop all {\n"
    "    controller blinking;\n"
    "    environment Any = free(OUT = A);\n"
    "    property never_on \"it stays dark\": never ON;\n"
    "    property ends: reachable X1 && !A;\n"
    "    property broken expected violated: never X1;\n"
    "}\n";

std::vector<std::string> titles(const Json& lenses) {
    std::vector<std::string> found;
    for (const Json& lens : lenses) found.push_back(lens["command"]["title"]);
    return found;
}

TEST(LspProofs, ReportViolationsWithTheirSteps) {
    Client client;
    client.begin();
    client.open(address, blinking);
    EXPECT_EQ(client.diagnostics(address), Json::array());
    const Json document = {{"textDocument", {{"uri", address}}}};
    EXPECT_EQ(titles(client.result("textDocument/codeLens", document)),
              (std::vector<std::string>{"check", "draw", "simulate", "check", "simulate", "not checked; check now",
                                        "not checked; check now", "not checked; check now"}));
    client.notify("textDocument/didSave", document);
    const Json published = client.next("textDocument/publishDiagnostics", [](const Json& params) {
        return !params["diagnostics"].empty();
    })["diagnostics"];
    ASSERT_EQ(published.size(), 1U) << published;
    EXPECT_EQ(published[0]["message"], "`never_on` is violated: it stays dark");
    EXPECT_EQ(published[0]["code"], "violated");
    EXPECT_EQ(published[0]["range"]["start"]["line"], 11);
    const Json related = published[0]["relatedInformation"];
    ASSERT_GE(related.size(), 2U);
    EXPECT_EQ(related.back()["location"]["range"]["start"]["line"], 5) << related;
    EXPECT_NE(related.back()["message"].get<std::string>().find("clears t0; active: 1"), std::string::npos) << related;

    EXPECT_EQ(titles(client.result("textDocument/codeLens", document)),
              (std::vector<std::string>{"check", "draw", "simulate", "check", "simulate", "violated", "holds",
                                        "violated, as expected"}));
    const Json verdict = client.result("workspace/executeCommand",
                                       {{"command", "grafverif.showVerdict"}, {"arguments", {address, "all", "ends"}}});
    EXPECT_EQ(verdict["verdict"], "holds");
    EXPECT_NE(verdict["text"].get<std::string>().find("timed engine"), std::string::npos) << verdict["text"];

    // A change discards all results.
    client.retype(address, 2, blinking + "\n");
    EXPECT_EQ(client.diagnostics(address, 2), Json::array());
    EXPECT_EQ(titles(client.result("textDocument/codeLens", document)).back(), "not checked; check now");
}

TEST(LspProofs, AgreeWithCheck) {
    const ParseResult reading = read_string(blinking, "blinking");
    ASSERT_TRUE(reading.model);
    Diagnostics diagnostics;
    const auto report = check(*reading.model, Id<ClosedLoop>{0}, {}, {}, diagnostics);
    ASSERT_TRUE(report);
    Client client;
    client.begin();
    client.open(address, blinking);
    client.result("workspace/executeCommand", {{"command", "grafverif.check"}, {"arguments", {address}}});
    client.next("textDocument/publishDiagnostics", [](const Json& params) { return !params["diagnostics"].empty(); });
    for (const PropertyResult& answer : report->answers) {
        const Json shown = client.result(
            "workspace/executeCommand",
            {{"command", "grafverif.showVerdict"}, {"arguments", {address, "all", answer.verdict.property}}});
        EXPECT_TRUE(shown["verdict"].get<std::string>().starts_with(word(answer.verdict.outcome)))
            << answer.verdict.property;
    }
}

TEST(LspProofs, ReportFindingsOfAnalyse) {
    Client client;
    client.begin();
    client.open(
        address,
        "grafcet a {\n    input A;\n    initial step 0;\n    step 1;\n    transition t0: 0 -> 1 when A && !A;\n}\n");
    client.notify("textDocument/didSave", {{"textDocument", {{"uri", address}}}});
    const Json published = client.next("textDocument/publishDiagnostics", [](const Json& params) {
        return !params["diagnostics"].empty();
    })["diagnostics"];
    std::vector<std::string> codes;
    for (const Json& each : published) codes.push_back(each["code"]);
    EXPECT_NE(std::ranges::find(codes, "step-never-active"), codes.end()) << published;
}

TEST(LspProofs, ReportErrorsOfTheDerivedModels) {
    Client client;
    client.begin();
    client.open(address,
                "grafcet a {\n    input A;\n    internal N: int 0..3;\n    initial step 0;\n    transition t: 0 -> 0 "
                "when A do N := 9;\n}\n");
    const Json published =
        client.next("textDocument/publishDiagnostics", [](const Json&) { return true; })["diagnostics"];
    ParseResult reading = read_string(
        "grafcet a {\n    input A;\n    internal N: int 0..3;\n    initial step 0;\n    transition t: 0 -> 0 when A do "
        "N := 9;\n}\n",
        "a");
    if (reading.model) equations_of(*reading.model, Id<Chart>{0}, reading.diagnostics);
    EXPECT_EQ(published.size(), reading.diagnostics.all().size());
}

TEST(LspProofs, AreCancelledByTheNextChange) {
    // The search takes long, because the chart has many timers that start at arbitrary times.
    std::string chart = "grafcet long {\n    input A", steps, environment;
    for (int k = 0; k < 12; ++k) {
        chart += ", I" + std::to_string(k);
        steps += "    partial P" + std::to_string(k) +
                 " {\n        initial step 0;\n        step 1;\n        transition 0 -> 1 when I" + std::to_string(k) +
                 ";\n        transition 1 -> 0 when " + std::to_string(k + 7) + "s/X1;\n    }\n";
        environment += "    environment E" + std::to_string(k) + " = free(OUT = I" + std::to_string(k) + ");\n";
    }
    const std::string text =
        chart + ";\n" + steps + "}\nclosed_loop l {\n    controller long;\n    environment E = free(OUT = A);\n" +
        environment + "    property p: never P0.X1 && P1.X1 && P2.X1 && P3.X1 && A && P11.X1 && false;\n}\n";
    Client client;
    client.begin({{"window", {{"workDoneProgress", true}}}});
    client.open(address, text);
    EXPECT_EQ(client.diagnostics(address), Json::array());
    client.notify("textDocument/didSave", {{"textDocument", {{"uri", address}}}});
    const Json create = client.request("window/workDoneProgress/create");
    client.send({{"jsonrpc", "2.0"}, {"id", create["id"]}, {"result", nullptr}});
    EXPECT_EQ(client.next("$/progress", [](const Json&) { return true; })["value"]["kind"], "begin");
    client.retype(address, 2, blinking);
    EXPECT_EQ(
        client.next("$/progress", [](const Json& params) { return params["value"]["kind"] == "end"; })["value"]["kind"],
        "end");
    client.notify("textDocument/didSave", {{"textDocument", {{"uri", address}}}});
    const Json published = client.next("textDocument/publishDiagnostics", [](const Json& params) {
        return !params["diagnostics"].empty();
    })["diagnostics"];
    EXPECT_EQ(published[0]["message"], "`never_on` is violated: it stays dark");
}

TEST(LspProofs, DrawTheOpenText) {
    Client client;
    client.begin();
    client.open(address, blinking);
    const Json drawn =
        client.result("workspace/executeCommand", {{"command", "grafverif.draw"}, {"arguments", {address}}});
    EXPECT_TRUE(drawn["svg"].get<std::string>().starts_with("<")) << drawn;
    const Json refused = client.answer(client.send_request(
        "workspace/executeCommand", {{"command", "grafverif.draw"}, {"arguments", {"file:///no"}}}));
    EXPECT_EQ(refused["error"]["code"], -32803);
}

}  // namespace
}  // namespace grafverif::lsp
