// SPDX-License-Identifier: MIT
// Tests the life cycle of a session, and invalid messages.
#include <random>

#include "unit/lsp/client.hpp"

namespace grafverif::lsp {
namespace {

const std::string good = "grafcet a {\n    input A;\n    initial step 0;\n    transition t0: 0 -> 0 when A;\n}\n";

int code_of(const Json& answer) { return answer.contains("error") ? answer["error"].value("code", 0) : 0; }

TEST(LspServer, ListsItsCapabilitiesAndEndsOnRequest) {
    Client client({.version = "1.2"});
    const Json answer = client.begin();
    EXPECT_EQ(answer["serverInfo"]["name"], "grafverif");
    EXPECT_EQ(answer["serverInfo"]["version"], "1.2");
    EXPECT_EQ(answer["capabilities"]["textDocumentSync"]["change"], 2);
    EXPECT_TRUE(client.result("shutdown", nullptr).is_null());
    EXPECT_EQ(code_of(client.answer(client.send_request("textDocument/hover", Json::object()))), -32600);
    client.notify("exit", nullptr);
    EXPECT_EQ(client.ending(), Ending::Requested);
}

TEST(LspServer, EndsWithoutShutdownAndReportsIt) {
    Client client;
    client.begin();
    client.notify("exit", nullptr);
    EXPECT_EQ(client.ending(), Ending::Unrequested);
}

TEST(LspServer, EndsWithTheClientEvenDuringAMessage) {
    Client client;
    client.begin();
    client.write("Content-Length: 100\r\n\r\n{\"jsonrpc\"");
    client.hang_up();
    EXPECT_EQ(client.ending(), Ending::Gone);
}

TEST(LspServer, EndsIfTheClientsProcessIsGone) {
    Client client({.is_alive = [](std::int64_t process) { return process != 77; }});
    client.result("initialize", {{"processId", 77}, {"rootUri", nullptr}, {"capabilities", Json::object()}});
    EXPECT_EQ(client.ending(), Ending::Gone);
}

TEST(LspServer, RequiresInitializationFirstAndOnce) {
    Client client;
    EXPECT_EQ(code_of(client.answer(client.send_request("textDocument/hover", Json::object()))), -32002);
    client.open(address, "nothing of this is looked at");
    client.begin();
    const Json again = client.answer(client.send_request("initialize", Json::object()));
    EXPECT_EQ(code_of(again), -32600);
    EXPECT_EQ(again["error"]["message"], "the server is already initialized");
    EXPECT_EQ(code_of(client.answer(client.send_request("no/such", Json::object()))), -32601);
    EXPECT_EQ(client.waiting(), 0U);
}

TEST(LspServer, AnswersInvalidInputAndContinues) {
    Client client;
    client.begin();
    struct Case {
        std::string bytes = {};
        int code = 0;
        Json id = nullptr;
    };
    const std::vector<Case> cases = {
        {framed("{\"jsonrpc\":"), -32700},
        {framed("\xFF\xFE{}"), -32700},
        {framed(""), -32700},
        {framed(std::string(5000, '[')), -32700},
        {framed("[]"), -32600},
        {framed("17"), -32600},
        {framed(R"({"id": 900, "method": 5})"), -32600, 900},
        {framed(R"({"id": "x", "method": "textDocument/codeAction", "params": [1]})"), -32602, "x"},
        {framed(R"({"id": 901, "method": "textDocument/codeAction"})"), -32602, 901},
        {"rubbish\r\n\r\n" + framed(R"({"id": 902, "method": "no/such"})"), -32601, 902},
        {"Content-Type: x\r\ncontent-length:  33  \r\n\r\n"
         R"({"id": 903, "method": "no/such!"})",
         -32601, 903},
        {"Content-Length: 99999999999999999999\r\nContent-Length: 2\r\n\r\n{}", -32600},
    };
    for (const Case& each : cases) {
        SCOPED_TRACE(each.bytes.substr(0, 80));
        client.write(each.bytes);
        EXPECT_EQ(code_of(client.answer(each.id)), each.code);
    }
    client.open(address, good);
    EXPECT_EQ(client.diagnostics(address), Json::array());
}

TEST(LspServer, SkipsAMessageThatIsTooLarge) {
    std::string stream = "Content-Length: 1000\r\n\r\n" + std::string(1000, ' ') + framed("{}");
    rpc::Framing framing(
        [&](std::span<char> buffer) {
            const std::size_t count = std::min<std::size_t>({buffer.size(), stream.size(), 7});
            std::copy_n(stream.begin(), count, buffer.begin());
            stream.erase(0, count);
            return count;
        },
        999);
    const auto first = framing.next(), second = framing.next();
    ASSERT_TRUE(first && second);
    EXPECT_EQ(first->error_text, "a message of 1000 bytes exceeds the limit of 999");
    EXPECT_EQ(second->body, "{}");
    EXPECT_FALSE(framing.next());
}

TEST(LspServer, AnswersARequestThatIsCancelledInTime) {
    Client client;
    client.begin();
    std::string bytes;
    for (int id = 5000; id < 5200; ++id)
        bytes += framed(Json{{"id", id}, {"method", "textDocument/codeAction"}, {"params", Json::object()}}.dump());
    bytes += framed(R"({"method": "$/cancelRequest", "params": {"id": 5199}})");
    bytes += framed(R"({"method": "$/cancelRequest", "params": {"id": "no such"}})");
    bytes += framed(R"({"method": "$/cancelRequest"})");
    client.write(bytes);
    for (int id = 5000; id < 5199; ++id) client.answer(id);
    const int code = code_of(client.answer(5199));
    EXPECT_TRUE(code == -32800 || code == -32602) << code;  // the server may have answered the request already
}

TEST(LspServer, AcceptsMessagesSplitAnywhere) {
    Client client;
    client.begin();
    std::string bytes =
        framed(Json{{"method", "textDocument/didOpen"},
                    {"params",
                     {{"textDocument", {{"uri", address}, {"languageId", "grafcet"}, {"version", 1}, {"text", good}}}}}}
                   .dump()) +
        framed(R"({"id": "last", "method": "no/such"})");
    for (const char byte : bytes) client.write(std::string(1, byte));
    EXPECT_EQ(code_of(client.answer("last")), -32601);
    EXPECT_EQ(client.diagnostics(address), Json::array());
}

TEST(LspServer, SurvivesDamagedStreams) {
    std::mt19937 random(14);
    const std::string message = framed(Json{
        {"method", "textDocument/didOpen"},
        {"params", {{"textDocument", {{"uri", address}, {"languageId", "grafcet"}, {"version", 1}, {"text", good}}}}}}
                                           .dump());
    const std::string request = framed(
        Json{{"id", 1}, {"method", "textDocument/codeAction"}, {"params", {{"textDocument", {{"uri", address}}}}}}
            .dump());
    for (int round = 0; round < 60; ++round) {
        Client client;
        client.begin();
        std::string bytes;
        for (int k = 0; k < 4; ++k) bytes += k % 2 == 0 ? message : request;
        for (int hits = 0; hits < 4; ++hits) {
            const std::size_t at = random() % bytes.size();
            switch (random() % 3) {
            case 0: bytes[at] = static_cast<char>(random() % 256); break;
            case 1: bytes.erase(at, random() % 40); break;
            default: bytes.insert(at, bytes.substr(random() % bytes.size(), random() % 60)); break;
            }
        }
        client.write(bytes + "\n\n" + std::string(400, ' ') + "\n");
        client.write(framed(R"({"id": "alive", "method": "no/such"})"));
        client.write(framed(R"({"id": "alive", "method": "no/such"})"));
        client.hang_up();  // a damaged header may hide the rest, but the session ends nevertheless
        EXPECT_EQ(client.ending(), Ending::Gone) << round;
    }
}

}  // namespace
}  // namespace grafverif::lsp
