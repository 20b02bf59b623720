// SPDX-License-Identifier: MIT
#include <array>
#include <charconv>

#include "support/xml_text.hpp"

namespace grafverif {

namespace {

/// Appends the character in UTF-8.
void append_character(std::string& text, std::uint32_t code) {
    const auto byte = [&text](std::uint32_t value) { text += static_cast<char>(static_cast<unsigned char>(value)); };
    if (code < 0x80) {
        byte(code);
    } else if (code < 0x800) {
        byte(0xC0U | (code >> 6U));
        byte(0x80U | (code & 0x3FU));
    } else if (code < 0x10000) {
        byte(0xE0U | (code >> 12U));
        byte(0x80U | ((code >> 6U) & 0x3FU));
        byte(0x80U | (code & 0x3FU));
    } else {
        byte(0xF0U | (code >> 18U));
        byte(0x80U | ((code >> 12U) & 0x3FU));
        byte(0x80U | ((code >> 6U) & 0x3FU));
        byte(0x80U | (code & 0x3FU));
    }
}

/// Appends the character denoted by `&NAME;`. Returns false if the reference is unknown. Only the five predefined
/// entities of XML are known.
bool append_reference(std::string& text, std::string_view name) {
    struct Entity {
        std::string_view name = {};
        char character = 0;
    };
    constexpr std::array<Entity, 5> entities = {
        {{"lt", '<'}, {"gt", '>'}, {"amp", '&'}, {"quot", '"'}, {"apos", '\''}}};
    for (const Entity& entity : entities) {
        if (entity.name != name) continue;
        text += entity.character;
        return true;
    }
    if (!name.starts_with('#')) return false;
    const bool hexadecimal = name.starts_with("#x");
    const std::string_view digits = name.substr(hexadecimal ? 2 : 1);
    std::uint32_t code = 0;
    const auto [end, failure] =
        std::from_chars(digits.data(), digits.data() + digits.size(), code, hexadecimal ? 16 : 10);
    if (failure != std::errc() || end != digits.data() + digits.size() || code == 0 || code > 0x10FFFF ||
        (code >= 0xD800 && code < 0xE000))
        return false;
    append_character(text, code);
    return true;
}

}  // namespace

std::string unescape_xml(std::string_view written, std::uint32_t begin, std::vector<std::uint32_t>& origins) {
    constexpr std::size_t longest_reference = 12;
    std::string text;
    for (std::size_t at = 0; at < written.size();) {
        const std::size_t end =
            written[at] == '&' ? written.substr(at, longest_reference).find(';') : std::string_view::npos;
        if (end == std::string_view::npos || !append_reference(text, written.substr(at + 1, end - 1))) {
            text += written[at];
            origins.push_back(begin + static_cast<std::uint32_t>(at++));
            continue;
        }
        origins.resize(text.size(), begin + static_cast<std::uint32_t>(at));
        at += end + 1;
    }
    origins.push_back(begin + static_cast<std::uint32_t>(written.size()));
    return text;
}

std::string unescape_xml(std::string_view written) {
    std::vector<std::uint32_t> origins;
    return written.find('&') == std::string_view::npos ? std::string(written) : unescape_xml(written, 0, origins);
}

}  // namespace grafverif
