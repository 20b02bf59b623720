// SPDX-License-Identifier: MIT
#include "syntax/readable.hpp"

#include <cstddef>
#include <string_view>

#include "grafverif/support/messages.hpp"

namespace grafverif {

namespace {

std::size_t length_of_character(unsigned char lead) {
    if (lead < 0x80) return 1;
    if (lead >= 0xC2 && lead <= 0xDF) return 2;
    if (lead >= 0xE0 && lead <= 0xEF) return 3;
    if (lead >= 0xF0 && lead <= 0xF4) return 4;
    return 0;
}

/// The length of the UTF-8 character at `at`; 0 where there is none: stray or missing continuation, overlong form,
/// surrogate, beyond U+10FFFF.
std::size_t character_at(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t length = length_of_character(byte(at));
    if (length == 0 || at + length > text.size()) return 0;
    for (std::size_t i = at + 1; i < at + length; ++i)
        if ((byte(i) & 0xC0U) != 0x80U) return 0;
    if (length < 3) return length;
    const unsigned char lead = byte(at), second = byte(at + 1);
    const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
    const bool beyond = (lead == 0xED && second >= 0xA0) || (lead == 0xF4 && second >= 0x90);
    return overlong || beyond ? 0 : length;
}

}  // namespace

bool is_utf16(std::string_view text) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return true;
    return text.size() >= 2 && (text[0] == '\0') != (text[1] == '\0');
}

bool is_readable(Span part, const Sources& sources, Diagnostics& diagnostics) {
    const std::string_view text = std::string_view(sources[part.source].text).substr(0, part.end);
    if (text.size() - part.begin > largest_text) {
        diagnostics.add(messages::file_too_large({part.source, part.begin, part.begin}, largest_text >> 20U));
        return false;
    }
    if (is_utf16(text.substr(part.begin))) {
        diagnostics.add(messages::utf16({part.source, part.begin, part.begin}));
        return false;
    }
    for (std::size_t at = part.begin; at < text.size();) {
        const std::size_t length = character_at(text, at);
        if (length == 0) {
            const auto place = static_cast<std::uint32_t>(at);
            diagnostics.add(
                messages::invalid_utf8({part.source, place, place + 1}, static_cast<unsigned char>(text[at])));
            return false;
        }
        at += length;
    }
    return true;
}

Span without_mark(Span part, const Sources& sources) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    const std::string_view text = std::string_view(sources[part.source].text).substr(part.begin);
    if (text.starts_with(byte_order_mark)) part.begin += static_cast<std::uint32_t>(byte_order_mark.size());
    return part;
}

}  // namespace grafverif
