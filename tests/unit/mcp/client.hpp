// SPDX-License-Identifier: MIT
// A client of the MCP server in the same process. The client sends lines and receives the messages
// of the server.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "mcp/server.hpp"

namespace grafverif::mcp {

using Json = nlohmann::json;

class Client {
public:
    explicit Client(ServerEnvironment environment) : environment_(std::move(environment)) {
        environment_.hang_up = [this] { hang_up(); };
        server_ = std::thread([this] {
            converse([this](std::span<char> buffer) { return give(buffer); },
                     [this](std::string_view bytes) { return take(bytes); }, environment_);
            const std::lock_guard hold(door_);
            ended_ = true;
            wake_.notify_all();
        });
    }
    ~Client() {
        hang_up();
        server_.join();
    }
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    // -- bytes
    void write(std::string_view bytes) {
        const std::lock_guard hold(door_);
        to_server_ += bytes;
        wake_.notify_all();
    }
    void hang_up() {
        const std::lock_guard hold(door_);
        gone_ = true;
        wake_.notify_all();
    }
    /// From now on, the client does not accept any bytes.
    void stop_reading() {
        const std::lock_guard hold(door_);
        reads_ = false;
    }
    bool ends() {
        std::unique_lock hold(door_);
        return wake_.wait_for(hold, time_limit, [this] { return ended_; });
    }

    // -- messages
    void send(const Json& message) { write(message.dump() + '\n'); }
    void notify(const std::string& method, const Json& params = Json::object()) {
        send({{"jsonrpc", "2.0"}, {"method", method}, {"params", params}});
    }
    int send_request(const std::string& method, const Json& params = Json::object()) {
        send({{"jsonrpc", "2.0"}, {"id", ++last_}, {"method", method}, {"params", params}});
        return last_;
    }
    /// Returns the first message for which `matches` is true, and removes it.
    template <class Matches>
    Json wait(const Matches& matches) {
        std::unique_lock hold(door_);
        Json found;
        const bool arrived = wake_.wait_for(hold, time_limit, [&] {
            for (std::size_t at = 0; at < messages_.size() && found.is_null(); ++at)
                if (matches(messages_[at])) {
                    found = messages_[at];
                    messages_.erase(messages_.begin() + static_cast<std::ptrdiff_t>(at));
                }
            return !found.is_null();
        });
        EXPECT_TRUE(arrived) << "no such message within the time limit";
        return found;
    }
    Json answer(const Json& id) {
        return wait([&](const Json& message) { return message.is_object() && message.value("id", Json()) == id; });
    }
    Json request(const std::string& method, const Json& params = Json::object()) {
        return answer(send_request(method, params));
    }
    Json result(const std::string& method, const Json& params = Json::object()) {
        const Json response = request(method, params);
        EXPECT_TRUE(response.contains("result")) << response.dump();
        return response.value("result", Json::object());
    }
    int error_code(const std::string& method, const Json& params = Json::object()) {
        const Json response = request(method, params);
        return response.contains("error") ? response["error"]["code"].get<int>() : 0;
    }
    Json begin(const std::string& version = "2025-06-18") {
        const Json found = result("initialize", {{"protocolVersion", version},
                                                 {"capabilities", Json::object()},
                                                 {"clientInfo", {{"name", "test"}, {"version", "1"}}}});
        notify("notifications/initialized");
        return found;
    }
    Json call(const std::string& tool, const Json& arguments) {
        return result("tools/call", {{"name", tool}, {"arguments", arguments}});
    }
    std::size_t received() {
        const std::lock_guard hold(door_);
        return messages_.size();
    }

private:
    static constexpr std::chrono::seconds time_limit{60};

    std::size_t give(std::span<char> buffer) {
        std::unique_lock hold(door_);
        wake_.wait(hold, [this] { return gone_ || !to_server_.empty(); });
        const std::size_t count = std::min<std::size_t>(buffer.size(), to_server_.size());
        std::copy_n(to_server_.begin(), count, buffer.begin());
        to_server_.erase(0, count);
        return count;
    }
    bool take(std::string_view bytes) {
        const std::lock_guard hold(door_);
        if (!reads_) return false;
        EXPECT_EQ(bytes.find('\n'), bytes.size() - 1) << "a message must be one line";
        messages_.push_back(Json::parse(bytes));
        wake_.notify_all();
        return true;
    }

    ServerEnvironment environment_;
    std::mutex door_ = {};
    std::condition_variable wake_ = {};
    std::string to_server_ = {};
    std::vector<Json> messages_ = {};
    bool gone_ = false, reads_ = true, ended_ = false;
    int last_ = 0;
    std::thread server_ = {};
};

}  // namespace grafverif::mcp
