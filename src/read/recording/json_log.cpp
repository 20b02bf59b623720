// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "read/recording/log_reader.hpp"
#include "support/wording.hpp"

namespace grafverif {

namespace {

std::optional<std::int64_t> time_of(const nlohmann::json& value) {
    if (value.is_string()) return log_time(value.get_ref<const std::string&>());
    if (!value.is_number()) return {};
    const double us = value.get<double>() * 1e6;
    if (!(us >= 0) || us > static_cast<double>(latest_log_us)) return {};
    return std::llround(us);
}

std::optional<std::int64_t> value_of(const nlohmann::json& value) {
    if (value.is_boolean()) return value.get<bool>() ? 1 : 0;
    if (value.is_number_unsigned() && value.get<std::uint64_t>() > INT64_MAX) return {};
    return value.is_number_integer() ? std::optional(value.get<std::int64_t>()) : std::nullopt;
}

}  // namespace

bool LogReader::open_json() {
    LogRow row;
    pending_ = true;
    return read_json(row, true);
}

bool LogReader::next_json(LogRow& row) {
    if (std::exchange(pending_, false)) return read_json(row, false);
    while (next_line()) {
        if (lines_.line().find_first_not_of(" \t") == std::string::npos) continue;
        row.values.clear();
        if (read_json(row, false)) return true;
    }
    return false;
}

/// Reads the current line, a JSON object. If `first` is true, declares the variables in the line instead of reading
/// their values. Returns false after an error.
bool LogReader::read_json(LogRow& row, bool first) {
    const nlohmann::json object = nlohmann::json::parse(lines_.line(), nullptr, false);
    if (!object.is_object()) return fail(where(), "the line is not a JSON object; write one object per line");
    const auto time = object.find("time");
    const auto time_us = time == object.end() ? std::nullopt : time_of(*time);
    if (!time_us)
        return fail(where(),
                    "the member `time` is missing or is not a time; write a number of seconds, or a string such as "
                    "`\"250ms\"`");
    row.time_us = *time_us;
    row.line = lines_.number();
    for (const auto& [name, value] : object.items()) {
        if (name == "time") continue;
        if (first && by_name_.try_emplace(name, columns_.size()).second) columns_.push_back({name, where()});
        const auto column = by_name_.find(name);
        if (column == by_name_.end())
            return fail(where(), fmt::format("the first line has no member `{}`; add it with its initial value",
                                             messages::clipped(name)));
        if (first || is_ignored(column->second)) continue;
        const auto number = value_of(value);
        if (!number)
            return fail(where(), fmt::format("the value of `{}` is neither a Boolean nor an integer; correct it",
                                             messages::clipped(name)));
        if (!put(row, {column->second, *number}, lines_.line())) return false;
    }
    return true;
}

}  // namespace grafverif
