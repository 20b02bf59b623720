// SPDX-License-Identifier: MIT
#include "app/system/cancellable_input.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <istream>

namespace grafverif::app {

std::size_t CancellableInput::receive(std::span<char> buffer) const {
    // The interval is in milliseconds. Polling is necessary, because a signal may be handled in
    // another thread and then does not interrupt this thread.
    constexpr int poll_interval = 200;
    while (!is_over(deadline_, &end_requested_)) {
        std::array<pollfd, 2> waited = {pollfd{STDIN_FILENO, POLLIN, 0}, pollfd{pipe_.read.number(), POLLIN, 0}};
        const int ready = ::poll(waited.data(), waited.size(), poll_interval);
        if (ready < 0 && errno != EINTR) return 0;
        if (ready <= 0) continue;
        if (waited[1].revents != 0) return 0;
        if (waited[0].revents == 0) continue;
        const ssize_t count = ::read(STDIN_FILENO, buffer.data(), buffer.size());
        if (count >= 0) return static_cast<std::size_t>(count);
        if (errno != EINTR && errno != EAGAIN) return 0;
    }
    return 0;
}

void CancellableInput::stop() const {
    const char any = 0;
    [[maybe_unused]] const ssize_t written = ::write(pipe_.write.number(), &any, 1);
}

rpc::Receive receive_from(std::istream& in) {
    return [&in](std::span<char> buffer) {
        in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        return static_cast<std::size_t>(in.gcount());
    };
}

}  // namespace grafverif::app
