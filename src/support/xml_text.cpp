// SPDX-License-Identifier: MIT
#include "support/xml_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/printable.hpp"

namespace grafverif {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

/// Returns the length of the first character of `text`, or 0 if XML does not permit the character.
std::size_t character_length(std::string_view text) {
    const Glyph glyph = first_glyph(text);
    const bool control = glyph.code < 0x20 && glyph.code != '\t' && glyph.code != '\n';
    return !glyph.well_formed || control || glyph.code == 0xFFFE || glyph.code == 0xFFFF ? 0 : glyph.bytes;
}

bool is_plain(char c) { return (c >= 0x20 && c < 0x7F && c != '<' && c != '>' && c != '&') || c == '\n'; }

/// Appends a character. A character that a terminal interprets is written as a character reference, which every XML
/// parser reads as the same character.
void append_shown(std::string_view text, std::size_t length, std::string& xml) {
    const Glyph glyph = first_glyph(text);
    if (length == 0) xml += replacement;
    else if (glyph.obeyed && text.front() != '\t') xml += fmt::format("&#x{:x};", glyph.code);
    else xml += text.substr(0, length);
}

}  // namespace

void escape_xml(std::string_view text, std::string& xml) {
    while (!text.empty()) {
        std::size_t plain = 0;
        while (plain < text.size() && is_plain(text[plain])) ++plain;
        xml += text.substr(0, plain);
        text.remove_prefix(plain);
        if (text.empty()) return;
        std::size_t length = character_length(text);
        switch (text.front()) {
        case '<': xml += "&lt;"; break;
        case '>': xml += "&gt;"; break;
        case '&': xml += "&amp;"; break;
        default: append_shown(text, length, xml);
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
}

std::string attribute_xml(std::string_view text) {
    std::string xml;
    while (!text.empty()) {
        const std::size_t plain = std::min(text.find_first_of("\"\n\t"), text.size());
        escape_xml(text.substr(0, plain), xml);
        if (plain == text.size()) break;
        xml += text[plain] == '"' ? "&quot;" : text[plain] == '\n' ? "&#10;" : "&#9;";
        text.remove_prefix(plain + 1);
    }
    return xml;
}

void comment_xml(std::string_view text, std::string& xml) {
    for (; !text.empty();) {
        const std::size_t length = character_length(text);
        if (text.front() == '-' && xml.ends_with('-')) xml += ' ';
        const bool hidden = length == 0 || (first_glyph(text).obeyed && text.front() != '\t' && text.front() != '\n');
        xml += hidden ? replacement : text.substr(0, length);
        text.remove_prefix(length == 0 ? 1 : length);
    }
}

}  // namespace grafverif
