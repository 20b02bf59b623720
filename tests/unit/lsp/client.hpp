// SPDX-License-Identifier: MIT
// A client of the language server in the same process. The client sends messages in arbitrary
// pieces and receives the responses.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "lsp/server.hpp"
#include "lsp/text.hpp"
#include "rpc/uri.hpp"

namespace grafverif::lsp {

using rpc::framed;
using Json = nlohmann::json;

/// The URI of a text that is not on disk.
inline constexpr const char* address = "file:///nowhere/a.grafcet";

class Client {
public:
    explicit Client(ServerEnvironment surroundings = {}) : surroundings_(std::move(surroundings)) {
        surroundings_.hang_up = [this] { hang_up(); };
        server_ = std::thread([this] {
            const Ending ending = converse([this](std::span<char> buffer) { return give(buffer); },
                                           [this](std::string_view bytes) { take(bytes); }, surroundings_);
            const std::lock_guard hold(door_);
            ending_ = ending;
            wake_.notify_all();
        });
    }
    ~Client() {
        hang_up();
        server_.join();
    }

    // -- bytes
    void write(std::string_view bytes) {
        const std::lock_guard hold(door_);
        to_server_ += bytes;
        wake_.notify_all();
    }
    void hang_up() {
        const std::lock_guard hold(door_);
        disconnected_ = true;
        wake_.notify_all();
    }
    /// Waits until the stream ends.
    Ending ending() {
        std::unique_lock hold(door_);
        wake_.wait_for(hold, time_limit, [this] { return ending_.has_value(); });
        EXPECT_TRUE(ending_.has_value());
        return ending_.value_or(Ending::Gone);
    }

    // -- messages
    void send(const Json& message) { write(framed(message.dump())); }
    void notify(const std::string& method, const Json& params) {
        send({{"jsonrpc", "2.0"}, {"method", method}, {"params", params}});
    }
    int send_request(const std::string& method, const Json& params) {
        send({{"jsonrpc", "2.0"}, {"id", ++last_}, {"method", method}, {"params", params}});
        return last_;
    }
    /// Returns the complete response to the request with the id `id`.
    Json answer(const Json& id) {
        return wait([&](const Json& message) {
            return !message.contains("method") && message.contains("id") && message["id"] == id;
        });
    }
    Json result(const std::string& method, const Json& params) {
        const Json whole = answer(send_request(method, params));
        EXPECT_TRUE(whole.contains("result")) << method << ' ' << whole;
        return whole.value("result", Json());
    }
    /// Returns the next notification of the method `method` that satisfies `that`, and discards earlier notifications.
    template <class That>
    Json next(const std::string& method, That that) {
        return wait([&](const Json& message) {
            return message.value("method", "") == method && that(message["params"]);
        })["params"];
    }
    /// Returns the next complete request of the method `method` from the server.
    Json request(const std::string& method) {
        return wait(
            [&](const Json& message) { return message.value("method", "") == method && message.contains("id"); });
    }
    std::size_t waiting() {
        const std::lock_guard hold(door_);
        return arrived_.size();
    }

    // -- sessions
    Json begin(const Json& capabilities = Json::object(), const std::string& folder = "") {
        Json params = {{"processId", nullptr}, {"rootUri", nullptr}, {"capabilities", capabilities}};
        if (!folder.empty())
            params["workspaceFolders"] = Json::array({{{"uri", rpc::uri_of_path(folder)}, {"name", "w"}}});
        Json answered = result("initialize", params);
        notify("initialized", Json::object());
        return answered;
    }
    void open(const std::string& uri, const std::string& text) {
        notify("textDocument/didOpen",
               {{"textDocument", {{"uri", uri}, {"languageId", "grafcet"}, {"version", 1}, {"text", text}}}});
    }
    /// Replaces the complete text.
    void retype(const std::string& uri, int version, const std::string& text) {
        notify("textDocument/didChange", {{"textDocument", {{"uri", uri}, {"version", version}}},
                                          {"contentChanges", Json::array({{{"text", text}}})}});
    }
    /// Returns the next diagnostics of `uri` with the given version, or with any version if it is 0.
    Json diagnostics(const std::string& uri, int version = 0) {
        return next("textDocument/publishDiagnostics", [&](const Json& params) {
            return params["uri"] == uri && (version == 0 || params.value("version", 0) == version);
        })["diagnostics"];
    }

private:
    static constexpr std::chrono::seconds time_limit{60};

    std::size_t give(std::span<char> buffer) {
        std::unique_lock hold(door_);
        wake_.wait(hold, [this] { return disconnected_ || !to_server_.empty(); });
        const std::size_t count = std::min(buffer.size(), to_server_.size());
        std::copy_n(to_server_.begin(), count, buffer.begin());
        to_server_.erase(0, count);
        return count;
    }

    void take(std::string_view bytes) {
        const std::lock_guard hold(door_);
        const std::size_t body = bytes.find("\r\n\r\n");
        EXPECT_NE(body, std::string_view::npos);
        arrived_.push_back(Json::parse(bytes.substr(body + 4)));
        wake_.notify_all();
    }

    template <class That>
    Json wait(That that) {
        std::unique_lock hold(door_);
        auto found = arrived_.end();
        const bool there = wake_.wait_for(hold, time_limit, [&] {
            found = std::ranges::find_if(arrived_, that);
            return found != arrived_.end();
        });
        EXPECT_TRUE(there) << "no message arrived";
        if (!there) return Json::object({{"params", {{"diagnostics", Json::array()}}}});
        Json message = *found;
        arrived_.erase(found);
        return message;
    }

    ServerEnvironment surroundings_;
    std::mutex door_ = {};
    std::condition_variable wake_ = {};
    std::string to_server_ = {};
    bool disconnected_ = false;
    std::vector<Json> arrived_ = {};
    std::optional<Ending> ending_ = {};
    int last_ = 0;
    std::thread server_ = {};
};

/// A temporary folder for one test.
class Folder {
public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "grafverif-lsp-XXXXXX").string();
        path_ = ::mkdtemp(name.data()) != nullptr ? name : "";
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const std::string& path() const { return path_; }
    std::string file(const std::string& name) const { return path_ + "/" + name; }
    std::string uri(const std::string& name) const { return rpc::uri_of_path(file(name)); }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(file(name), std::ios::binary) << text;
    }

private:
    std::string path_ = {};
};

}  // namespace grafverif::lsp
