// SPDX-License-Identifier: MIT
// Framing: divides a byte stream into messages. Framing implements the base protocol of LSP: each message consists of
// the line `Content-Length: N`, an empty line, and N bytes of JSON. LineFraming implements the transport of MCP over
// standard input and output: each message is one line.
//
// Bytes that do not form a header are skipped up to the next header. A message is skipped completely if it is too large
// or if an allocation for it fails.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace grafverif::rpc {

/// Waits for bytes and stores some of them at the beginning of the buffer. Returns the number of stored bytes; 0 at the
/// end of the stream.
using Receive = std::function<std::size_t(std::span<char> buffer)>;

/// Maximum size of a message in bytes, sufficient for a text of 256 MiB.
inline constexpr std::size_t largest_message = std::size_t{320} << 20U;

/// A frame of the stream: the body of a message, or an error.
struct Framed {
    std::string body = {};
    std::string error_text = {};  ///< error message; if not empty, there is no body
};

/// Stores bytes that were received but not consumed yet.
class ReceiveBuffer {
public:
    static constexpr std::size_t capacity = std::size_t{1} << 16U;

    explicit ReceiveBuffer(Receive receive) : receive_(std::move(receive)) {}

    std::string_view rest() const { return {bytes_.data() + begin_, end_ - begin_}; }
    /// Consumes the first `count` bytes of `rest()`.
    void consume(std::size_t count) { begin_ += count; }
    /// Replaces the contents of the buffer by the next bytes of the stream. Returns false at the end of the stream.
    bool more();

private:
    Receive receive_;
    std::array<char, capacity> bytes_ = {};
    std::size_t begin_ = 0, end_ = 0;
};

/// Divides a stream into messages with headers.
class Framing {
public:
    explicit Framing(Receive receive, std::size_t largest = largest_message);

    /// Returns the next message, or nothing at the end of the stream. An incomplete last message is ignored. If a call
    /// throws std::bad_alloc, the current message is skipped, and the next call returns the following message.
    std::optional<Framed> next();

private:
    bool line();
    bool take(std::size_t count, std::string* text);

    ReceiveBuffer buffer_;
    std::size_t largest_;
    std::string line_ = {};  ///< the current line of the header
};

/// Divides a stream into messages that are lines. Empty lines are skipped.
class LineFraming {
public:
    LineFraming(Receive receive, std::size_t largest) : buffer_(std::move(receive)), largest_(largest) {}

    /// Returns the next message, or nothing at the end of the stream. A last line without terminator is also a message.
    /// If a call throws std::bad_alloc, the current message is skipped, and the next call returns the following
    /// message.
    std::optional<Framed> next();

private:
    bool line(Framed& message, bool& refused);

    ReceiveBuffer buffer_;
    std::size_t largest_;
};

/// Returns `body` with its header.
std::string framed(std::string_view body);

}  // namespace grafverif::rpc
