// SPDX-License-Identifier: MIT
// The base protocol of LSP: a sequence of messages `Content-Length: N`, empty line, N bytes of JSON.
//
// Bytes that are not a header are skipped up to the next one. A message that is too large, or for which memory is
// refused, is skipped completely.
#pragma once

#include <array>
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
    std::string error_text = {};  ///< not empty: an error, without a body
};

class Framing {
public:
    explicit Framing(Receive receive, std::size_t largest = largest_message);

    /// The next message; nothing at the end of the stream. An incomplete last message is ignored. After std::bad_alloc
    /// the next call returns the next message.
    std::optional<Framed> next();

private:
    bool more();
    bool line();
    bool take(std::size_t count, std::string* text);

    Receive receive_;
    std::size_t largest_;
    std::array<char, std::size_t{1} << 16U> room_ = {};  ///< received; not yet consumed from `begin_` to `end_`
    std::size_t begin_ = 0, end_ = 0;
    std::string line_ = {};  ///< of the header; its capacity is that of the longest
};

/// `body` with its header.
std::string framed(std::string_view body);

}  // namespace grafverif::lsp
