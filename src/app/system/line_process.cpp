// SPDX-License-Identifier: MIT
// Reads and writes all three pipes as they become ready, so that a program that writes before it reads, or never reads,
// does not block the caller. Standard output of the program is stored up to a limit; of its standard error, only the
// end is stored.
#include "app/system/line_process.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <vector>

#include "app/system/interrupt.hpp"
#include "app/system/watchdog.hpp"
#include "syntax/print/scan_line.hpp"

namespace grafverif::app {

namespace {

/// Reads available bytes, at most `most`. Closes the descriptor at the end of file.
std::string taken(Descriptor& from, std::size_t most) {
    std::string text(most, '\0');
    const ssize_t count = ::read(from.number(), text.data(), text.size());
    const bool later = count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
    if (count <= 0 && !later) from.close();
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return text;
}

constexpr std::size_t bytes_at_once = 65'536;  ///< number of bytes read per call
constexpr int shell_found_nothing = 127, shell_could_not_run = 126;

}  // namespace

LineProcess::LineProcess(const std::string& command, const LineProcessLimits& limits) : limits_(limits) {
    const MemoryUnbounded unbounded;  // the memory limit of this process does not apply to the program
    Pipe in = make_pipe(), out = make_pipe(), err = make_pipe();
    program_.emplace(std::vector<std::string>{"/bin/sh", "-c", command},
                     ChildStreams{in.read.number(), out.write.number(), err.write.number()});
    to_ = std::move(in.write);
    from_ = std::move(out.read);
    errors_ = std::move(err.read);
    for (const Descriptor* pipe : {&to_, &from_, &errors_}) set_nonblocking(*pipe);
    pipe_signal_before_ = std::signal(SIGPIPE, SIG_IGN);  // writing to a program that has ended must not raise a signal
}

LineProcess::~LineProcess() {
    const SignalBlocker whole;
    to_.close();
    from_.close();
    if (!wait_for_end(std::chrono::milliseconds(over_ ? 0 : 500))) {
        program_->send(SIGTERM);
        wait_for_end(std::chrono::milliseconds(200));
    }
    program_->end();
    if (stopped()) work_is_done();  // the watchdog allows additional time to print the results
    std::signal(SIGPIPE, pipe_signal_before_);
}

Reply LineProcess::request(const std::string& line) {
    Reply answer = result_for(line);
    over_ = answer.kind != Reply::Kind::Line;
    return answer;
}

Reply LineProcess::result_for(const std::string& line) {
    receive();
    if (const std::size_t end = received_.find('\n'); end != std::string::npos)  // an unexpected line
        return {Reply::Kind::Flood, received_.substr(0, end)};
    send(line);
    const Steady::time_point deadline = Steady::now() + limits_.response_timeout;
    for (;;) {
        const bool answered = received_.find('\n') != std::string::npos;
        if (answered || received_.size() > limits_.longest_line || !from_.open()) return result_so_far();
        if (stopped()) return {Reply::Kind::Stopped, {}};
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Steady::now());
        if (left.count() <= 0) return {Reply::Kind::Silent, {}};
        wait(left);
        send();
        receive();
        listen();
    }
}

/// Returns the reply for the text received so far, if it contains a line or is too long, or if the output has ended.
Reply LineProcess::result_so_far() {
    const std::size_t end = received_.find('\n');
    if (end == std::string::npos && received_.size() <= limits_.longest_line) return {Reply::Kind::Ended, received_};
    if (end != received_.size() - 1) return {Reply::Kind::Flood, received_.substr(0, end)};
    std::string line = std::exchange(received_, {});
    line.pop_back();
    return {Reply::Kind::Line, std::move(line)};
}

void LineProcess::send() {
    if (!to_.open() || unsent_.empty()) return;
    const ssize_t count = ::write(to_.number(), unsent_.data(), unsent_.size());
    if (count > 0) unsent_.erase(0, static_cast<std::size_t>(count));
    else if (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR) to_.close();
}

void LineProcess::receive() {
    if (from_.open() && received_.size() <= limits_.longest_line) received_ += taken(from_, bytes_at_once);
}

void LineProcess::listen() {
    constexpr std::size_t kept = 2000;
    if (!errors_.open()) return;
    error_output_ += taken(errors_, bytes_at_once);
    if (error_output_.size() > kept) error_output_.erase(0, error_output_.size() - kept);
}

/// Waits until a pipe is ready, at most for `longest`, and at most 20 ms, so that a stop request is noticed in time.
void LineProcess::wait(std::chrono::milliseconds longest) {
    constexpr std::chrono::milliseconds most{20};
    const auto writing = static_cast<short>(unsent_.empty() ? 0 : POLLOUT);
    std::array<pollfd, 3> waited = {pollfd{from_.number(), POLLIN, 0}, pollfd{errors_.number(), POLLIN, 0},
                                    pollfd{writing != 0 ? to_.number() : -1, writing, 0}};
    ::poll(waited.data(), waited.size(), static_cast<int>(std::min(longest, most).count()));
}

/// Waits at most `longest` for the end of the program. Returns true if the program has ended. Reads
/// standard error at the same time, because a program that is blocked by a full pipe cannot end.
bool LineProcess::wait_for_end(std::chrono::milliseconds longest) {
    const Steady::time_point deadline = Steady::now() + longest;
    while (!program_->ended() && Steady::now() < deadline) {
        pollfd waited{errors_.number(), POLLIN, 0};
        ::poll(&waited, 1, 2);
        listen();
    }
    return program_->ended().has_value();
}

std::string LineProcess::end_text() {
    std::string text = "the controller closed its output";
    if (wait_for_end(std::chrono::milliseconds(500))) {
        const ChildEnd end = *program_->ended();
        text = end.by_signal
                   ? fmt::format("the controller was terminated by signal {} ({})", end.status, ::strsignal(end.status))
                   : fmt::format("the controller exited with code {}", end.status);
    }
    if (!received_.empty()) text += fmt::format(", after the incomplete line `{}`", shown_line(received_));
    listen();
    std::string_view last = error_output_;
    while (last.ends_with('\n')) last.remove_suffix(1);
    last.remove_prefix(last.rfind('\n') + 1);  // if there is no line feed, npos + 1 is 0, and the complete text is used
    if (!last.empty()) text += fmt::format("; its error output: {}", shown_line(last));
    return text;
}

bool LineProcess::not_found() {
    if (!wait_for_end(std::chrono::milliseconds(500))) return false;
    const ChildEnd end = *program_->ended();
    return !end.by_signal && (end.status == shell_found_nothing || end.status == shell_could_not_run);
}

}  // namespace grafverif::app
