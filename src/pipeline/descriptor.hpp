// SPDX-License-Identifier: MIT
// Owned file descriptors and pipes. The callers run external programs that end after one request (process.hpp) or
// answer line by line (line_process.hpp).
#pragma once

#include <string>
#include <utility>

namespace grafverif {

/// A file descriptor that the destructor closes.
class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() { close(); }

    int number() const { return number_; }
    bool open() const { return number_ >= 0; }
    void close();

private:
    int number_;
};

struct Pipe {
    Descriptor read = Descriptor(), write = Descriptor();
};

/// Creates a pipe that child processes do not inherit. Throws std::system_error if the system cannot create the pipe.
Pipe make_pipe();

/// Makes reads and writes of `descriptor` non-blocking.
void set_nonblocking(const Descriptor& descriptor);

/// Throws std::system_error with the error number `code` and the text `what`.
[[noreturn]] void fail(int code, const std::string& what);

}  // namespace grafverif
