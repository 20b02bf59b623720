// SPDX-License-Identifier: MIT
// Checks state properties of closed loops on recorded values. A property is violated if its condition is false for a
// combination of recorded values that lasts for more than four times the jitter. If a property reads columns whose
// times are from several clocks, this duration is increased by the maximum difference between the offsets of two of
// these clocks. A combination of values that lasts for a shorter time can be an artefact of the recording, and is not
// reported. The result assumes that no pulse of an output is missing in the recording.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "ir/recording.hpp"

namespace grafverif {

/// Differences between recorded times and the times in the controller.
struct RecordingTolerance {
    std::int64_t jitter_us = 0;
    std::vector<std::size_t> clock_of = {};    ///< for each column: index of its clock + 1, or 0
    std::vector<std::int64_t> clocks_us = {};  ///< for each clock: maximum absolute value of its offset
};

class RecordedProperties {
public:
    /// `names` contains for each column the name of its variable. Selects, from all loops, the properties `always`,
    /// `never` and `exactly one of` that read only these variables and have neither `at stable` nor `expected
    /// violated`. `model` must outlive the object.
    RecordedProperties(const Model& model, const std::vector<std::string>& names, RecordingTolerance tolerance);

    /// Sets the value of a column in the sample at `time_us`. Successive calls must have non-decreasing times.
    void set(std::size_t column, std::int64_t value, std::int64_t time_us, std::uint64_t line);
    /// Declares that the values set so far are valid until `time_us`, and records which properties these values
    /// violate.
    void pass(std::int64_t time_us);

    const std::vector<RecordedProperty>& results() const { return results_; }

private:
    struct Checked {
        const ClosedLoop* loop = nullptr;
        Id<Property> property = {};
        std::vector<std::size_t> column_of = {};  ///< for each symbol of the loop: its column
        std::vector<bool> reads = {};             ///< for each column: true if the property reads it
        std::int64_t least_us = 0;                ///< a shorter violation is not reported
        std::int64_t since_us = 0;                ///< time of the last change of a variable that the property reads
        std::uint64_t line = 0;
        bool pending = true;  ///< true if the values since `since_us` have not been evaluated
    };

    bool holds(const Checked& checked) const;
    std::int64_t least_us(const std::vector<bool>& reads) const;

    RecordingTolerance tolerance_;
    std::vector<std::optional<std::int64_t>> values_;  ///< for each column: current value; empty before the first value
    std::vector<Checked> checked_ = {};
    std::vector<RecordedProperty> results_ = {};
};

}  // namespace grafverif
