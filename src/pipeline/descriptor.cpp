// SPDX-License-Identifier: MIT
#include "pipeline/descriptor.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace grafverif {

void Descriptor::close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
}

void fail(int code, const std::string& what) { throw std::system_error(code, std::generic_category(), what); }

Pipe make_pipe() {
    std::array<int, 2> ends = {};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) fail(errno, "cannot create a pipe");
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

void set_nonblocking(const Descriptor& descriptor) { ::fcntl(descriptor.number(), F_SETFL, O_NONBLOCK); }

}  // namespace grafverif
