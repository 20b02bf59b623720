// SPDX-License-Identifier: MIT
// Fuzz target for messages that a client sends to the MCP server.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "fuzz/targets.hpp"
#include "mcp/server.hpp"

namespace grafverif::fuzz {

namespace {

using Json = nlohmann::json;

/// Stub that replaces the execution of commands. Depending on the number of arguments, it prints a result of `check`, a
/// drawing, or an error.
ProgramResult command(const mcp::CommandRun& run) {
    const std::string_view verdicts =
        R"({"model":"m","properties":[{"name":"p","text":null,"file":null,"line":null,"column":null,"verdict":"unknown",)"
        R"("expected":"holds","declared":true,"reason":"r","vacuous":false,"notes":["n"],"assumptions":"a",)"
        R"("trace_text":null,"trace":null}]})";
    switch (run.arguments.size() % 3) {
    case 0: return {ProgramResult::End::Exited, 0, std::string(verdicts), ""};
    case 1: return {ProgramResult::End::Exited, 0, "<svg/>", "warning"};
    default: return {ProgramResult::End::Exited, 2, "", "error"};
    }
}

/// Returns the violated rule of JSON-RPC 2.0, or an empty string.
std::string message_complaint(const Json& message) {
    if (!message.is_object() || message.value("jsonrpc", "") != "2.0") return "not a message of JSON-RPC 2.0";
    if (message.contains("method"))
        return message["method"] == "notifications/progress" && !message.contains("id") ? "" : "an unknown request";
    if (!message.contains("id")) return "a response without an id";
    if (message.contains("result") == message.contains("error")) return "a result and an error, or neither";
    const bool silent = message.contains("error") && message["error"].value("message", "").empty();
    return silent ? "an error without a text" : "";
}

}  // namespace

std::string mcp_complaint(std::string_view bytes) {
    std::string stream =
        R"({"jsonrpc":"2.0","id":"begin","method":"initialize","params":{"protocolVersion":"2025-03-26"}})"
        "\n";
    stream += bytes;
    stream +=
        "\n"
        R"({"jsonrpc":"2.0","id":"end","method":"ping"})"
        "\n";
    mcp::ServerEnvironment environment;
    environment.folders = {"/nowhere"};
    environment.execute = command;
    std::size_t at = 0;
    const auto receive = [&](std::span<char> buffer) {
        const std::size_t count = std::min(buffer.size(), stream.size() - at);
        std::copy_n(stream.begin() + static_cast<std::ptrdiff_t>(at), count, buffer.begin());
        at += count;
        return count;
    };
    std::string complaint;
    bool begun = false, ended = false;
    const auto send = [&](std::string_view line) {
        const Json sent = Json::parse(line, nullptr, false);
        if (sent.is_discarded() || line.find('\n') != line.size() - 1) complaint = "not one line of JSON";
        for (const Json& message : sent.is_array() ? sent : Json::array({sent})) {
            if (std::string found = message_complaint(message); !found.empty())
                complaint = found + ": " + message.dump();
            begun = begun || message.value("id", Json()) == "begin";
            ended = ended || message.value("id", Json()) == "end";
        }
        return true;
    };
    mcp::converse(receive, send, environment);
    if (complaint.empty() && (!begun || !ended)) complaint = "a request has no response";
    return complaint;
}

}  // namespace grafverif::fuzz
