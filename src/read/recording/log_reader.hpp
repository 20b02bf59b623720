// SPDX-License-Identifier: MIT
// Log reader: reads a time-stamped recording of variables line by line, in constant memory. The first character selects
// the format:
//
//   CSV         column names, then one row per sample: the time, and a value or nothing (unchanged) per column. The
//               separator is `;`, a tab or `,`
//   JSON lines  `{`: one object per line, with the member `time` and values of some variables of the first line
//   VCD         `$`: value change dump (IEEE 1364), Boolean and integer variables
//
// A time is in seconds (`12.25`) or has a unit (`us`, `ms`, `s`, `min`); in VCD, it has the unit of the time scale.
// Fractions of a microsecond are ignored. Times must not decrease. Rows with the same time are one sample.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

/// A function that replaces `block` by the next part of a log; it returns false at the end of the log.
using LogBlocks = std::function<bool(std::string& block)>;

/// Latest time of a sample, in microseconds (about 285 years).
inline constexpr std::int64_t latest_log_us = 9'000'000'000'000'000;

/// Reads the lines of a log, and creates positions for diagnostics. To save memory, the source of these positions
/// contains only the lines for which a position was created; all other lines are empty.
class LogLines {
public:
    LogLines(LogBlocks blocks, std::string name, Sources& sources);

    /// Reads the next line, without its line end. Returns false at the end of the log. A line longer than `longest` is
    /// truncated.
    bool next();
    const std::string& line() const { return line_; }
    std::uint64_t number() const { return number_; }
    bool is_too_long() const { return line_.size() > longest; }
    /// Returns the position of a part of the current line.
    Span span(std::string_view part);

    static constexpr std::size_t longest = std::size_t{1} << 20U;

private:
    bool next_block();

    LogBlocks blocks_;
    Sources& sources_;
    Id<Source> source_;
    std::string block_ = {};
    std::size_t read_ = 0;  ///< number of bytes of the current block that were read
    std::string line_ = {};
    std::uint64_t number_ = 0;
    std::uint64_t shown_ = 0;  ///< number of lines in the source
};

struct LogColumn {
    std::string name = {};
    Span where = {};
};

struct LogValue {
    std::size_t column = 0;
    std::int64_t value = 0;  ///< the values of a Boolean are 0 and 1
    std::uint64_t line = 0;
};

struct LogRow {
    std::int64_t time_us = 0;
    std::uint64_t line = 0;  ///< number of the first line of the row
    std::vector<LogValue> values = {};
};

class LogReader {
public:
    /// `name` is the name of the log in diagnostics. `sources` and `diagnostics` must outlive the reader.
    LogReader(LogBlocks blocks, std::string name, Sources& sources, Diagnostics& diagnostics)
        : lines_(std::move(blocks), std::move(name), sources), sources_(sources), diagnostics_(diagnostics) {}

    /// Reads the names of the variables. Returns false after an error.
    bool open();
    const std::vector<LogColumn>& columns() const { return columns_; }

    /// Ignores the values of a column. The values may then be of any type.
    void ignore(std::size_t column) { use_of(column).ignored = true; }
    /// Rejects values of a column that are outside of `low` .. `high`. Ranges from earlier calls for the column remain
    /// valid.
    void restrict(std::size_t column, std::int64_t low, std::int64_t high);
    /// Ends the log at the first error. The default is to report the errors of all rows.
    void stop_at_error() { stop_at_error_ = true; }

    /// Reads the next row. Returns false at the end of the log. Reports and skips a row with errors.
    bool next(LogRow& row);

    /// Returns the position of the last line that was read.
    Span where() { return lines_.span(lines_.line()); }

private:
    enum class Format : std::uint8_t { Csv, JsonLines, Vcd };

    bool open_csv();
    bool open_json();
    bool open_vcd();
    bool next_csv(LogRow& row);
    bool next_json(LogRow& row);
    bool next_vcd(LogRow& row);

    bool read_csv(LogRow& row);
    bool read_json(LogRow& row, bool first);
    bool next_line();
    /// Returns the next word of a VCD file; empty at the end of the file.
    std::string_view word();
    std::string_view words_to_end();
    void declare(std::string_view words);
    bool read_time_scale(std::string_view words);
    void change(LogRow& row, std::string_view value, std::string_view code);

    bool fail(Span where, std::string_view problem);
    bool may_continue() const { return !diagnostics_.full() && !(failed_ && stop_at_error_); }
    bool is_ignored(std::size_t column) const { return column < uses_.size() && uses_[column].ignored; }
    /// Adds a value to `row`. `part` is the text of the value in the current line. Returns false, and reports an error,
    /// if the value is outside of the range of its column.
    bool put(LogRow& row, LogValue value, std::string_view part);

    LogLines lines_;
    Sources& sources_;
    Diagnostics& diagnostics_;
    Format format_ = Format::Csv;
    std::vector<LogColumn> columns_ = {};
    struct Use {
        bool ignored = false;
        std::int64_t low = std::numeric_limits<std::int64_t>::min(), high = std::numeric_limits<std::int64_t>::max();
    };
    Use& use_of(std::size_t column) { return uses_.resize(columns_.size()), uses_[column]; }
    std::vector<Use> uses_ = {};  ///< for each column: its use; may have fewer elements than columns_
    bool failed_ = false, stop_at_error_ = false;
    std::optional<std::int64_t> last_time_ = {};
    char separator_ = ',';                                          ///< for CSV
    std::map<std::string, std::size_t, std::less<>> by_name_ = {};  ///< for JSON lines: column by name
    bool pending_ = false;  ///< for JSON lines: true if the current line is the first row

    struct Wire {
        std::size_t column = 0;
        std::uint32_t bits = 1;
        bool is_signed = false;
    };
    std::map<std::string, std::vector<Wire>, std::less<>> wires_ = {};  ///< for VCD: variables by their code
    std::vector<std::string> scopes_ = {};
    std::string_view rest_ = {};     ///< unread remainder of the current line
    std::string words_ = {};         ///< contents of the last declaration
    std::int64_t ticks_per_us_ = 1;  ///< for VCD: ticks per microsecond; 1 if a tick is at least 1 us
    std::int64_t us_per_tick_ = 1;
    std::optional<std::int64_t> vcd_time_ = {};  ///< time of the next row
    std::uint64_t vcd_line_ = 0;
};

/// Parses a Boolean (`0`, `1`, `true`, `FALSE`) or an integer.
std::optional<std::int64_t> log_value(std::string_view text);
/// Parses a time. Returns microseconds, or an empty result if `text` is not a time, is negative or exceeds
/// `latest_log_us`.
std::optional<std::int64_t> log_time(std::string_view text);

}  // namespace grafverif
