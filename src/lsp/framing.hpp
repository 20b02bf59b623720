// SPDX-License-Identifier: MIT
// The base protocol of LSP: `Content-Length: N`, an empty line, N bytes of JSON; again and again.
//
// Whatever arrives is taken as far as it can be: bytes that are no header are skipped up to the next one, a message that
// is too large is skipped as a whole.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace grafverif::lsp {

/// Waits for bytes and puts some at the front of `room`: how many; 0: there will be none any more.
using Receive = std::function<std::size_t(std::span<char> room)>;
/// Writes all of it.
using Send = std::function<void(std::string_view bytes)>;

inline constexpr std::size_t largest_message = std::size_t{320} << 20U;  ///< bytes; a text of 256 MiB fits

/// What was cut out of the stream: the body of a message, or what is wrong with it.
struct Framed {
    std::string body = {};
    std::string complaint = {};  ///< not empty: there is no body
};

class Framing {
public:
    explicit Framing(Receive receive, std::size_t largest = largest_message)
        : receive_(std::move(receive)), largest_(largest) {}

    /// The next message; nothing: the stream is over. A message that it cuts short is none.
    std::optional<Framed> next();

private:
    bool more();
    std::optional<std::string> line();
    bool skip(std::size_t count);

    Receive receive_;
    std::size_t largest_;
    std::string held_ = {};  ///< received and not yet taken
};

/// `body` with its header.
std::string framed(std::string_view body);

}  // namespace grafverif::lsp
