// SPDX-License-Identifier: MIT
// Trial of a remedy: `check` with other options, for the properties that a check could not decide within a limit.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "grafverif/ir/report.hpp"

namespace grafverif {

struct Trial {
    std::string options = {};                  ///< options to add to the command; they replace options of the same name
    std::vector<PropertyResult> decided = {};  ///< results for open properties, without traces
    double seconds = 0;                        ///< duration of the trial

    bool operator==(const Trial&) const = default;
};

/// Returns the trials as lines: a heading, a line for each remedy that decided a property, and one line for all other
/// remedies. If no trial decided a property, the result is one line. If there are no trials, the result is empty. If
/// `durations` is true, the lines contain the durations of the trials.
std::vector<std::string> remedies_text(const std::vector<Trial>& trials, bool durations = true);

void print_remedies(const std::vector<Trial>& trials, std::ostream& out);

}  // namespace grafverif
