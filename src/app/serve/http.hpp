// SPDX-License-Identifier: MIT
// HttpServer: pages for browsers on this machine, and for nobody else. It listens on 127.0.0.1 and, where there is one,
// on [::1]; a request must name one of these as its Host, come from no other page (Origin), and bring the token, so that
// no page of another site and no other user of the machine reaches it. Requests are bounded in size, time and number.
//
// One thread reads and writes; answers are made by a few others. An answer may be put off until something happens.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace grafverif::app {

struct HttpRequest {
    bool post = false;
    std::string path = {};                          ///< `/state`
    std::map<std::string, std::string> query = {};  ///< decoded
    std::string body = {};
};

struct HttpAnswer {
    unsigned status = 200;
    std::string type = "application/json";
    std::string body = {};
};

/// The answer, or nothing: the request waits for `notify`. With `at_once` there must be one. Called from several threads.
using HttpHandler = std::function<std::optional<HttpAnswer>(const HttpRequest&, bool at_once)>;

struct HttpOptions {
    std::uint16_t port = 0;  ///< 0: any that is free
    std::string token = {};
    std::size_t largest_body = std::size_t{1} << 20U;
    /// With more, the oldest whose token has not been read is closed; if there is none, the new one.
    std::size_t most_connections = 64;
    int longest_wait = 20;  ///< seconds, of an answer put off
};

class HttpServer {
public:
    /// Listens. Throws std::system_error where it cannot: the port is in use.
    HttpServer(const HttpOptions& options, HttpHandler handler);
    ~HttpServer();
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

    std::uint16_t port() const;
    /// Serves until `stop` is set.
    void run(const std::atomic<bool>& stop);
    /// Requests that wait are asked again. From any thread.
    void notify();

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace grafverif::app
