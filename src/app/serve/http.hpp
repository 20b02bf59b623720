// SPDX-License-Identifier: MIT
// HttpServer: serves pages to browsers of this user on this computer. The server listens on 127.0.0.1 and, if
// available, on [::1]. A request must name one of these addresses as its Host, must not come from another page
// (Origin), and must contain the token. Therefore neither pages of other sites nor other users of the computer have
// access. The size, duration and number of requests are bounded.
//
// One thread reads and writes; other threads compute responses. The response to a request can be delayed until `notify`
// is called.
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
    std::string path = {};                          ///< path such as `/state`
    std::map<std::string, std::string> query = {};  ///< decoded query parameters
    std::string body = {};
};

struct HttpAnswer {
    unsigned status = 200;
    std::string type = "application/json";
    std::string body = {};
};

/// Returns the response. An empty result means that the request waits for `notify`; an empty result is not allowed if
/// `at_once` is true. Called from several threads.
using HttpHandler = std::function<std::optional<HttpAnswer>(const HttpRequest&, bool at_once)>;

struct HttpOptions {
    std::uint16_t port = 0;  ///< 0 selects any free port
    std::string token = {};
    std::size_t largest_body = std::size_t{1} << 20U;
    /// Maximum number of connections. If another client connects, the oldest connection whose token has not been read
    /// is closed; if there is no such connection, the new connection is closed.
    std::size_t most_connections = 64;
    int longest_wait = 20;  ///< maximum delay of a response in seconds
};

class HttpServer {
public:
    /// Starts listening. Throws std::system_error if listening fails, for example because the port
    /// is in use.
    HttpServer(const HttpOptions& options, HttpHandler handler);
    ~HttpServer();
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

    std::uint16_t port() const;
    /// Serves until `stop` is set.
    void run(const std::atomic<bool>& stop);
    /// Calls the handler again for the waiting requests. Thread-safe.
    void notify();

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace grafverif::app
