// SPDX-License-Identifier: MIT
// Generates random small PLC programs, as Structured Text or with a Sequential Function Chart, for
// closed loops. The inputs of a program are `a` and `b`, and its outputs are `q0` and `q1`. The
// programs have timers, edge blocks, counters, integers that wrap around, and sometimes run-time
// faults.
#pragma once

#include <string>
#include <vector>

#include "support/random_chart.hpp"

namespace grafverif {

struct RandomScans {
    std::string text = {};
    bool timers = false, counter = false;
    std::vector<std::string> booleans = {}, integers = {};  ///< names of variables of the program
};

/// `timers`: the program may contain timers. `milliseconds` is the unit of the preset times of the
/// timers.
RandomScans random_scans(Random& random, bool timers, int milliseconds);

}  // namespace grafverif
