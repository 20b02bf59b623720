// SPDX-License-Identifier: MIT
// Session: the state of one client of the MCP server, and the handlers of its messages. Only one thread may use a
// session.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mcp/call_runner.hpp"
#include "mcp/server.hpp"
#include "mcp/tools.hpp"

namespace grafverif::mcp {

class Session {
public:
    /// Schedules a call in the thread of the session. Any thread may call this function.
    using Later = std::function<void(std::function<void()>)>;
    Session(const Send& send, const ServerEnvironment& environment, Later later);

    /// Handles a message: a request, a notification, a response, or a batch of such messages.
    void take(const Json& message);
    /// Sends an error response to invalid input.
    void refuse(const std::string& error_text);
    /// Sends progress notifications for the calls for which the client has requested progress.
    void report_progress();
    /// True if the client has disappeared.
    bool disconnected() const { return disconnected_; }

private:
    /// The responses to a batch of messages (MCP 2025-03-26), which are sent as one message.
    struct Batch {
        std::size_t open = 0;  ///< number of calls without a result, plus 1 while the batch is read
        Json responses = Json::array();
    };
    using SharedBatch = std::shared_ptr<Batch>;
    /// A call of a tool that is waiting or running.
    struct ActiveCall {
        std::uint64_t number = 0;  ///< distinguishes calls with the same id
        std::shared_ptr<Work> work = {};
        SharedBatch batch = {};
        std::string tool = {};
        Json progress_token = {};  ///< null if the client has not requested progress
        std::chrono::steady_clock::time_point begun = {}, reported = {};
        std::int64_t timeout_s = 0;
    };

    /// True if the negotiated version of the protocol supports structured results.
    bool structured() const;
    void send(const Json& message);
    void reply(Json message, const SharedBatch& batch);
    void take_batch(const Json& messages);
    void take_single(const Json& message, const SharedBatch& batch);
    void notified(const std::string& method, const Json& params);
    void request(const Json& id, const std::string& method, const Json& params, const SharedBatch& batch);
    Json answer(const std::string& method, const Json& params);
    Json initialize(const Json& params);
    static Json read_resource(const Json& params);
    void call(const Json& id, const Json& params, const SharedBatch& batch);
    void finished(const Json& id, std::uint64_t number, Json result);
    Json result_of(const Tool& tool, const Json& arguments, const std::atomic<bool>& stop) const;
    void close(const SharedBatch& batch);

    const Send& send_;
    const ServerEnvironment& environment_;
    Later later_;
    std::vector<Tool> tools_;
    std::string version_ = {};  ///< negotiated version of the protocol; empty before `initialize`
    bool disconnected_ = false;
    std::uint64_t last_call_ = 0;
    std::map<Json, ActiveCall> calls_ = {};  ///< active calls by request id
    CallRunner runner_;                      ///< declared last, so that its threads end first
};

}  // namespace grafverif::mcp
