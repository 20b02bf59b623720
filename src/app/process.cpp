// SPDX-License-Identifier: MIT
// The program runs in a process group of its own, so that it can be ended with all it has started. Its input is a file
// without a name: nothing has to be written to it while it runs, and one that does not read it breaks no pipe.
#include "app/process.hpp"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <utility>

#include "app/spawn.hpp"

namespace grafverif::app {

namespace fs = std::filesystem;

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File file_of(const std::string& input) {
    File file(std::tmpfile(), std::fclose);
    if (!file) fail(errno, "cannot make a temporary file");
    if (std::fwrite(input.data(), 1, input.size(), file.get()) != input.size() || std::fflush(file.get()) != 0)
        fail(errno, "cannot write a temporary file");
    ::lseek(::fileno(file.get()), 0, SEEK_SET);
    return file;
}

/// One of its output streams as it comes in.
struct Stream {
    Descriptor from = Descriptor();
    std::string text = {};

    /// Takes what is there, but little more than `most` bytes in all.
    void take(std::size_t most) {
        std::array<char, 65536> buffer = {};
        while (from.open() && text.size() <= most) {
            const ssize_t count = ::read(from.number(), buffer.data(), buffer.size());
            if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
            else if (count == 0) from.close();
            else if (errno == EINTR) continue;
            else if (errno == EAGAIN || errno == EWOULDBLOCK) return;
            else from.close();
        }
    }
};

void wait_for_output(const Stream& out, const Stream& err, int milliseconds) {
    std::array<pollfd, 2> waited = {pollfd{out.from.number(), POLLIN, 0}, pollfd{err.from.number(), POLLIN, 0}};
    ::poll(waited.data(), waited.size(), milliseconds);   // a closed descriptor is negative: poll leaves it out
}

}  // namespace

std::optional<fs::path> find_program(const std::string& name) {
    const auto executable = [](const fs::path& file) {
        std::error_code ignored;
        return fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0;
    };
    if (name.find('/') != std::string::npos) return executable(name) ? std::optional<fs::path>(name) : std::nullopt;
    const char* const path = std::getenv("PATH");
    for (std::string_view rest = path == nullptr ? "" : path; !rest.empty() && !name.empty();) {
        const std::string_view folder = rest.substr(0, rest.find(':'));
        rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
        if (const fs::path file = fs::path(folder) / name; !folder.empty() && executable(file)) return file;
    }
    return {};
}

ProgramResult run_program(const std::vector<std::string>& arguments, const std::string& input, const ProgramLimits& limits) {
    const File stdin_file = file_of(input);
    Pipe out_pipe = make_pipe(), err_pipe = make_pipe();
    set_nonblocking(out_pipe.read);
    set_nonblocking(err_pipe.read);
    const pid_t child = spawn(arguments, ::fileno(stdin_file.get()), out_pipe.write.number(), err_pipe.write.number());
    out_pipe.write.close();
    err_pipe.write.close();
    Stream out{std::move(out_pipe.read), {}}, err{std::move(err_pipe.read), {}};

    ProgramResult result;
    int status = 0;
    bool ended_by_us = true;
    for (;;) {
        out.take(limits.max_output);
        err.take(limits.max_output);
        if (out.text.size() > limits.max_output || err.text.size() > limits.max_output) result.end = ProgramResult::End::TooMuchOutput;
        else if (limits.stop != nullptr && limits.stop->load()) result.end = ProgramResult::End::Stopped;
        else if (limits.deadline && std::chrono::steady_clock::now() >= *limits.deadline) result.end = ProgramResult::End::TimedOut;
        else if (::waitpid(child, &status, WNOHANG) == child) ended_by_us = false;
        else { wait_for_output(out, err, out.from.open() || err.from.open() ? 10 : 1); continue; }
        break;
    }
    ::kill(-child, SIGKILL);
    if (ended_by_us) ::waitpid(child, &status, 0);
    out.take(limits.max_output);
    err.take(limits.max_output);
    if (!ended_by_us) {
        result.end = WIFSIGNALED(status) ? ProgramResult::End::Signalled : ProgramResult::End::Exited;
        result.status = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
    }
    result.out = std::move(out.text);
    result.err = std::move(err.text);
    return result;
}

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (fs::temp_directory_path() / "grafverif-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) fail(errno, "cannot make a temporary folder");
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

}  // namespace grafverif::app
