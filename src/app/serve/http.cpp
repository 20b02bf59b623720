// SPDX-License-Identifier: MIT
#include "app/serve/http.hpp"

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <list>
#include <set>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace grafverif::app {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using Tcp = asio::ip::tcp;

constexpr std::size_t largest_header = 16384;
constexpr auto longest_transfer = std::chrono::seconds(5);
constexpr std::size_t answering_threads = 4;

/// Compares texts of equal length in constant time.
bool equal(std::string_view one, std::string_view other) {
    bool same = one.size() == other.size();
    for (std::size_t k = 0; k < one.size() && k < other.size(); ++k) same = (one[k] == other[k]) & same;
    return same;
}

int digit_of(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    const char small = static_cast<char>(c | 0x20);
    return small >= 'a' && small <= 'f' ? small - 'a' + 10 : -1;
}

/// Decodes escapes such as `%41` (`A`).
std::string decoded(std::string_view text) {
    std::string plain;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const int high = text[k] == '%' && k + 2 < text.size() ? digit_of(text[k + 1]) : -1;
        const int low = high >= 0 ? digit_of(text[k + 2]) : -1;
        plain += low < 0 ? text[k] : static_cast<char>(high * 16 + low);
        if (low >= 0) k += 2;
    }
    return plain;
}

std::map<std::string, std::string> query_of(std::string_view text) {
    std::map<std::string, std::string> query;
    while (!text.empty()) {
        const std::string_view part = text.substr(0, text.find('&'));
        const std::size_t sign = std::min(part.find('='), part.size());
        query[decoded(part.substr(0, sign))] = decoded(part.substr(std::min(sign + 1, part.size())));
        text.remove_prefix(std::min(part.size() + 1, text.size()));
    }
    return query;
}

std::string_view text_of(boost::beast::string_view view) { return {view.data(), view.size()}; }

[[noreturn]] void refuse(const boost::system::error_code& error, const std::string& what) {
    throw std::system_error(error.value(), std::generic_category(), what);
}

/// Sets the headers of every response. The headers forbid caching, loading or embedding by other sites, guessing of
/// media types, and sending the address of the page as a referrer.
template <class Message>
void set_headers(Message& message) {
    message.set(http::field::cache_control, "no-store");
    message.set("X-Content-Type-Options", "nosniff");
    message.set("X-Frame-Options", "SAMEORIGIN");
    message.set("Referrer-Policy", "no-referrer");
    message.set("Cross-Origin-Resource-Policy", "same-origin");
}

/// Threads for the handler: as many as the system permits, at most `answering_threads`. Throws if no thread can be
/// started. asio::thread_pool is not suitable: its constructor waits forever if the system permits some threads but not
/// all.
class HandlerThreads {
public:
    HandlerThreads() {
        threads_.reserve(answering_threads);
        try {
            while (threads_.size() < answering_threads) threads_.emplace_back([this] { context_.run(); });
        } catch (...) {
            if (threads_.empty()) throw;
        }
    }
    ~HandlerThreads() { join(); }
    HandlerThreads(const HandlerThreads&) = delete;
    HandlerThreads& operator=(const HandlerThreads&) = delete;

    asio::io_context& context() { return context_; }
    void stop() { context_.stop(); }
    /// Waits until the threads have no more work, and then ends the threads.
    void join() {
        work_.reset();
        threads_.clear();
    }

private:
    asio::io_context context_ = asio::io_context(static_cast<int>(answering_threads));
    asio::executor_work_guard<asio::io_context::executor_type> work_ = asio::make_work_guard(context_);
    std::vector<std::jthread> threads_ = {};
};

}  // namespace

class HttpServer::Impl {
public:
    Impl(const HttpOptions& options, HttpHandler handler) : options_(options), handler_(std::move(handler)) {
        for (int tries = 0; acceptors_.empty(); ++tries) listen(tries);
    }

    ~Impl() {
        context_.stop();
        threads_.join();
    }

    std::uint16_t port() const { return acceptors_.front().local_endpoint().port(); }

    void run(const std::atomic<bool>& stop) {
        for (Tcp::acceptor& acceptor : acceptors_) accept(acceptor);
        poll_stop_flag(stop);
        context_.run();
        threads_.stop();
        threads_.join();
    }

    void notify() {
        ++notices_;
        asio::post(context_, [this] {
            for (const std::shared_ptr<Connection>& waiting : std::exchange(waiting_, {})) waiting->call_handler(false);
        });
    }

private:
    /// A connection, which serves one request.
    class Connection : public std::enable_shared_from_this<Connection> {
    public:
        Connection(Impl& server, Tcp::socket socket)
            : server_(server),
              stream_(std::move(socket)),
              timer_(server.context_),
              place_(server.unidentified_.insert(server.unidentified_.end(), this)) {}
        ~Connection() {
            if (state_ == State::Unidentified) server_.unidentified_.erase(place_);
            if (state_ == State::Identified) --server_.identified_;
        }

        /// Closes this connection, so that another connection can be accepted.
        void drop() {
            state_ = State::Dropped;
            server_.unidentified_.erase(place_);
            close();
        }

        void begin() {
            parser_.header_limit(largest_header);
            parser_.body_limit(server_.options_.largest_body);
            stream_.expires_after(longest_transfer);
            http::async_read_header(
                stream_, buffer_, parser_,
                [self = shared_from_this()](beast::error_code error, std::size_t) { self->header_is_read(error); });
        }

        /// Calls the handler in one of the threads of `threads_`.
        void call_handler(bool at_once) {
            timer_.cancel();
            asio::post(server_.threads_.context(), [self = shared_from_this(), at_once]() mutable {
                const std::uint64_t notices = self->server_.notices_;
                std::optional<HttpAnswer> answer;
                try {
                    answer = self->server_.handler_(self->request_, at_once);
                } catch (const std::bad_alloc&) {
                    answer = HttpAnswer{503, "text/plain", "out of memory\n"};
                } catch (const std::exception&) {
                    answer = HttpAnswer{500, "text/plain", "internal error\n"};
                }
                Impl& server = self->server_;  // only the thread of the server releases connections
                asio::post(server.context_, [self = std::move(self), notices, answer = std::move(answer)]() mutable {
                    if (answer) return self->answer(std::move(*answer));
                    // If an event occurred during the call of the handler, the request may be waiting for this event.
                    self->server_.notices_ == notices ? self->wait() : self->call_handler(false);
                });
            });
        }

    private:
        void header_is_read(beast::error_code error) {
            if (error == http::error::end_of_stream || error == beast::error::timeout || state_ == State::Dropped)
                return close();
            if (error == http::error::body_limit) return refuse(413, "the request is too large");
            if (error == http::error::header_limit) return refuse(431, "the header of the request is too large");
            if (error) return refuse(400, "malformed request");
            if (auto [status, why] = server_.reason_to_reject(parser_.get()); status != 0) return refuse(status, why);
            if (server_.has_token(parser_.get())) identify();
            http::async_read(stream_, buffer_, parser_,
                             [self = shared_from_this()](beast::error_code failure, std::size_t) {
                                 if (failure == http::error::body_limit)
                                     return self->refuse(413, "the request is too large");
                                 if (failure) return self->close();
                                 self->request_is_read();
                             });
        }

        void identify() {
            state_ = State::Identified;
            server_.unidentified_.erase(place_);
            ++server_.identified_;
        }

        void request_is_read() {
            const std::string_view target = text_of(parser_.get().target());
            const std::size_t mark = std::min(target.find('?'), target.size());
            request_.post = parser_.get().method() == http::verb::post;
            request_.path = std::string(target.substr(0, mark));
            request_.query = query_of(target.substr(std::min(mark + 1, target.size())));
            request_.body = std::move(parser_.get().body());
            last_moment_ = std::chrono::steady_clock::now() + std::chrono::seconds(server_.options_.longest_wait);
            stream_.expires_never();
            call_handler(false);
        }

        void wait() {
            if (disconnected_) return close();
            if (!std::exchange(watched_, true)) watch();
            server_.waiting_.insert(shared_from_this());
            timer_.expires_at(last_moment_);
            timer_.async_wait([self = shared_from_this()](beast::error_code error) {
                if (!error && self->server_.waiting_.erase(self) != 0) self->call_handler(true);
            });
        }

        /// Detects that the client has disconnected, so that another connection can be accepted. Ignores data that the
        /// client sends.
        void watch() {
            stream_.async_read_some(asio::buffer(rest_),
                                    [self = shared_from_this()](beast::error_code error, std::size_t) {
                                        error ? self->leave() : self->watch();
                                    });
        }

        void leave() {
            disconnected_ = true;
            timer_.cancel();
            if (server_.waiting_.erase(shared_from_this()) != 0) close();
        }

        void refuse(unsigned status, const std::string& why) { answer({status, "text/plain", why + "\n"}); }

        void answer(HttpAnswer answer) {
            response_.version(11);
            response_.result(answer.status);
            set_headers(response_);
            response_.set(http::field::content_type, answer.type + "; charset=utf-8");
            response_.body() = std::move(answer.body);
            response_.keep_alive(false);
            response_.prepare_payload();
            stream_.expires_after(longest_transfer);
            http::async_write(stream_, response_,
                              [self = shared_from_this()](beast::error_code, std::size_t) { self->linger(); });
        }

        /// Reads and ignores remaining input of the client for a short time. Closing the connection immediately would
        /// discard the response.
        void linger() {
            beast::error_code ignored;
            stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
            if (parser_.is_done()) return close();
            stream_.async_read_some(asio::buffer(rest_),
                                    [self = shared_from_this()](beast::error_code error, std::size_t) {
                                        error ? self->close() : self->linger();
                                    });
        }

        void close() {
            beast::error_code ignored;
            stream_.socket().close(ignored);
        }

        enum class State { Unidentified, Identified, Dropped };

        Impl& server_;
        beast::tcp_stream stream_;
        asio::steady_timer timer_;
        std::list<Connection*>::iterator place_;
        State state_ = State::Unidentified;
        beast::flat_buffer buffer_ = beast::flat_buffer(largest_header * 2);
        http::request_parser<http::string_body> parser_ = {};
        http::response<http::string_body> response_ = {};
        std::array<char, 4096> rest_ = {};
        HttpRequest request_ = {};
        std::chrono::steady_clock::time_point last_moment_ = {};
        bool watched_ = false, disconnected_ = false;
    };

    /// Listens on the IPv4 loopback address and, if available, on the IPv6 loopback address, at the same port. If the
    /// system chooses a port that is in use on the IPv6 address, returns without acceptors, so that the caller tries
    /// another port.
    void listen(int tries) {
        std::vector<Tcp::acceptor> acceptors;
        acceptors.push_back(listening({asio::ip::address_v4::loopback(), options_.port}));
        const std::uint16_t port = acceptors.front().local_endpoint().port();
        try {
            acceptors.push_back(listening({asio::ip::address_v6::loopback(), port}));
        } catch (const std::system_error& error) {
            const bool in_use = error.code() == std::errc::address_in_use;
            if (in_use && (options_.port != 0 || tries > 10)) throw;
            if (in_use) return;
        }
        acceptors_ = std::move(acceptors);
    }

    Tcp::acceptor listening(const Tcp::endpoint& endpoint) {
        const std::string where = "cannot listen on port " + std::to_string(endpoint.port());
        boost::system::error_code error;
        Tcp::acceptor acceptor(context_);
        acceptor.open(endpoint.protocol(), error);
        if (error) grafverif::app::refuse(error, where);
        acceptor.set_option(asio::socket_base::reuse_address(true), error);
        if (endpoint.address().is_v6()) acceptor.set_option(asio::ip::v6_only(true), error);
        acceptor.bind(endpoint, error);
        if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
        if (error) grafverif::app::refuse(error, where);
        return acceptor;
    }

    void accept(Tcp::acceptor& acceptor) {
        acceptor.async_accept([this, &acceptor](boost::system::error_code error, Tcp::socket socket) {
            const auto full = [this] { return identified_ + unidentified_.size() >= options_.most_connections; };
            if (!error && full() && !unidentified_.empty()) unidentified_.front()->drop();
            if (!error && !full()) std::make_shared<Connection>(*this, std::move(socket))->begin();
            if (error == asio::error::operation_aborted) return;
            if (!error) return accept(acceptor);
            // No connection can be accepted now, because the computer or this process has too many open files.
            const auto pause = std::make_shared<asio::steady_timer>(context_, std::chrono::milliseconds(100));
            pause->async_wait([this, &acceptor, pause](boost::system::error_code) { accept(acceptor); });
        });
    }

    /// True if `host` is an address of this server. Requests with any other Host are rejected.
    bool is_own_address(std::string_view host) const {
        const std::string end = ":" + std::to_string(port());
        return host == "127.0.0.1" + end || host == "[::1]" + end || host == "localhost" + end ||
               (port() == 80 && (host == "127.0.0.1" || host == "[::1]" || host == "localhost"));
    }

    /// Returns the status and the reason for rejecting `request` before its body is read. The status is 0 if the
    /// request is accepted.
    template <class Request>
    std::pair<unsigned, std::string> reason_to_reject(const Request& request) const {
        if (!is_own_address(text_of(request[http::field::host])) || request.count(http::field::host) != 1)
            return {421, "unknown host name"};
        const std::string_view origin = text_of(request[http::field::origin]);
        if (request.count(http::field::origin) > 1 ||
            (!origin.empty() && !(origin.starts_with("http://") && is_own_address(origin.substr(7)))))
            return {403, "cross-origin request refused"};
        if (request.method() != http::verb::get && request.method() != http::verb::post)
            return {405, "only GET and POST are supported"};
        // The static files of the pages (/web/) are served without a token.
        if (text_of(request.target()).starts_with("/web/") || has_token(request)) return {0, ""};
        return {403, "the token is missing; open the address that grafverif printed"};
    }

    template <class Request>
    bool has_token(const Request& request) const {
        const std::string_view target = text_of(request.target());
        const auto query = query_of(target.substr(std::min(target.find('?'), target.size() - 1) + 1));
        const auto token = query.find("token");
        return equal(token != query.end() ? std::string_view(token->second) : text_of(request["X-Grafverif-Token"]),
                     options_.token);
    }

    void poll_stop_flag(const std::atomic<bool>& stop) {
        if (stop) return context_.stop();
        stop_timer_.expires_after(std::chrono::milliseconds(50));
        stop_timer_.async_wait([this, &stop](boost::system::error_code) { poll_stop_flag(stop); });
    }

    HttpOptions options_;
    HttpHandler handler_;
    std::atomic<std::uint64_t> notices_ = 0;
    // Only the thread that reads from and writes to the connections accesses the following members.
    std::list<Connection*> unidentified_ = {};  ///< connections whose token has not been read, oldest first
    std::size_t identified_ = 0;
    asio::io_context context_ = asio::io_context(1);
    std::vector<Tcp::acceptor> acceptors_ = {};
    std::set<std::shared_ptr<Connection>> waiting_ = {};
    asio::steady_timer stop_timer_ = asio::steady_timer(context_);
    HandlerThreads threads_ = {};
};

HttpServer::HttpServer(const HttpOptions& options, HttpHandler handler)
    : impl_(std::make_unique<Impl>(options, std::move(handler))) {}
HttpServer::~HttpServer() = default;
std::uint16_t HttpServer::port() const { return impl_->port(); }
void HttpServer::run(const std::atomic<bool>& stop) { impl_->run(stop); }
void HttpServer::notify() { impl_->notify(); }

}  // namespace grafverif::app
