// SPDX-License-Identifier: MIT
// Trial of a remedy: other options of `check`, for the properties that a check left open because of a limit.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "grafverif/ir/report.hpp"

namespace grafverif {

struct Trial {
    std::string options = {};                  ///< they replace those of the same name
    std::vector<PropertyResult> decided = {};  ///< among the open properties; without traces
    double seconds = 0;                        ///< duration

    bool operator==(const Trial&) const = default;
};

/// The trials as lines: a head, then one per remedy that decided a property, then the others together. Empty without
/// trials. `durations`: with those of the trials.
std::vector<std::string> remedies_text(const std::vector<Trial>& trials, bool durations = true);

void print_remedies(const std::vector<Trial>& trials, std::ostream& out);

}  // namespace grafverif
