// SPDX-License-Identifier: MIT
#include "read/encoding.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "grafverif/support/messages.hpp"
#include "grafverif/syntax/st_tree.hpp"

namespace grafverif {

namespace {

void append_utf8(std::string& text, std::uint32_t code) {
    const auto byte = [&text](std::uint32_t value) { text += static_cast<char>(static_cast<unsigned char>(value)); };
    if (code < 0x80) return byte(code);
    if (code < 0x800) return byte(0xC0U | (code >> 6U)), byte(0x80U | (code & 0x3FU));
    if (code < 0x10000)
        return byte(0xE0U | (code >> 12U)), byte(0x80U | ((code >> 6U) & 0x3FU)), byte(0x80U | (code & 0x3FU));
    byte(0xF0U | (code >> 18U)), byte(0x80U | ((code >> 12U) & 0x3FU)), byte(0x80U | ((code >> 6U) & 0x3FU)),
        byte(0x80U | (code & 0x3FU));
}

/// Lone surrogates become U+FFFD.
std::string from_utf16(std::string_view bytes, bool big_endian) {
    std::string text;
    const auto unit = [&](std::size_t at) {
        const auto one = static_cast<unsigned char>(bytes[at]), two = static_cast<unsigned char>(bytes[at + 1]);
        return static_cast<std::uint32_t>(big_endian ? one << 8U | two : two << 8U | one);
    };
    for (std::size_t at = 0; at + 1 < bytes.size(); at += 2) {
        std::uint32_t code = unit(at);
        const bool high = code >= 0xD800 && code < 0xDC00;
        if (high && at + 3 < bytes.size() && unit(at + 2) >= 0xDC00 && unit(at + 2) < 0xE000) {
            code = 0x10000 + ((code - 0xD800) << 10U) + (unit(at + 2) - 0xDC00);
            at += 2;
        } else if (code >= 0xD800 && code < 0xE000) {
            code = 0xFFFD;
        }
        append_utf8(text, code);
    }
    return text;
}

/// What Windows-1252 has where Latin-1 has control characters.
constexpr std::array<std::uint16_t, 32> windows = {
    0x20AC, 0x81, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0x8D, 0x017D, 0x8F,
    0x90, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D, 0x017E, 0x0178};

std::string from_latin(std::string_view bytes) {
    std::string text;
    for (const char c : bytes) {
        const auto code = static_cast<unsigned char>(c);
        append_utf8(text, code >= 0x80 && code < 0xA0 ? windows[code - 0x80U] : code);
    }
    return text;
}

/// The value of `encoding` in the XML declaration, with where it begins; empty where there is none.
std::string_view declared_encoding(std::string_view text) {
    const std::string_view head = text.substr(0, text.starts_with("<?xml") ? std::min(text.find("?>"), text.size()) : 0);
    const std::size_t word = head.find("encoding");
    if (word == std::string_view::npos) return {};
    const std::size_t open = head.find_first_of("\"'", word);
    if (open == std::string_view::npos) return {};
    const std::size_t close = head.find(head[open], open + 1);
    return close == std::string_view::npos ? std::string_view{} : head.substr(open + 1, close - open - 1);
}

}  // namespace

bool make_utf8(Id<Source> source, Sources& sources, Diagnostics& diagnostics) {
    std::string& text = sources[source].text;
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        text = from_utf16(std::string_view(text).substr(2), text[0] == '\xFE');
        return true;
    }
    const std::size_t mark = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    const std::string_view encoding = declared_encoding(std::string_view(text).substr(mark));
    const std::string name = st::capitals(encoding);
    if (mark == 3 || name.empty() || name == "UTF-8" || name == "UTF8" || name == "ASCII" || name == "US-ASCII") return true;
    if (name == "ISO-8859-1" || name == "LATIN1" || name == "WINDOWS-1252" || name == "CP1252") {
        text = from_latin(text);
        return true;
    }
    const auto begin = static_cast<std::uint32_t>(encoding.data() - text.data());
    diagnostics.add(messages::unknown_encoding({source, begin, begin + static_cast<std::uint32_t>(encoding.size())}, encoding));
    return false;
}

}  // namespace grafverif
