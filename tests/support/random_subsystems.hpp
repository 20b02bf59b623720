// SPDX-License-Identifier: MIT
// Random networks of several parts that share only time, each of one or two small automata, for randomized tests of
// compositional checking. Some parts cause a timelock, continue forever within one instant, reach a dead end, race, or
// leave a range.
#pragma once

#include <string>

#include "grafverif/ir/network.hpp"
#include "support/random_chart.hpp"

namespace grafverif {

/// A network of `parts` parts, with `settled` and sometimes `race`; without properties.
Network random_parts(Random& random, int parts);

/// A network whose parts read each other's flags, assign variables that they read, and set shared flags: at least
/// `cells` fragments of a network without controllers.
Network random_cells(Random& random, int cells);

/// Adds properties of every kind: of single parts, of two of them, of all moves and of quiescent states.
void query_subsystems(Network& network, Random& random);

/// The text of a loop of several PLCs, each with a lamp and a button: cycles with delays, edges, a counter that may
/// leave its range, stored actions that may race.
std::string loop_of_plcs(Random& random, int plcs);

}  // namespace grafverif
