// SPDX-License-Identifier: MIT
#include "app/serve/live_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <functional>
#include <mutex>
#include <random>
#include <semaphore>
#include <sstream>
#include <utility>

#include "app/commands.hpp"
#include "app/serve/edited_file.hpp"
#include "app/serve/file_checker.hpp"
#include "app/serve/http.hpp"
#include "app/serve/live_files.hpp"
#include "app/serve/play.hpp"

namespace grafverif::app {

namespace {

/// Returns 128 unpredictable bits as hexadecimal digits.
std::string random_token() {
    std::random_device source;
    std::string token;
    for (int k = 0; k < 4; ++k) token += fmt::format("{:08x}", source());
    return token;
}

std::string_view media_type(std::string_view name) {
    return name.ends_with(".css") ? "text/css" : name.ends_with(".js") ? "text/javascript" : "text/html";
}

HttpAnswer file_named(std::string_view name) {
    const auto files = live_files();
    const auto found = std::ranges::find(files, name, &LiveFile::name);
    if (found == files.end()) return {404, "text/plain", "not found\n"};
    return {200, std::string(media_type(name)), std::string(found->text)};
}

constexpr std::uint64_t longest_report_ms = 120'000;
/// Maximum size of a request in bytes, for a page that only shows a file and for a page that edits it.
constexpr std::size_t largest_request = std::size_t{1} << 20U, largest_edit = 3 * largest_edited;

/// Returns the version of the state that the client has, as given by `after` in the query; 0 if `after` is missing or
/// is not a number.
std::uint64_t known_version(const HttpRequest& request) {
    std::uint64_t version = 0;
    if (const auto after = request.query.find("after"); after != request.query.end())
        std::from_chars(after->second.data(), after->second.data() + after->second.size(), version);
    return version;
}

}  // namespace

/// Dispatches requests to their handlers.
class RequestDispatcher {
public:
    /// The dispatcher calls `on_capacity` when a simulation ends, so that delayed requests are tried again. `edited` is
    /// the file that the page can change, or null.
    RequestDispatcher(const Options& options, std::function<void()> on_capacity, EditedFile* edited)
        : options_(options), on_capacity_(std::move(on_capacity)), edited_(edited) {}

    void begin(FileChecker& bench) { bench_ = &bench; }

    std::optional<HttpAnswer> answer(const HttpRequest& request, bool at_once) const {
        if (edited_ != nullptr && EditedFile::handles(request.path))
            return request.post ? HttpAnswer{.body = edited_->respond(request.path, request.body)}
                                : HttpAnswer{405, "text/plain", "use POST for changes\n"};
        if (request.path == "/simulate")
            return request.post ? simulation(request, at_once) : HttpAnswer{405, "text/plain", "use POST for moves\n"};
        if (request.post) return HttpAnswer{405, "text/plain", "POST is not supported here\n"};
        if (request.path == "/drawings") return HttpAnswer{.body = drawings(*bench_->checked_file())};
        if (edited_ != nullptr && request.path == "/document")
            return newest(edited_->newer(known_version(request)), at_once);
        if (edited_ == nullptr && request.path == "/report") return report_page(request);
        if (request.path == "/state") return newest(bench_->newer(known_version(request)), at_once);
        if (request.path == "/") return file_named(edited_ != nullptr ? "edit.html" : "live.html");
        return file_named(request.path.starts_with("/web/") ? request.path.substr(5) : "");
    }

private:
    static std::optional<HttpAnswer> newest(std::optional<std::string> newer, bool at_once) {
        if (newer) return HttpAnswer{.body = std::move(*newer)};
        if (at_once) return HttpAnswer{.body = "null"};
        return {};
    }

    /// Performs a simulation. At most two simulations run at a time, so that threads remain for other requests.
    std::optional<HttpAnswer> simulation(const HttpRequest& request, bool at_once) const {
        if (!simulating_.try_acquire()) {
            if (at_once) return HttpAnswer{503, "text/plain", "too many simulations are running; try again later\n"};
            return {};
        }
        const std::unique_ptr<const RequestDispatcher, void (*)(const RequestDispatcher*)> place(
            this, [](const RequestDispatcher* dispatcher) {
                dispatcher->simulating_.release();
                dispatcher->on_capacity_();
            });
        return HttpAnswer{.body = play(*bench_->checked_file(), options_, request.body)};
    }

    /// Returns the page that `report` writes. Only one page is computed at a time.
    HttpAnswer report_page(const HttpRequest& request) const {
        const std::unique_lock hold(reporting_, std::try_to_lock);
        if (!hold) return {503, "text/plain", "another report is being generated; try again later\n"};
        CommandContext job{.options = options_};
        const bool selects = !options_.property_file;  // a file with a PLC program has a single model
        if (const auto loop = request.query.find("loop"); selects && loop != request.query.end())
            job.options.loop = loop->second;
        if (const auto chart = request.query.find("chart"); selects && chart != request.query.end())
            job.options.chart = chart->second;
        const std::uint64_t time =
            std::min(longest_report_ms, options_.response_timeout_ms.value_or(longest_report_ms));
        job.options.timeout_ms = time;
        job.options.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(time);
        std::istringstream nothing;
        std::ostringstream page, error_texts;
        report(job, {nothing, page, error_texts});
        if (!page.str().empty()) return {200, "text/html", std::move(page).str()};
        render_text(job.diagnostics.all(), job.sources, Colour::Plain, error_texts);
        return {409, "text/plain", std::move(error_texts).str()};
    }

    const Options& options_;
    std::function<void()> on_capacity_;
    EditedFile* edited_;
    FileChecker* bench_ = nullptr;
    mutable std::counting_semaphore<2> simulating_{2};
    mutable std::mutex reporting_ = {};
};

class LivePage::Parts {
public:
    Parts(Options options, std::uint16_t port, std::optional<std::string> edited)
        : options_(std::move(options)),
          edited_(edited ? std::make_unique<EditedFile>(options_, std::move(*edited)) : nullptr),
          dispatcher_(
              options_, [this] { server_.notify(); }, edited_.get()),
          token_(random_token()),
          server_({.port = port, .token = token_, .largest_body = edited_ != nullptr ? largest_edit : largest_request},
                  [this](const HttpRequest& request, bool at_once) { return dispatcher_.answer(request, at_once); }),
          bench_(
              options_, [this] { server_.notify(); },
              edited_ != nullptr ? [this] { return edited_->text(); } : std::function<std::string()>()) {
        dispatcher_.begin(bench_);
        if (edited_ != nullptr) edited_->begin([this] { bench_.refresh(); }, [this] { server_.notify(); });
    }
    ~Parts() {
        if (edited_ != nullptr) edited_->end();
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    std::string address() const { return fmt::format("http://127.0.0.1:{}/?token={}", server_.port(), token_); }
    void run(const std::atomic<bool>& stop) {
        server_.run(stop);
        if (edited_ != nullptr) edited_->end();
    }
    std::string unsaved() const { return edited_ != nullptr ? edited_->unsaved() : std::string(); }
    std::string loss() const { return edited_ != nullptr ? edited_->loss() : std::string(); }

private:
    Options options_;
    std::unique_ptr<EditedFile> edited_;
    RequestDispatcher dispatcher_;
    std::string token_;
    HttpServer server_;
    FileChecker bench_;
};

LivePage::LivePage(const Options& options, std::optional<std::string> edited)
    : parts_(std::make_unique<Parts>(options, static_cast<std::uint16_t>(options.port), std::move(edited))) {}
LivePage::~LivePage() = default;
std::string LivePage::address() const { return parts_->address(); }
void LivePage::run(const std::atomic<bool>& stop) { parts_->run(stop); }
std::string LivePage::unsaved() const { return parts_->unsaved(); }
std::string LivePage::loss() const { return parts_->loss(); }

}  // namespace grafverif::app
