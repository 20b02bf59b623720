// SPDX-License-Identifier: MIT
// Generates random well-formed networks with all features of the IR, for randomized tests of emitters and engines.
// Templates have parameters of each kind and several processes each. The networks have clocks with constant bounds and
// with bounds given by a parameter, urgent and timed edges, procedures, scratch variables, ranged integers, and
// properties with locations. The networks have no intended meaning.
#pragma once

#include "grafverif/ir/network.hpp"
#include "support/random_chart.hpp"

namespace grafverif {

Network random_network(Random& random);

}  // namespace grafverif
