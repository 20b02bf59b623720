// SPDX-License-Identifier: MIT
// Writes the verdicts of a recording as text or JSON.
#pragma once

#include <iosfwd>
#include <string>

#include "grafverif/support/diagnostic.hpp"
#include "ir/recording.hpp"

namespace grafverif {

void print_recording(const RecordingReport& report, Colour colour, std::ostream& out);
std::string recording_json(const RecordingReport& report);

}  // namespace grafverif
