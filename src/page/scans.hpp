// SPDX-License-Identifier: MIT
// ProgramScans: determines the values that the statements of a PLC program compute in the scans of a run, for the page.
// The interpreter of programs (ProgramRun) executes the scans with the inputs of the run.
//
// A point is an item of a line (page/listing.hpp), such as a variable, in one instance of the unit that contains the
// line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/chart_run.hpp"
#include "page/listing.hpp"
#include "run/program/interpreter.hpp"

namespace grafverif {

class ProgramScans {
public:
    /// `interface` is the chart that represents the program. `interface` and `listing` must outlive the object.
    ProgramScans(const Chart& interface, const ProgramListing& listing);

    /// Returns the JSON member `scans` for a controller of a run (page/data.hpp). If the number of points and scans
    /// exceeds `remaining`, returns null; otherwise, subtracts this number from `remaining`.
    nlohmann::ordered_json scans(const ChartRun& run, Id<ChartRun::Controller> controller, std::size_t& remaining);

    /// Returns the JSON member `program` (page/data.hpp): the lines, and the points of all previous results of `scans`.
    nlohmann::ordered_json json() const;

private:
    struct Point {
        std::size_t item = 0;
        std::optional<std::size_t> instance = {};  ///< index in the layout; empty for a function
    };
    /// The last evaluation of a point.
    struct Value {
        std::size_t scan = 0, count = 0;
        std::int64_t value = 0;
    };

    template <class T>
    void add(const std::vector<ScanLog::Evaluation<T>>& evaluations,
             const std::vector<std::optional<std::size_t>>& items);
    std::size_t point(std::size_t item, std::size_t frame);
    nlohmann::ordered_json changes();
    nlohmann::ordered_json steps_json() const;
    nlohmann::ordered_json format_json(Id<Program::Type> type) const;

    const Chart& interface_;
    const Program& program_;
    const ProgramListing& listing_;
    ProgramLayout layout_;
    /// Index of each instance by unit and frame.
    std::map<std::pair<std::uint32_t, std::size_t>, std::size_t> instances_ = {};
    /// Index of each point by item and instance.
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> known_ = {};
    std::vector<Point> points_ = {};
    std::size_t scan_ = 0;  ///< number of the current scan, from 1

    /// Value of each point; `before_` is the value at the end of the previous scan.
    std::vector<Value> values_ = {}, before_ = {};
    std::vector<std::size_t> now_ = {}, earlier_ = {};  ///< points evaluated in the current scan, in the previous scan
};

/// Adds the transitions of a program to a run, and to each of its scans the transitions that the scan clears. `drawn`
/// is the chart that `drawn_chart` returns.
void add_cleared_transitions(ChartRun& run, Id<ChartRun::Controller> controller, const Chart& drawn);

}  // namespace grafverif
