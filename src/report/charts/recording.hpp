// SPDX-License-Identifier: MIT
// Writes the verdicts of a recording as text or JSON.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "grafverif/support/diagnostic.hpp"
#include "ir/recording.hpp"

namespace grafverif {

/// Returns a time of a recording as text, such as `5.14 s`. `us` is in microseconds.
std::string recording_time_text(std::int64_t us);
/// Returns text about the output that deviates, such as "`HORN` is 0, but the chart sets it to 1 at 5.14 s".
std::string deviation_text(const Deviation& deviation);
/// Returns a sentence that states that there is no admissible timing.
std::string no_timing_text(const RecordingVerdict& verdict);
/// Returns text about the offset of a clock, such as "clock offset of `PUMP`: 0.28 s to 0.32 s (--skew 500 ms)".
std::string offset_text(const ClockOffset& offset);
/// Returns the number of samples, the time range, the tolerances and the length of the inconclusive part.
std::string summary_text(const RecordingReport& report);

void print_recording(const RecordingReport& report, Colour colour, std::ostream& out);
std::string recording_json(const RecordingReport& report);

}  // namespace grafverif
