// SPDX-License-Identifier: MIT
#include "support/json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "support/printable.hpp"

namespace grafverif {

std::string json_text(const nlohmann::ordered_json& value, int indent) {
    const std::string text = value.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    const auto ascii = [](char c) { return static_cast<unsigned char>(c) < 0x7F; };
    if (std::ranges::all_of(text, ascii)) return text;
    std::string clean;
    for (std::string_view rest = text; !rest.empty();) {
        // All characters that a terminal interprets are below U+10000, so one `\u` escape represents each of them. The
        // characters occur only inside JSON strings, where escapes are allowed.
        const Glyph glyph = first_glyph(rest);
        if (glyph.obeyed && !ascii(rest.front())) clean += fmt::format("\\u{:04x}", glyph.code);
        else clean += rest.substr(0, glyph.bytes);
        rest.remove_prefix(glyph.bytes);
    }
    return clean;
}

}  // namespace grafverif
