// SPDX-License-Identifier: MIT
#include "rpc/framing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <new>

namespace grafverif::rpc {

namespace {

constexpr std::size_t longest_header = 4096;

/// Returns the number in a line `Content-Length: N` (in upper or lower case), or nothing for any other line.
std::optional<std::uint64_t> content_length(std::string_view line) {
    constexpr std::string_view name = "content-length:";
    if (line.size() < name.size() || !std::ranges::equal(line.substr(0, name.size()), name, [](char a, char b) {
            return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
        }))
        return {};
    line.remove_prefix(name.size());
    while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
    while (!line.empty() && line.back() == ' ') line.remove_suffix(1);
    std::uint64_t length = 0;
    const auto [end, failure] = std::from_chars(line.data(), line.data() + line.size(), length);
    if (line.empty() || end != line.data() + line.size()) return {};
    return failure == std::errc() ? length : UINT64_MAX;
}

std::string too_large(std::uint64_t size, std::size_t largest) {
    return fmt::format("a message of {} bytes exceeds the limit of {}", size, largest);
}

}  // namespace

bool ReceiveBuffer::more() {
    begin_ = 0;
    end_ = receive_(bytes_);
    return end_ != 0;
}

Framing::Framing(Receive receive, std::size_t largest) : buffer_(std::move(receive)), largest_(largest) {
    line_.reserve(longest_header + ReceiveBuffer::capacity);
}

/// Reads a line without its terminator. Returns false if the stream ends before the terminator. If the line is too
/// long, only its last bytes are stored, so that a header at its end is still found.
bool Framing::line() {
    for (line_.clear();;) {
        const std::string_view here = buffer_.rest();
        const std::size_t count = std::min(here.find('\n'), here.size());
        line_.append(here.substr(0, count));
        if (line_.size() > longest_header) line_.erase(0, line_.size() - longest_header / 2);
        buffer_.consume(std::min(count + 1, here.size()));
        if (count < here.size()) {
            if (line_.ends_with('\r')) line_.pop_back();
            return true;
        }
        if (!buffer_.more()) return false;
    }
}

/// Consumes `count` bytes of the stream and, if `text` is not null, appends the bytes to `text`. Returns false if the
/// stream ends earlier. If an allocation fails, the bytes are consumed nevertheless, so that the next message can be
/// found.
bool Framing::take(std::size_t count, std::string* text) {
    bool refused = false;
    for (;;) {
        const std::string_view here = buffer_.rest().substr(0, count);
        try {
            if (text != nullptr && !refused) text->append(here);
        } catch (const std::bad_alloc&) {
            refused = true;
            *text = {};
        }
        buffer_.consume(here.size());
        count -= here.size();
        if (count == 0) break;
        if (!buffer_.more()) return false;
    }
    if (refused) throw std::bad_alloc();
    return true;
}

std::optional<Framed> Framing::next() {
    std::optional<std::uint64_t> length;
    for (;;) {
        if (!line()) return {};
        if (const auto found = content_length(line_)) length = found;
        if (line_.empty() && length) break;
    }
    Framed message;
    const bool fits = *length <= largest_;
    if (!take(*length, fits ? &message.body : nullptr)) return {};
    if (!fits) message.error_text = too_large(*length, largest_);
    return message;
}

/// Appends the bytes up to the next line terminator or the end of the stream. If the line is too large, or an
/// allocation fails (`refused`), the remaining bytes of the line are consumed without being stored. Returns false if
/// the stream has no further byte.
bool LineFraming::line(Framed& message, bool& refused) {
    std::size_t size = 0;
    bool any = false;
    for (bool terminated = false; !terminated && (!buffer_.rest().empty() || buffer_.more()); any = true) {
        const std::string_view here = buffer_.rest();
        const std::size_t count = std::min(here.find('\n'), here.size());
        terminated = count < here.size();
        size += count;
        try {
            if (size <= largest_ && !refused) message.body.append(here.substr(0, count));
        } catch (const std::bad_alloc&) {
            refused = true;
        }
        if (size > largest_ || refused) message.body = {};
        buffer_.consume(std::min(count + 1, here.size()));
    }
    if (size > largest_) message.error_text = too_large(size, largest_);
    return any;
}

std::optional<Framed> LineFraming::next() {
    for (;;) {
        Framed message;
        bool refused = false;
        if (!line(message, refused)) return {};
        if (refused) throw std::bad_alloc();
        if (!message.error_text.empty() || message.body.find_first_not_of(" \t\r") != std::string::npos) return message;
    }
}

std::string framed(std::string_view body) { return fmt::format("Content-Length: {}\r\n\r\n{}", body.size(), body); }

}  // namespace grafverif::rpc
