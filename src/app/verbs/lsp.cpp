// SPDX-License-Identifier: MIT
// `lsp`: the language server, for an editor that starts it.
#include <poll.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <istream>
#include <ostream>
#include <system_error>

#include "app/verbs.hpp"
#include "lsp/server.hpp"

namespace grafverif::app {

namespace {

/// Standard input, and a way to stop waiting for it.
class Ear {
public:
    Ear() {
        if (::pipe(ends_.data()) != 0) throw std::system_error(errno, std::generic_category(), "no pipe");
    }
    ~Ear() {
        ::close(ends_[0]);
        ::close(ends_[1]);
    }
    Ear(const Ear&) = delete;
    Ear& operator=(const Ear&) = delete;

    std::size_t receive(std::span<char> room) const {
        for (;;) {
            std::array<pollfd, 2> waited = {pollfd{STDIN_FILENO, POLLIN, 0}, pollfd{ends_[0], POLLIN, 0}};
            if (::poll(waited.data(), waited.size(), -1) < 0 && errno != EINTR) return 0;
            if (waited[1].revents != 0) return 0;
            if (waited[0].revents == 0) continue;
            const ssize_t count = ::read(STDIN_FILENO, room.data(), room.size());
            if (count >= 0) return static_cast<std::size_t>(count);
            if (errno != EINTR && errno != EAGAIN) return 0;
        }
    }
    void stop() const {
        const char any = 0;
        [[maybe_unused]] const ssize_t written = ::write(ends_[1], &any, 1);
    }

private:
    std::array<int, 2> ends_ = {};
};

bool is_alive(std::int64_t process) {
    return process <= 0 || ::kill(static_cast<pid_t>(process), 0) == 0 || errno != ESRCH;
}

/// LSP 3.17, "Exit Notification": 0 only where `shutdown` came first.
ExitCode code_of(grafverif::lsp::Ending ending) {
    return ending == grafverif::lsp::Ending::Asked ? ExitCode::Done : ExitCode::Verdict;
}

}  // namespace

ExitCode lsp(Job& job, const Streams& streams) {
    grafverif::lsp::Surroundings surroundings;
    surroundings.version = GRAFVERIF_VERSION;
    surroundings.include_folders = job.options.include_folders;
    const grafverif::lsp::Send send = [&](std::string_view bytes) { streams.out << bytes << std::flush; };
    if (!streams.alone) {
        const auto receive = [&](std::span<char> room) {
            streams.in.read(room.data(), static_cast<std::streamsize>(room.size()));
            return static_cast<std::size_t>(streams.in.gcount());
        };
        return code_of(grafverif::lsp::converse(receive, send, surroundings));
    }
    const Ear ear;
    surroundings.is_alive = is_alive;
    surroundings.hang_up = [&] { ear.stop(); };
    return code_of(
        grafverif::lsp::converse([&](std::span<char> room) { return ear.receive(room); }, send, surroundings));
}

Verb lsp_usage() {
    return {
        "lsp",
        "",
        0,
        0,
        "serve an editor: what is wrong while it is typed, names, completion, verdicts",
        "Speaks the Language Server Protocol 3.17 on standard input and output, for editors that start it by "
        "themselves: see\n"
        "docs/lsp.md for two lines of configuration. What is open in the editor stands for the files on the disk, and "
        "for\n"
        "all that include them. Nothing is written. It ends when the editor says so, or is gone.",
        {"grafverif lsp"},
        {Accepts::Lsp}};
}

}  // namespace grafverif::app
