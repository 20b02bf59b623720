// SPDX-License-Identifier: MIT
#include "syntax/language/readable.hpp"

#include <cstddef>
#include <string_view>

#include "support/messages.hpp"
#include "support/printable.hpp"

namespace grafverif {

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
        const Glyph glyph = first_glyph(text.substr(at));
        if (!glyph.well_formed) {
            const auto place = static_cast<std::uint32_t>(at);
            diagnostics.add(
                messages::invalid_utf8({part.source, place, place + 1}, static_cast<unsigned char>(text[at])));
            return false;
        }
        at += glyph.bytes;
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
