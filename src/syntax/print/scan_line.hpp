// SPDX-License-Identifier: MIT
// Scan lines: what a tester and a controller say to each other, one line of inputs there, one line of outputs back for
// each scan of the PLC (docs/conformance.md). A line holds one value per column, in the order in which the chart
// declares its inputs, or its outputs; values are separated by commas, blanks or semicolons.
//
//   1,0,0,1,1       what is written: 0 and 1 for Booleans, decimal numbers for integers, commas between
//   TRUE 0 12       what is read besides: true and false in any case, blanks
//   wait 5s         time passes before the next scan (ms, s, min); it is no scan and has no answer
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/type.hpp"

namespace grafverif {

/// What stands at one place of the line.
struct ScanColumn {
    std::string name = {};
    Type type = {};

    bool operator==(const ScanColumn&) const = default;
};

/// One value per column; or what is wrong with the line, in the words of a message.
struct ScanValues {
    std::optional<std::vector<std::int64_t>> values = {};
    std::string problem = {};
};

/// `values` as they are written, without a line end.
std::string scan_line(std::span<const std::int64_t> values);

/// The values of `line`, each of the type of its column and within its range.
ScanValues read_scan_line(std::string_view line, std::span<const ScanColumn> columns);

/// A line longer than this says nothing for so many columns: readers need not keep more of it.
std::size_t longest_scan_line(std::size_t columns);

/// `line` as it can be shown in a message: what is not printable replaced, and cut where it is long.
std::string shown_line(std::string_view line);

}  // namespace grafverif
