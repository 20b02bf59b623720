// SPDX-License-Identifier: MIT
#include "emit/wrapped_text.hpp"

#include <algorithm>
#include <ostream>
#include <string>

namespace grafverif {

std::vector<std::string_view> wrapped(std::string_view text, std::size_t width, bool (*breaks)(std::string_view)) {
    constexpr std::size_t none = std::string_view::npos;
    std::vector<std::string_view> lines;
    while (text.size() > width) {
        // The position of the last break within the width; if no break is within the width, the position of the first
        // break.
        std::size_t end = none;
        for (auto blank = text.find(' '); blank != none && (blank <= width || end == none);
             blank = text.find(' ', blank + 1))
            if (breaks(text.substr(0, blank))) end = blank;
        if (end == none) break;
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end + 1);
    }
    lines.push_back(text);
    return lines;
}

void print_wrapped(std::ostream& out, std::string_view text, std::string_view comment) {
    constexpr std::size_t width = 118;
    const auto after_token = [](std::string_view before) { return before.find_first_not_of(' ') != before.npos; };
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
        const bool whole = line.substr(indent).starts_with(comment);
        std::string margin = "";
        for (const std::string_view part : wrapped(line, whole ? line.size() : width, after_token)) {
            out << margin << part << '\n';
            margin = std::string(indent + 4, ' ');
        }
    }
}

}  // namespace grafverif
