// SPDX-License-Identifier: MIT
#include "mcp/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>
#include <system_error>
#include <utility>

#include "mcp/resources.hpp"
#include "rpc/message.hpp"
#include "support/memory_reserve.hpp"
#include "support/printable.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif::mcp {

using rpc::member;
using rpc::RequestError;

namespace {

/// Supported versions of the protocol, in ascending order.
constexpr std::array versions = {"2024-11-05", "2025-03-26", "2025-06-18"};
constexpr std::string_view with_batches = "2025-03-26", with_structured_results = "2025-06-18";

/// JSON-RPC 2.0 reserves the codes from -32000 to -32099 for errors of the server.
constexpr int too_many_calls = -32000, resource_not_found = -32002;

constexpr const char* instructions =
    "grafverif verifies controllers written in GRAFCET (IEC 60848) in closed loop with a model of their plant. "
    "Read the resources `grafverif://reference/...` before you write a `.grafcet` file. `read` lists the models and "
    "properties of a file, `check` decides the properties, and `explain` shows the counterexample of one property. "
    "The tools do not write files; pass `text` to check a draft. Results state their assumptions; repeat the "
    "assumptions when you report a verdict.";

}  // namespace

Session::Session(const Send& send, const ServerEnvironment& environment, Later later)
    : send_(send),
      environment_(environment),
      later_(std::move(later)),
      tools_(tools(environment)),
      runner_(most_running, most_waiting) {}

bool Session::structured() const { return version_ >= with_structured_results; }

void Session::send(const Json& message) {
    if (!disconnected_ && !send_(rpc::text_of(message) + '\n')) disconnected_ = true;
}

void Session::reply(Json message, const SharedBatch& batch) {
    if (batch == nullptr) send(message);
    else batch->responses.push_back(std::move(message));
}

void Session::refuse(const std::string& error_text) { send(rpc::failure(nullptr, rpc::parse_error, error_text)); }

// -- messages ---------------------------------------------------------------------------------------------------------

void Session::take(const Json& message) {
    if (message.is_array()) take_batch(message);
    else take_single(message, nullptr);
}

void Session::take_batch(const Json& messages) {
    if (version_ != with_batches || messages.empty())
        return send(rpc::failure(nullptr, rpc::invalid_request,
                                 messages.empty()
                                     ? "the batch is empty"
                                     : "this version of the protocol does not support batches; send single messages"));
    if (messages.size() > most_messages)
        return send(
            rpc::failure(nullptr, rpc::invalid_request,
                         fmt::format("the batch has more than {} messages; send several batches", most_messages)));
    const auto batch = std::make_shared<Batch>();
    batch->open = 1;
    for (const Json& message : messages) take_single(message, batch);
    close(batch);
}

/// Called when a call of a batch has ended, and when all messages of the batch have been read. After the last of these
/// events, sends the responses.
void Session::close(const SharedBatch& batch) {
    if (batch != nullptr && --batch->open == 0 && !batch->responses.empty()) send(batch->responses);
}

void Session::take_single(const Json& message, const SharedBatch& batch) {
    const Json& id = member(message, "id");
    const bool has_id = message.is_object() && message.contains("id");
    const auto refused = [&](const std::string& why) {
        reply(rpc::failure(rpc::is_id(id) ? id : Json(), rpc::invalid_request, why), batch);
    };
    const bool is_response = rpc::is_id(id) && (message.contains("result") || message.contains("error"));
    // A response is ignored, because the server sends no requests.
    if (is_response && !message.contains("method")) return;
    const std::string method = rpc::method_of(message);
    if (method.empty() || member(message, "jsonrpc") != "2.0")
        return refused("the message is not a request or notification of JSON-RPC 2.0");
    if (has_id && !rpc::is_id(id)) return refused("the id of a request must be a string or an integer");
    const Json& params = member(message, "params");
    if (!params.is_null() && !params.is_object()) {
        if (has_id) reply(rpc::failure(id, rpc::invalid_params, "`params` must be an object"), batch);
        return;
    }
    if (has_id) request(id, method, params, batch);
    else notified(method, params);
}

void Session::notified(const std::string& method, const Json& params) {
    if (method != "notifications/cancelled") return;
    const auto found = calls_.find(member(params, "requestId"));
    if (found == calls_.end()) return;
    found->second.work->stop = true;
    const SharedBatch batch = found->second.batch;
    calls_.erase(found);  // no response is sent to a cancelled request
    close(batch);
}

void Session::request(const Json& id, const std::string& method, const Json& params, const SharedBatch& batch) {
    try {
        if (calls_.contains(id)) throw RequestError{rpc::invalid_request, "a request with this id is in progress"};
        if (method == "tools/call" && !version_.empty()) return call(id, params, batch);
        reply(rpc::response(id, answer(method, params)), batch);
    } catch (const RequestError& refusal) {
        reply(rpc::failure(id, refusal.code, refusal.message), batch);
    } catch (const std::bad_alloc&) {
        reply(rpc::failure(id, rpc::internal_error, "out of memory"), batch);
    } catch (const std::system_error& failure) {
        reply(rpc::failure(id, rpc::internal_error, failure.what()), batch);
    }
}

Json Session::answer(const std::string& method, const Json& params) {
    if (method == "ping") return Json::object();
    if (method == "initialize") return initialize(params);
    if (version_.empty())
        throw RequestError{rpc::invalid_request, "the server is not initialized; send `initialize` first"};
    const bool is_list = method == "tools/list" || method == "resources/list" || method == "resources/templates/list";
    if (is_list && params.is_object() && params.contains("cursor"))
        throw RequestError{rpc::invalid_params, "unknown cursor; omit `cursor`, because each list has only one page"};
    if (method == "tools/list") return tool_list(tools_, structured());
    if (method == "resources/list") return resource_list();
    if (method == "resources/templates/list") return {{"resourceTemplates", Json::array()}};
    if (method == "resources/read") return read_resource(params);
    throw RequestError{rpc::no_such_method, "unsupported method " + printable(method.substr(0, longest_name))};
}

Json Session::initialize(const Json& params) {
    if (!version_.empty()) throw RequestError{rpc::invalid_request, "the server is already initialized"};
    const Json& requested = member(params, "protocolVersion");
    if (!requested.is_string()) throw RequestError{rpc::invalid_params, "`protocolVersion` must be a string"};
    const auto known = std::ranges::find_if(versions, [&](const char* each) { return requested == each; });
    version_ = known != versions.end() ? *known : versions.back();
    Json info = {{"name", "grafverif"}, {"version", environment_.version}};
    if (structured()) info["title"] = "grafverif";
    return {{"protocolVersion", version_},
            {"capabilities", {{"tools", Json::object()}, {"resources", Json::object()}}},
            {"serverInfo", std::move(info)},
            {"instructions", instructions}};
}

Json Session::read_resource(const Json& params) {
    const Json& uri = member(params, "uri");
    if (!uri.is_string()) throw RequestError{rpc::invalid_params, "`uri` must be a string"};
    auto content = resource_content(uri.get_ref<const std::string&>());
    if (!content) throw RequestError{resource_not_found, "unknown resource; `resources/list` lists all resources"};
    return std::move(*content);
}

// -- calls ------------------------------------------------------------------------------------------------------------

void Session::call(const Json& id, const Json& params, const SharedBatch& batch) {
    const Json& name = member(params, "name");
    if (!name.is_string()) throw RequestError{rpc::invalid_params, "`name` must be a string"};
    const auto tool = std::ranges::find_if(tools_, [&](const Tool& each) { return name == each.name; });
    if (tool == tools_.end()) {
        std::vector<std::string> names;
        for (const Tool& each : tools_) names.push_back(each.name);
        const std::string unknown = printable(name.get<std::string>().substr(0, longest_name));
        throw RequestError{rpc::invalid_params, unknown_name_text("tool", unknown, names)};
    }
    const Json arguments = params.contains("arguments") ? params["arguments"] : Json::object();
    if (const std::string error = argument_error(tool->arguments, arguments); !error.empty())
        throw RequestError{rpc::invalid_params, error};
    const Json& token = member(member(params, "_meta"), "progressToken");
    ActiveCall active{++last_call_, std::make_shared<Work>(), batch, tool->name, rpc::is_id(token) ? token : Json()};
    active.begun = active.reported = std::chrono::steady_clock::now();
    active.timeout_s = arguments.value("timeout", environment_.default_timeout_s());
    active.work->run = [this, id, number = active.number, tool = &*tool, arguments](const std::atomic<bool>& stop) {
        Json made = result_of(*tool, arguments, stop);
        const ReserveUse use(true);
        const auto result = std::make_shared<Json>(std::move(made));
        later_([this, id, number, result] { finished(id, number, std::move(*result)); });
    };
    if (!runner_.submit(active.work))
        throw RequestError{too_many_calls, "too many calls are waiting; wait for their results"};
    if (batch != nullptr) ++batch->open;
    calls_.emplace(id, std::move(active));
}

void Session::finished(const Json& id, std::uint64_t number, Json result) {
    const auto found = calls_.find(id);
    // The result is discarded, because the call was cancelled.
    if (found == calls_.end() || found->second.number != number) return;
    const ActiveCall call = std::move(found->second);
    calls_.erase(found);
    reply(rpc::response(id, std::move(result)), call.batch);
    close(call.batch);
}

/// Executes a call of a tool and returns its result. Worker threads call this function.
Json Session::result_of(const Tool& tool, const Json& arguments, const std::atomic<bool>& stop) const {
    const auto content = [](const std::string& text) { return Json{{"type", "text"}, {"text", text}}; };
    const auto failed = [&](const std::string& why) {
        const ReserveUse use(true);
        return Json{{"content", Json::array({content(why)})}, {"isError", true}};
    };
    try {
        ToolCall call(environment_, arguments, stop);
        ToolResult result = tool.run(call);
        Json made = {{"content", Json::array({content(result.text)})}, {"isError", false}};
        if (!result.data.is_null() && structured()) made["structuredContent"] = std::move(result.data);
        else if (!result.data.is_null()) made["content"].push_back(content(rpc::text_of(result.data)));
        return made;
    } catch (const CallError& failure) {
        return failed(failure.text);
    } catch (const std::bad_alloc&) {
        return failed("there is not enough memory for the result");
    } catch (const std::system_error& failure) {
        return failed(failure.what());
    } catch (const Json::exception& failure) {
        return failed(fmt::format("internal error: unexpected output of a command: {}", failure.what()));
    } catch (const std::exception& failure) {
        return failed(fmt::format("internal error: {}", failure.what()));
    }
}

void Session::report_progress() {
    const auto now = std::chrono::steady_clock::now();
    for (auto& [id, call] : calls_) {
        if (call.progress_token.is_null() || now - call.reported < environment_.progress_interval) continue;
        call.reported = now;
        const double seconds = std::chrono::duration<double>(now - call.begun).count();
        send({{"jsonrpc", "2.0"},
              {"method", "notifications/progress"},
              {"params",
               {{"progressToken", call.progress_token},
                {"progress", seconds},
                {"total", call.timeout_s},
                {"message", fmt::format("{}: {:.0f} s of at most {} s", call.tool, seconds, call.timeout_s)}}}});
    }
}

}  // namespace grafverif::mcp
