// SPDX-License-Identifier: MIT
#include "simulate/commands.hpp"

#include <fmt/format.h>

#include <vector>

#include "syntax/print/dialect.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif {

namespace {

std::string_view without_comment(std::string_view line) {
    return line.substr(0, std::min(line.find('#'), line.find("//")));
}

/// Splits a line into words, which are separated by spaces. `=` and `,` are always separate words.
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

Command wait_of(const std::vector<std::string>& list) {
    if (list.size() == 1) return WaitCommand{};
    const auto milliseconds = duration_ms(list.size() == 2 ? list[1] : list[1] + " " + list[2]);
    if (!milliseconds || list.size() > 3)
        return BadCommand{"`wait` requires a duration; write `3s`, `250ms` or `2min`, for example"};
    return WaitCommand{*milliseconds};
}

Command set_of(const std::vector<std::string>& list) {
    SetCommand set;
    for (std::size_t k = 0; k < list.size(); k += 4) {
        const bool whole = k + 2 < list.size() && list[k + 1] == "=" && (k + 3 == list.size() || list[k + 3] == ",");
        if (!whole || k + 4 == list.size()) return BadCommand{"the assignment is incomplete; write `NAME = VALUE`"};
        const std::string& value = list[k + 2];
        const std::optional<std::int64_t> counted = value_of(value);
        if (!counted)
            return BadCommand{fmt::format("invalid value `{}`; write `true`, `false` or a whole number", value)};
        set.settings.push_back({list[k], *counted});
    }
    return set;
}

/// Returns the text of the line after its first `count` words.
std::string_view skip_words(std::string_view line, std::size_t count) {
    for (; count > 0; --count) {
        line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
        line.remove_prefix(std::min(line.find_first_of(" \t"), line.size()));
    }
    return line;
}

Command expectation(std::string_view text, std::optional<std::int64_t> response_timeout_ms) {
    auto read = parse_expectation(text);
    if (auto* const error_text = std::get_if<std::string>(&read)) return BadCommand{std::move(*error_text)};
    return ExpectCommand{std::get<Expectation>(std::move(read)), response_timeout_ms};
}

Command expect_of(std::string_view line, const std::vector<std::string>& list) {
    if (list.size() < 2 || list[1] != "within") return expectation(skip_words(line, 1), 0);
    const auto joined = list.size() > 2 ? duration_ms(list[2]) : std::nullopt;
    const auto apart = list.size() > 3 ? duration_ms(list[2] + " " + list[3]) : std::nullopt;
    if (!joined && !apart)
        return BadCommand{
            "`expect within` requires a duration and a condition; write for example `expect within 3s X3`"};
    return expectation(skip_words(line, joined ? 3 : 4), joined ? joined : apart);
}

Command repeat_of(const std::vector<std::string>& list) {
    const auto times = list.size() == 3 && list[2] == "{" ? number_of(list[1]) : std::nullopt;
    if (!times || *times < 1)
        return BadCommand{"invalid `repeat`; write `repeat 3 {`, and `}` on a separate line after the repeated lines"};
    return RepeatCommand{static_cast<std::uint64_t>(*times)};
}

}  // namespace

Command command_of(std::string_view line) {
    line = without_comment(line);
    const std::vector<std::string> list = words(line);
    if (list.empty()) return NoCommand{};
    const std::string& first = list[0];
    if (list.size() > 1 && list[1] == "=") return set_of(list);
    if (first == "expect") return expect_of(line, list);
    if (first == "wait" && list.size() > 1 && list[1] == "until") return expectation(skip_words(line, 2), {});
    if (first == "repeat") return repeat_of(list);
    if (first == "wait" || first == "w") return wait_of(list);
    if (first == "do" && (list.size() == 2 || list.size() == 3))
        return DoCommand{list[1], list.size() == 3 ? list[2] : ""};
    if (first == "save") {
        const std::string_view file = skip_words(line, 1);
        const std::size_t from = file.find_first_not_of(" \t"), to = file.find_last_not_of(" \t\r");
        if (from == std::string_view::npos) return BadCommand{"the file name is missing; write `save FILE`"};
        return SaveCommand{std::string(file.substr(from, to + 1 - from))};
    }
    if (first == "force") {
        if (list.size() == 3 && (list[2] == "on" || list[2] == "off")) return ForceCommand{list[1], list[2] == "on"};
        return BadCommand{"`force` is incomplete; write `force STEP on` or `force STEP off`"};
    }
    if (list.size() == 1) {
        if (first == "show") return ShowCommand{};
        if (first == "}") return EndCommand{};
        if (first == "back" || first == "b" || first == "undo") return BackCommand{};
        if (first == "quit" || first == "q") return QuitCommand{};
        if (first == "help" || first == "?") return HelpCommand{};
        if (const auto choice = number_of(first); choice && *choice > 0)
            return ChooseCommand{static_cast<std::size_t>(*choice)};
    }
    const std::string meant = nearest_of(first, command_text);
    return BadCommand{
        fmt::format("unknown command `{}`; {}", first,
                    meant.empty() ? "list the commands with `help`" : fmt::format("did you mean `{}`?", meant))};
}

}  // namespace grafverif
