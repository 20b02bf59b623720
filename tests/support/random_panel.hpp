// SPDX-License-Identifier: MIT
// Random closed loops with an operator panel, as text, for tests of input abstraction.
//
// One or two charts of three steps read two to eight elements. These are push buttons with and without a bound on the
// time pressed, emergency stops, selectors, key switches, two-hand controls, light curtains, and enabling switches.
// Others are free, integer and faulty inputs, inputs that read each other, a door and an acknowledge button that read
// the loop. The charts have times and edges of inputs, conditional, stored and counting actions. An actuator and
// sensors read outputs and inputs. Instances begin in any location. Some instances block time or end, and if requested
// one leaves the range of its variable.
#pragma once

#include <string>

#include "support/random_chart.hpp"

namespace grafverif {

struct PanelOptions {
    int elements = 0;       ///< of the panel; 0: mostly two or three, eight at most
    bool faulty = false;    ///< also instances that leave the range of a variable
    bool observed = true;   ///< with properties that observers check
    bool progress = false;  ///< with `always possible`, `leads to` and `inevitable`
};

std::string random_panel(Random& random, const PanelOptions& options = {});

}  // namespace grafverif
