// SPDX-License-Identifier: MIT
#include "lsp/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace grafverif::lsp {

namespace {

struct Character {
    std::size_t bytes = 1;
    std::uint32_t units = 1;  ///< of UTF-16
};

/// The character that begins with `text`; a byte that begins none stands for itself.
Character first_character(std::string_view text) {
    const auto byte = static_cast<unsigned char>(text[0]);
    const std::size_t bytes = byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : byte >= 0xC0 ? 2 : 1;
    return {std::min(bytes, text.size()), bytes == 4 ? 2U : 1U};
}

}  // namespace

Text::Text(std::string bytes) : bytes_(std::move(bytes)) {
    for (std::size_t at = 0; at < bytes_.size(); ++at) {
        const bool ends =
            bytes_[at] == '\n' || (bytes_[at] == '\r' && (at + 1 == bytes_.size() || bytes_[at + 1] != '\n'));
        if (ends) starts_.push_back(static_cast<std::uint32_t>(at + 1));
    }
}

Position Text::position(std::size_t offset) const {
    offset = std::min(offset, bytes_.size());
    const auto line = std::prev(std::ranges::upper_bound(starts_, offset));
    Position found{static_cast<std::uint32_t>(line - starts_.begin()), 0};
    for (std::size_t at = *line; at < offset;) {
        const Character next = first_character(std::string_view(bytes_).substr(at));
        at += next.bytes;
        if (at <= offset) found.character += next.units;
    }
    return found;
}

std::uint32_t Text::offset(Position position) const {
    if (position.line >= starts_.size()) return static_cast<std::uint32_t>(bytes_.size());
    std::size_t at = starts_[position.line];
    std::uint32_t units = 0;
    while (at < bytes_.size() && bytes_[at] != '\n' && bytes_[at] != '\r') {
        const Character next = first_character(std::string_view(bytes_).substr(at));
        units += next.units;
        if (units > position.character) break;
        at += next.bytes;
    }
    return static_cast<std::uint32_t>(at);
}

std::string changed(const Text& before, const Change& change) {
    if (!change.range) return change.text;
    const std::uint32_t begin = before.offset(change.range->start);
    const std::uint32_t end = std::max(begin, before.offset(change.range->end));
    std::string after = before.bytes().substr(0, begin);
    after += change.text;
    after.append(before.bytes(), end, std::string::npos);
    return after;
}

std::string path_of_uri(std::string_view uri) {
    constexpr std::string_view scheme = "file://";
    if (!uri.starts_with(scheme)) return std::string(uri);
    uri.remove_prefix(scheme.size());
    uri.remove_prefix(std::min(uri.find('/'), uri.size()));  // the host is this one
    std::string path;
    for (std::size_t at = 0; at < uri.size(); ++at) {
        unsigned byte = 0;
        const bool coded =
            uri[at] == '%' && at + 2 < uri.size() &&
            std::from_chars(uri.data() + at + 1, uri.data() + at + 3, byte, 16).ptr == uri.data() + at + 3;
        path += coded ? static_cast<char>(byte) : uri[at];
        if (coded) at += 2;
    }
    return path;
}

std::string uri_of_path(std::string_view path) {
    if (!path.starts_with('/') && path.find(':') != std::string_view::npos) return std::string(path);
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
    std::string uri = path.starts_with('/') ? "file://" : "grafverif:";
    for (const char byte : path) {
        if (plain.find(byte) != std::string_view::npos) uri += byte;
        else uri += fmt::format("%{:02X}", static_cast<unsigned char>(byte));
    }
    return uri;
}

}  // namespace grafverif::lsp
