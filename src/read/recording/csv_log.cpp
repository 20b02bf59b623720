// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "read/csv.hpp"
#include "read/recording/log_reader.hpp"
#include "support/wording.hpp"

namespace grafverif {

bool LogReader::open_csv() {
    separator_ = csv_separator(rest_);
    if (separator_ == ',' && rest_.find(',') == std::string_view::npos) separator_ = '\t';
    CsvScanner scanner(rest_, separator_);
    scanner.field();
    while (scanner.separator()) {
        const CsvScanner::Field name = scanner.field();
        columns_.push_back({name.text, lines_.span(rest_.substr(name.begin, name.end - name.begin))});
    }
    if (!columns_.empty()) return true;
    return fail(where(), "the first line has only one column; write a time column and a column for each variable");
}

bool LogReader::next_csv(LogRow& row) {
    while (next_line()) {
        if (lines_.line().find_first_not_of(" \t") == std::string::npos) continue;
        row.values.clear();
        if (read_csv(row)) return true;
    }
    return false;
}

bool LogReader::read_csv(LogRow& row) {
    const std::string_view line = lines_.line();
    CsvScanner scanner(line, separator_);
    const auto part = [&](const CsvScanner::Field& field) { return line.substr(field.begin, field.end - field.begin); };
    const CsvScanner::Field time = scanner.field();
    const auto time_us = log_time(time.text);
    if (!time_us)
        return fail(
            lines_.span(part(time)),
            fmt::format("`{}` is not a time; write seconds, as in `12.25`, or a number with a unit, as in `250ms`",
                        messages::clipped(time.text)));
    row.time_us = *time_us;
    row.line = lines_.number();
    std::size_t column = 0;
    for (; scanner.separator(); ++column) {
        const CsvScanner::Field field = scanner.field();
        if (field.text.empty() || column >= columns_.size() || is_ignored(column)) continue;
        const auto value = log_value(field.text);
        if (!value)
            return fail(lines_.span(part(field)),
                        fmt::format("`{}` is neither a Boolean nor an integer; write 0, 1, `true`, "
                                    "`false` or a decimal number without a fraction",
                                    messages::clipped(field.text)));
        if (!put(row, {column, *value}, part(field))) return false;
    }
    if (column == columns_.size()) return true;
    return fail(where(), fmt::format("this line has {} fields, but the first line has {}; add or remove fields",
                                     column + 1, columns_.size() + 1));
}

}  // namespace grafverif
