// SPDX-License-Identifier: MIT
// Generates random closed loops with an operator panel, as text, for tests of input abstraction.
//
// One or two charts of three steps read two to eight elements of the panel. The elements are push buttons with and
// without a bound on the time pressed, emergency stops, selectors, key switches, two-hand controls, light curtains, and
// enabling switches. Other elements are free, integer and faulty inputs, instances that read each other's output, and a
// door and an acknowledge button, which read outputs of the chart. The charts have times and edges of inputs, and
// conditional, stored and counting actions. An actuator and sensors read outputs and inputs. Instances begin in any
// location. Some instances block time or have no further edge; if requested, an instance leaves the range of its
// variable.
#pragma once

#include <string>

#include "support/random_chart.hpp"

namespace grafverif {

struct PanelOptions {
    int elements = 0;       ///< number of elements of the panel; 0: a random number, usually 2 or 3, at most 8
    bool faulty = false;    ///< if true, an instance leaves the range of its variable
    bool observed = true;   ///< if true, the loop has properties that observers check
    bool progress = false;  ///< if true, the loop has `always possible`, `leads to` and `inevitable`
};

std::string random_panel(Random& random, const PanelOptions& options = {});

}  // namespace grafverif
