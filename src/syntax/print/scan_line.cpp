// SPDX-License-Identifier: MIT
#include "syntax/print/scan_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>

namespace grafverif {

namespace {

constexpr std::string_view separators = ", \t;\r";

/// Returns the first `most` + 1 words of `line`. The limit avoids splitting an extremely long line completely.
std::vector<std::string_view> words_of(std::string_view line, std::size_t most) {
    std::vector<std::string_view> words;
    while (words.size() <= most) {
        const std::size_t begin = line.find_first_not_of(separators);
        if (begin == std::string_view::npos) break;
        line.remove_prefix(begin);
        words.push_back(line.substr(0, line.find_first_of(separators)));
        line.remove_prefix(words.back().size());
    }
    return words;
}

bool is_word(std::string_view text, std::string_view word) {
    return std::ranges::equal(text, word, [](char given, char wanted) {
        return (given >= 'A' && given <= 'Z' ? static_cast<char>(given - 'A' + 'a') : given) == wanted;
    });
}

std::optional<std::int64_t> number(std::string_view text) {
    if (is_word(text, "true")) return 1;
    if (is_word(text, "false")) return 0;
    std::int64_t value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{} || end != text.data() + text.size()) return {};
    return value;
}

std::string range_text(const Type& type) {
    return type.boolean ? "0 to 1" : fmt::format("{} to {}", type.low, type.high);
}

}  // namespace

std::string scan_line(std::span<const std::int64_t> values) {
    std::string line;
    for (const std::int64_t value : values) {
        if (!line.empty()) line += ',';
        fmt::format_to(std::back_inserter(line), "{}", value);
    }
    return line;
}

ScanValues read_scan_line(std::string_view line, std::span<const ScanColumn> columns) {
    const std::vector<std::string_view> words = words_of(line, columns.size());
    if (words.size() != columns.size()) {
        const bool more = words.size() > columns.size();
        return {{},
                fmt::format("{}{} value{}, expected {}", more ? "more than " : "", more ? columns.size() : words.size(),
                            (more ? columns.size() : words.size()) == 1 ? "" : "s", columns.size())};
    }
    std::vector<std::int64_t> values;
    values.reserve(words.size());
    for (std::size_t k = 0; k < words.size(); ++k) {
        const std::optional<std::int64_t> value = number(words[k]);
        const Type& type = columns[k].type;
        if (!value) return {{}, fmt::format("`{}` is not a value of `{}`", shown_line(words[k]), columns[k].name)};
        if (*value < type.low || *value > type.high)
            return {{},
                    fmt::format("the value `{}` of `{}` is outside the range {}", *value, columns[k].name,
                                range_text(type))};
        values.push_back(*value);
    }
    return {std::move(values), {}};
}

std::size_t longest_scan_line(std::size_t columns) {
    constexpr std::size_t least = 4096, per_column = 32;
    return std::max(least, columns * per_column);
}

std::string shown_line(std::string_view line) {
    constexpr std::size_t longest = 60;
    std::string text;
    for (const char c : line.substr(0, longest)) text += c >= ' ' && c <= '~' ? c : '?';
    return line.size() > longest ? text + "..." : text;
}

}  // namespace grafverif
