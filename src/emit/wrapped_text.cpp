// SPDX-License-Identifier: MIT
#include "emit/wrapped_text.hpp"

#include <algorithm>
#include <ostream>
#include <string>

namespace grafverif {

void print_wrapped(std::ostream& out, std::string_view text, std::string_view comment) {
    constexpr std::size_t width = 118;
    while (!text.empty()) {
        std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
        const bool whole = line.substr(indent).starts_with(comment);
        const std::string margin(indent + 4, ' ');
        while (!whole && line.size() > width) {
            const std::size_t space = line.rfind(' ', width);
            if (space == std::string_view::npos || space <= margin.size()) break;
            out << line.substr(0, space) << '\n' << margin;
            line.remove_prefix(space + 1);
        }
        out << line << '\n';
    }
}

}  // namespace grafverif
