// SPDX-License-Identifier: MIT
// Generates random networks of several parts that share only time, for randomized tests of compositional checking. Each
// part has one or two small automata. Some parts cause a timelock, continue forever within one instant, reach a dead
// end, have a race of stored actions, or leave the range of a variable.
#pragma once

#include <string>

#include "grafverif/ir/network.hpp"
#include "support/random_chart.hpp"

namespace grafverif {

/// Returns a network of `parts` parts with the term `settled` and sometimes `race`, but without properties.
Network random_parts(Random& random, int parts);

/// Returns a network whose parts read each other's flags, assign variables that they read, and set shared flags. The
/// network has no controllers and consists of at least `cells` fragments.
Network random_cells(Random& random, int cells);

/// Adds properties of every pattern over terms of one part or of two parts, some of them only about quiescent states.
void query_subsystems(Network& network, Random& random);

/// Returns the text of a loop of several PLCs, each with a lamp and a button. The charts have cycles with delays,
/// edges, a counter that may leave its range, and stored actions that may race.
std::string loop_of_plcs(Random& random, int plcs);

}  // namespace grafverif
