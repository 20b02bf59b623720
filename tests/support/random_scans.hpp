// SPDX-License-Identifier: MIT
// Generates random small PLC programs, as Structured Text or with a Sequential Function Chart, for closed loops. Their
// inputs are `a` and `b`, their outputs are `q0` and `q1`. They have timers, edge blocks, counters, integers that wrap
// around, and sometimes run-time faults.
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

/// `timers`: the program may contain timers. `milliseconds` is the unit of their preset times.
RandomScans random_scans(Random& random, bool timers, int milliseconds);

}  // namespace grafverif
