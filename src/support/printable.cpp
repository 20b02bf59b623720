// SPDX-License-Identifier: MIT
#include "support/printable.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace grafverif {

namespace {

struct CodeRange {
    std::uint32_t first = 0, last = 0;
};

/// Directional marks, embeddings, overrides, isolates and line separators. Control characters are tested separately.
constexpr std::array directions = {CodeRange{0x061C, 0x061C}, CodeRange{0x200E, 0x200F}, CodeRange{0x2028, 0x202E},
                                   CodeRange{0x2066, 0x2069}};

/// Characters of width 0: the most common combining marks and joiners. The list is incomplete: after a missing
/// character, a caret may be one column off.
constexpr std::array without_width = {CodeRange{0x0300, 0x036F}, CodeRange{0x200B, 0x200D}, CodeRange{0x20D0, 0x20FF},
                                      CodeRange{0x2060, 0x2064}, CodeRange{0xFE00, 0xFE0F}, CodeRange{0xFE20, 0xFE2F},
                                      CodeRange{0xFEFF, 0xFEFF}};

/// Characters of width 2: East Asian characters and pictographs.
constexpr std::array wide = {CodeRange{0x1100, 0x115F},   CodeRange{0x2E80, 0x303E},   CodeRange{0x3041, 0xA4CF},
                             CodeRange{0xAC00, 0xD7A3},   CodeRange{0xF900, 0xFAFF},   CodeRange{0xFE30, 0xFE6F},
                             CodeRange{0xFF00, 0xFF60},   CodeRange{0xFFE0, 0xFFE6},   CodeRange{0x1F300, 0x1F64F},
                             CodeRange{0x1F680, 0x1F6FF}, CodeRange{0x1F900, 0x1F9FF}, CodeRange{0x20000, 0x3FFFD}};

template <std::size_t N>
bool is_in(const std::array<CodeRange, N>& ranges, std::uint32_t code) {
    return std::ranges::any_of(ranges,
                               [code](const CodeRange& range) { return range.first <= code && code <= range.last; });
}

/// Decodes a character according to RFC 3629: overlong forms, surrogates and codes above U+10FFFF are invalid.
Glyph decoded(std::string_view text) {
    constexpr Glyph none{1, 0xFFFD, false, true, 1};
    const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
    const std::uint32_t lead = byte(0);
    if (lead < 0x80) return {1, lead};
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return none;
    std::uint32_t code = lead & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) return none;
        code = (code << 6U) | (byte(i) & 0x3FU);
    }
    constexpr std::array<std::uint32_t, 5> least = {0, 0, 0x80, 0x800, 0x10000};
    if (code < least[length] || (code >= 0xD800 && code <= 0xDFFF) || code > 0x10FFFF) return none;
    return {length, code};
}

std::string shown(std::string_view text, std::string_view kept) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const Glyph glyph = first_glyph(text);
        if (glyph.obeyed && kept.find(text.front()) == std::string_view::npos) result += '?';
        else result += text.substr(0, glyph.bytes);
        text.remove_prefix(glyph.bytes);
    }
    return result;
}

}  // namespace

Glyph first_glyph(std::string_view text) {
    Glyph glyph = decoded(text);
    if (glyph.well_formed)
        glyph.obeyed = glyph.code < 0x20 || (glyph.code >= 0x7F && glyph.code < 0xA0) || is_in(directions, glyph.code);
    constexpr std::uint32_t first_of_tables = 0x300;
    if (!glyph.obeyed && glyph.code >= first_of_tables)
        glyph.columns = is_in(without_width, glyph.code) ? 0 : is_in(wide, glyph.code) ? 2 : 1;
    return glyph;
}

std::size_t columns_of(std::string_view text) {
    std::size_t columns = 0;
    for (; !text.empty(); text.remove_prefix(first_glyph(text).bytes)) columns += first_glyph(text).columns;
    return columns;
}

std::size_t bytes_within(std::string_view text, std::size_t columns) {
    std::size_t bytes = 0;
    for (std::size_t used = 0; bytes < text.size();) {
        const Glyph glyph = first_glyph(text.substr(bytes));
        if ((used += glyph.columns) > columns) break;
        bytes += glyph.bytes;
    }
    return bytes;
}

std::string cut_to(std::string_view text, std::size_t columns) {
    if (bytes_within(text, columns) == text.size()) return std::string(text);
    return std::string(text.substr(0, bytes_within(text, columns - 1))) + "…";
}

std::string padded(std::string_view text, std::size_t columns) {
    return std::string(text) + std::string(columns - std::min(columns, columns_of(text)), ' ');
}

std::string printable(std::string_view text) { return shown(text, "\t"); }

std::string printable_lines(std::string_view text) { return shown(text, "\t\n"); }

}  // namespace grafverif
