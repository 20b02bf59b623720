// SPDX-License-Identifier: MIT
#include "app/commands.hpp"

#include <fmt/format.h>

#include <charconv>
#include <vector>

namespace grafverif::app {

namespace {

std::string_view without_comment(std::string_view line) {
    return line.substr(0, std::min(line.find('#'), line.find("//")));
}

/// Words are separated by blanks; `=` is a word of its own.
std::vector<std::string> words(std::string_view line) {
    std::vector<std::string> list;
    bool open = false;
    for (const char c : line) {
        const bool blank = c == ' ' || c == '\t' || c == '\r';
        if (c == '=') list.emplace_back("=");
        else if (!blank && open) list.back() += c;
        else if (!blank) list.emplace_back(1, c);
        open = !blank && c != '=';
    }
    return list;
}

std::optional<std::int64_t> number(std::string_view text, std::string_view* rest = nullptr) {
    std::int64_t value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{}) return {};
    if (rest != nullptr) *rest = {end, static_cast<std::size_t>(text.data() + text.size() - end)};
    else if (end != text.data() + text.size()) return {};
    return value;
}

Command wait_of(const std::vector<std::string>& list) {
    if (list.size() == 1) return WaitCommand{};
    std::string_view unit;
    const std::optional<std::int64_t> count = number(list[1], &unit);
    if (list.size() == 3 && unit.empty()) unit = list[2];
    const std::int64_t factor = unit == "ms" ? 1 : unit == "s" ? 1000 : unit == "min" ? 60'000 : 0;
    constexpr std::int64_t longest = std::int64_t{1} << 40U;
    if (!count || factor == 0 || *count <= 0 || *count > longest || list.size() > 3)
        return BadCommand{"`wait` takes a duration such as `3s`, `250ms` or `2min`"};
    return WaitCommand{*count * factor};
}

Command set_of(const std::vector<std::string>& list) {
    if (list.size() != 3) return BadCommand{"write `NAME = VALUE`"};
    if (list[2] == "true" || list[2] == "false") return SetCommand{list[0], list[2] == "true"};
    const std::optional<std::int64_t> value = number(list[2]);
    if (!value) return BadCommand{fmt::format("`{}` is no value; write `true`, `false` or a whole number", list[2])};
    return SetCommand{list[0], *value};
}

}  // namespace

Command command_of(std::string_view line) {
    const std::vector<std::string> list = words(without_comment(line));
    if (list.empty()) return NoCommand{};
    const std::string& first = list[0];
    if (list.size() > 1 && list[1] == "=") return set_of(list);
    if (first == "wait" || first == "w") return wait_of(list);
    if (first == "do" && (list.size() == 2 || list.size() == 3))
        return DoCommand{list[1], list.size() == 3 ? list[2] : ""};
    if (list.size() == 1) {
        if (first == "back" || first == "b") return BackCommand{};
        if (first == "quit" || first == "q") return QuitCommand{};
        if (first == "help" || first == "?") return HelpCommand{};
        if (const auto choice = number(first); choice && *choice > 0)
            return ChooseCommand{static_cast<std::size_t>(*choice)};
    }
    return BadCommand{fmt::format("`{}` is no command; `help` lists them", first)};
}

}  // namespace grafverif::app
