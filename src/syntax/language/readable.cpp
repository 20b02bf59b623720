// SPDX-License-Identifier: MIT
#include "syntax/language/readable.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "support/messages.hpp"
#include "support/messages_system.hpp"
#include "support/printable.hpp"
#include "support/text/encoding.hpp"

namespace grafverif {

void make_utf8(Id<Source> source, Sources& sources, Diagnostics& diagnostics) {
    std::string& text = sources[source].text;
    if (text.size() > largest_text) return;
    if (is_utf16(text)) {
        if (text.size() % 2 != 0) return;  // `is_readable` reports a text of odd length
        text = utf8_of_utf16(text);
    } else if (is_latin(text)) {
        const auto first = std::ranges::find_if(text, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
        const auto at = static_cast<std::uint32_t>(first - text.begin());
        text = utf8_of_latin(text);
        const std::size_t bytes = first_glyph(std::string_view(text).substr(at)).bytes;
        diagnostics.add(messages::read_as_latin({source, at, at + static_cast<std::uint32_t>(bytes)}));
    }
}

bool is_readable(Span part, const Sources& sources, Diagnostics& diagnostics) {
    const std::string_view text = std::string_view(sources[part.source].text).substr(0, part.end);
    if (text.size() - part.begin > largest_text) {
        diagnostics.add(messages::file_too_large({part.source, part.begin, part.begin}, largest_text >> 20U));
        return false;
    }
    if (is_utf16(text.substr(part.begin))) {
        const Span where{part.source, part.begin, part.begin};
        const bool incomplete = (text.size() - part.begin) % 2 != 0;
        diagnostics.add(incomplete ? messages::incomplete_utf16(where) : messages::utf16(where));
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
