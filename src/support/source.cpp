// SPDX-License-Identifier: MIT
#include "grafverif/support/source.hpp"

#include <algorithm>

namespace grafverif {

Place place(std::string_view text, std::uint32_t offset) {
    const std::string_view before = text.substr(0, offset);
    const auto lines = std::ranges::count(before, '\n');
    const std::size_t line_start = before.rfind('\n') + 1;  // 0 if there is no line feed, because npos + 1 is 0
    return {static_cast<std::uint32_t>(lines + 1), static_cast<std::uint32_t>(before.size() - line_start + 1)};
}

std::string file_and_line(const Sources& sources, const Span& where) {
    if (!where.source.valid()) return {};
    const Source& source = sources[where.source];
    return source.name + ":" + std::to_string(place(source.text, where.begin).line);
}

std::string_view line_at(std::string_view text, std::uint32_t offset) {
    const std::size_t at = std::min<std::size_t>(offset, text.size());
    const std::size_t start = text.substr(0, at).rfind('\n') + 1;
    std::size_t end = text.find('\n', start);
    if (end == std::string_view::npos) end = text.size();
    if (end > start && text[end - 1] == '\r') --end;
    return text.substr(start, end - start);
}

}  // namespace grafverif
