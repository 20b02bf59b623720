// SPDX-License-Identifier: MIT
#include "lsp/framing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace grafverif::lsp {

namespace {

constexpr std::size_t longest_header = 4096;

/// The number in a `Content-Length` line (case-insensitive name); nothing for any other line.
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

bool Framing::more() {
    char room[1U << 16U];
    const std::size_t count = receive_(room);
    held_.append(room, count);
    return count != 0;
}

/// A line without its end. Of an overlong line only the end is kept, so that a header after other bytes is found.
std::optional<std::string> Framing::line() {
    std::size_t looked_at = 0;
    for (;;) {
        const std::size_t end = held_.find('\n', looked_at);
        if (end != std::string::npos) {
            std::string line = held_.substr(0, end);
            held_.erase(0, end + 1);
            if (line.ends_with('\r')) line.pop_back();
            return line;
        }
        if (held_.size() > longest_header) held_.erase(0, held_.size() - longest_header / 2);
        looked_at = held_.size();
        if (!more()) return {};
    }
}

bool Framing::skip(std::size_t count) {
    for (;;) {
        const std::size_t here = std::min(count, held_.size());
        held_.erase(0, here);
        count -= here;
        if (count == 0) return true;
        if (!more()) return false;
    }
}

std::optional<Framed> Framing::next() {
    std::optional<std::uint64_t> length;
    for (;;) {
        const auto line = this->line();
        if (!line) return {};
        if (const auto found = content_length(*line)) length = found;
        if (line->empty() && length) break;
    }
    if (*length > largest_) {
        if (!skip(*length)) return {};
        return Framed{{}, fmt::format("a message of {} bytes; {} are taken at most", *length, largest_)};
    }
    while (held_.size() < *length)
        if (!more()) return {};
    Framed message{held_.substr(0, *length), {}};
    held_.erase(0, *length);
    return message;
}

std::string framed(std::string_view body) { return fmt::format("Content-Length: {}\r\n\r\n{}", body.size(), body); }

}  // namespace grafverif::lsp
