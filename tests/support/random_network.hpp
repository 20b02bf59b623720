// SPDX-License-Identifier: MIT
// Random well-formed networks with all features of the IR, for randomized tests of emitters and engines: templates with
// parameters of each kind and several processes each; clocks with constant bounds and bounds by parameter, urgent and
// timed edges; procedures, scratch variables, ranged integers, properties with locations. They have no intended
// meaning.
#pragma once

#include "grafverif/ir/network.hpp"
#include "support/random_chart.hpp"

namespace grafverif {

Network random_network(Random& random);

}  // namespace grafverif
