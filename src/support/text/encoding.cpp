// SPDX-License-Identifier: MIT
#include "support/text/encoding.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

#include "support/printable.hpp"

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

/// The characters that the bytes 0x80 to 0x9F encode in Windows-1252; in Latin-1, these bytes are control characters.
constexpr std::array<std::uint16_t, 32> windows = {0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                                   0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0x8D,   0x017D, 0x8F,
                                                   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                                   0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};

}  // namespace

bool is_utf16(std::string_view text) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return true;
    return text.size() >= 2 && (text[0] == '\0') != (text[1] == '\0');
}

std::string utf8_of_utf16(std::string_view bytes) {
    const bool marked = bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
    const bool big_endian = marked ? bytes[0] == '\xFE' : bytes[0] == '\0';
    if (marked) bytes.remove_prefix(2);
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

std::string utf8_of_latin(std::string_view bytes) {
    std::string text;
    for (const char c : bytes) {
        const auto code = static_cast<unsigned char>(c);
        append_utf8(text, code >= 0x80 && code < 0xA0 ? windows[code - 0x80U] : code);
    }
    return text;
}

bool is_latin(std::string_view text) {
    bool beyond_ascii = false;
    for (const char c : text) {
        if (c == '\0') return false;
        beyond_ascii = beyond_ascii || static_cast<unsigned char>(c) >= 0x80;
    }
    for (std::size_t at = 0; beyond_ascii && at < text.size();) {
        const Glyph glyph = first_glyph(text.substr(at));
        if (glyph.well_formed && glyph.bytes > 1) return false;
        at += glyph.bytes;
    }
    return beyond_ascii;
}

}  // namespace grafverif
