// SPDX-License-Identifier: MIT
#include <poll.h>
#include <unistd.h>

#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "app/program.hpp"
#include "app/system/watchdog.hpp"
#include "support/printable.hpp"

namespace {

/// Exit code of a process ended by SIGPIPE, as reported by shells.
constexpr int closed_pipe = 128 + SIGPIPE;

/// True if the reader of the pipe at `descriptor` has closed it.
bool reader_is_gone(int descriptor) {
    pollfd requested{descriptor, POLLOUT, 0};
    return ::poll(&requested, 1, 0) == 1 && (requested.revents & POLLERR) != 0;
}

}  // namespace

int main(int count, char** values) {
    using namespace grafverif::app;
    expect_memory_to_end();
    std::ios::sync_with_stdio(false);
    try {
        const std::vector<std::string> arguments(values + 1, values + count);
        Streams streams{std::cin, std::cout, std::cerr, true, screen_of(STDOUT_FILENO), screen_of(STDERR_FILENO)};
        streams.typed = screen_of(STDIN_FILENO).terminal && streams.out_screen.rewrites;
        const ExitCode code = run(arguments, streams);
        std::cout.flush();
        if (!std::cout && reader_is_gone(STDOUT_FILENO)) return closed_pipe;
        if (!std::cout) {
            std::cerr << "grafverif: error: cannot write to standard output\n";
            return static_cast<int>(ExitCode::Input);
        }
        return static_cast<int>(code);
    } catch (const std::bad_alloc&) {
        std::cerr << "error: out of memory: the system refused an allocation [out-of-memory]\n";
        return static_cast<int>(ExitCode::Unknown);
    } catch (const std::exception& failure) {
        std::cerr << "grafverif: internal error: " << grafverif::printable(failure.what()) << '\n';
        return static_cast<int>(ExitCode::Failure);
    }
}
