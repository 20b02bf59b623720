// SPDX-License-Identifier: MIT
#include "read/recording/log_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "support/messages_log.hpp"
#include "support/wording.hpp"
#include "syntax/language/readable.hpp"

namespace grafverif {

LogLines::LogLines(LogBlocks blocks, std::string name, Sources& sources)
    : blocks_(std::move(blocks)), sources_(sources), source_(sources.add({std::move(name), ""})) {}

/// If all bytes of the current block were read, reads the next block that is not empty. Returns false at the end of the
/// log.
bool LogLines::next_block() {
    while (read_ == block_.size()) {
        read_ = 0;
        if (!blocks_(block_)) return block_.clear(), false;
    }
    return true;
}

bool LogLines::next() {
    line_.clear();
    if (!next_block()) return false;
    for (bool ended = false; !ended && next_block();) {
        const std::size_t end = std::min(block_.find('\n', read_), block_.size());
        line_.append(block_, read_, std::min(end - read_, longest + 1 - std::min(line_.size(), longest + 1)));
        ended = end < block_.size();
        read_ = end + (ended ? 1 : 0);
    }
    if (!line_.empty() && line_.back() == '\r') line_.pop_back();
    ++number_;
    return true;
}

Span LogLines::span(std::string_view part) {
    constexpr std::uint64_t most_lines = std::uint64_t{1} << 30U;  // positions are 32-bit numbers
    if (number_ > most_lines) return {};
    std::string& text = sources_[source_].text;
    if (shown_ < number_) {
        if (shown_ != 0) text += '\n';
        text.append(number_ - std::max<std::uint64_t>(shown_, 1) - (shown_ == 0 ? 0 : 1), '\n');
        text += line_;
        shown_ = number_;
    }
    const bool is_part = part.data() >= line_.data() && part.data() <= line_.data() + line_.size();
    const std::size_t column = is_part ? static_cast<std::size_t>(part.data() - line_.data()) : 0;
    const std::size_t begin = text.size() - std::min(text.size(), line_.size()) + column;
    return {source_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(begin + part.size())};
}

std::optional<std::int64_t> log_value(std::string_view text) {
    const auto is = [&](std::string_view word) {
        return std::ranges::equal(text, word, [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
    };
    if (is("true")) return 1;
    if (is("false")) return 0;
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    std::int64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [rest, failure] = std::from_chars(text.data(), end, value);
    if (failure != std::errc{} || rest != end) return {};
    return value;
}

std::optional<std::int64_t> log_time(std::string_view text) {
    struct Unit {
        std::string_view name = {};
        std::int64_t us = 0;
    };
    constexpr std::array units = {Unit{"us", 1}, Unit{"ms", 1'000}, Unit{"min", 60'000'000}, Unit{"s", 1'000'000}};
    std::int64_t us = 1'000'000;
    for (const Unit& unit : units)
        if (text.ends_with(unit.name)) {
            us = unit.us;
            text.remove_suffix(unit.name.size());
            while (text.ends_with(' ')) text.remove_suffix(1);
            break;
        }
    const std::size_t point = std::min(text.find('.'), text.size());
    const std::string_view whole = text.substr(0, point);
    const std::string_view fraction = point < text.size() ? text.substr(point + 1) : "";
    const auto is_digit = [](char letter) { return letter >= '0' && letter <= '9'; };
    if (whole.empty() || whole.size() > 15 || !std::ranges::all_of(whole, is_digit) ||
        !std::ranges::all_of(fraction, is_digit) || (point < text.size() && fraction.empty()))
        return {};
    std::int64_t value = 0;
    for (const char digit : whole) value = value * 10 + (digit - '0');
    if (value > latest_log_us / us) return {};
    value *= us;
    for (const char digit : fraction) {
        us /= 10;
        value += (digit - '0') * us;
    }
    return value <= latest_log_us ? std::optional(value) : std::nullopt;
}

bool LogReader::fail(Span where, std::string_view problem) {
    diagnostics_.add(messages::bad_log(where, problem));
    failed_ = true;
    return false;
}

void LogReader::restrict(std::size_t column, std::int64_t low, std::int64_t high) {
    Use& use = use_of(column);
    use.low = std::max(use.low, low);
    use.high = std::min(use.high, high);
}

bool LogReader::put(LogRow& row, LogValue value, std::string_view part) {
    value.line = lines_.number();
    if (value.column < uses_.size()) {
        const Use& use = uses_[value.column];
        if (value.value < use.low || value.value > use.high)
            return fail(lines_.span(part),
                        fmt::format("the value {} of `{}` is outside its range {}..{}; correct the value or the "
                                    "declaration",
                                    value.value, messages::clipped(columns_[value.column].name), use.low, use.high));
    }
    row.values.push_back(value);
    return true;
}

/// Reads the next line. Returns false at the end of the log. Reports and skips a line that is too long.
bool LogReader::next_line() {
    while (may_continue() && lines_.next()) {
        if (!lines_.is_too_long()) return true;
        fail(lines_.span(std::string_view(lines_.line()).substr(0, 1)), "the line is longer than 1 MiB; shorten it");
    }
    return false;
}

bool LogReader::open() {
    do {
        if (!next_line()) return fail(lines_.span(""), "the log is empty; write column names and samples");
    } while (lines_.line().find_first_not_of(" \t") == std::string::npos);
    if (!is_readable(where(), sources_, diagnostics_)) return false;
    std::string_view line = lines_.line();
    if (line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    rest_ = line;
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    format_ = line.starts_with('{') ? Format::JsonLines : line.starts_with('$') ? Format::Vcd : Format::Csv;
    switch (format_) {
    case Format::Csv: return open_csv();
    case Format::JsonLines: return open_json();
    case Format::Vcd: break;
    }
    return open_vcd();
}

bool LogReader::next(LogRow& row) {
    while (may_continue()) {
        row.values.clear();
        bool read = false;
        switch (format_) {
        case Format::Csv: read = next_csv(row); break;
        case Format::JsonLines: read = next_json(row); break;
        case Format::Vcd: read = next_vcd(row); break;
        }
        if (!read) return false;
        if (!last_time_ || row.time_us >= *last_time_) {
            last_time_ = row.time_us;
            return true;
        }
        fail(where(), "the time is before the time of the previous sample; sort the rows by time");
    }
    return false;
}

}  // namespace grafverif
