// SPDX-License-Identifier: MIT
#include "lsp/text.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "support/text/encoding.hpp"

namespace grafverif::lsp {

namespace {

struct Character {
    std::size_t bytes = 1;
    std::uint32_t units = 1;  ///< number of UTF-16 code units
};

/// Returns the length of the first character of `text`. If the character is truncated, its length is the number of
/// available bytes.
Character first_character(std::string_view text) {
    const auto byte = static_cast<unsigned char>(text[0]);
    const std::size_t most = byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : byte >= 0xC0 ? 2 : 1;
    std::size_t bytes = 1;
    while (bytes < most && bytes < text.size() && continues_character(text[bytes])) ++bytes;
    return {bytes, bytes == 4 ? 2U : 1U};
}

constexpr std::size_t between_anchors = 256;  ///< distance of two anchors in a long line, in bytes

}  // namespace

Text::Text(std::string bytes) : bytes_(std::move(bytes)) {
    const std::string_view text = bytes_;
    Position here;
    for (std::size_t at = 0; at < text.size();) {
        const char byte = text[at];
        const Character next = first_character(text.substr(at));
        at += next.bytes;
        const bool ends = byte == '\n' || (byte == '\r' && !text.substr(at).starts_with('\n'));
        here = ends ? Position{here.line + 1, 0} : Position{here.line, here.character + next.units};
        const bool far = byte != '\r' && at - anchors_.back().offset >= between_anchors;
        if (ends || far) anchors_.push_back({static_cast<std::uint32_t>(at), here});
    }
}

Position Text::position(std::size_t offset) const {
    offset = std::min(offset, bytes_.size());
    const Anchor& anchor = *std::prev(std::ranges::upper_bound(anchors_, offset, {}, &Anchor::offset));
    Position found = anchor.position;
    for (std::size_t at = anchor.offset; at < offset;) {
        const Character next = first_character(std::string_view(bytes_).substr(at));
        at += next.bytes;
        if (at <= offset) found.character += next.units;
    }
    return found;
}

std::uint32_t Text::offset(Position position) const {
    if (position.line >= lines()) return static_cast<std::uint32_t>(bytes_.size());
    const Anchor& anchor = *std::prev(std::ranges::upper_bound(anchors_, position, {}, &Anchor::position));
    std::size_t at = anchor.offset;
    std::uint32_t units = anchor.position.character;
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

}  // namespace grafverif::lsp
