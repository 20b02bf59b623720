// SPDX-License-Identifier: MIT
// RecordingVerdict: result of the check of a recording of inputs and outputs against a chart.
// run/recording/recording_check.hpp defines which timings of a recording are admissible.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/chart_run.hpp"

namespace grafverif {

/// Evidence that a recording has no admissible timing: a timing for which the chart agrees with the recording for the
/// longest time, and the output that differs afterwards.
struct Deviation {
    /// Time, in microseconds, of the change of the recorded output or, if `missing_change`, of the output of the chart.
    std::int64_t time_us = 0;
    std::uint64_t line = 0;     ///< line of the recorded value in the log
    std::string output = {};    ///< name of the output in the chart
    std::int64_t recorded = 0;  ///< value in the recording
    std::int64_t allowed = 0;   ///< value that the chart writes with this timing

    /// True: the output changes in the chart, but not in the recording; false: the output changes in the recording, but
    /// not in the chart.
    bool missing_change = false;
    std::string situation = {};  ///< active steps, such as `{2, 5}`

    bool operator==(const Deviation&) const = default;
};

/// Offset of the clock of a data source: the difference between the recorded times of some columns and those of the
/// other columns. If the offset is positive, the clock of the data source is ahead of the clock of the other columns.
struct ClockOffset {
    std::vector<std::string> columns = {};  ///< the columns of the log with times of this clock
    std::int64_t bound_us = 0;              ///< maximum absolute value of the offset (`--skew`)
    std::int64_t low_us = 0, high_us = 0;   ///< range of the offsets that explain the recording

    bool operator==(const ClockOffset&) const = default;
};

struct RecordingVerdict {
    enum class Kind { Conforms, Deviates, Unknown };
    std::string chart = {};
    Kind kind = Kind::Conforms;
    std::string reason = {};                  ///< reason for the result Unknown
    std::optional<Deviation> deviation = {};  ///< valid only for the result Deviates

    /// Run of the chart with one timing. For Deviates, this is the timing of `deviation`; otherwise, it is a timing
    /// that is admissible for the samples that were read. If there is no such timing, the run has no events.
    ChartRun run = {};
    bool run_is_complete = true;  ///< true if `run` begins at power-on; false if `run` contains only the last instants

    /// Offset of each clock of `--skew` that concerns the chart. No other offset explains the recording. For Deviates,
    /// the range applies to the timing of `deviation`. Empty for Unknown.
    std::vector<ClockOffset> offsets = {};
    std::vector<std::string> unrecorded = {};  ///< outputs that the recording does not contain

    bool operator==(const RecordingVerdict&) const = default;
};

/// A state property of a closed loop that reads only recorded variables.
struct RecordedProperty {
    std::string name = {};
    std::string loop = {};
    bool violated = false;
    std::int64_t time_us = 0;  ///< if violated: time of the first recorded values that violate the property
    std::uint64_t line = 0;    ///< if violated: line of the first recorded values that violate the property

    bool operator==(const RecordedProperty&) const = default;
};

/// Maximum number of instants of a run in text and JSON.
constexpr std::size_t printed_instants = 16;

/// Verdicts of several charts for one recording.
struct RecordingReport {
    std::string log = {};  ///< name of the log file
    std::int64_t jitter_us = 0;
    std::int64_t skew_us = 0;                ///< maximum absolute value of the offsets of clocks
    std::uint64_t samples = 0;               ///< number of samples that were read
    std::int64_t first_us = 0, last_us = 0;  ///< times of the first and the last of these samples
    bool stopped = false;                    ///< true if a limit or the user ended the check before the end of the log
    std::vector<RecordingVerdict> verdicts = {};
    std::vector<RecordedProperty> properties = {};

    bool operator==(const RecordingReport&) const = default;
};

/// Returns `conforms`, `deviates` or `unknown`.
constexpr std::string_view word(RecordingVerdict::Kind kind) {
    switch (kind) {
    case RecordingVerdict::Kind::Conforms: return "conforms";
    case RecordingVerdict::Kind::Deviates: return "deviates";
    case RecordingVerdict::Kind::Unknown: break;
    }
    return "unknown";
}

}  // namespace grafverif
