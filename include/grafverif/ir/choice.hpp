// SPDX-License-Identifier: MIT
// Choice: something that may be chosen now in a simulation.
#pragma once

#include <string>

namespace grafverif {

struct Choice {
    std::string words = {};    ///< what would happen: `Start: START`
    std::string command = {};  ///< the line of a script that chooses it
    bool operator==(const Choice&) const = default;
};

}  // namespace grafverif
