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

/// Returns the number in a line `Content-Length: N` (in upper or lower case); empty for any other line.
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

}  // namespace

Framing::Framing(Receive receive, std::size_t largest) : receive_(std::move(receive)), largest_(largest) {
    line_.reserve(longest_header + buffer_.size());
}

bool Framing::more() {
    begin_ = 0;
    end_ = receive_(buffer_);
    return end_ != 0;
}

/// Reads a line without its terminator. If the line is too long, only its last bytes are stored, so that a header after
/// other bytes is found.
bool Framing::line() {
    for (line_.clear();;) {
        const std::string_view here(buffer_.data() + begin_, end_ - begin_);
        const std::size_t count = std::min(here.find('\n'), here.size());
        line_.append(here.substr(0, count));
        if (line_.size() > longest_header) line_.erase(0, line_.size() - longest_header / 2);
        begin_ += count;
        if (count < here.size()) {
            ++begin_;
            if (line_.ends_with('\r')) line_.pop_back();
            return true;
        }
        if (!more()) return false;
    }
}

/// Consumes `count` bytes of the stream and, if `text` is not null, appends them to `text`. Returns false if the stream
/// ends earlier. If an allocation fails, the bytes are consumed nevertheless, so that the next message is found.
bool Framing::take(std::size_t count, std::string* text) {
    bool refused = false;
    for (;;) {
        const std::size_t here = std::min(count, end_ - begin_);
        try {
            if (text != nullptr && !refused) text->append(buffer_.data() + begin_, here);
        } catch (const std::bad_alloc&) {
            refused = true;
            *text = {};
        }
        begin_ += here;
        count -= here;
        if (count == 0) break;
        if (!more()) return false;
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
    if (!fits) message.error_text = fmt::format("a message of {} bytes exceeds the limit of {}", *length, largest_);
    return message;
}

/// Appends the bytes up to the next line terminator or the end of the stream. If the line is too large or does not fit
/// into memory (`refused`), its remaining bytes are consumed without being stored. Returns false if there was no byte.
bool LineFraming::line(Framed& message, bool& refused) {
    std::size_t size = 0;
    const auto check_size = [&] {
        if (size <= largest_) return;
        message.error_text = fmt::format("a message of {} bytes exceeds the limit of {}", size, largest_);
    };
    for (bool any = false;; any = true) {
        if (begin_ == end_) {
            begin_ = 0;
            end_ = receive_(buffer_);
            if (end_ == 0) return check_size(), any;
        }
        const std::string_view here(buffer_.data() + begin_, end_ - begin_);
        const std::size_t count = std::min(here.find('\n'), here.size());
        size += count;
        try {
            if (size <= largest_ && !refused) message.body.append(here.substr(0, count));
        } catch (const std::bad_alloc&) {
            refused = true;
        }
        if (size > largest_ || refused) message.body = {};
        begin_ += std::min(count + 1, here.size());
        if (count == here.size()) continue;
        check_size();
        return true;
    }
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
