// SPDX-License-Identifier: MIT
// Choice: a possible next move in a simulation.
#pragma once

#include <string>

namespace grafverif {

struct Choice {
    std::string words = {};    ///< description of the move, such as `Start: START`
    std::string command = {};  ///< the command of `grafverif simulate` that makes this move
    bool operator==(const Choice&) const = default;
};

}  // namespace grafverif
