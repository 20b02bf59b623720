// SPDX-License-Identifier: MIT
#include "simulate/commands.hpp"

#include <fmt/format.h>

#include <charconv>
#include <vector>

#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

std::string_view without_comment(std::string_view line) {
    return line.substr(0, std::min(line.find('#'), line.find("//")));
}

/// Words are separated by blanks; `=` and `,` are words of their own.
std::vector<std::string> words(std::string_view line) {
    std::vector<std::string> list;
    bool open = false;
    for (const char c : line) {
        const bool blank = c == ' ' || c == '\t' || c == '\r';
        if (c == '=' || c == ',') list.emplace_back(1, c);
        else if (!blank && open) list.back() += c;
        else if (!blank) list.emplace_back(1, c);
        open = !blank && c != '=' && c != ',';
    }
    return list;
}

std::optional<std::int64_t> number(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{} || end != text.data() + text.size()) return {};
    return value;
}

Command wait_of(const std::vector<std::string>& list) {
    if (list.size() == 1) return WaitCommand{};
    const auto milliseconds = duration_ms(list.size() == 2 ? list[1] : list[1] + " " + list[2]);
    if (!milliseconds || list.size() > 3) return BadCommand{"`wait` takes a duration such as `3s`, `250ms` or `2min`"};
    return WaitCommand{*milliseconds};
}

Command set_of(const std::vector<std::string>& list) {
    SetCommand set;
    for (std::size_t k = 0; k < list.size(); k += 4) {
        const bool whole = k + 2 < list.size() && list[k + 1] == "=" && (k + 3 == list.size() || list[k + 3] == ",");
        if (!whole || k + 4 == list.size()) return BadCommand{"write `NAME = VALUE`"};
        const std::string& value = list[k + 2];
        const std::optional<std::int64_t> counted =
            value == "true" || value == "false" ? value == "true" : number(value);
        if (!counted)
            return BadCommand{fmt::format("`{}` is no value; write `true`, `false` or a whole number", value)};
        set.settings.push_back({list[k], *counted});
    }
    return set;
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
    if (first == "force") {
        if (list.size() == 3 && (list[2] == "on" || list[2] == "off")) return ForceCommand{list[1], list[2] == "on"};
        return BadCommand{"write `force STEP on` or `force STEP off`"};
    }
    if (list.size() == 1) {
        if (first == "back" || first == "b") return BackCommand{};
        if (first == "quit" || first == "q") return QuitCommand{};
        if (first == "help" || first == "?") return HelpCommand{};
        if (const auto choice = number(first); choice && *choice > 0)
            return ChooseCommand{static_cast<std::size_t>(*choice)};
    }
    return BadCommand{fmt::format("`{}` is no command; `help` lists them", first)};
}

}  // namespace grafverif
