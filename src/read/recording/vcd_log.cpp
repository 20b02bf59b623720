// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "read/recording/log_reader.hpp"
#include "support/wording.hpp"

namespace grafverif {

namespace {

constexpr std::string_view blanks = " \t\r\f\v";
constexpr std::size_t longest_declaration = std::size_t{1} << 16U, most_columns = 100'000, most_scopes = 100;

std::string_view first_word(std::string_view& rest) {
    rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
    const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
    rest.remove_prefix(word.size());
    return word;
}

/// Returns the value of a bit vector. The result is empty if a bit is unknown or if the value needs more than 63 bits.
std::optional<std::int64_t> vector_value(std::string_view digits, std::uint32_t bits, bool is_signed) {
    std::uint64_t value = 0;
    if (digits.empty()) return {};
    for (const char digit : digits) {
        if ((digit != '0' && digit != '1') || (value >> 62U) != 0) return {};
        value = value << 1U | (digit == '1' ? 1U : 0U);
    }
    const bool negative = is_signed && bits < 63 && (value >> (bits - 1)) == 1;
    return static_cast<std::int64_t>(value) - (negative ? std::int64_t{1} << bits : 0);
}

}  // namespace

std::string_view LogReader::word() {
    while (true) {
        const std::string_view word = first_word(rest_);
        if (!word.empty()) return word;
        if (!next_line()) return {};
        rest_ = lines_.line();
    }
}

/// Reads up to the keyword `$end`. Returns all words before `$end`, each followed by a blank.
std::string_view LogReader::words_to_end() {
    words_.clear();
    for (std::string_view next = word(); !next.empty() && next != "$end"; next = word())
        if (words_.size() < longest_declaration) words_.append(next).append(" ");
    return words_;
}

bool LogReader::open_vcd() {
    for (std::string_view next = word(); next != "$enddefinitions"; next = word()) {
        if (next.empty()) return fail(where(), "the declarations do not end; add `$enddefinitions $end`");
        const std::string keyword(next);
        if (keyword.front() != '$')
            return fail(lines_.span(next),
                        fmt::format("`{}` is not a declaration; remove it", messages::clipped(keyword)));
        std::string_view words = words_to_end();
        if (keyword == "$timescale" && !read_time_scale(words)) return false;
        if (keyword == "$var") declare(words);
        if (keyword == "$scope") {
            first_word(words);
            scopes_.emplace_back(first_word(words));
        }
        if (keyword == "$upscope" && !scopes_.empty()) scopes_.pop_back();
    }
    words_to_end();
    // If the name of a variable is unique, its column has this name; otherwise, the name of the column includes the
    // scopes.
    std::map<std::string, int> count;
    const auto name_of = [](const std::string& path) { return path.substr(path.rfind('.') + 1); };
    for (const LogColumn& column : columns_) ++count[name_of(column.name)];
    for (LogColumn& column : columns_)
        if (count[name_of(column.name)] == 1) column.name = name_of(column.name);
    return !diagnostics_.has_errors();
}

bool LogReader::read_time_scale(std::string_view words) {
    std::string text(words);
    std::erase(text, ' ');
    std::int64_t number = 0;
    const auto [rest, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    const std::string_view unit(rest, static_cast<std::size_t>(text.data() + text.size() - rest));
    const bool is_number = failure == std::errc{} && (number == 1 || number == 10 || number == 100);
    us_per_tick_ = number;
    ticks_per_us_ = 1;
    if (is_number && unit == "s") us_per_tick_ *= 1'000'000;
    else if (is_number && unit == "ms") us_per_tick_ *= 1'000;
    else if (is_number && unit == "ns") ticks_per_us_ = 1'000;
    else if (is_number && unit == "ps") ticks_per_us_ = 1'000'000;
    else if (!is_number || unit != "us")
        return fail(where(),
                    fmt::format("the time scale `{}` is unknown; write 1, 10 or 100 with a unit: s, ms, us, ns or ps",
                                messages::clipped(text)));
    return true;
}

/// Declares a variable. `words` is the declaration of the variable, such as `wire 1 ! START` or `integer 32 # N`.
void LogReader::declare(std::string_view words) {
    const std::string_view type = first_word(words), size = first_word(words);
    const std::string_view code = first_word(words), name = first_word(words);
    Wire wire{.column = columns_.size(), .is_signed = type == "integer"};
    const auto [rest, failure] = std::from_chars(size.data(), size.data() + size.size(), wire.bits);
    if (failure != std::errc{} || wire.bits == 0 || name.empty()) {
        fail(where(),
             "the variable has no name or no valid size; write its declaration as in `$var wire 1 ! NAME $end`");
        return;
    }
    if (columns_.size() >= most_columns || scopes_.size() > most_scopes) {
        if (columns_.size() <= most_columns)
            fail(where(), fmt::format("there are more than {} variables or {} nested scopes; remove some of them",
                                      most_columns, most_scopes));
        return;
    }
    std::string path;
    for (const std::string& scope : scopes_) path += scope + ".";
    columns_.push_back({path.append(name), where()});
    wires_[std::string(code)].push_back(wire);
}

bool LogReader::next_vcd(LogRow& row) {
    bool begun = vcd_time_.has_value();
    while (true) {
        const std::string_view next = word();
        if (next.empty() || next.front() == '#') {
            const bool is_row = begun || !row.values.empty();
            row.time_us = vcd_time_.value_or(0);
            row.line = vcd_line_ == 0 ? lines_.number() : vcd_line_;
            vcd_time_.reset();
            vcd_line_ = lines_.number();
            if (next.empty()) return is_row;
            std::int64_t ticks = 0;
            const char* const end = next.data() + next.size();
            const auto [rest, failure] = std::from_chars(next.data() + 1, end, ticks);
            if (failure != std::errc{} || rest != end || ticks < 0 ||
                ticks / ticks_per_us_ > latest_log_us / us_per_tick_)
                fail(lines_.span(next), fmt::format("`{}` is not a time; write `#` and a whole number of units of the "
                                                    "time scale",
                                                    messages::clipped(next)));
            else
                vcd_time_ = ticks / ticks_per_us_ * us_per_tick_ + ticks % ticks_per_us_ * us_per_tick_ / ticks_per_us_;
            if (!may_continue()) return false;
            begun = true;
            if (is_row) return true;
            continue;
        }
        const char kind = next.front();
        if (kind == '$') {
            if (next == "$comment") words_to_end();
        } else if (std::string_view("bBrR").find(kind) != std::string_view::npos) {
            const std::string value(next.substr(1));
            const bool is_real = kind == 'r' || kind == 'R';
            change(row, is_real ? "x" : std::string_view(value), word());
        } else if (std::string_view("01xXzZ").find(kind) != std::string_view::npos) {
            change(row, next.substr(0, 1), next.substr(1));
        } else {
            fail(lines_.span(next), fmt::format("`{}` is not a value change; remove it", messages::clipped(next)));
            if (!may_continue()) return false;
        }
    }
}

void LogReader::change(LogRow& row, std::string_view value, std::string_view code) {
    const auto wires = wires_.find(code);
    if (wires == wires_.end()) {
        fail(where(),
             fmt::format("no variable has the code `{}`; declare a variable with this code", messages::clipped(code)));
        return;
    }
    for (const Wire& wire : wires->second) {
        if (is_ignored(wire.column)) continue;
        const auto number = vector_value(value, wire.bits, wire.is_signed);
        if (number) put(row, {wire.column, *number}, lines_.line());
        else
            fail(where(),
                 fmt::format("the value of `{}` is unknown, not an integer, or longer than 63 bits; replace it",
                             messages::clipped(columns_[wire.column].name)));
    }
}

}  // namespace grafverif
