// SPDX-License-Identifier: MIT
// Scan lines: a protocol between a tester and a controller, with one line of inputs and one line of outputs for each
// scan of the PLC (docs/how-to/test-a-plc.md). A line has one value per column, in the order in which the chart
// declares its inputs or outputs. Commas, spaces or semicolons separate the values.
//
//   1,0,0,1,1       printed format: 0 and 1 for Booleans, decimal numbers for integers, separated by commas
//   TRUE 0 12       also accepted: true and false in upper or lower case, spaces
//   wait 5s         time passes before the next scan (ms, s, min); this line causes no scan and has no response
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/type.hpp"

namespace grafverif {

/// A column of scan lines: name and type of the value at one position of a line.
struct ScanColumn {
    std::string name = {};
    Type type = {};

    bool operator==(const ScanColumn&) const = default;
};

/// The result of reading a line: one value per column, or the text of an error message.
struct ScanValues {
    std::optional<std::vector<std::int64_t>> values = {};
    std::string problem = {};
};

/// Returns `values` as a scan line, without a line end.
std::string scan_line(std::span<const std::int64_t> values);

/// Parses a scan line. Each value must have the type of its column and be within the range of the column.
ScanValues read_scan_line(std::string_view line, std::span<const ScanColumn> columns);

/// Returns the maximum length in characters of a valid scan line with this number of columns. A reader may truncate
/// longer lines.
std::size_t longest_scan_line(std::size_t columns);

/// Returns `line` for display in a message: unprintable characters are replaced, and long lines are truncated.
std::string shown_line(std::string_view line);

}  // namespace grafverif
