// SPDX-License-Identifier: MIT
// `serve`: a page on this machine that shows a file as it is now, proves it with every save, and plays with it.
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <ostream>
#include <random>
#include <semaphore>
#include <sstream>
#include <system_error>
#include <utility>

#include "app/outputs.hpp"
#include "app/serve/bench.hpp"
#include "app/serve/http.hpp"
#include "app/serve/live_files.hpp"
#include "app/serve/play.hpp"
#include "app/system/interrupt.hpp"
#include "app/verbs.hpp"
#include "pipeline/files.hpp"
#include "support/messages.hpp"
#include "support/printable.hpp"

namespace grafverif::app {

namespace {

/// 128 bits that nobody guesses.
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
    if (found == files.end()) return {404, "text/plain", "there is nothing here\n"};
    return {200, std::string(media_type(name)), std::string(found->text)};
}

constexpr std::uint64_t longest_report_ms = 120'000;

/// What is known already, of the query; whatever is no number knows nothing.
std::uint64_t known_version(const HttpRequest& request) {
    std::uint64_t version = 0;
    if (const auto after = request.query.find("after"); after != request.query.end())
        std::from_chars(after->second.data(), after->second.data() + after->second.size(), version);
    return version;
}

class Desk {
public:
    /// `room`: somebody who was put off may ask again.
    Desk(const Options& options, std::function<void()> room) : options_(options), room_(std::move(room)) {}

    void begin(Bench& bench) { bench_ = &bench; }

    std::optional<HttpAnswer> answer(const HttpRequest& request, bool at_once) const {
        if (request.path == "/simulate")
            return request.post ? simulation(request, at_once) : HttpAnswer{405, "text/plain", "moves are posted\n"};
        if (request.post) return HttpAnswer{405, "text/plain", "nothing is posted here\n"};
        if (request.path == "/drawings") return HttpAnswer{.body = drawings(*bench_->workpiece())};
        if (request.path == "/report") return report_page(request);
        if (request.path == "/state") return state(known_version(request), at_once);
        if (request.path == "/") return file_named("live.html");
        return file_named(request.path.starts_with("/web/") ? request.path.substr(5) : "");
    }

private:
    std::optional<HttpAnswer> state(std::uint64_t known, bool at_once) const {
        if (auto newer = bench_->newer(known)) return HttpAnswer{.body = std::move(*newer)};
        if (at_once) return HttpAnswer{.body = "null"};
        return {};
    }

    /// Two at a time, so that somebody is left to tell the state.
    std::optional<HttpAnswer> simulation(const HttpRequest& request, bool at_once) const {
        if (!simulating_.try_acquire()) {
            if (at_once) return HttpAnswer{503, "text/plain", "other simulations are still being made\n"};
            return {};
        }
        const std::unique_ptr<const Desk, void (*)(const Desk*)> place(this, [](const Desk* desk) {
            desk->simulating_.release();
            desk->room_();
        });
        return HttpAnswer{.body = play(*bench_->workpiece(), options_, request.body)};
    }

    /// What `report` writes, one at a time.
    HttpAnswer report_page(const HttpRequest& request) const {
        const std::unique_lock hold(reporting_, std::try_to_lock);
        if (!hold) return {503, "text/plain", "another report is being made; try again when it is there\n"};
        Job job{.options = options_};
        if (const auto loop = request.query.find("loop"); loop != request.query.end()) job.options.loop = loop->second;
        if (const auto chart = request.query.find("chart"); chart != request.query.end())
            job.options.chart = chart->second;
        const std::uint64_t time = std::min(longest_report_ms, options_.patience_ms.value_or(longest_report_ms));
        job.options.timeout_ms = time;
        job.options.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(time);
        std::istringstream nothing;
        std::ostringstream page, complaints;
        report(job, {nothing, page, complaints});
        if (!page.str().empty()) return {200, "text/html", std::move(page).str()};
        render_text(job.diagnostics.all(), job.sources, Colour::Plain, complaints);
        return {409, "text/plain", std::move(complaints).str()};
    }

    const Options& options_;
    std::function<void()> room_;
    Bench* bench_ = nullptr;
    mutable std::counting_semaphore<2> simulating_{2};
    mutable std::mutex reporting_ = {};
};

/// In the browser that the user has chosen; it lives on when we end.
void open_in_browser(const std::string& address, const Streams& streams) {
    std::string program = "xdg-open", operand = address;
    char* arguments[] = {program.data(), operand.data(), nullptr};
    posix_spawn_file_actions_t quiet;
    ::posix_spawn_file_actions_init(&quiet);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        ::posix_spawn_file_actions_addopen(&quiet, stream, "/dev/null", O_RDWR, 0);
    posix_spawnattr_t apart;
    ::posix_spawnattr_init(&apart);
    ::posix_spawnattr_setflags(&apart, POSIX_SPAWN_SETSID);
    pid_t child = 0;
    const int failure = ::posix_spawnp(&child, program.c_str(), &quiet, &apart, arguments, environ);
    ::posix_spawn_file_actions_destroy(&quiet);
    ::posix_spawnattr_destroy(&apart);
    if (failure != 0) streams.err << "note: there is no `xdg-open` to open the page with; open the address by hand\n";
}

bool can_be_served(Job& job) {
    const std::string& path = job.options.operands[0];
    std::string why;
    if (path == "-" || own_descriptor(path)) why = "what is watched is a file with a name";
    else if (content_of_file(path, why)) why.clear();
    if (!why.empty()) job.diagnostics.add(messages::cannot_read(path, why));
    const std::uint64_t port = job.options.port;
    if (port > 65535) job.diagnostics.add(messages::cannot_listen(port, "ports go up to 65535"));
    return !job.diagnostics.has_errors();
}

}  // namespace

ExitCode serve(Job& job, const Streams& streams) {
    if (!can_be_served(job)) return ExitCode::Input;
    const Interrupt interrupt;
    std::optional<HttpServer> server;
    Desk desk(job.options, [&] { server->notify(); });
    const std::string token = random_token();
    try {
        server.emplace(HttpOptions{.port = static_cast<std::uint16_t>(job.options.port), .token = token},
                       [&](const HttpRequest& request, bool at_once) { return desk.answer(request, at_once); });
    } catch (const std::system_error& failure) {
        const bool in_use = failure.code() == std::errc::address_in_use;
        job.diagnostics.add(messages::cannot_listen(
            job.options.port, in_use ? "another program listens there" : failure.code().message()));
        return ExitCode::Input;
    }
    Bench bench(job.options, [&] { server->notify(); });
    desk.begin(bench);
    const std::string address = fmt::format("http://127.0.0.1:{}/?token={}", server->port(), token);
    streams.out << fmt::format("{} is at {}\nCtrl-C ends it.\n", printable(job.options.operands[0]), address)
                << std::flush;
    if (job.options.open) open_in_browser(address, streams);
    server->run(interrupt.asked());
    return ExitCode::Done;
}

Verb serve_usage() {
    return {
        "serve",
        "FILE",
        1,
        1,
        "show a file in the browser while it is edited: drawings, verdicts, a simulator",
        "Prints an address of this machine, where the browser shows FILE as it is now: what is wrong with it, its "
        "charts, the\n"
        "verdicts on its properties, and a simulator to click through. Every save of FILE, or of what it includes, is "
        "shown at\n"
        "once. Nobody else reaches the page: it is for this machine alone and asks for the token of the address. "
        "Nothing is\n"
        "written. Ctrl-C ends it.",
        {"grafverif serve samples/oven_door/oven_door.grafcet", "grafverif serve station.grafcet --port 8060 --open"},
        {Accepts::Serve, Accepts::Mode, Accepts::Grain}};
}

}  // namespace grafverif::app
