// SPDX-License-Identifier: MIT
// Checks a recording of a real controller against charts, sample by sample (run/recording, read/recording).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "grafverif/grafverif.hpp"
#include "ir/recording.hpp"
#include "read/recording/log_reader.hpp"

namespace grafverif {

struct RecordingOptions {
    std::int64_t jitter_ms = 20;
    /// Pairs of the name of a column and the name of an input or output. A column without a pair records the input or
    /// output with the name of the column.
    std::vector<std::pair<std::string, std::string>> map = {};
    /// True: end at the first deviation of a chart, violated property or invalid line; the report then concerns the
    /// samples before an invalid line. False: read the log until each chart has a verdict, and report the errors of all
    /// lines.
    bool stop_early = false;
    Limits limits = {};
};

/// Reads `log` until the verdict of each chart is final. The sources of diagnostics about `log`, which has the name
/// `name`, are added to `sources`. The result is empty if at least one error was added to `diagnostics`.
std::optional<RecordingReport> check_recording(const Model& model, const std::vector<Id<Chart>>& charts, LogBlocks log,
                                               const std::string& name, const RecordingOptions& options,
                                               Sources& sources, Diagnostics& diagnostics);

}  // namespace grafverif
