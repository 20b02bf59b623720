// SPDX-License-Identifier: MIT
#include "support/xml_text.hpp"

#include <algorithm>
#include <cstdint>

namespace grafverif {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";

/// The length of the well-formed character that `text` begins with, or 0.
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::uint32_t first = byte(0);
    if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' ? 1 : 0;
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
    std::uint32_t code = first & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80) return 0;
        code = (code << 6U) | (byte(i) & 0x3FU);
    }
    static constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    const bool forbidden = surrogate || code == 0xFFFE || code == 0xFFFF || code > 0x10FFFF;
    return code < least[length] || forbidden ? 0 : length;
}

bool is_plain(char c) { return (c >= 0x20 && c < 0x7F && c != '<' && c != '>' && c != '&') || c == '\n'; }

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
        default:  xml += length == 0 ? replacement : text.substr(0, length);
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
        xml += length == 0 ? replacement : text.substr(0, length);
        text.remove_prefix(length == 0 ? 1 : length);
    }
}

}  // namespace grafverif
