// SPDX-License-Identifier: MIT
// Checks a recording of a real controller against charts, sample by sample (run/recording, read/recording).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "grafverif/grafverif.hpp"
#include "ir/recording.hpp"
#include "read/recording/log_reader.hpp"

namespace grafverif {

/// A separate clock of the recording, and the columns whose times are those of this clock.
struct RecordingClock {
    std::vector<std::string> columns = {};
    std::int64_t bound_us = 0;  ///< maximum absolute value of the offset of the clock
};

struct RecordingOptions {
    std::int64_t jitter_ms = 20;
    std::vector<RecordingClock> clocks = {};
    /// Pairs of the name of a column and the name of an input or output. A column without a pair records the input or
    /// output with the name of the column.
    std::vector<std::pair<std::string, std::string>> map = {};
    /// If true, the check ends at the first deviation of a chart, violated property or invalid line; after an invalid
    /// line, the report concerns the samples before this line. If false, the check reads the log until each chart has a
    /// verdict, and reports the errors of all lines.
    bool stop_early = false;
    std::uint64_t shown_instants = printed_instants;  ///< minimum number of instants in the runs of the report
    Limits limits = {};
};

/// Parses a value of `--skew`, such as `PUMP,HORN=500ms`. Returns an empty result after an error.
std::optional<RecordingClock> recording_clock(const std::string& text, Diagnostics& diagnostics);

/// True if recordings can be checked against the chart: it has equations, and its mode is stability search. Otherwise,
/// the function adds an error.
bool can_be_recorded(const Model& model, Id<Chart> chart, std::optional<ExecutionMode> mode, Diagnostics& diagnostics);

class RecordingReader;

/// Checks a recording whose lines arrive one by one. All references must outlive the object.
class RecordingMonitor {
public:
    RecordingMonitor(const Model& model, std::vector<Id<Chart>> charts, const std::string& name,
                     RecordingOptions options, Sources& sources, Diagnostics& diagnostics);
    ~RecordingMonitor();
    RecordingMonitor(const RecordingMonitor&) = delete;
    RecordingMonitor& operator=(const RecordingMonitor&) = delete;

    /// Adds a line of a log in JSON lines; the first line determines the columns. Returns false if the check has ended:
    /// after an error, if the verdict on each chart is final or, with `stop_early`, after the first deviation or
    /// violated property. After the end, further lines are ignored, so that the results for properties concern only the
    /// samples up to the end. A sample is complete when a line with a later time is added.
    bool add(const std::string& line);
    /// Returns the verdicts on the lines added so far. The result is empty if at least one error was added to
    /// `diagnostics`. Must be called at most once, after the last line.
    std::optional<RecordingReport> finish();

private:
    const Model& model_;
    const std::vector<Id<Chart>> charts_;
    const RecordingOptions options_;
    std::string line_ = {};  ///< the line that `reader_` reads next
    bool open_ = false;
    std::unique_ptr<RecordingReader> reader_;
};

/// Checks the recording `log` until the verdict on each chart is final. `name` is the name of the log in diagnostics.
/// The function adds the log to `sources`. The result is empty if at least one error was added to `diagnostics`.
std::optional<RecordingReport> check_recording(const Model& model, const std::vector<Id<Chart>>& charts, LogBlocks log,
                                               const std::string& name, const RecordingOptions& options,
                                               Sources& sources, Diagnostics& diagnostics);

}  // namespace grafverif
