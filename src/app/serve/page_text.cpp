// SPDX-License-Identifier: MIT
#include "app/serve/page_text.hpp"

#include "edit/text_edit.hpp"
#include "support/text/encoding.hpp"

namespace grafverif::app {

namespace {

/// True if `text` has the two bytes `\r\n` at `at`.
bool is_double_end(std::string_view text, std::size_t at) { return text.substr(at, 2) == "\r\n"; }

}  // namespace

std::string page_text(std::string_view text) {
    std::string page;
    page.reserve(text.size());
    for (std::size_t at = 0; at < text.size(); ++at)
        if (!is_double_end(text, at)) page += text[at] == '\r' ? '\n' : text[at];
    return page;
}

std::string with_line_ends(std::string_view page, std::string_view file) {
    const std::size_t first = file.find('\n');
    const bool doubled = first != std::string_view::npos && first > 0 && file[first - 1] == '\r';
    std::string text;
    for (const char c : page) text += c == '\n' && doubled ? "\r\n" : std::string(1, c);
    return text;
}

std::string text_of_page(std::string_view page, std::string_view before) {
    const edit::TextEdit change = edit::difference(page_text(before), page);
    std::size_t begin = 0, end = 0, shown = 0;
    for (std::size_t at = 0; at <= before.size(); ++at) {
        if (shown == change.begin && (at == 0 || !is_double_end(before, at - 1))) begin = at;
        if (shown == change.end && (at == 0 || !is_double_end(before, at - 1))) end = at;
        if (at < before.size() && !is_double_end(before, at)) ++shown;
        if (shown > change.end) break;
    }
    std::string text(before.substr(0, begin));
    return text.append(with_line_ends(change.replacement, before)).append(before.substr(end));
}

PagePositions::PagePositions(std::string_view text) {
    units_.reserve(text.size() + 1);
    std::uint32_t units = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        units_.push_back(units);
        if (continues_character(text[at]) || is_double_end(text, at)) continue;
        units += static_cast<unsigned char>(text[at]) >= 0xF0U ? 2U : 1U;
    }
    units_.push_back(units);
}

}  // namespace grafverif::app
