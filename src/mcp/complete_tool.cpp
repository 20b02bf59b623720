// SPDX-License-Identifier: MIT
// Implements the tool `complete`, which returns the names and keywords that are valid at a position. A language server
// that runs only for this call determines these names and keywords.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>

#include "mcp/tools.hpp"
#include "rpc/framing.hpp"
#include "rpc/message.hpp"
#include "rpc/uri.hpp"

namespace grafverif::mcp {

namespace {

using Kind = Argument::Kind;

constexpr std::size_t most_proposals = 200;
constexpr int completion_id = 2;

/// Returns the name of a kind of proposal (LSP 3.17, "CompletionItemKind").
std::string kind_word(int kind) {
    static const std::map<int, std::string> words = {
        {3, "transition"}, {5, "parameter"}, {6, "variable"},  {7, "component"}, {9, "chart or loop"},
        {10, "property"},  {14, "keyword"},  {20, "location"}, {21, "constant"}, {23, "step"}};
    const auto found = words.find(kind);
    return found != words.end() ? found->second : "other";
}

std::string conversation(const std::string& uri, const std::string& text, std::int64_t line, std::int64_t column) {
    std::string messages;
    const auto say = [&](Json message) {
        message["jsonrpc"] = "2.0";
        messages += rpc::framed(rpc::text_of(message));
    };
    const Json document = {{"uri", uri}, {"languageId", "grafcet"}, {"version", 1}, {"text", text}};
    const Json position = {{"line", line - 1}, {"character", column - 1}};
    say({{"id", 1}, {"method", "initialize"}, {"params", {{"capabilities", Json::object()}}}});
    say({{"method", "initialized"}, {"params", Json::object()}});
    say({{"method", "textDocument/didOpen"}, {"params", {{"textDocument", document}}}});
    say({{"id", completion_id},
         {"method", "textDocument/completion"},
         {"params", {{"textDocument", {{"uri", uri}}}, {"position", position}}}});
    say({{"id", completion_id + 1}, {"method", "shutdown"}});
    say({{"method", "exit"}});
    return messages;
}

/// Returns the response to the request for proposals from the output `bytes` of the language server.
Json response_in(const std::string& bytes) {
    std::size_t at = 0;
    rpc::Framing framing([&](std::span<char> buffer) {
        const std::size_t count = std::min(buffer.size(), bytes.size() - at);
        std::memcpy(buffer.data(), bytes.data() + at, count);
        at += count;
        return count;
    });
    while (const auto framed = framing.next()) {
        const Json message = Json::parse(framed->body, nullptr, false);
        if (rpc::member(message, "id") == completion_id && message.contains("result")) return message["result"];
    }
    throw CallError{"the language server sent no proposals"};
}

ToolResult complete(ToolCall& call) {
    const std::string text = call.content();
    const std::string file =
        call.file() ? call.file()->string() : call.environment().folders.front() + "/unsaved.grafcet";
    const ProgramResult served = call.execute_language_server(
        conversation(rpc::uri_of_path(file), text, call.number("line", 1), call.number("column", 1)));
    ToolResult result;
    Json proposals = Json::array();
    for (const Json& item : first_of(response_in(served.out).at("items"), most_proposals)) {
        const std::string detail = item.value("detail", "");
        proposals.push_back(
            {{"label", item.at("label")}, {"kind", kind_word(item.at("kind").get<int>())}, {"detail", detail}});
        result.text += fmt::format("{}{}{}\n", item.at("label").get<std::string>(), detail.empty() ? "" : "  ", detail);
    }
    result.data = {{"proposals", std::move(proposals)}};
    return result;
}

}  // namespace

Tool complete_tool() {
    Tool tool{"complete", "Complete a name or keyword",
              "Returns the names and keywords that are valid at a position of a `.grafcet` file, also in an incomplete "
              "declaration.",
              input_arguments()};
    constexpr std::int64_t most = 100'000'000;
    tool.arguments.push_back({.name = "line",
                              .kind = Kind::Number,
                              .description = "line, from 1",
                              .required = true,
                              .least = 1,
                              .most = most});
    tool.arguments.push_back({.name = "column",
                              .kind = Kind::Number,
                              .description = "column of the cursor in UTF-16 units, from 1",
                              .required = true,
                              .least = 1,
                              .most = most});
    tool.output_schema = {
        {"type", "object"},
        {"properties",
         {{"proposals",
           {{"type", "array"},
            {"items",
             {{"type", "object"},
              {"properties",
               {{"label", {{"type", "string"}}}, {"kind", {{"type", "string"}}}, {"detail", {{"type", "string"}}}}},
              {"required", Json::array({"label", "kind"})}}}}}}},
        {"required", Json::array({"proposals"})}};
    tool.run = complete;
    return tool;
}

}  // namespace grafverif::mcp
