// SPDX-License-Identifier: MIT
// The base protocol of LSP: a sequence of messages `Content-Length: N`, empty line, N bytes of JSON.
//
// Tolerates errors: bytes that are not a header are skipped up to the next one, and a message that is too large is
// skipped completely.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace grafverif::lsp {

/// Waits for bytes and stores some at the front of the buffer; returns their number, 0 at the end of the stream.
using Receive = std::function<std::size_t(std::span<char> room)>;
/// Writes all bytes.
using Send = std::function<void(std::string_view bytes)>;

inline constexpr std::size_t largest_message = std::size_t{320} << 20U;  ///< bytes; a text of 256 MiB fits

/// A frame of the stream: the body of a message, or an error.
struct Framed {
    std::string body = {};
    std::string complaint = {};  ///< not empty: an error, without a body
};

class Framing {
public:
    explicit Framing(Receive receive, std::size_t largest = largest_message)
        : receive_(std::move(receive)), largest_(largest) {}

    /// The next message; nothing at the end of the stream. An incomplete last message is ignored.
    std::optional<Framed> next();

private:
    bool more();
    std::optional<std::string> line();
    bool skip(std::size_t count);

    Receive receive_;
    std::size_t largest_;
    std::string held_ = {};  ///< received and not yet consumed
};

/// `body` with its header.
std::string framed(std::string_view body);

}  // namespace grafverif::lsp
