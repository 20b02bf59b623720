// SPDX-License-Identifier: MIT
// Tests the protocol of the MCP server; functions of the tests replace the commands.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <vector>

#include "unit/mcp/client.hpp"

namespace grafverif::mcp {
namespace {

using namespace std::chrono_literals;

/// An environment whose commands wait until they are cancelled or `open` is true, and then print a drawing.
struct Gate {
    std::atomic<bool> open = false;
    std::atomic<int> started = 0, cancelled = 0, running = 0;

    ServerEnvironment environment() {
        ServerEnvironment made;
        made.version = "1.2.3";
        made.folders = {"/"};
        made.progress_interval = 1ms;
        made.execute = [this](const CommandRun& run) {
            ++started, ++running;
            while (!open && !*run.stop) std::this_thread::sleep_for(1ms);
            --running;
            if (*run.stop) ++cancelled;
            return ProgramResult{*run.stop ? ProgramResult::End::Stopped : ProgramResult::End::Exited, 0, "<svg/>", ""};
        };
        return made;
    }
    void await(const std::atomic<int>& count, int least) const {
        for (int k = 0; k < 60'000 && count < least; ++k) std::this_thread::sleep_for(1ms);
        EXPECT_GE(count, least);
    }
};

const Json drawing = {{"name", "draw"}, {"arguments", {{"text", "grafcet a {}"}}}};

TEST(McpProtocol, NegotiatesTheVersion) {
    for (const char* version : {"2024-11-05", "2025-03-26", "2025-06-18", "2099-01-01"}) {
        SCOPED_TRACE(version);
        Gate gate;
        Client client(gate.environment());
        const Json found = client.begin(version);
        EXPECT_EQ(found["protocolVersion"], std::string(version) == "2099-01-01" ? "2025-06-18" : version);
        EXPECT_EQ(found["serverInfo"]["name"], "grafverif");
        EXPECT_EQ(found["serverInfo"]["version"], "1.2.3");
        EXPECT_TRUE(found["capabilities"].contains("tools"));
        EXPECT_TRUE(found["capabilities"].contains("resources"));
        const bool structured = version >= std::string("2025-06-18");
        const Json listed = client.result("tools/list");
        for (const Json& tool : listed["tools"]) {
            EXPECT_EQ(tool.contains("outputSchema"), structured && tool["name"] != "draw") << tool["name"];
            EXPECT_EQ(tool["inputSchema"]["type"], "object");
            EXPECT_EQ(tool["inputSchema"]["properties"]["timeout"]["maximum"], 600);
            if (tool.contains("outputSchema")) {
                for (const Json& name : tool["outputSchema"]["required"])
                    EXPECT_TRUE(tool["outputSchema"]["properties"].contains(name)) << tool["name"] << name;
            }
        }
    }
}

TEST(McpProtocol, RejectsRequestsBeforeInitialization) {
    Gate gate;
    Client client(gate.environment());
    EXPECT_EQ(client.request("ping")["result"], Json::object());
    EXPECT_EQ(client.error_code("tools/list"), -32600);
    EXPECT_EQ(client.error_code("tools/call", drawing), -32600);
    EXPECT_EQ(client.error_code("initialize", {{"protocolVersion", 5}}), -32602);
    EXPECT_EQ(client.error_code("initialize"), -32602);
    client.begin();
    EXPECT_EQ(client.error_code("initialize", {{"protocolVersion", "2025-06-18"}}), -32600);
    EXPECT_EQ(gate.started, 0);
}

TEST(McpProtocol, RejectsInvalidMessagesAndContinues) {
    Gate gate;
    Client client(gate.environment());
    client.begin();
    const auto error_of = [&](const std::string& line) {
        client.write(line + "\n");
        return client.wait([](const Json& message) { return message.contains("error"); });
    };
    struct Case {
        std::string line;
        int code;
        Json id = nullptr;
    };
    const std::vector<Case> cases = {
        {"nonsense", -32700},
        {"{\"jsonrpc\":", -32700},
        {"\xFF\xFE{}", -32700},
        {std::string(1000, '['), -32700},
        {"{\"a\":" + std::string(100'000, '{'), -32700},
        {std::string(largest_message + 1, 'x'), -32700},
        {"17", -32600},
        {"{}", -32600},
        {"[]", -32600},
        {R"([{"jsonrpc":"2.0","id":1,"method":"ping"}])", -32600},
        {R"({"id":1,"method":"ping"})", -32600, 1},
        {R"({"jsonrpc":"2.0","id":null,"method":"ping"})", -32600},
        {R"({"jsonrpc":"2.0","id":1.5,"method":"ping"})", -32600},
        {R"({"jsonrpc":"2.0","id":7,"method":5})", -32600, 7},
        {R"({"jsonrpc":"2.0","id":7,"method":"ping","params":[1]})", -32602, 7},
        {R"({"jsonrpc":"2.0","id":"x","method":"no/such"})", -32601, "x"},
        {R"({"jsonrpc":"2.0","id":8,"method":"tools/list","params":{"cursor":"2"}})", -32602, 8},
        {R"({"jsonrpc":"2.0","id":8,"method":"tools/call"})", -32602, 8},
        {R"({"jsonrpc":"2.0","id":8,"method":"tools/call","params":{"name":"chek"}})", -32602, 8},
        {R"({"jsonrpc":"2.0","id":8,"method":"tools/call","params":{"name":"draw","arguments":5}})", -32602, 8},
        {R"({"jsonrpc":"2.0","id":8,"method":"resources/read","params":{"uri":"file:///etc/passwd"}})", -32002, 8},
        {R"({"jsonrpc":"2.0","id":8,"method":"resources/read"})", -32602, 8},
    };
    for (const Case& each : cases) {
        SCOPED_TRACE(each.line.substr(0, 100));
        const Json found = error_of(each.line);
        EXPECT_EQ(found["error"]["code"], each.code);
        EXPECT_EQ(found["id"], each.id);
    }
    client.write("\n\r\n   \n");
    client.write(R"({"jsonrpc":"2.0","method":"no/such"})"
                 "\n");
    client.write(R"({"jsonrpc":"2.0","id":99,"result":{}})"
                 "\n");
    client.notify("notifications/cancelled");
    client.notify("notifications/cancelled", {{"requestId", "no such"}});
    EXPECT_EQ(client.request("ping")["result"], Json::object());
    EXPECT_EQ(client.received(), 0U);
}

TEST(McpProtocol, DividesTheStreamIntoLinesOfAnyLength) {
    std::string stream = "one\n\n" + std::string(11, 'x') + "\n  \ntwo\r\n" + std::string(10, 'y') + "\nlast";
    rpc::LineFraming framing(
        [&](std::span<char> buffer) {
            const std::size_t count = std::min<std::size_t>({buffer.size(), stream.size(), 3});
            std::copy_n(stream.begin(), count, buffer.begin());
            stream.erase(0, count);
            return count;
        },
        10);
    std::vector<std::string> bodies;
    while (const auto framed = framing.next())
        bodies.push_back(framed->error_text.empty() ? framed->body : framed->error_text);
    EXPECT_EQ(bodies, (std::vector<std::string>{"one", "a message of 11 bytes exceeds the limit of 10", "two\r",
                                                "yyyyyyyyyy", "last"}));
}

TEST(McpProtocol, RejectsWrongArguments) {
    Gate gate;
    gate.open = true;
    Client client(gate.environment());
    client.begin();
    const auto message_of = [&](const std::string& tool, const Json& arguments) {
        const Json found = client.request("tools/call", {{"name", tool}, {"arguments", arguments}});
        EXPECT_EQ(found.value("/error/code"_json_pointer, 0), -32602) << found.dump();
        return found.value("/error/message"_json_pointer, "");
    };
    EXPECT_EQ(message_of("chek", {}), "unknown tool `chek`; did you mean `check`?");
    EXPECT_EQ(message_of("draw", {{"fil", "a"}}), "unknown argument `fil`; did you mean `file`?");
    EXPECT_EQ(message_of("draw", {{"file", 5}}), "the argument `file` must be a string");
    EXPECT_EQ(message_of("draw", {{"file", ""}}), "the argument `file` must not be empty");
    EXPECT_EQ(message_of("draw", {{"file", std::string("a\0b", 3)}}),
              "the argument `file` must not contain the character NUL");
    EXPECT_EQ(message_of("draw", {{"file", std::string(5000, 'a')}}),
              "the argument `file` must have at most 4096 bytes");
    EXPECT_EQ(message_of("draw", {{"text", std::string("\0", 1)}}),
              "the argument `text` must not contain the character NUL");
    EXPECT_EQ(message_of("draw", {{"text", ""}, {"notation", "none"}}),
              "the argument `notation` must be one of iec, text");
    EXPECT_EQ(message_of("draw", {{"text", ""}, {"timeout", 0}}),
              "the argument `timeout` must be an integer from 1 to 600");
    EXPECT_EQ(message_of("draw", {{"text", ""}, {"timeout", 1.5}}),
              "the argument `timeout` must be an integer from 1 to 600");
    EXPECT_EQ(message_of("draw", {{"text", ""}, {"timeout", 18446744073709551615ULL}}),
              "the argument `timeout` must be an integer from 1 to 600");
    EXPECT_EQ(message_of("check", {{"text", ""}, {"property", "P"}}),
              "the argument `property` must be a list of strings");
    EXPECT_EQ(message_of("check", {{"text", ""}, {"property", {1}}}),
              "the argument `property` has an invalid element: each element must be a string");
    EXPECT_EQ(message_of("check", {{"text", ""}, {"untimed", "yes"}}), "the argument `untimed` must be true or false");
    EXPECT_EQ(message_of("explain", {{"text", ""}}), "the argument `property` is missing");
    EXPECT_EQ(gate.started, 0);
}

TEST(McpProtocol, RunsTwoCallsAtTheSameTime) {
    Gate gate;
    Client client(gate.environment());
    client.begin();
    const int one = client.send_request("tools/call", drawing), other = client.send_request("tools/call", drawing);
    gate.await(gate.running, 2);
    EXPECT_EQ(client.request("ping")["result"], Json::object());  // the server responds during the calls
    gate.open = true;
    for (const int id : {other, one}) EXPECT_EQ(client.answer(id)["result"]["content"][0]["text"], "<svg/>");
}

TEST(McpProtocol, CancelsARunningCallWithoutResponse) {
    Gate gate;
    Client client(gate.environment());
    client.begin();
    const int id = client.send_request("tools/call", drawing);
    gate.await(gate.started, 1);
    client.notify("notifications/cancelled", {{"requestId", id}, {"reason", "test"}});
    gate.await(gate.cancelled, 1);
    EXPECT_EQ(client.request("ping")["result"], Json::object());
    EXPECT_EQ(client.received(), 0U);
    gate.open = true;
    EXPECT_EQ(client.call("draw", drawing["arguments"])["isError"], false);
}

TEST(McpProtocol, ReportsProgressWithIncreasingValues) {
    Gate gate;
    Client client(gate.environment());
    client.begin();
    Json params = drawing;
    params["_meta"] = {{"progressToken", "token"}};
    const int id = client.send_request("tools/call", params);
    double last = -1;
    for (int k = 0; k < 3; ++k) {
        const Json found = client.wait([](const Json& message) { return message.contains("method"); });
        EXPECT_EQ(found["method"], "notifications/progress");
        EXPECT_EQ(found["params"]["progressToken"], "token");
        EXPECT_EQ(found["params"]["total"], 60);
        EXPECT_GT(found["params"]["progress"], last);
        last = found["params"]["progress"];
    }
    gate.open = true;
    EXPECT_EQ(client.answer(id)["result"]["isError"], false);
}

TEST(McpProtocol, LimitsTheCallsThatWaitAndRun) {
    Gate gate;
    Client client(gate.environment());
    client.begin();
    constexpr int calls = 200;
    std::vector<int> ids;
    for (int k = 0; k < calls; ++k) ids.push_back(client.send_request("tools/call", drawing));
    gate.await(gate.started, static_cast<int>(most_running));
    EXPECT_EQ(client.request("ping")["result"], Json::object());
    EXPECT_EQ(gate.started, static_cast<int>(most_running));
    gate.open = true;
    int accepted = 0, rejected = 0;
    for (const int id : ids) {
        const Json found = client.answer(id);
        if (found.contains("result")) ++accepted;
        else if (found["error"]["code"] == -32000) ++rejected;
    }
    EXPECT_EQ(accepted + rejected, calls);
    EXPECT_GE(accepted, static_cast<int>(most_waiting));
    EXPECT_LE(accepted, static_cast<int>(most_waiting + most_running));
}

/// While the client does not accept a response, the server reads only a few more messages.
TEST(McpProtocol, ReadsNoFurtherMessagesOfAFloodWhileTheClientDoesNotRead) {
    constexpr std::size_t pings = 20'000;
    std::string flood;
    for (std::size_t k = 0; k < pings; ++k)
        flood += Json{{"jsonrpc", "2.0"}, {"id", k}, {"method", k % 2 == 0 ? "ping" : "no such method"}}.dump() + '\n';
    const std::size_t longest = 100;  // more than the length of each of these messages
    std::atomic<std::size_t> given = 0, answers = 0;
    std::atomic<bool> open = false, blocked = false;
    std::thread server([&] {
        converse(
            [&](std::span<char> buffer) {
                const std::size_t count = std::min({buffer.size(), longest, flood.size() - given});
                std::copy_n(flood.begin() + static_cast<std::ptrdiff_t>(given), count, buffer.begin());
                given += count;
                return count;
            },
            [&](std::string_view bytes) {
                blocked = true;
                while (!open) std::this_thread::sleep_for(1ms);
                EXPECT_EQ(Json::parse(bytes)["id"], answers.load());
                ++answers;
                return true;
            },
            Gate().environment());
    });
    while (!blocked) std::this_thread::sleep_for(1ms);
    std::size_t last = 0;
    do {
        last = given;
        std::this_thread::sleep_for(100ms);
    } while (given != last);
    EXPECT_LT(given, (most_messages + 4) * longest);
    open = true;
    server.join();
    EXPECT_EQ(answers, pings);
}

TEST(McpProtocol, EndsWithRunningCallsIfTheClientDisappears) {
    for (const bool reads : {true, false}) {
        Gate gate;
        Client client(gate.environment());
        client.begin();
        for (int k = 0; k < 10; ++k) client.send_request("tools/call", drawing);
        gate.await(gate.running, static_cast<int>(most_running));
        if (reads) client.hang_up();
        else {
            client.stop_reading();
            client.send_request("ping");
        }
        EXPECT_TRUE(client.ends());
        EXPECT_EQ(gate.cancelled, static_cast<int>(most_running));
        EXPECT_EQ(gate.started, static_cast<int>(most_running));
    }
}

TEST(McpProtocol, AnswersBatchesOfVersion20250326) {
    Gate gate;
    gate.open = true;
    Client client(gate.environment());
    client.begin("2025-03-26");
    const Json ping = {{"jsonrpc", "2.0"}, {"id", "a"}, {"method", "ping"}};
    const Json call = {{"jsonrpc", "2.0"}, {"id", "b"}, {"method", "tools/call"}, {"params", drawing}};
    client.send(Json::array({ping, call, 5, {{"jsonrpc", "2.0"}, {"method", "notifications/initialized"}}}));
    const Json found = client.wait([](const Json& message) { return message.is_array(); });
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0]["id"], "a");
    EXPECT_EQ(found[1]["error"]["code"], -32600);
    EXPECT_EQ(found[2]["id"], "b");
    client.send(Json::array({{{"jsonrpc", "2.0"}, {"method", "notifications/initialized"}}}));
    client.send(Json::array());
    EXPECT_EQ(client.wait([](const Json& message) { return message.contains("error"); })["error"]["code"], -32600);
    client.send(Json::array_t(most_messages + 1, ping));
    EXPECT_TRUE(client.wait([](const Json& message) { return message.contains("error"); })["error"]["message"]
                    .get<std::string>()
                    .starts_with("the batch has more than 64 messages"));
    EXPECT_EQ(client.received(), 0U);
}

TEST(McpProtocol, ReportsTheEndOfACommandAsAnErrorOfTheTool) {
    struct Case {
        ProgramResult end;
        std::string text;
    };
    const std::vector<Case> cases = {
        {{ProgramResult::End::Signalled, 11, "", ""}, "terminated by signal 11"},
        {{ProgramResult::End::TimedOut, 0, "", ""}, "time limit"},
        {{ProgramResult::End::TooMuchOutput, 0, "", ""}, "too large"},
        {{ProgramResult::End::Exited, 4, "", "assertion"}, "assertion"},
        {{ProgramResult::End::Exited, 2, "", "file:1:1: error: x"}, "file:1:1: error: x"},
        {{ProgramResult::End::Exited, 0, "no JSON", ""}, "no result"},
        {{ProgramResult::End::Exited, 0, "{}", ""}, "unexpected output"},
    };
    for (const Case& each : cases) {
        Gate gate;
        ServerEnvironment environment = gate.environment();
        environment.execute = [&](const CommandRun&) { return each.end; };
        Client client(environment);
        client.begin();
        const Json found = client.call("check", {{"text", ""}});
        EXPECT_EQ(found["isError"], true);
        EXPECT_NE(found["content"][0]["text"].get<std::string>().find(each.text), std::string::npos) << found.dump();
    }
}

TEST(McpProtocol, OffersTheReferenceAndTheLibraryAsResources) {
    Gate gate;
    Client client(gate.environment());
    client.begin();
    const Json list = client.result("resources/list")["resources"];
    EXPECT_GT(list.size(), 30U);
    for (const Json& each : list) {
        const Json content = client.result("resources/read", {{"uri", each["uri"]}})["contents"][0];
        EXPECT_EQ(content["uri"], each["uri"]);
        EXPECT_EQ(content["text"].get<std::string>().size(), each["size"]);
    }
    const auto text = [&](const char* uri) {
        return client.result("resources/read", {{"uri", uri}})["contents"][0]["text"].get<std::string>();
    };
    EXPECT_TRUE(text("grafverif://reference/language").starts_with("# "));
    EXPECT_NE(text("grafverif://component/free").find("component free"), std::string::npos);
    EXPECT_EQ(client.result("resources/templates/list")["resourceTemplates"], Json::array());
}

}  // namespace
}  // namespace grafverif::mcp
